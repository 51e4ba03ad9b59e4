//! Impact of a ball and the slate.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::{Check, Parameter};

/// What the slate does to a ball that is driven into it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum SlateLaw {
    /// The ball stays on the slate: its vertical velocity is dropped.
    #[default]
    Held,
    /// The vertical velocity is dropped, and the blow that takes it up rubs: an impulse min(μ Jₙ, (2/7) m |u|)
    /// against the slip. Spin about the vertical is untouched (Alciatore, TP B.10).
    Rubbed {
        /// Coefficient of friction.
        friction: f64,
    },
}

impl SlateLaw {
    /// One of each registered law, with its default parameters.
    #[must_use]
    pub fn all() -> Vec<Self> {
        vec![Self::Held, Self::Rubbed { friction: 0.2 }]
    }

    /// Velocities after a ball was driven into the slate.
    #[must_use]
    pub fn land(&self, ball: &Ball, state: &State) -> State {
        let mut after = *state;
        let down = -state.velocity.y;
        after.velocity.y = 0.0;
        if let (Self::Rubbed { friction }, true) = (self, down > 0.0 && ball.spins) {
            let slip = ball.slip(after.velocity, state.angular_velocity);
            let speed = slip.length();
            if speed > 0.0 {
                let change = -(friction * down).min(2.0 / 7.0 * speed) / speed * slip;
                after.velocity += change;
                after.angular_velocity += 2.5 / ball.radius * (-DVec3::Y).cross(change);
            }
        }
        after
    }
}

impl Check for SlateLaw {
    fn parameters(&self) -> Vec<Parameter> {
        match *self {
            Self::Held => Vec::new(),
            Self::Rubbed { friction } => vec![
                Parameter::new("friction", friction, 0.0, 2.0)
                    .basis("dry friction; balls on cloth measure 0.15 to 0.4, Alciatore, physical properties"),
            ],
        }
    }
}
