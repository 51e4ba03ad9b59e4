//! `masse sweep`.

use std::fs::File;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};

use crate::cli::scene_options::SceneOptions;
use crate::cli::{CommandError, say, to_stdout};
use crate::scenarios::file::Scenario;
use crate::scenarios::sweep::{Axis, AxisError, Sweep};

/// What to play, and what varies.
#[derive(Args, Debug)]
#[command(after_long_help = "NUMBERS\n  \
    heading, speed, side, height, elevation      of the stroke: degrees, m/s, radii\n  \
    balls.NAME.x, .z, .mass, .radius             of a ball: m, kg\n  \
    laws.motion.sliding, cue.mass, ...           of the laws, the cue, the table: `masse laws` names those of every law\n\n\
    VALUES\n  \
    speed=1:7:100    100 values from 1 to 7      speed=1,2,4    these\n  \
    speed=1:7        any from 1 to 7             speed=2+-0.1   normally about 2; both need --shots\n\n\
    COLUMNS\n  \
    shot, a column for each number, reason (rest, time_limit, ..., or why it was refused), time in s, hits of balls, of\n  \
    cushions; where the scene expects something met, and found_1, found_2, ... what was found; of every ball x and z at\n  \
    the end in m, and its fate: table, off, or the pocket. What else is to be measured - a speed, an angle, a gap, a\n  \
    height, a way at any moment - is an expectation in the scene file.\n\n\
    EXAMPLES\n  \
    masse sweep stun-shot --over speed=0.5:6:100 --over height=-0.4:0.4:100 --out stun.csv\n  \
    masse sweep butterfly --over heading=0+-0.5 --over speed=7.94+-0.2 --shots 10000 --out butterfly.csv\n  \
    masse sweep throw --over laws.ball_ball.restitution=0.9:1:11 --solver stepped --tick 0.002")]
pub(super) struct SweepOptions {
    #[command(flatten)]
    what: SceneOptions,
    /// A number and its values, such as speed=1:7:100; may be given several times, the last varies fastest
    #[arg(long, value_name = "NAME=VALUES", required = true)]
    over: Vec<String>,
    /// Play so many shots with values at random, instead of every value with every other
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    shots: Option<u64>,
    /// Where the random numbers begin
    #[arg(long, default_value_t = 1, requires = "shots")]
    seed: u64,
    /// Threads; without it one for each processor. They change nothing but the time
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
    /// The CSV file to write, instead of the standard output
    #[arg(long, value_name = "FILE.csv")]
    out: Option<PathBuf>,
}

impl SweepOptions {
    fn sweep<'s>(&self, scenario: &'s Scenario) -> Result<Sweep<'s>, AxisError> {
        let axes = self
            .over
            .iter()
            .map(|text| Axis::parse(text, &scenario.scene));
        let axes = axes.collect::<Result<_, _>>()?;
        match self.shots {
            Some(shots) => Sweep::random(scenario, axes, shots, self.seed),
            None => Sweep::grid(scenario, axes),
        }
    }
}

/// Plays the sweep and writes its table. What cannot be played has a row that says why.
pub(super) fn run(options: &SweepOptions) -> Result<ExitCode, CommandError> {
    let scenario = options.what.open()?;
    if scenario.scene.solver.is_crowd() {
        return Err(CommandError::Usage(format!(
            "{}: a crowd is counted and not recorded, so that its shots have no rows",
            options.what.scene
        )));
    }
    let sweep = options
        .sweep(&scenario)
        .map_err(|error| CommandError::Usage(format!("--over {error}")))?
        .on_threads(options.threads.unwrap_or(0))
        .map_err(|error| CommandError::Usage(format!("--threads: {error}")))?;
    let bar = ProgressBar::new(sweep.shots());
    let style = "{elapsed_precise} {bar:40} {pos} of {len} shots, {per_sec}, {eta} to go";
    if let Ok(style) = ProgressStyle::with_template(style) {
        bar.set_style(style);
    }
    let begun = Instant::now();
    let mut refused = 0;
    let mut write = |out: &mut dyn Write| -> io::Result<()> {
        refused = sweep.write(out, |done| bar.set_position(done))?;
        Ok(())
    };
    match &options.out {
        Some(path) => File::create(path)
            .and_then(|mut file| write(&mut file))
            .map_err(|source| CommandError::Write {
                to: path.display().to_string(),
                source,
            })?,
        None => to_stdout(write)?,
    }
    bar.finish_and_clear();
    let seconds = begun.elapsed().as_secs_f64();
    let shots = sweep.shots();
    say(&format!(
        "masse: {shots} shots in {seconds:.1} s, {:.0} a second{}",
        shots as f64 / seconds,
        match refused {
            0 => String::new(),
            _ => format!("; {refused} cannot be played: their rows say why"),
        }
    ));
    Ok(ExitCode::SUCCESS)
}
