//! Impact with nose and cloth at once: the ball is wedged between them while it rebounds.
//!
//! The nose stands above the centre, sin θ = h/R − 1, so it presses the ball into the cloth, and friction works at both
//! contacts while the normal impulse grows: at the nose with μ, at the cloth with `sliding` times its own normal force
//! sin θ + μ sin φ cos θ per unit at the nose. The ball is held on the slate. Restitution is energetic: the nose gives
//! back e² of the work put in.
//!
//! Source: Mathavan, Jackson & Parkin, "A theoretical analysis of billiard ball dynamics under cushion impacts", Proc.
//! `IMechE` C 224 (2010) 1863; good below 2.5 m/s along the normal, they say. Homogeneous in speed. Followed to 1e-6 of the
//! speed (see `rub`), where the paper steps by hand. Where friction at the nose would lift the ball its weight
//! on the cloth is taken as zero.

use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::cushion::{CushionContact, Cushioning};
use crate::physics::laws::restitution::{NoseFriction, Restitution};
use crate::physics::laws::rub::{Accuracy, Limit, Rub};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// Mathavan's cushion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Mathavan2010 {
    /// Energetic coefficient of restitution of the nose, 0 to 1.
    pub restitution: Restitution,
    /// Coefficient of friction between ball and nose.
    pub friction: NoseFriction,
    /// Coefficient of friction between ball and cloth during the impact.
    pub sliding: f64,
}

impl Default for Mathavan2010 {
    /// As the paper: chosen by its authors to meet their own measurements on a snooker table.
    fn default() -> Self {
        Self {
            restitution: 0.98.into(),
            friction: 0.14.into(),
            sliding: 0.212,
        }
    }
}

impl Cushioning for Mathavan2010 {
    const SOURCE: Source = Source {
        paper: "Mathavan, Jackson & Parkin, Proc. IMechE C 224 (2010) 1863",
        formula: "nose and cloth rub at once along the impulse P; e² of the work comes back",
        leaves_out: "rubber that yields: good below 2.5 m/s along the normal",
    };

    fn rebound(&self, ball: &Ball, state: &State, contact: &CushionContact) -> State {
        // The paper's axes: y into the cushion, z up, x = y × z. Spins times R.
        let y = -contact.normal;
        let x = y.cross(DVec3::Y);
        let (v, w) = (state.velocity, ball.radius * state.angular_velocity);
        let (v_x, v_y) = (v.dot(x), v.dot(y));
        let (w_x, w_y, w_z) = (w.dot(x), w.dot(y), w.y);
        let sin = contact.sine(ball);
        let cos = (1.0 - sin * sin).sqrt();
        let closing = v_y * cos;
        let mut after = *state;
        if cos < 1e-3 {
            return after;
        }
        let mu = self.friction.at(v_y, v_x);
        let nose = DVec2::new(v_x + w_y * sin - w_z * cos, w_x - v_y * sin);
        let cloth = DVec2::new(v_x - w_y, v_y + w_x);
        let size = v_x.abs() + v_y + w_x.abs() + w_y.abs() + w_z.abs();
        let rub = Rub {
            mobility_x: [[3.5, 1.0 - 2.5 * sin], [1.0 - 2.5 * sin, 3.5]],
            mobility_y: [[sin * sin + 2.5, 2.5 - sin], [2.5 - sin, 3.5]],
            drive: [sin * cos, -cos],
            normal: cos * cos,
            limits: [
                Limit {
                    friction: mu,
                    alpha: 1.0,
                    beta: 0.0,
                },
                Limit {
                    friction: self.sliding,
                    alpha: sin,
                    beta: cos,
                },
            ],
            slip: [nose / closing, cloth / closing],
            noise: 1e-15 * size / closing,
            restitution: contact
                .restitution
                .unwrap_or_else(|| self.restitution.at(v_y)),
        };
        let impulses = rub.follow(&Accuracy::GAME);
        let p = closing * impulses.normal;
        let [nose, cloth] = impulses.friction.map(|impulse| closing * impulse);
        after.velocity -= (nose.x + cloth.x) * x + (p * cos - nose.y * sin + cloth.y) * y;
        let spin = (nose.y + cloth.y) * x + (nose.x * sin - cloth.x) * y - nose.x * cos * DVec3::Y;
        after.angular_velocity -= 2.5 / ball.radius * spin;
        after
    }

    fn restitution(&self) -> Restitution {
        self.restitution
    }

    fn friction(&self, into: f64, along: f64) -> f64 {
        self.friction.at(into, along)
    }
}

impl Check for Mathavan2010 {
    fn parameters(&self) -> Vec<Parameter> {
        let mut parameters = self.restitution.parameters(super::RESTITUTION);
        parameters.extend(self.friction.parameters(super::FRICTION));
        parameters.push(
            Parameter::new("sliding", self.sliding, 0.0, 2.0).basis(
                "dry friction; 0.212 measured, Mathavan 2009, balls on cloth 0.15 to 0.4, Alciatore, physical properties",
            ),
        );
        parameters
    }
}
