//! `masse report`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::cli::{CommandError, say, to_file, to_stdout};
use crate::report::chart;
use crate::report::speed_and_error::{self, Effort, LIBRARY, Named, Progress, Report};
use crate::scenarios::library;

/// How much to measure, and where to put it.
#[derive(Args, Debug)]
pub(super) struct ReportOptions {
    /// Less of everything: done within a minute
    #[arg(long)]
    quick: bool,
    /// Folder for tables and pictures; made if it is not there
    #[arg(long, value_name = "DIR", default_value = "report")]
    out: PathBuf,
    /// Play only this scene of the ladder; may be given several times
    #[arg(long, value_name = "NAME")]
    scene: Vec<String>,
    /// Largest crowd [default: 1000000, with --quick 100000]
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(100..=1_000_000))]
    balls: Option<u32>,
}

/// A bar on the terminal; where there is none, nothing.
struct Bar(ProgressBar);

impl Progress for Bar {
    fn begin(&self, steps: usize) {
        self.0.set_length(steps as u64);
        self.0.tick();
    }

    fn step(&self, what: &str) {
        self.0.set_message(what.to_owned());
        self.0.inc(1);
    }
}

/// Measures, and writes tables and pictures. Exit code 1 if a method converges slower than is demanded of it.
pub(super) fn run(options: &ReportOptions) -> Result<ExitCode, CommandError> {
    let mut effort = if options.quick {
        Effort::quick()
    } else {
        Effort::whole()
    };
    effort.most_balls = options.balls.unwrap_or(effort.most_balls);
    let mut scenes = Vec::new();
    for name in LIBRARY {
        let scenario = library::open(name)?;
        scenes.push(Named {
            name: name.to_owned(),
            title: scenario.title,
            scene: scenario.scene,
        });
    }
    let known = speed_and_error::names(&effort, &scenes);
    if let Some(unknown) = options.scene.iter().find(|name| !known.contains(name)) {
        return Err(CommandError::Usage(format!(
            "--scene {unknown}: the ladder has no such scene; it has {}",
            known.join(", ")
        )));
    }
    writable(&options.out)?;
    let bar =
        Bar(ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr()).with_style(style()));
    let report = speed_and_error::run(&effort, &scenes, &options.scene, &bar)
        .map_err(|stopped| CommandError::Unfinished(stopped.to_string()))?;
    bar.0.finish_and_clear();
    write(&options.out, &report)?;
    let missed = report.missed();
    if missed.is_empty() {
        return Ok(ExitCode::SUCCESS);
    }
    say(&format!(
        "masse: located contacts are not of second order in {}",
        missed.join(", ")
    ));
    Ok(ExitCode::from(1))
}

fn style() -> ProgressStyle {
    ProgressStyle::with_template("{bar:30} {pos}/{len} {elapsed} {msg}")
        .unwrap_or_else(|_| ProgressStyle::default_bar())
}

/// Finds out before minutes of measuring whether there is a folder to write to.
fn writable(folder: &Path) -> Result<(), CommandError> {
    let tried =
        std::fs::create_dir_all(folder).and_then(|()| tempfile::tempfile_in(folder).map(drop));
    tried.map_err(|source| CommandError::Write {
        to: folder.display().to_string(),
        source,
    })
}

fn write(folder: &Path, report: &Report) -> Result<(), CommandError> {
    let text = speed_and_error::markdown(report);
    to_file(&folder.join("report.md"), text.as_bytes())?;
    let sheets = speed_and_error::csv(report)
        .map_err(|error| CommandError::Unfinished(error.to_string()))?;
    let mut names = vec!["report.md".to_owned()];
    for (name, text) in sheets {
        to_file(&folder.join(name), text.as_bytes())?;
        names.push(name.to_owned());
    }
    for (name, chart) in speed_and_error::pictures(report) {
        let text = chart::draw(&chart)
            .map_err(|reason| CommandError::Unfinished(format!("{name}: {reason}")))?;
        to_file(&folder.join(name), text.as_bytes())?;
        names.push(name.to_owned());
    }
    to_stdout(|out| write!(out, "{text}"))?;
    say(&format!(
        "masse: in {}: {}",
        folder.display(),
        names.join(", ")
    ));
    Ok(())
}
