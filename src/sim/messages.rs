//! What the simulation hears and says.

use bevy::prelude::*;

use crate::physics::cue::Shot;
use crate::physics::record::{Event, PathPiece};
use crate::physics::scene::Scene;

/// Lay out this scene in place of the present one.
#[derive(Message, Clone, Debug)]
pub struct LoadScene(pub Scene);

/// Balls have been moved or pushed from outside: the shot begins anew with all components as they are. A ball that is spawned
/// or despawned does the same without being asked.
#[derive(Message, Clone, Copy, Debug, PartialEq, Eq)]
pub struct Restart;

/// Strike this ball. Ignored while balls move.
#[derive(Message, Clone, Copy, Debug, PartialEq)]
pub struct Strike {
    /// Index of the ball in the scene.
    pub ball: usize,
    /// The stroke.
    pub shot: Shot,
}

/// The cue has struck a ball.
#[derive(Message, Clone, Copy, Debug, PartialEq)]
pub struct Struck(pub Event);

/// Two balls, or a ball and a cushion, have touched. The event carries the impulse and the states.
#[derive(Message, Clone, Copy, Debug, PartialEq)]
pub struct Touched(pub Event);

/// A pocket has taken a ball.
#[derive(Message, Clone, Copy, Debug, PartialEq)]
pub struct Pocketed(pub Event);

/// A ball has changed its kind of motion on its own.
#[derive(Message, Clone, Copy, Debug, PartialEq)]
pub struct MotionChanged(pub Event);

/// A ball has turned into a new piece of path.
#[derive(Message, Clone, Copy, Debug, PartialEq)]
pub struct PathTurned {
    /// Index of the ball in the scene.
    pub ball: usize,
    /// The piece and the time at which it begins.
    pub piece: PathPiece,
}

/// The last moving ball has come to rest.
#[derive(Message, Clone, Copy, Debug, PartialEq)]
pub struct AtRest {
    /// Seconds since the scene began.
    pub time: f64,
}

/// The solver could not follow a ball any further; the clock stands.
#[derive(Message, Clone, Debug, PartialEq)]
pub struct Failed {
    /// Seconds since the shot began.
    pub time: f64,
    /// What went wrong, with names and numbers.
    pub reason: String,
}

pub(super) fn plugin(app: &mut App) {
    app.add_message::<LoadScene>()
        .add_message::<Restart>()
        .add_message::<Strike>()
        .add_message::<Struck>()
        .add_message::<Touched>()
        .add_message::<Pocketed>()
        .add_message::<MotionChanged>()
        .add_message::<PathTurned>()
        .add_message::<AtRest>()
        .add_message::<Failed>();
}
