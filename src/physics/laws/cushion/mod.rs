//! Impact of a ball and a cushion.

mod han_2005;
mod mirror;
mod stronge_2018;

pub use han_2005::Han2005;
pub use mirror::Mirror;
pub use stronge_2018::{Inclination, Stronge2018};

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::{Check, Parameter};
use crate::physics::table::{Cushion, Nose};

/// What is known of the restitution of a cushion.
const RESTITUTION: &str = "above 1 a rebound would make energy; 0.6 to 0.9 measured, Alciatore, physical properties, and \
                           0.98 of the rubber alone, Mathavan 2010";
/// What is known of the friction of a cushion.
const FRICTION: &str = "dry friction; 0.14 measured, Mathavan 2010, 0.2 to 0.5 by angle, Han 2005";

/// The geometry of one rebound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CushionContact {
    /// Horizontal unit vector from the cushion to the ball.
    pub normal: DVec3,
    /// Height of the nose above the slate in m.
    pub nose_height: f64,
    /// Profile of the nose.
    pub nose: Nose,
    /// Restitution to use instead of the law's own, for a contact that is coming to rest.
    pub restitution: Option<f64>,
}

impl CushionContact {
    /// Sine of the angle by which the line from the centre of a ball on the slate to the nose rises: h/R − 1 for a
    /// sharp nose.
    #[must_use]
    pub fn sine(&self, ball: &Ball) -> f64 {
        self.nose.sine(self.nose_height, ball.radius, ball.radius)
    }

    /// Unit vector in space from the nose to the centre of a ball, at the height at which it is.
    #[must_use]
    pub fn normal_in_space(&self, ball: &Ball, state: &State) -> DVec3 {
        let height = state.position.y;
        self.nose
            .normal(self.normal, self.nose_height, ball.radius, height)
    }
}

/// Velocities after a rebound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rebound {
    /// The ball.
    pub state: State,
    /// Impulse in N s along the horizontal normal.
    pub impulse: f64,
}

/// How a cushion throws a ball back.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum CushionLaw {
    /// The normal velocity turns round, scaled by the restitution; all else stays.
    Mirror(Mirror),
    /// Han's rigid impact at the height of the nose, with friction.
    Han2005(Han2005),
    /// Stronge's compliant impact, with tangential give.
    Stronge2018(Stronge2018),
}

impl CushionLaw {
    /// One of each registered law, with its default parameters.
    #[must_use]
    pub fn all() -> Vec<Self> {
        vec![
            Self::Mirror(Mirror::default()),
            Self::Han2005(Han2005::default()),
            Self::Stronge2018(Stronge2018::default()),
        ]
    }

    /// Velocities after the rebound; position and motion label are left as they are. A ball that leaves the cushion
    /// is returned unchanged.
    #[must_use]
    pub fn rebound(&self, ball: &Ball, state: &State, contact: &CushionContact) -> Rebound {
        if state.velocity.dot(contact.normal) >= 0.0 {
            return Rebound {
                state: *state,
                impulse: 0.0,
            };
        }
        let mut after = match self {
            Self::Mirror(law) => law.rebound(state, contact),
            Self::Han2005(law) if ball.spins => law.rebound(ball, state, contact),
            Self::Stronge2018(law) if ball.spins => law.rebound(ball, state, contact),
            Self::Han2005(_) | Self::Stronge2018(_) => Mirror {
                restitution: self.restitution(),
            }
            .rebound(state, contact),
        };
        // An inclined impact that gives back little, or rubs the ball downwards, leaves it wedged between nose and slate
        // and still on its way in; the slate, which no cushion law knows, then takes up the rest.
        let inward = after.velocity.dot(contact.normal).min(0.0);
        after.velocity -= inward * contact.normal;
        Rebound {
            state: after,
            impulse: ball.mass * (after.velocity - state.velocity).dot(contact.normal),
        }
    }

    /// The law's own restitution.
    #[must_use]
    pub fn restitution(&self) -> f64 {
        match self {
            Self::Mirror(law) => law.restitution,
            Self::Han2005(law) => law.restitution,
            Self::Stronge2018(law) => law.restitution,
        }
    }

    /// The height in m to give to [`CushionContact`] for this stretch of cushion of a table with this nose height.
    #[must_use]
    pub fn nose_height(&self, height: f64, ball: &Ball, cushion: &Cushion) -> f64 {
        match self {
            Self::Stronge2018(law) => law.nose_height(height, ball, cushion),
            Self::Mirror(_) | Self::Han2005(_) => height,
        }
    }
}

impl Check for CushionLaw {
    fn parameters(&self) -> Vec<Parameter> {
        match self {
            Self::Mirror(law) => law.parameters(),
            Self::Han2005(law) => law.parameters(),
            Self::Stronge2018(law) => law.parameters(),
        }
    }
}
