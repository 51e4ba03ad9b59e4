//! Impulse with restitution and Coulomb friction: throw and spin transfer.
//!
//! Along the line of centres as in [`Frictionless`]. Across it the slip
//! u = (v₁ − v₂)ₜ + (R₁ ω₁ + R₂ ω₂) × n is opposed by Jₜ = min(μ Jₙ, (2/7) m* |u|): friction slides until the slip
//! is gone, and no further. Both balls get spin of the same sign; the spin about n never changes.
//!
//! Source: Alciatore, TP A.14. Cap: |Jₜ| ≤ μ Jₙ with the whole normal impulse, (1 + e) m* vₙ. The vertical part of
//! Jₜ would lift one ball and press the other; on the slate it is dropped from the velocities (Mathavan, Jackson &
//! Parkin 2014 follow it; the difference is below 0.4° and 0.004 m/s for rolling shots).

use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::ball_ball::{Friction, Frictionless, Impact, PairContact, PairOutcome};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// Rough balls.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Frictional {
    /// Coefficient of restitution, 0 to 1.
    pub restitution: f64,
    /// Friction between the balls.
    pub friction: Friction,
}

impl Default for Frictional {
    fn default() -> Self {
        Self {
            restitution: 0.95,
            friction: Friction::MARLOW,
        }
    }
}

impl Frictional {
    /// `cap` scales the normal impulse that limits friction: 1 is right.
    pub(super) fn collide_capped(
        &self,
        cap: f64,
        (ball_1, state_1): (&Ball, &State),
        (ball_2, state_2): (&Ball, &State),
        contact: &PairContact,
    ) -> PairOutcome {
        let smooth = Frictionless {
            restitution: self.restitution,
        };
        let mut outcome = smooth.collide((ball_1, state_1), (ball_2, state_2), contact);
        if outcome.impulse == 0.0 || !(ball_1.spins && ball_2.spins) {
            return outcome;
        }
        let normal = contact.normal;
        let relative = state_1.velocity - state_2.velocity;
        let surface =
            ball_1.radius * state_1.angular_velocity + ball_2.radius * state_2.angular_velocity;
        let slip = relative - relative.dot(normal) * normal + surface.cross(normal);
        let speed = slip.length();
        if speed == 0.0 {
            return outcome;
        }
        let total = ball_1.mass + ball_2.mass;
        let reduced = ball_1.mass * (ball_2.mass / total);
        let sliding = self.friction.coefficient(speed) * cap * outcome.impulse;
        let sticking = (2.0 / 7.0) * reduced * speed;
        let impulse = -(sliding.min(sticking) / speed) * slip;
        outcome.first.velocity += impulse / ball_1.mass;
        outcome.second.velocity -= impulse / ball_2.mass;
        let torque = normal.cross(impulse);
        outcome.first.angular_velocity += (ball_1.radius / ball_1.inertia()) * torque;
        outcome.second.angular_velocity += (ball_2.radius / ball_2.inertia()) * torque;
        outcome
    }
}

impl Impact for Frictional {
    const SOURCE: Source = Source {
        paper: "Alciatore, TP A.14; friction fitted to Marlow (1995)",
        formula: "Jₜ = min(μ Jₙ, (2/7) m* |u|) against the slip u",
        leaves_out: "the cloth under the balls while they touch: up to 0.4° and 0.004 m/s",
    };

    fn collide(
        &self,
        first: (&Ball, &State),
        second: (&Ball, &State),
        contact: &PairContact,
    ) -> PairOutcome {
        self.collide_capped(1.0, first, second, contact)
    }

    fn restitution(&self, _closing: f64) -> f64 {
        self.restitution
    }
}

impl Check for Frictional {
    fn parameters(&self) -> Vec<Parameter> {
        let mut parameters = vec![
            Parameter::new("restitution", self.restitution, 0.0, 1.0).basis(super::RESTITUTION),
        ];
        parameters.extend(self.friction.parameters());
        parameters
    }
}
