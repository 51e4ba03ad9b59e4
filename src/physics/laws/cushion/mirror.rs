//! The plain mirror with restitution.
//!
//! v′ = v − (1 + e)(v·n) n. No friction, no spin: a rolling ball at 45° leaves 7.7° too wide and settles 5.1° too
//! steep against the converged model of Mathavan, Jackson & Parkin (2010).

use serde::{Deserialize, Serialize};

use crate::physics::ball::State;
use crate::physics::laws::cushion::CushionContact;
use crate::physics::laws::{Check, Parameter};

/// A wall.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Mirror {
    /// Coefficient of restitution, 0 to 1.
    pub restitution: f64,
}

impl Default for Mirror {
    fn default() -> Self {
        Self { restitution: 0.85 }
    }
}

impl Mirror {
    pub(super) fn rebound(&self, state: &State, contact: &CushionContact) -> State {
        let restitution = contact.restitution.unwrap_or(self.restitution);
        let mut after = *state;
        after.velocity -= (1.0 + restitution) * state.velocity.dot(contact.normal) * contact.normal;
        after
    }
}

impl Check for Mirror {
    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("restitution", self.restitution, 0.0, 1.0).basis(super::RESTITUTION)]
    }
}
