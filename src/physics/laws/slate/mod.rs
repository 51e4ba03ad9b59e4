//! Impact of a ball and the slate.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// Least speed in m/s at which a ball leaves the rim or the wall of a pocket.
const LEAVE: f64 = 0.02;

/// What the slate does to a ball that comes down on it.
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
    /// The ball bounces, and each blow rubs.
    Bouncing(Bouncing),
}

/// A slate from which balls bounce. The normal impulse is m (1 + e) v; across it the blow rubs as in
/// [`SlateLaw::Rubbed`], so that (5/7) v + (2/7) R ω × ŷ is kept in plan. Only cloth over slate that does not yield is
/// meant: a bounce is instant.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Bouncing {
    /// Coefficient of restitution, 0 to 1; about 0.5 (Alciatore, physical properties page).
    pub restitution: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// A ball that would leave the slate at less than this in m/s stays: bounces get ever shorter and never end by
    /// themselves. At 0.02 m/s it would rise 20 µm.
    pub settle: f64,
}

impl Default for Bouncing {
    fn default() -> Self {
        Self {
            restitution: 0.5,
            friction: 0.2,
            settle: 0.02,
        }
    }
}

impl SlateLaw {
    /// One of each registered law, with its default parameters.
    #[must_use]
    pub fn all() -> Vec<Self> {
        vec![
            Self::Held,
            Self::Rubbed { friction: 0.2 },
            Self::Bouncing(Bouncing::default()),
        ]
    }

    /// Where the law comes from.
    #[must_use]
    pub fn source(&self) -> Source {
        match self {
            Self::Held => Source {
                paper: "a choice, not a law of nature",
                formula: "v·ŷ = 0 after every blow",
                leaves_out: "bounces, and the friction of the blow",
            },
            Self::Rubbed { .. } => Source {
                paper: "Alciatore, TP B.10",
                formula: "J = min(μ Jₙ, (2/7) m |u|) against the slip u, v·ŷ = 0",
                leaves_out: "bounces",
            },
            Self::Bouncing(_) => Source {
                paper: "Alciatore, TP B.10; restitution from his physical properties page",
                formula: "Jₙ = m (1 + e) v, across it as Rubbed",
                leaves_out: "a slate or a cloth that yields",
            },
        }
    }

    /// Coefficient of restitution.
    #[must_use]
    pub fn restitution(&self) -> f64 {
        match self {
            Self::Held | Self::Rubbed { .. } => 0.0,
            Self::Bouncing(law) => law.restitution,
        }
    }

    /// The ball after it came down on the slate: velocities, and the label of flight if it bounces. A ball that stays
    /// lies on the slate with the label [`Motion::Sliding`], for the motion law to classify.
    #[must_use]
    pub fn land(&self, ball: &Ball, state: &State) -> State {
        let down = -state.velocity.y;
        let restitution = self.restitution();
        let (friction, settle) = match *self {
            Self::Held => (0.0, 0.0),
            Self::Rubbed { friction } => (friction, 0.0),
            Self::Bouncing(law) => (law.friction, law.settle),
        };
        let mut after = *state;
        let up = match self {
            _ if down > 0.0 => restitution * down,
            Self::Bouncing(_) => -down,
            Self::Held | Self::Rubbed { .. } => 0.0,
        };
        after.velocity.y = if up > settle { up } else { 0.0 };
        after.motion = if up > settle {
            Motion::Airborne
        } else {
            Motion::Sliding
        };
        if down > 0.0 {
            rub(
                ball,
                &mut after,
                DVec3::Y,
                friction,
                (1.0 + restitution) * down,
            );
        }
        after
    }

    /// The ball after it met an edge that does not yield, with this unit vector from the edge to its centre: as it
    /// would bounce from a slate across that direction. The label of motion is left as it is.
    ///
    /// A touch that closes at less than `LEAVE` leaves at that speed, with energy taken from the motion along the edge:
    /// a ball that leans on it would touch it ever more often. Not so with a restitution in place of the law's own.
    #[must_use]
    pub fn bounce(
        &self,
        ball: &Ball,
        state: &State,
        normal: DVec3,
        restitution: Option<f64>,
    ) -> State {
        let friction = match *self {
            Self::Held => 0.0,
            Self::Rubbed { friction } => friction,
            Self::Bouncing(law) => law.friction,
        };
        let closing = -state.velocity.dot(normal);
        if closing < -LEAVE {
            return *state;
        }
        let mut after = *state;
        if let Some(restitution) = restitution {
            let blow = (1.0 + restitution) * closing.max(0.0);
            after.velocity += blow * normal;
            rub(ball, &mut after, normal, friction, blow);
            return after;
        }
        let leave = (self.restitution() * closing).max(closing.abs().min(LEAVE));
        after.velocity += (closing + leave) * normal;
        rub(ball, &mut after, normal, friction, closing + leave);
        let along = after.velocity - after.velocity.dot(normal) * normal;
        let missing = LEAVE * LEAVE - leave * leave;
        if missing > 0.0 && along.length_squared() > missing {
            let kept = (1.0 - missing / along.length_squared()).sqrt();
            after.velocity = kept * along + LEAVE * normal;
        }
        after
    }
}

/// Friction of a blow with this change of normal velocity in m/s: sliding, but never more than ends the slip.
fn rub(ball: &Ball, state: &mut State, normal: DVec3, friction: f64, blow: f64) {
    if !ball.spins {
        return;
    }
    let across = state.velocity - state.velocity.dot(normal) * normal;
    let slip = across - ball.radius * state.angular_velocity.cross(normal);
    let speed = slip.length();
    if speed > 0.0 {
        let change = -(friction * blow).min(2.0 / 7.0 * speed) / speed * slip;
        state.velocity += change;
        state.angular_velocity += 2.5 / ball.radius * (-normal).cross(change);
    }
}

fn friction(value: f64) -> Parameter {
    Parameter::new("friction", value, 0.0, 2.0)
        .basis("dry friction; balls on cloth measure 0.15 to 0.4, Alciatore, physical properties")
}

impl Check for SlateLaw {
    fn parameters(&self) -> Vec<Parameter> {
        match *self {
            Self::Held => Vec::new(),
            Self::Rubbed { friction: value } => vec![friction(value)],
            Self::Bouncing(law) => vec![
                Parameter::new("restitution", law.restitution, 0.0, 0.999)
                    .basis("a blow gives back less than it took; about 0.5, Alciatore, physical properties"),
                friction(law.friction),
                Parameter::new("settle", law.settle, 1e-12, 1.0)
                    .basis("below it bounces end; 1 m/s would be a hop of 5 cm"),
            ],
        }
    }
}
