//! `masse judge`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use serde::Serialize;

use crate::cli::{CommandError, say, to_file, to_stdout};
use crate::report::chart;
use crate::report::judge::hard::{self, Hard};
use crate::report::judge::{Judgement, judge, pictures};
use crate::scenarios::preset;

/// What to judge, and how to tell it.
#[derive(Args, Debug)]
pub(super) struct JudgeOptions {
    /// Write the tables as one JSON object
    #[arg(long)]
    json: bool,
    /// Folder for the pictures, in SVG; made if it is not there. Without this option it is `judge`, and with --json none
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Play the hard cases H1 to H16 by both solvers instead, and print what must happen and what did; no pictures
    #[arg(long, conflicts_with_all = ["out", "no_pictures", "allow"])]
    hard: bool,
    /// Write no pictures
    #[arg(long, conflicts_with = "out")]
    no_pictures: bool,
    /// Multiply the tolerances of the exact judges by this: below 1 shows how much room is left
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = factor)]
    allow: f64,
}

fn factor(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|factor: &f64| factor.is_finite() && *factor >= 0.0)
        .ok_or_else(|| "a number from 0 up".to_owned())
}

/// What is judged: every law, and every built-in preset.
pub(super) fn judgement(allowance: f64) -> Result<Judgement, CommandError> {
    let mut presets = Vec::new();
    for built_in in preset::BUILT_IN {
        presets.push((built_in.name.to_owned(), built_in.preset()?.equipment));
    }
    Ok(judge(allowance, &presets))
}

/// Judges every law, prints the tables and draws the pictures. Exit code 1 if an exact judge misses.
pub(super) fn run(options: &JudgeOptions) -> Result<ExitCode, CommandError> {
    if options.hard {
        return hard_cases(options.json);
    }
    let judgement = judgement(options.allow)?;
    print(options, &judgement)?;
    let standard = (!options.json && !options.no_pictures).then(|| PathBuf::from("judge"));
    let drawn = options.out.clone().or(standard).map(|folder| draw(&folder));
    let missed = judgement.missed();
    if missed.is_empty() {
        return drawn.unwrap_or(Ok(())).map(|()| ExitCode::SUCCESS);
    }
    if let Some(Err(error)) = drawn {
        say(&format!("masse: {error}"));
    }
    say(&format!(
        "masse: {} exact judges miss, the first is: {}",
        missed.len(),
        missed[0]
    ));
    Ok(ExitCode::from(1))
}

/// What `--hard --json` writes.
#[derive(Serialize)]
struct HardCases<'r> {
    hard: &'r [Hard],
}

/// Plays the hard cases. Exit code 1 if one of them misses.
fn hard_cases(json: bool) -> Result<ExitCode, CommandError> {
    let rows = hard::suite();
    to_stdout(|out| {
        if json {
            serde_json::to_writer_pretty(&mut *out, &HardCases { hard: &rows })?;
            writeln!(out)
        } else {
            write!(out, "{}", hard::text(&rows))
        }
    })?;
    let missed: Vec<&Hard> = rows.iter().filter(|row| !row.pass).collect();
    let Some(first) = missed.first() else {
        return Ok(ExitCode::SUCCESS);
    };
    say(&format!(
        "masse: {} hard cases miss, the first is: {} {}, {}",
        missed.len(),
        first.case,
        first.scene,
        first.solver
    ));
    Ok(ExitCode::from(1))
}

fn print(options: &JudgeOptions, judgement: &Judgement) -> Result<(), CommandError> {
    to_stdout(|out| {
        if options.json {
            serde_json::to_writer_pretty(&mut *out, judgement)?;
            writeln!(out)
        } else {
            write!(out, "{}", judgement.text())
        }
    })
}

/// Draws every picture into this folder.
fn draw(folder: &Path) -> Result<(), CommandError> {
    std::fs::create_dir_all(folder).map_err(|source| CommandError::Write {
        to: folder.display().to_string(),
        source,
    })?;
    let mut names = Vec::new();
    for (name, compute) in pictures::ALL {
        let unfinished = |reason: String| CommandError::Unfinished(format!("{name}: {reason}"));
        let chart = compute
            .run()
            .map_err(|stopped| unfinished(stopped.to_string()))?;
        let text = chart::draw(&chart).map_err(unfinished)?;
        to_file(&folder.join(name), text.as_bytes())?;
        names.push(*name);
    }
    say(&format!(
        "masse: pictures in {}: {}",
        folder.display(),
        names.join(", ")
    ));
    Ok(())
}
