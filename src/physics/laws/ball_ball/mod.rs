//! Impact of two balls.

mod friction;
mod frictional;
mod frictionless;
mod mathavan_2014;
mod peer_cap;

pub use friction::Friction;
pub use frictional::Frictional;
pub use frictionless::Frictionless;
pub use mathavan_2014::Mathavan2014;
pub use peer_cap::PeerCap;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// What is known of the restitution of two balls.
const RESTITUTION: &str = "above 1 an impact would make energy; pool balls measure 0.92 to 0.98, Alciatore, physical \
                           properties, snooker balls 0.89, Mathavan 2014";

/// The geometry of one impact, and what may override the law in a settling contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairContact {
    /// Unit vector from the first to the second ball; horizontal when both are on the slate.
    pub normal: DVec3,
    /// Both balls are held on the slate: the vertical part of the outcome goes into the table.
    pub on_slate: bool,
    /// Restitution to use instead of the law's own, for a contact that is coming to rest.
    pub restitution: Option<f64>,
}

impl PairContact {
    /// The contact of two balls at these positions.
    #[must_use]
    pub fn between(first: &State, second: &State) -> Self {
        let on_slate = !first.motion.flies() && !second.motion.flies();
        let mut offset = second.position - first.position;
        let mut approach = first.velocity - second.velocity;
        if on_slate {
            offset.y = 0.0;
            approach.y = 0.0;
        }
        // Divided, not multiplied by the reciprocal: a row along an axis has exactly that axis for its normals. Where a tick
        // is not searched for contacts two centres can coincide: then the balls meet head-on.
        let distance = offset.length();
        let normal = if distance > 0.0 {
            offset / distance
        } else {
            approach.try_normalize().unwrap_or(DVec3::X)
        };
        Self {
            normal,
            on_slate,
            restitution: None,
        }
    }
}

/// Velocities after an impact of two balls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairOutcome {
    /// The first ball.
    pub first: State,
    /// The second ball.
    pub second: State,
    /// Normal impulse in N s.
    pub impulse: f64,
}

/// How two balls collide.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum BallBallLaw {
    /// Impulse along the line of centres only.
    Frictionless(Frictionless),
    /// Impulse along the line of centres and Coulomb friction across it: throw and spin transfer.
    Frictional(Frictional),
    /// As `Frictional`, with the friction of the cloth under balls that press each other down.
    Mathavan2014(Mathavan2014),
    /// As `Frictional` with the peer pooltool's limit of friction; for comparison only.
    PeerCap(PeerCap),
}

impl BallBallLaw {
    /// One of each registered law, with its default parameters.
    #[must_use]
    pub fn all() -> Vec<Self> {
        vec![
            Self::Frictionless(Frictionless::default()),
            Self::Frictional(Frictional::default()),
            Self::Mathavan2014(Mathavan2014::default()),
            Self::PeerCap(PeerCap::default()),
        ]
    }

    /// Velocities after the impact; positions and motion labels are left as they are. A pair that separates is
    /// returned unchanged.
    #[must_use]
    pub fn collide(
        &self,
        first: (&Ball, &State),
        second: (&Ball, &State),
        contact: &PairContact,
    ) -> PairOutcome {
        let mut outcome = match self {
            Self::Frictionless(law) => law.collide(first, second, contact),
            Self::Frictional(law) => law.collide(1.0, first, second, contact),
            Self::Mathavan2014(law) => law.collide(first, second, contact),
            Self::PeerCap(law) => law.collide(first, second, contact),
        };
        if contact.on_slate {
            outcome.first.velocity.y = 0.0;
            outcome.second.velocity.y = 0.0;
        }
        outcome
    }

    /// Where the law comes from.
    #[must_use]
    pub fn source(&self) -> Source {
        match self {
            Self::Frictionless(_) => frictionless::SOURCE,
            Self::Frictional(_) => frictional::SOURCE,
            Self::Mathavan2014(_) => mathavan_2014::SOURCE,
            Self::PeerCap(_) => peer_cap::SOURCE,
        }
    }

    /// The law's own restitution.
    #[must_use]
    pub fn restitution(&self) -> f64 {
        match self {
            Self::Frictionless(law) => law.restitution,
            Self::Frictional(law) | Self::PeerCap(PeerCap(law)) => law.restitution,
            Self::Mathavan2014(law) => law.restitution,
        }
    }
}

impl Check for BallBallLaw {
    fn parameters(&self) -> Vec<Parameter> {
        match self {
            Self::Frictionless(law) => law.parameters(),
            Self::Frictional(law) => law.parameters(),
            Self::Mathavan2014(law) => law.parameters(),
            Self::PeerCap(law) => law.parameters(),
        }
    }
}
