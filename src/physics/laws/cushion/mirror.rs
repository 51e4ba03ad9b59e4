//! The plain mirror with restitution.
//!
//! v′ = v − (1 + e)(v·n) n. No friction, no spin: a rolling ball at 45° leaves 7.7° too wide and settles 5.1° too
//! steep against the converged model of Mathavan, Jackson & Parkin (2010).

use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::cushion::{CushionContact, Cushioning};
use crate::physics::laws::restitution::Restitution;
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// A wall.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Mirror {
    /// Coefficient of restitution, 0 to 1.
    pub restitution: Restitution,
}

impl Default for Mirror {
    fn default() -> Self {
        Self {
            restitution: 0.85.into(),
        }
    }
}

impl Mirror {
    pub(super) fn reflect(&self, state: &State, contact: &CushionContact) -> State {
        let closing = -state.velocity.dot(contact.normal);
        let restitution = contact
            .restitution
            .unwrap_or_else(|| self.restitution.at(closing));
        let mut after = *state;
        after.velocity += (1.0 + restitution) * closing * contact.normal;
        after
    }
}

impl Cushioning for Mirror {
    const SOURCE: Source = Source {
        paper: "the law of reflection with restitution",
        formula: "v′ = v − (1 + e)(v·n) n",
        leaves_out: "friction and spin: a roll at 45° settles 5.1° too steep",
    };

    fn rebound(&self, _ball: &Ball, state: &State, contact: &CushionContact) -> State {
        self.reflect(state, contact)
    }

    fn restitution(&self) -> Restitution {
        self.restitution
    }

    fn friction(&self, _into: f64, _along: f64) -> f64 {
        0.0
    }
}

impl Check for Mirror {
    fn parameters(&self) -> Vec<Parameter> {
        self.restitution.parameters(super::RESTITUTION)
    }
}
