//! Slide, roll, spin, rest on cloth with Coulomb friction.
//!
//! | motion | acceleration | ends |
//! |---|---|---|
//! | sliding | −μₛ g û, û the direction of slip, constant; dω/dt = (5 μₛ g / 2R) ŷ × û | after 2\|u\| / (7 μₛ g), rolling |
//! | rolling | −μᵣ g v̂ | after \|v\| / (μᵣ g) |
//! | spinning | none; the spin about the vertical falls by α in every motion | after \|ω·ŷ\| / α, at rest |
//!
//! Source: Alciatore, TP A.4 and TP B.7 (post-impact motion); Leckie & Greenspan (2006), section 3. Exact for a
//! rigid ball on a flat cloth with constant coefficients; cloth nap, ball drag in air and the dependence of
//! rolling resistance on speed are not modelled. `rolling` is the coefficient in a = μᵣ g, not 5/7 of it.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::laws::motion::Piece;
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// Where the law comes from.
pub(super) const SOURCE: Source = Source {
    paper: "Alciatore, TP A.4 and TP B.7; Leckie & Greenspan (2006), section 3",
    formula: "sliding −μₛ g û for 2|u|/(7 μₛ g), rolling −μᵣ g v̂, spin falls by α",
    leaves_out: "nap, drag of the air, rolling resistance that depends on speed",
};

/// The friction of a cloth.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cloth {
    /// Coefficient of sliding friction, 1.
    #[serde(default = "defaults::sliding")]
    pub sliding: f64,
    /// Coefficient of rolling resistance, 1: deceleration divided by gravity.
    #[serde(default = "defaults::rolling")]
    pub rolling: f64,
    /// Deceleration of spin about the vertical, rad/s².
    #[serde(default = "defaults::spin_deceleration")]
    pub spin_deceleration: f64,
    /// Gravity, m/s².
    #[serde(default = "defaults::gravity")]
    pub gravity: f64,
}

/// Pool cloth: the middle of the ranges on Alciatore's physical-properties page.
mod defaults {
    pub(super) fn sliding() -> f64 {
        0.2
    }
    pub(super) fn rolling() -> f64 {
        0.01
    }
    pub(super) fn spin_deceleration() -> f64 {
        10.9
    }
    pub(super) fn gravity() -> f64 {
        9.81
    }
}

impl Default for Cloth {
    fn default() -> Self {
        Self {
            sliding: defaults::sliding(),
            rolling: defaults::rolling(),
            spin_deceleration: defaults::spin_deceleration(),
            gravity: defaults::gravity(),
        }
    }
}

impl Check for Cloth {
    fn parameters(&self) -> Vec<Parameter> {
        vec![
            Parameter::new("sliding", self.sliding, 0.0, 2.0)
                .basis("dry friction; balls on cloth measure 0.15 to 0.4, Alciatore, physical properties"),
            Parameter::new("rolling", self.rolling, 0.0, 1.0).basis(
                "above 1 a ball would rather slide; cloths measure 0.005 to 0.015, Alciatore, physical properties, and \
                 heated ones 0.004",
            ),
            Parameter::new("spin_deceleration", self.spin_deceleration, 0.0, 1e4)
                .basis("rad/s²; 5 to 15 measured, Alciatore, physical properties"),
            Parameter::new("gravity", self.gravity, 1e-6, 1e3)
                .basis("m/s²; 9.78 to 9.83 on Earth, and a ball on cloth needs some"),
        ]
    }
}

/// Slip below this fraction of the speeds it is the difference of is rounding, not slip.
const SLIP_ROUNDING: f64 = 1e-13;

/// A ball whose centre is higher than its radius by more than this in m is off the slate.
const LIFT: f64 = 1e-7;

pub(super) fn classify(ball: &Ball, mut state: State) -> State {
    if state.motion.flies() {
        if state.motion == Motion::Wedged && state.velocity != DVec3::ZERO {
            state.motion = Motion::Airborne;
        }
        return state;
    }
    if state.velocity.y > 0.0 || state.position.y > ball.radius + LIFT {
        state.motion = Motion::Airborne;
        return state;
    }
    state.velocity.y = 0.0;
    if !ball.spins {
        state.angular_velocity = DVec3::ZERO;
        state.motion = if state.velocity == DVec3::ZERO {
            Motion::Rest
        } else {
            Motion::Rolling
        };
        return state;
    }
    let spin = state.angular_velocity;
    let slip = ball.slip(state.velocity, spin);
    let scale = state.velocity.length() + ball.radius * spin.length();
    state.motion = if slip.length() > SLIP_ROUNDING * scale {
        Motion::Sliding
    } else if state.velocity != DVec3::ZERO {
        state.angular_velocity = ball.rolling_spin(state.velocity);
        state.angular_velocity.y = spin.y;
        Motion::Rolling
    } else if spin.y != 0.0 {
        state.angular_velocity = DVec3::Y * spin.y;
        Motion::Spinning
    } else {
        state.angular_velocity = DVec3::ZERO;
        Motion::Rest
    };
    state
}

pub(super) fn piece(cloth: &Cloth, ball: &Ball, state: &State) -> Piece {
    let mut piece = Piece::uniform(*state);
    let spin = state.angular_velocity;
    let spin_time = if spin.y == 0.0 {
        0.0
    } else {
        spin.y.abs() / cloth.spin_deceleration
    };
    piece.spin_deceleration = cloth.spin_deceleration;
    match state.motion {
        Motion::Sliding => {
            let slip = ball.slip(state.velocity, spin);
            let speed = slip.length();
            let direction = direction_of(slip, speed);
            let friction = cloth.sliding * cloth.gravity;
            piece.acceleration = -friction * direction;
            piece.angular_acceleration = (2.5 * friction / ball.radius) * DVec3::Y.cross(direction);
            piece.duration = 2.0 * speed / (7.0 * friction);
            piece.next = Motion::Rolling;
            // A ball whose friction stops it just when slipping ends does not go on to roll.
            if piece.velocity(piece.duration).length() <= SLIP_ROUNDING * state.velocity.length() {
                piece.next = still(spin_time > piece.duration);
            }
        }
        Motion::Rolling => {
            let speed = state.velocity.length();
            let direction = direction_of(state.velocity, speed);
            let friction = cloth.rolling * cloth.gravity;
            piece.acceleration = -friction * direction;
            if ball.spins {
                piece.angular_acceleration = ball.rolling_spin(piece.acceleration);
            }
            piece.duration = speed / friction;
            piece.next = still(spin_time > piece.duration);
        }
        Motion::Spinning => {
            piece.duration = spin_time;
            piece.next = Motion::Rest;
        }
        Motion::Airborne => {
            piece.acceleration = -cloth.gravity * DVec3::Y;
            piece.spin_deceleration = 0.0;
        }
        Motion::Rest
        | Motion::Gliding
        | Motion::Tipping
        | Motion::Wedged
        | Motion::Pocketed
        | Motion::OffTable => {
            piece.spin_deceleration = 0.0;
        }
    }
    piece
}

/// The direction of a vector of this length, zero for none: a tick that ends exactly on a change of motion leaves a slip
/// or a speed of 0 behind.
fn direction_of(vector: DVec3, length: f64) -> DVec3 {
    if length > 0.0 {
        vector / length
    } else {
        DVec3::ZERO
    }
}

fn still(spins: bool) -> Motion {
    if spins {
        Motion::Spinning
    } else {
        Motion::Rest
    }
}
