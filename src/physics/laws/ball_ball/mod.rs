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

/// What the file of a law of the impact of two balls has to say.
trait Impact: Check {
    /// Where the law comes from.
    const SOURCE: Source;

    /// Velocities after the impact; positions and motion labels are left as they are. A pair that separates is returned
    /// unchanged.
    fn collide(
        &self,
        first: (&Ball, &State),
        second: (&Ball, &State),
        contact: &PairContact,
    ) -> PairOutcome;

    /// The law's own restitution for balls that close at this speed in m/s.
    fn restitution(&self, closing: f64) -> f64;
}

macro_rules! laws {
    ($($(#[doc = $doc:literal])+ $name:ident),+ $(,)?) => {
        /// How two balls collide.
        #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
        pub enum BallBallLaw {
            $($(#[doc = $doc])+ $name($name)),+
        }

        impl BallBallLaw {
            /// One of each registered law, with its default parameters.
            #[must_use]
            pub fn all() -> Vec<Self> {
                vec![$(Self::$name($name::default())),+]
            }

            /// Where the law comes from.
            #[must_use]
            pub fn source(&self) -> Source {
                match self {
                    $(Self::$name(_) => $name::SOURCE),+
                }
            }

            fn impact(
                &self,
                first: (&Ball, &State),
                second: (&Ball, &State),
                contact: &PairContact,
            ) -> PairOutcome {
                match self {
                    $(Self::$name(law) => law.collide(first, second, contact)),+
                }
            }

            /// The law's own restitution for balls that close at this speed in m/s.
            #[must_use]
            pub fn restitution(&self, closing: f64) -> f64 {
                match self {
                    $(Self::$name(law) => law.restitution(closing)),+
                }
            }
        }

        impl Check for BallBallLaw {
            fn parameters(&self) -> Vec<Parameter> {
                match self {
                    $(Self::$name(law) => law.parameters()),+
                }
            }
        }
    };
}

laws! {
    /// Impulse along the line of centres only.
    Frictionless,
    /// Impulse along the line of centres and Coulomb friction across it: throw and spin transfer.
    Frictional,
    /// As `Frictional`, with the friction of the cloth under balls that press each other down.
    Mathavan2014,
    /// As `Frictional` with the peer pooltool's limit of friction; for comparison only.
    PeerCap,
}

impl BallBallLaw {
    /// Velocities after the impact; positions and motion labels are left as they are. A pair that separates is
    /// returned unchanged.
    #[must_use]
    pub fn collide(
        &self,
        first: (&Ball, &State),
        second: (&Ball, &State),
        contact: &PairContact,
    ) -> PairOutcome {
        let mut outcome = self.impact(first, second, contact);
        if contact.on_slate {
            outcome.first.velocity.y = 0.0;
            outcome.second.velocity.y = 0.0;
        }
        outcome
    }
}
