//! A smooth incline: a table without cloth that is tilted.
//!
//! Gravity has a component along the slate, g sin θ for a slope of θ, the same for every ball: paths are parabolas, and
//! two balls see each other on straight lines (Galilei, Discorsi, third day). Nothing turns the balls and nothing slows
//! them; what presses them on the slate does no work.
//!
//! On cloth a sphere that rolls gains 5/7 of it, but one that slips is pulled by friction along a slip whose direction the
//! slope keeps turning: its path is no parabola, and no law here has that. So a tilted table has no cloth.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::State;
use crate::physics::laws::motion::{Piece, frictionless};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// Where the law comes from.
pub(super) const SOURCE: Source = Source {
    paper: "Galilei, Discorsi, third day",
    formula: "a = g sin θ along the slope",
    leaves_out: "cloth, flight",
};

/// How far a table without cloth is tilted: the part of gravity along the slate. One degree of slope is 0.171 m/s².
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Incline {
    /// Acceleration along x, m/s²: positive where the foot end is low.
    #[serde(default)]
    pub x: f64,
    /// Acceleration along z, m/s²: positive where the right side, as seen from the head, is low.
    #[serde(default)]
    pub z: f64,
}

impl Default for Incline {
    /// Three degrees down to the foot.
    fn default() -> Self {
        Self { x: 0.5, z: 0.0 }
    }
}

impl Incline {
    /// Acceleration of every ball, m/s².
    #[must_use]
    pub fn pull(&self) -> DVec3 {
        DVec3::new(self.x, 0.0, self.z)
    }
}

impl Check for Incline {
    fn parameters(&self) -> Vec<Parameter> {
        let along = |field, value| {
            Parameter::new(field, value, -10.0, 10.0)
                .basis("m/s²; g sin θ, 9.81 on a table that stands upright")
        };
        vec![along("x", self.x), along("z", self.z)]
    }
}

pub(super) fn piece(incline: &Incline, state: &State) -> Piece {
    let mut piece = Piece::uniform(*state);
    if state.motion.translates() {
        piece.acceleration = incline.pull();
    }
    piece
}

/// Nothing rests on a slope.
pub(super) fn classify(incline: &Incline, state: State) -> State {
    let mut state = frictionless::classify(state);
    if incline.pull() != DVec3::ZERO {
        state.motion = crate::physics::ball::Motion::Gliding;
    }
    state
}
