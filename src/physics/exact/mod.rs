//! The event-driven solver: every event at its own time.
//!
//! Between events each ball follows a closed-form [`Piece`](crate::physics::laws::motion::Piece). The engine finds the
//! earliest contact, capture or change of motion, applies one law, and looks again for the balls that it touched; nothing
//! else is computed. There is no step: the states between events are read off the pieces, so that a table can be
//! advanced by any amounts of time with the same bits.
//!
//! Bookkeeping after event-driven molecular dynamics: each ball keeps one next event, found when its path last changed;
//! events whose partner has changed since are noticed when they come up (lazy invalidation by counters); the earliest of
//! all comes from a tournament; neighbours come from cells where there are many balls. Sources: Rapaport, J. Comput.
//! Phys. 34 (1980) 184; Lubachevsky, J. Comput. Phys. 94 (1991) 255; Marín, Risso & Cordero, J. Comput. Phys. 109 (1993)
//! 306. Touching bodies are resolved together by [`crate::physics::laws::cluster`].
//!
//! **Lasting contact.** A ball that is pressed against a cushion or another ball touches it once every
//! [`CONTACT_TIME`](crate::physics::laws::cluster::CONTACT_TIME) at most, by the rules of
//! [`Cluster::collide`](crate::physics::laws::cluster::Cluster::collide); the pair is then in [`Contact::Resting`].
//!
//! **How long it is the truth.** A direction error grows by d / (2R cos c) − 1 a hit over a distance d at cut c: about 3 at
//! 0.2 m, 19 at 1 m, half a digit to a digit and a half. The 16 digits of f64 last some 12 long hits, or 60 to 100
//! collisions of a break; after that the result is one of the possible ones, still with the same bits every time.

mod air;
mod alone;
mod cells;
mod engine;
mod flight;
mod gather;
mod impact;
mod lay_out;
mod predict;
mod queue;
mod recorder;
mod saved;
mod step;
mod walls;
mod wedged;

pub use engine::Engine;
pub use recorder::{Recorder, Watch};
pub use saved::Saved;

use thiserror::Error;

use crate::physics::ball::State;
use crate::physics::record::{EndReason, Record};
use crate::physics::roots::RootError;
use crate::physics::scene::{Scene, SceneError};

/// When to give up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Events in one scene.
    pub events: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { events: 1_000_000 }
    }
}

/// How a ball is in touch with something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contact {
    /// It touches nothing for longer than an impact.
    Free,
    /// It leans on another ball.
    Resting {
        /// Index of the other ball.
        on: usize,
    },
    /// It leans on a cushion.
    RestingOnCushion {
        /// Index of the cushion.
        cushion: usize,
    },
    /// It leans on the edge or the wall of a pocket.
    RestingInPocket {
        /// Index of the pocket.
        pocket: usize,
    },
}

/// Why a scene cannot be advanced.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SolveError {
    /// The scene itself is unplayable.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The motion law has no closed form.
    #[error("laws.motion: the exact solver needs a law with a closed form; use the stepped solver")]
    NotClosedForm,
    /// Two bodies are inside each other.
    #[error("at {time} s ball `{ball}` is {overlap} m inside {other}")]
    Overlap {
        /// The ball.
        ball: String,
        /// The other ball or the cushion.
        other: String,
        /// When, s.
        time: f64,
        /// How deep, m.
        overlap: f64,
    },
    /// A number is not finite.
    #[error("at {time} s the state of ball `{ball}` is not finite: {state:?}")]
    NotFinite {
        /// The ball.
        ball: String,
        /// When, s.
        time: f64,
        /// Its state.
        state: State,
    },
    /// A contact time could not be computed.
    #[error("at {time} s, ball `{ball}`: {source}")]
    Root {
        /// The ball.
        ball: String,
        /// When, s.
        time: f64,
        /// The polynomial.
        source: RootError,
    },
    /// Too many events.
    #[error(
        "{events} events by {time} s, the last of them at ball `{ball}`: more than the limit allows"
    )]
    EventLimit {
        /// Events so far.
        events: u64,
        /// When, s.
        time: f64,
        /// The ball of the last event.
        ball: String,
    },
    /// What was saved does not fit together.
    #[error("a saved table does not fit: ball `{ball}`: {what}")]
    Saved {
        /// The ball; empty if it is no one's.
        ball: String,
        /// What does not fit.
        what: String,
    },
    /// There is no such ball.
    #[error("there is no ball number {ball}, the table has {count}")]
    NoSuchBall {
        /// Index asked for.
        ball: usize,
        /// Balls on the table.
        count: usize,
    },
}

/// Plays a scene with its shot to the end: until rest, until nothing can happen any more, or to its time limit.
///
/// # Errors
/// [`SolveError`] if the scene is unplayable or cannot be advanced.
pub fn solve(scene: &Scene, limits: Limits) -> Result<Record, SolveError> {
    scene.check()?;
    let mut engine = Engine::new(scene, limits)?;
    let mut recorder = Recorder::new(&engine);
    play(&mut engine, scene, &mut recorder)?;
    Ok(recorder.into_record())
}

/// Plays the shot of a scene that has just been loaded, as [`solve`] does, into a recorder that has just begun.
///
/// # Errors
/// [`SolveError`] if the scene cannot be advanced; the engine is then of no further use.
pub fn play<'r>(
    engine: &mut Engine,
    scene: &Scene,
    recorder: &'r mut Recorder,
) -> Result<&'r Record, SolveError> {
    if let Some(planned) = &scene.shot {
        engine.strike(planned.ball, &scene.cue, &planned.shot, recorder)?;
    }
    engine.advance(scene.time_limit, recorder)?;
    let reason = if engine.is_at_rest() {
        EndReason::Rest
    } else if engine.next_time().is_none() {
        EndReason::Quiet
    } else {
        EndReason::TimeLimit
    };
    let end_time = match reason {
        EndReason::Rest => engine.last_event_time(),
        _ => engine.time(),
    };
    Ok(recorder.end(engine, end_time, reason))
}
