//! Impulse along the line of centres.
//!
//! Jₙ = (1 + e) m* (v₁ − v₂)·n with m* = m₁ m₂ / (m₁ + m₂). With e = 1 this is the momentum formula of the
//! coursework report, V₁′ = V₁ − 2 (s₁ − s₂) / (m₁ + m₂) m₂ n. Spin is untouched: no throw, no spin transfer.
//! Source: Newton's law of restitution; Alciatore, TP A.5 and A.6.

use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::ball_ball::{Impact, PairContact, PairOutcome};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// Smooth balls.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Frictionless {
    /// Coefficient of restitution, 0 to 1.
    pub restitution: f64,
}

impl Default for Frictionless {
    fn default() -> Self {
        Self { restitution: 0.95 }
    }
}

impl Impact for Frictionless {
    const SOURCE: Source = Source {
        paper: "Newton's law of restitution; Alciatore, TP A.5 and A.6",
        formula: "Jₙ = (1 + e) m* (v₁ − v₂)·n",
        leaves_out: "throw and passed-on spin",
    };

    fn collide(
        &self,
        (ball_1, state_1): (&Ball, &State),
        (ball_2, state_2): (&Ball, &State),
        contact: &PairContact,
    ) -> PairOutcome {
        let mut outcome = PairOutcome {
            first: *state_1,
            second: *state_2,
            impulse: 0.0,
        };
        let closing = (state_1.velocity - state_2.velocity).dot(contact.normal);
        if closing <= 0.0 {
            return outcome;
        }
        let restitution = contact.restitution.unwrap_or(self.restitution);
        let total = ball_1.mass + ball_2.mass;
        // Each change is written with the other ball's share of the mass, so that a mass ratio of 1e6 keeps all
        // its digits.
        let change = (1.0 + restitution) * closing;
        outcome.first.velocity -= change * (ball_2.mass / total) * contact.normal;
        outcome.second.velocity += change * (ball_1.mass / total) * contact.normal;
        outcome.impulse = change * ball_1.mass * (ball_2.mass / total);
        outcome
    }

    fn restitution(&self, _closing: f64) -> f64 {
        self.restitution
    }
}

impl Check for Frictionless {
    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("restitution", self.restitution, 0.0, 1.0).basis(super::RESTITUTION)]
    }
}
