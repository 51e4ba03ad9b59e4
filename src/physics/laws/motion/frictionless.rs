//! A table without cloth: Newton's first law. There is no gravity, and nothing leaves the plane.

use crate::physics::ball::{Motion, State};
use crate::physics::laws::motion::Piece;
use crate::physics::laws::source::Source;

/// Where the law comes from.
pub(super) const SOURCE: Source = Source {
    paper: "Newton's first law",
    formula: "a = 0",
    leaves_out: "cloth, gravity, flight",
};

pub(super) fn piece(state: &State) -> Piece {
    Piece::uniform(*state)
}

pub(super) fn classify(mut state: State) -> State {
    state.velocity.y = 0.0;
    state.motion = if state.velocity != glam::DVec3::ZERO {
        Motion::Gliding
    } else if state.angular_velocity != glam::DVec3::ZERO {
        Motion::Spinning
    } else {
        Motion::Rest
    };
    state
}
