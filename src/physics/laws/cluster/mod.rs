//! Impacts of several touching bodies at one instant: racks, cradles, corners, balls frozen to each other or to a cushion.

mod borne;
mod complementarity;
mod energy;
mod friction;
mod lasting;
mod smith_2012;
mod touching;
mod wedged;

pub use lasting::{CONTACT_TIME, LEAN, Other, SLOW, Touched, put_off};
pub use smith_2012::{Cluster, ROUNDS};
pub use touching::{DEEP, How, Inside, inside, leans, leans_inside, reach_of};

use glam::DVec3;

use crate::physics::ball::{Ball, State};
use crate::physics::table::Nose;

/// Balls closer than this in m touch: rounding of positions written in a file.
pub const TOUCH: f64 = 1e-9;

/// Contacts that close more slowly than this in m/s are settled without a rebound.
pub const STILL: f64 = 1e-11;

/// A contact that is held back leaves at this speed in m/s: far below anything that can be seen, far above rounding.
pub const PART: f64 = 1e-12;

/// What a ball touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Against {
    /// Another ball of the cluster.
    Ball {
        /// Its place in the cluster.
        member: usize,
    },
    /// A cushion.
    Cushion {
        /// Its index in the table.
        cushion: usize,
    },
    /// The rounded edge of a pocket.
    Rim {
        /// Index of the pocket in the table.
        pocket: usize,
    },
    /// The wall of a pocket below its edge, or its liner above.
    Wall {
        /// Index of the pocket in the table.
        pocket: usize,
    },
}

impl Against {
    /// The place of the other ball in the cluster, if it is a ball.
    #[must_use]
    pub fn member(self) -> Option<usize> {
        match self {
            Self::Ball { member } => Some(member),
            Self::Cushion { .. } | Self::Rim { .. } | Self::Wall { .. } => None,
        }
    }
}

/// One contact of a cluster.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touching {
    /// Place of the ball in the cluster.
    pub first: usize,
    /// What it touches.
    pub against: Against,
    /// Unit vector from the ball to what it touches; horizontal for balls on the slate.
    pub normal: DVec3,
    /// For a cushion the horizontal unit vector from the nose to the ball, for a pocket that to its middle.
    pub away: DVec3,
    /// How hollow a pocket is in 1/m: what the square of the speed along it is to be multiplied with for the acceleration at
    /// which it closes; 0 for all else.
    pub hollow: f64,
    /// Height of the nose in m, for a cushion.
    pub nose_height: f64,
    /// Profile of the nose.
    pub nose: Nose,
    /// Restitution in place of the law's own.
    pub restitution: Option<f64>,
    /// Normal impulse in N s that has passed so far.
    pub impulse: f64,
}

/// A ball of a cluster.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Member {
    /// Index of the ball in the scene.
    pub ball: usize,
    /// Its constants.
    pub body: Ball,
    /// How it moves.
    pub state: State,
}

/// How a cluster is resolved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blow {
    /// Contacts are short: each rebounds by the law of its own.
    Impact,
    /// The cue pushes for about 1 ms, four times as long as balls touch: what is frozen to the struck ball moves off
    /// with it, and nothing rebounds. So a frozen pair leaves at tan θ = 2 tan φ (Alciatore, TP A.15).
    Stroke,
}
