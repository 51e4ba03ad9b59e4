//! The friction and spin of the coursework report, as its own named model.
//!
//! Once a tick, after collisions, with V the velocity, W the spin and u a rate in 1/s:
//!
//! 1. drag, `V' = V − V u dt` and `W' = W − W u dt`;
//! 2. rolling coupling, the horizontal spin follows the velocity: `W += (Wroll − W) c dt`;
//! 3. push, `V = r W u` from the horizontal spin: top spin drives on, back spin drives back: `V += r (W × ŷ) u dt`;
//! 4. english, the vertical spin turns the velocity by `k W_y dt`.
//!
//! It has no closed form, so it runs in the stepped solver only. The report's code was not available; the order of the
//! steps and the `dt` in 2 to 4 (without which the result depends on the tick) are ours.
//!
//! What it gets wrong against Coulomb friction, for a shot of 2 m/s:
//!
//! | what | coursework | real |
//! |---|---|---|
//! | drag is linear: a ball never stops; with u fitted to the length of the roll, speed after 0.291 s | 1.896 m/s | 1.429 m/s |
//! | time over 2.54 m, same fit | 1.446 s | 1.798 s |
//! | push is proportional to W; sliding friction has the fixed size μ g. A rolling cue ball after a square hit, after 0.291 s | 0.12 m/s at u = 0.2/s | 0.571 m/s |
//! | no throw: a half-ball hit is out by | 0° | 2.7 to 4.7° (46 to 82 mm per metre) |
//! | no restitution: the cue ball of a square stun hit keeps | 0 | 0.05 m/s at e = 0.95 |
//! | english turns the path on the open cloth; real english leaves it straight but for squirt (1.9 to 2.7°, away) and works at the cushion | curve | straight |
//! | energy can be made from spin if (push + 0.4 c)² > 1.6 u (u + c); the defaults lie below | | |

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// Where the law comes from.
pub(super) const SOURCE: Source = Source {
    paper: "the coursework report that this program grew out of",
    formula: "V′ = V − V u dt, spin follows and pushes by rates",
    leaves_out: "sliding friction of a fixed size: nothing ever stops; stepped solver only",
};

/// The report's friction.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Coursework {
    /// Drag u on velocity, 1/s.
    pub drag: f64,
    /// Drag u on spin, 1/s.
    pub spin_drag: f64,
    /// Rolling coupling c, 1/s.
    pub coupling: f64,
    /// Rate u at which horizontal spin pushes the ball, 1/s.
    pub push: f64,
    /// How far english turns the velocity, rad per rad of spin.
    pub english: f64,
    /// Speed in m/s, and spin in R times rad/s, below which a ball is put to rest. Exponential drag alone never ends.
    pub rest_below: f64,
}

impl Default for Coursework {
    fn default() -> Self {
        Self {
            drag: 0.6,
            spin_drag: 0.6,
            coupling: 0.2,
            push: 0.6,
            english: 0.02,
            rest_below: 0.005,
        }
    }
}

impl Coursework {
    /// The velocities after the friction of one tick of `dt` seconds.
    #[must_use]
    pub fn rub(&self, ball: &Ball, state: &State, dt: f64) -> State {
        let mut after = *state;
        let v = &mut after.velocity;
        *v -= *v * (self.drag * dt);
        if ball.spins {
            let w = &mut after.angular_velocity;
            *w -= *w * (self.spin_drag * dt);
            let english = w.y;
            let roll = ball.rolling_spin(*v);
            *w += (roll - *w) * (self.coupling * dt);
            w.y = english;
            *v += ball.radius * w.cross(DVec3::Y) * (self.push * dt);
            let angle = self.english * english * dt;
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            *v = DVec3::new(cos * v.x + sin * v.z, v.y, cos * v.z - sin * v.x);
        }
        let spin = ball.radius * after.angular_velocity.length();
        if after.velocity.length() < self.rest_below && spin < self.rest_below {
            after.velocity = DVec3::ZERO;
            after.angular_velocity = DVec3::ZERO;
        }
        after
    }
}

impl Check for Coursework {
    fn parameters(&self) -> Vec<Parameter> {
        vec![
            Parameter::new("drag", self.drag, 0.0, 60.0),
            Parameter::new("spin_drag", self.spin_drag, 0.0, 60.0),
            Parameter::new("coupling", self.coupling, 0.0, 60.0),
            Parameter::new("push", self.push, 0.0, 60.0),
            Parameter::new("english", self.english, -10.0, 10.0),
            Parameter::new("rest_below", self.rest_below, 0.0, 1.0),
        ]
    }
}
