//! `masse run`.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, ValueEnum};

use crate::cli::simulate::simulate;
use crate::cli::{CommandError, crowd, say, to_file, to_stdout};
use crate::physics::cue_path::{self, Obstacle};
use crate::physics::scene::{Scene, Solver, Stepped};
use crate::report::record_file::Expected;
use crate::report::{picture, record_file};
use crate::scenarios::expect::Outcome;
use crate::scenarios::{library, preset};

/// What to run, and how.
#[derive(Args, Debug)]
pub(super) struct RunOptions {
    /// Built-in scene (see `masse list`) or path of a scene file
    scene: String,
    /// Solver to use instead of the one the scene names
    #[arg(long, value_enum)]
    solver: Option<SolverName>,
    /// Length in s of a tick of the stepped solver
    #[arg(long, value_name = "S")]
    tick: Option<f64>,
    /// Grid of the stepped solver, such as 20x20; `none` tests every pair
    #[arg(long, value_name = "COLUMNSxROWS", value_parser = grid)]
    grid: Option<GridOption>,
    /// Seconds after which the run ends even if balls still move
    #[arg(long, value_name = "S")]
    time_limit: Option<f64>,
    /// Preset to play it with (see `masse list`), or a preset file
    #[arg(long, value_name = "NAME|FILE")]
    preset: Option<String>,
    /// File for the record, instead of the standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// File for a picture of the paths, in SVG
    #[arg(long, value_name = "FILE.svg")]
    picture: Option<PathBuf>,
    /// Write no record to the standard output and no summary to the standard error
    #[arg(long, short)]
    quiet: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SolverName {
    /// Every event at its own time
    Exact,
    /// A fixed tick
    Stepped,
}

#[derive(Clone, Copy, Debug)]
struct GridOption(Option<(u32, u32)>);

fn grid(text: &str) -> Result<GridOption, String> {
    if text == "none" {
        return Ok(GridOption(None));
    }
    text.split_once('x')
        .and_then(|(columns, rows)| Some((columns.parse().ok()?, rows.parse().ok()?)))
        .map(|cells| GridOption(Some(cells)))
        .ok_or_else(|| "two numbers such as 20x20, or `none`".to_owned())
}

/// Runs a scene and writes its record and, if asked for, its picture. Exit code 1 if an expectation is missed.
pub(super) fn run(options: &RunOptions) -> Result<ExitCode, CommandError> {
    let mut scenario = library::open(&options.scene)?;
    options.change(&mut scenario.scene)?;
    let (scene, title) = (&scenario.scene, &scenario.title);
    if !options.quiet
        && let Some(note) = cue_note(scene)
    {
        say(&note);
    }
    if scene.solver.is_crowd() {
        if options.out.is_some() || options.picture.is_some() {
            return Err(CommandError::Usage(
                "--out and --picture: a crowd is counted, not written down ball by ball".to_owned(),
            ));
        }
        return crowd::run(&options.scene, title, scene, options.quiet);
    }
    let record = simulate(scene)?;
    let outcomes = scenario.judge(&record);
    let expected: Vec<Expected> = outcomes.iter().map(told).collect();
    let written = |out: &mut dyn std::io::Write| {
        record_file::write_judged(out, &options.scene, title, scene, &record, &expected)
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
    if let Some(path) = &options.picture {
        to_file(path, picture::draw(title, scene, &record).as_bytes())?;
    }
    if !options.quiet {
        let summary = record_file::Summary::of(&options.scene, title, scene, &record);
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

impl RunOptions {
    /// Changes a scene to what the options say.
    fn change(&self, scene: &mut Scene) -> Result<(), CommandError> {
        if let Some(name) = &self.preset {
            let shot = scene.shot;
            if !preset::open(name)?.equipment.take_over(scene) {
                return Err(CommandError::Usage(format!(
                    "--preset {name}: the balls of the scene have no room there"
                )));
            }
            scene.shot = shot;
        }
        match (self.solver, scene.solver) {
            (Some(SolverName::Exact), _) => scene.solver = Solver::Exact,
            (Some(SolverName::Stepped), Solver::Exact) => {
                scene.solver = Solver::Stepped(Stepped::default());
            }
            _ => {}
        }
        if let Some(time_limit) = self.time_limit {
            scene.time_limit = time_limit;
        }
        if self.tick.is_some() || self.grid.is_some() {
            let Solver::Stepped(stepped) = &mut scene.solver else {
                return Err(CommandError::Usage(
                    "--tick and --grid belong to the stepped solver; add --solver stepped"
                        .to_owned(),
                ));
            };
            stepped.tick = self.tick.unwrap_or(stepped.tick);
            if let Some(GridOption(cells)) = self.grid {
                stepped.grid = cells;
            }
        }
        scene.check()?;
        Ok(())
    }
}
