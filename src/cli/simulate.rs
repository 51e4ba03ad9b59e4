//! The one place where a scene meets the solver it asks for.

use crate::cli::CommandError;
use crate::physics::exact;
use crate::physics::record::Record;
use crate::physics::scene::{Scene, Solver};
use crate::sim::stepping;

/// Runs a scene until it rests or its time is over.
pub(super) fn simulate(scene: &Scene) -> Result<Record, CommandError> {
    let stopped = |reason: String| CommandError::Unfinished(format!("the solver stopped {reason}"));
    match scene.solver {
        Solver::Stepped(_) => stepping::try_run_to_rest(scene)
            .map(|(record, _)| record)
            .map_err(|failed| stopped(format!("at {} s: {}", failed.time, failed.reason))),
        Solver::Exact => exact::solve(scene, exact::Limits::default())
            .map_err(|error| stopped(error.to_string())),
    }
}
