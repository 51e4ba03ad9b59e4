//! The frictional impact as the peer pooltool computes it, for comparison with its data only.
//!
//! As [`Frictional`], but friction is limited by μ times 2 e m* vₙ, twice the normal impulse of restitution, where Coulomb
//! has μ times the whole normal impulse (1 + e) m* vₙ: for e = 0.95 it allows 2.6 % too little, for e = 0 none at all.
//! Source: pooltool 0.6.0, `frictional_inelastic`.

use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::ball_ball::{Frictional, Impact, PairContact, PairOutcome};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// Rough balls with the peer's limit of friction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct PeerCap(pub Frictional);

impl Impact for PeerCap {
    const SOURCE: Source = Source {
        paper: "pooltool 0.6.0, frictional_inelastic",
        formula: "as Frictional, with μ 2 e m* vₙ as the limit of friction",
        leaves_out: "part of Coulomb's limit: for comparison with its data only",
    };

    fn collide(
        &self,
        first: (&Ball, &State),
        second: (&Ball, &State),
        contact: &PairContact,
    ) -> PairOutcome {
        let restitution = contact.restitution.unwrap_or(self.0.restitution);
        let cap = 2.0 * restitution / (1.0 + restitution);
        self.0.collide_capped(cap, first, second, contact)
    }

    fn restitution(&self, _closing: f64) -> f64 {
        self.0.restitution
    }
}

impl Check for PeerCap {
    fn parameters(&self) -> Vec<Parameter> {
        self.0.parameters()
    }
}
