//! `masse run`.

use std::fs::File;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use crate::cli::scene_options::SceneOptions;
use crate::cli::{CommandError, crowd, say, to_file, to_stdout};
use crate::physics::cue_path::{self, Obstacle};
use crate::physics::scene::Scene;
use crate::report::record_file::Expected;
use crate::report::{picture, record_file, states};
use crate::scenarios::expect::Outcome;
use crate::sim::play::play;

/// What to run, and how.
#[derive(Args, Debug)]
pub(super) struct RunOptions {
    #[command(flatten)]
    what: SceneOptions,
    /// File for the record, instead of the standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// File for a table of every ball at even times, in CSV: time, ball, place, velocity, spin, kind of motion
    #[arg(long, value_name = "FILE.csv")]
    states: Option<PathBuf>,
    /// Seconds between two times of the table
    #[arg(long, value_name = "S", default_value_t = 0.01, value_parser = step, requires = "states")]
    every: f64,
    /// File for a picture of the paths, in SVG
    #[arg(long, value_name = "FILE.svg")]
    picture: Option<PathBuf>,
    /// Write no record to the standard output and no summary to the standard error
    #[arg(long, short)]
    quiet: bool,
}

fn step(text: &str) -> Result<f64, String> {
    let step = text.parse().ok();
    step.filter(|step: &f64| step.is_finite() && *step > 0.0)
        .ok_or_else(|| "a number of seconds above 0".to_owned())
}

/// Runs a scene and writes its record and, if asked for, its picture. Exit code 1 if an expectation is missed.
pub(super) fn run(options: &RunOptions) -> Result<ExitCode, CommandError> {
    let scenario = options.what.open()?;
    let (scene, title) = (&scenario.scene, &scenario.title);
    if !options.quiet
        && let Some(note) = cue_note(scene)
    {
        say(&note);
    }
    if scene.solver.is_crowd() {
        if options.out.is_some() || options.picture.is_some() || options.states.is_some() {
            return Err(CommandError::Usage(
                "--out, --states and --picture: a crowd is counted, not written down ball by ball"
                    .to_owned(),
            ));
        }
        return crowd::run(&options.what.scene, title, scene, options.quiet);
    }
    let record = play(scene)?;
    let outcomes = scenario.judge(&record);
    let expected: Vec<Expected> = outcomes.iter().map(told).collect();
    let written = |out: &mut dyn std::io::Write| {
        record_file::write_judged(out, &options.what.scene, title, scene, &record, &expected)
    };
    if let Some(path) = &options.out {
        let mut lines = Vec::new();
        written(&mut lines).map_err(|source| CommandError::Write {
            to: path.display().to_string(),
            source,
        })?;
        to_file(path, &lines)?;
    } else if !options.quiet {
        to_stdout(written)?;
    }
    if let Some(path) = &options.states {
        File::create(path)
            .and_then(|file| states::write(file, scene, &record, options.every))
            .map_err(|source| CommandError::Write {
                to: path.display().to_string(),
                source,
            })?;
    }
    if let Some(path) = &options.picture {
        to_file(path, picture::draw(title, scene, &record).as_bytes())?;
    }
    if !options.quiet {
        let summary = record_file::Summary::of(&options.what.scene, title, scene, &record);
        say(&summary.text());
        for outcome in &outcomes {
            say(&format!("  {}", outcome.sentence()));
        }
    }
    let missed = outcomes.iter().filter(|outcome| !outcome.met).count();
    if missed == 0 {
        return Ok(ExitCode::SUCCESS);
    }
    if !options.quiet {
        let count = outcomes.len();
        say(&format!(
            "masse: {missed} of {count} expectations are missed"
        ));
    }
    Ok(ExitCode::from(1))
}

/// An outcome as a record tells it.
fn told(outcome: &Outcome) -> Expected {
    Expected {
        expected: outcome.wanted.to_string(),
        met: outcome.met,
        found: outcome.found,
        unit: outcome.unit.to_owned(),
        seen: outcome.seen.to_string(),
    }
}

/// A line about a cue that would pass through something: the stroke is played all the same, as pure physics.
fn cue_note(scene: &Scene) -> Option<String> {
    let planned = scene.shot?;
    let obstacle = cue_path::obstacle(scene, planned.ball, &planned.shot)?;
    let what = match obstacle {
        Obstacle::Ball(ball) => format!("ball `{}`", scene.balls[ball].name),
        Obstacle::Cushion(cushion) => format!("cushion {cushion}"),
        Obstacle::Rail => "the rail".to_owned(),
        Obstacle::Slate => "the slate".to_owned(),
    };
    let need = match cue_path::lift(scene, planned.ball, &planned.shot) {
        Some(lift) => format!(
            "from {:.2} degrees of elevation on it is clear",
            (100.0 * lift.elevation.to_degrees()).ceil() / 100.0
        ),
        None => "no elevation clears it".to_owned(),
    };
    Some(format!(
        "note: at {:.2} degrees the cue would pass through {what}; {need}",
        planned.shot.elevation.to_degrees()
    ))
}
