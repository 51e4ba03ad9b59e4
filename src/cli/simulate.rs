//! The one place where a scene meets the solver it asks for.

use crate::cli::CommandError;
use crate::physics::ball::State;
use crate::physics::exact;
use crate::physics::record::Record;
use crate::physics::scene::{Scene, Solver};
use crate::sim::stepping;

/// What happened, and where each ball was at which time in s.
pub(super) struct Run {
    pub(super) record: Record,
    pub(super) trails: Vec<Vec<(f64, State)>>,
}

/// Seconds between the points of a trail that the exact solver, which has no tick, is drawn with.
const SAMPLE: f64 = 1.0 / 240.0;

/// Runs a scene until it rests or its time is over.
pub(super) fn simulate(scene: &Scene) -> Result<Run, CommandError> {
    let stopped = |reason: String| CommandError::Unfinished(format!("the solver stopped {reason}"));
    match scene.solver {
        Solver::Stepped(_) => {
            let (record, recorder) = stepping::try_run_to_rest(scene)
                .map_err(|failed| stopped(format!("at {} s: {}", failed.time, failed.reason)))?;
            Ok(Run {
                record,
                trails: recorder.trails,
            })
        }
        Solver::Exact => {
            let record = exact::solve(scene, exact::Limits::default())
                .map_err(|error| stopped(error.to_string()))?;
            let trails = trails(&record);
            Ok(Run { record, trails })
        }
    }
}

/// The path of each ball: a point at every turn, and between them while it moves.
fn trails(record: &Record) -> Vec<Vec<(f64, State)>> {
    let end = (record.end_time / SAMPLE).ceil() as u32;
    let mut trails: Vec<Vec<(f64, State)>> = record
        .paths
        .iter()
        .map(|path| {
            path.iter()
                .map(|turn| (turn.time, turn.piece.start))
                .collect()
        })
        .collect();
    for (ball, trail) in trails.iter_mut().enumerate() {
        for sample in 0..=end {
            let time = (f64::from(sample) * SAMPLE).min(record.end_time);
            let state = record.state_at(ball, time);
            if state.motion.translates() || sample == end {
                trail.push((time, state));
            }
        }
        trail.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    trails
}
