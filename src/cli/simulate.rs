//! The one place where a scene meets the solver it asks for.

use crate::cli::CommandError;
use crate::physics::ball::State;
use crate::physics::record::Record;
use crate::physics::scene::{Scene, Solver};
use crate::sim::stepping;

/// What happened, and where each ball was at which time in s.
pub(super) struct Run {
    pub(super) record: Record,
    pub(super) trails: Vec<Vec<(f64, State)>>,
}

/// Runs a scene until it rests or its time is over.
pub(super) fn simulate(scene: &Scene) -> Result<Run, CommandError> {
    match scene.solver {
        Solver::Stepped(_) => {
            let (record, recorder) = stepping::try_run_to_rest(scene).map_err(|failed| {
                CommandError::Unfinished(format!(
                    "the solver stopped at {} s: ball `{}`: {}",
                    failed.time,
                    scene.balls.get(failed.ball).map_or("", |ball| &ball.name),
                    failed.reason
                ))
            })?;
            Ok(Run {
                record,
                trails: recorder.trails,
            })
        }
        Solver::Exact => Err(CommandError::Usage(
            "solver: `exact` is not part of this version; use `--solver stepped`".to_owned(),
        )),
    }
}
