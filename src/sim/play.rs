//! A whole scene at once, by the solver that it names: what the command line, the judges, sweeps and the second picture share.

use thiserror::Error;

use crate::physics::exact::{self, Limits, SolveError};
use crate::physics::record::Record;
use crate::physics::scene::{Scene, Solver};
use crate::sim::messages::Failed;
use crate::sim::stepping;

/// Why a scene could not be played to its end.
#[derive(Clone, Debug, Error)]
pub enum Stopped {
    /// By the exact solver.
    #[error("the exact solver stopped: {0}")]
    Exact(#[from] SolveError),
    /// By the stepped solver.
    #[error("the stepped solver stopped at {} s: {}", .0.time, .0.reason)]
    Stepped(Failed),
}

/// Plays a scene until every ball rests or its time limit is over.
///
/// ```
/// use masse::scenarios::library;
/// use masse::sim::play::play;
///
/// let scene = library::open("draw-back")?.scene;
/// let cue = scene.ball_named("cue").expect("a cue ball");
/// let record = play(&scene)?;
/// for event in &record.events {
///     println!("{:.3} s {:?}", event.time, event.kind);
/// }
/// // Between events every ball follows a closed form: any time will do.
/// let state = record.state_at(cue, 0.5);
/// assert!(state.position.is_finite() && record.end_time > 0.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Stopped`] with what the solver says if it cannot go on, or does not play such a scene at all.
pub fn play(scene: &Scene) -> Result<Record, Stopped> {
    match scene.solver {
        Solver::Exact => Ok(exact::solve(scene, Limits::default())?),
        Solver::Stepped(_) => stepping::try_run_to_rest(scene)
            .map(|(record, _)| record)
            .map_err(Stopped::Stepped),
    }
}
