//! `masse solve`.

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};

use crate::cli::{CommandError, say, to_file, to_stdout};
use crate::scenarios::search::{self, Plan, Watch};
use crate::scenarios::{file, library};
use crate::sim::play::play;

/// What to search, and how.
#[derive(Args, Debug)]
pub(super) struct SolveOptions {
    /// A scene file that says with `free` what may change, and with `expect` what is wanted
    scene: String,
    /// Where the random numbers begin; the same seed gives the same result on any number of threads
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Shots after which the search ends if it has found nothing
    #[arg(long, default_value_t = Plan::default().shots)]
    shots: u64,
    /// Threads; without it one for each processor
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
    /// The scene file to write, instead of the standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

struct Bar(ProgressBar);

impl Watch for Bar {
    fn played(&self, shots: u64) {
        self.0.set_position(shots);
    }

    fn round(&self, best: f64) {
        self.0.set_message(format!("best miss {best:.4}"));
    }
}

/// Searches, and writes the best scene. Exit code 1 if it misses an expectation.
pub(super) fn run(options: &SolveOptions) -> Result<ExitCode, CommandError> {
    let scenario = library::open(&options.scene)?;
    let plan = Plan {
        seed: options.seed,
        shots: options.shots,
    };
    let bar = ProgressBar::new(options.shots);
    let style = "{elapsed_precise} {bar:40} {pos} of at most {len} shots, {per_sec}, {msg}";
    if let Ok(style) = ProgressStyle::with_template(style) {
        bar.set_style(style);
    }
    let bar = Bar(bar);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(options.threads.unwrap_or(0))
        .build()
        .map_err(|error| CommandError::Usage(format!("--threads: {error}")))?;
    let begun = Instant::now();
    let found = pool.install(|| search::solve(&scenario, plan, &bar));
    bar.0.finish_and_clear();
    let found =
        found.map_err(|error| CommandError::Usage(format!("{}: {error}", options.scene)))?;
    let seconds = begun.elapsed().as_secs_f64();
    say(&format!(
        "masse: {} shots in {seconds:.1} s, {:.0} a second; {:.0} % of strokes with errors succeed",
        found.shots,
        found.shots as f64 / seconds,
        100.0 * found.robustness
    ));
    for (free, value) in scenario.free.iter().zip(&found.values) {
        let (label, unit) = free.label();
        say(&format!("  {label}: {value} {unit}"));
    }
    let record = play(&found.scenario.scene)?;
    let outcomes = found.scenario.judge(&record);
    for outcome in &outcomes {
        say(&format!("  {}", outcome.sentence()));
    }
    let text = file::write(&found.scenario)?;
    match &options.out {
        Some(path) => to_file(path, text.as_bytes())?,
        None => to_stdout(|out| out.write_all(text.as_bytes()))?,
    }
    if outcomes.iter().all(|outcome| outcome.met) {
        return Ok(ExitCode::SUCCESS);
    }
    say(
        "masse: the best shot found misses an expectation; try more --shots, another --seed, or wider ranges",
    );
    Ok(ExitCode::from(1))
}
