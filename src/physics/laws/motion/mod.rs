//! Free motion between two impacts, in closed form.
//!
//! Every law cuts the path of a ball into [`Piece`]s with constant acceleration. Both solvers, the aim
//! preview and the replay walk the same pieces.

mod coulomb;
mod frictionless;
mod incline;
mod piece;

pub use coulomb::Cloth;
pub use incline::Incline;
pub use piece::Piece;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::coursework::{self, Coursework};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// How a ball moves when nothing but the table acts on it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum MotionLaw {
    /// No cloth: straight lines at constant speed for ever.
    Frictionless,
    /// No cloth, and the table tilted: the same constant acceleration for every ball.
    Inclined(Incline),
    /// Coulomb friction between ball and cloth: slide, roll, spin, rest.
    Coulomb(Cloth),
    /// The linear drag of the coursework report; stepped solver only.
    Coursework(Coursework),
}

impl MotionLaw {
    /// One of each registered law, with its default parameters.
    #[must_use]
    pub fn all() -> Vec<Self> {
        vec![
            Self::Frictionless,
            Self::Inclined(Incline::default()),
            Self::Coulomb(Cloth::default()),
            Self::Coursework(Coursework::default()),
        ]
    }

    /// Where the law comes from.
    #[must_use]
    pub fn source(&self) -> Source {
        match self {
            Self::Frictionless => frictionless::SOURCE,
            Self::Inclined(_) => incline::SOURCE,
            Self::Coulomb(_) => coulomb::SOURCE,
            Self::Coursework(_) => coursework::SOURCE,
        }
    }

    /// Whether the law has a closed form, so that the exact solver can use it.
    #[must_use]
    pub fn is_closed_form(&self) -> bool {
        !matches!(self, Self::Coursework(_))
    }

    /// Gravity in m/s², if the law knows any: without it nothing flies.
    #[must_use]
    pub fn gravity(&self) -> Option<f64> {
        match self {
            Self::Coulomb(cloth) => Some(cloth.gravity),
            Self::Frictionless | Self::Inclined(_) | Self::Coursework(_) => None,
        }
    }

    /// Acceleration in m/s² that the law gives every ball on the slate, however it moves.
    #[must_use]
    pub fn pull(&self) -> DVec3 {
        match self {
            Self::Inclined(incline) => incline.pull(),
            Self::Frictionless | Self::Coulomb(_) | Self::Coursework(_) => DVec3::ZERO,
        }
    }

    /// Potential energy in J, from the middle of the slate.
    #[must_use]
    pub fn potential(&self, ball: &Ball, state: &State) -> f64 {
        let height = state.position.y - ball.radius;
        let along = self.pull().dot(state.position);
        ball.mass * (self.gravity().unwrap_or(0.0) * height - along)
    }

    /// The closed-form piece that starts with this state. For the coursework model, which has no closed
    /// form, the piece is the straight line of one tick; its friction comes after the tick.
    #[must_use]
    pub fn piece(&self, ball: &Ball, state: &State) -> Piece {
        match self {
            Self::Coulomb(cloth) => coulomb::piece(cloth, ball, state),
            Self::Inclined(incline) => incline::piece(incline, state),
            Self::Frictionless | Self::Coursework(_) => frictionless::piece(state),
        }
    }

    /// The state with the motion label that its velocities deserve. Call it after every impulse.
    #[must_use]
    pub fn classify(&self, ball: &Ball, state: State) -> State {
        if !state.motion.in_play() {
            return state;
        }
        match self {
            Self::Coulomb(_) => coulomb::classify(ball, state),
            Self::Inclined(incline) => incline::classify(incline, state),
            Self::Frictionless | Self::Coursework(_) => frictionless::classify(state),
        }
    }

    /// The state `time` seconds later if nothing is met on the way.
    #[must_use]
    pub fn advance(&self, ball: &Ball, state: &State, time: f64) -> State {
        let mut piece = self.piece(ball, state);
        let mut left = time;
        // A path has at most four pieces: slide, roll, spin, rest. The moment of a change belongs to the next one.
        while piece.duration <= left {
            left -= piece.duration;
            piece = self.piece(ball, &piece.end(ball));
        }
        piece.at(left)
    }
}

impl Check for MotionLaw {
    fn parameters(&self) -> Vec<Parameter> {
        match self {
            Self::Frictionless => Vec::new(),
            Self::Inclined(incline) => incline.parameters(),
            Self::Coulomb(cloth) => cloth.parameters(),
            Self::Coursework(coursework) => coursework.parameters(),
        }
    }
}
