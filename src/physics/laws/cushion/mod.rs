//! Impact of a ball and a cushion.

mod han_2005;
mod impulse;
mod mathavan_2010;
mod mirror;
mod stronge_2018;

pub use han_2005::Han2005;
pub use impulse::Impulse;
pub use mathavan_2010::Mathavan2010;
pub use mirror::Mirror;
pub use stronge_2018::{Inclination, Stronge2018};

use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::laws::restitution::Restitution;
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};
use crate::physics::table::{Cushion, Nose, Table};

/// What is known of the restitution of a cushion.
const RESTITUTION: &str = "above 1 a rebound would make energy; 0.6 to 0.9 measured, Alciatore, physical properties, and \
                           0.98 of the rubber alone, Mathavan 2010";
/// What is known of the friction of a cushion.
const FRICTION: &str = "dry friction; 0.14 measured, Mathavan 2010, 0.2 to 0.5 by angle, Han 2005";

/// The geometry of one rebound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CushionContact {
    /// Horizontal unit vector from the cushion to the ball.
    pub normal: DVec3,
    /// Height of the nose above the slate in m.
    pub nose_height: f64,
    /// Profile of the nose.
    pub nose: Nose,
    /// Restitution to use instead of the law's own, for a contact that is coming to rest.
    pub restitution: Option<f64>,
}

impl CushionContact {
    /// Sine of the angle by which the line from the centre of a ball on the slate to the nose rises: h/R − 1 for a
    /// sharp nose.
    #[must_use]
    pub fn sine(&self, ball: &Ball) -> f64 {
        self.nose.sine(self.nose_height, ball.radius, ball.radius)
    }

    /// Unit vector in space from the nose to the centre of a ball, at the height at which it is.
    #[must_use]
    pub fn normal_in_space(&self, ball: &Ball, state: &State) -> DVec3 {
        let height = state.position.y;
        self.nose
            .normal(self.normal, self.nose_height, ball.radius, height)
    }
}

/// Velocities after a rebound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rebound {
    /// The ball.
    pub state: State,
    /// Impulse in N s along the horizontal normal.
    pub impulse: f64,
}

/// What the file of a law of cushions has to say.
trait Cushioning: Check {
    /// Where the law comes from.
    const SOURCE: Source;

    /// Velocities of a ball on the slate that comes into the cushion and spins; position and motion label are left as they
    /// are.
    fn rebound(&self, ball: &Ball, state: &State, contact: &CushionContact) -> State;

    /// Its own restitution.
    fn restitution(&self) -> Restitution;

    /// Its own friction for a ball in flight that comes with these speeds in m/s into the cushion and along it.
    fn friction(&self, into: f64, along: f64) -> f64;

    /// The height in m to give to [`CushionContact`] for this stretch of cushion of a table with this nose height.
    fn nose_height(&self, height: f64, _ball: &Ball, _cushion: &Cushion) -> f64 {
        height
    }
}

macro_rules! laws {
    ($($(#[doc = $doc:literal])+ $name:ident),+ $(,)?) => {
        /// How a cushion throws a ball back.
        #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
        pub enum CushionLaw {
            $($(#[doc = $doc])+ $name($name)),+
        }

        impl CushionLaw {
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

            /// The law as it stands, for a ball on the slate.
            fn roll(&self, ball: &Ball, state: &State, contact: &CushionContact) -> State {
                match self {
                    $(Self::$name(law) => law.rebound(ball, state, contact)),+
                }
            }

            fn own_restitution(&self) -> Restitution {
                match self {
                    $(Self::$name(law) => law.restitution()),+
                }
            }

            fn friction(&self, into: f64, along: f64) -> f64 {
                match self {
                    $(Self::$name(law) => law.friction(into, along)),+
                }
            }

            /// The height in m to give to [`CushionContact`] for this stretch of cushion of a table with this nose height.
            #[must_use]
            pub fn nose_height(&self, height: f64, ball: &Ball, cushion: &Cushion) -> f64 {
                match self {
                    $(Self::$name(law) => law.nose_height(height, ball, cushion)),+
                }
            }
        }

        impl Check for CushionLaw {
            fn parameters(&self) -> Vec<Parameter> {
                match self {
                    $(Self::$name(law) => law.parameters()),+
                }
            }
        }
    };
}

laws! {
    /// The normal velocity turns round, scaled by the restitution; all else stays.
    Mirror,
    /// Han's rigid impact at the height of the nose, with friction.
    Han2005,
    /// Rigid impact along the normal in space, with friction.
    Impulse,
    /// Mathavan's impact with nose and cloth at once.
    Mathavan2010,
    /// Stronge's compliant impact, with tangential give.
    Stronge2018,
}

impl CushionLaw {
    /// The rebound of a ball from a cushion that it touches where it is. One on the slate that has gone beyond the nose, as a
    /// tick without contact times leaves it, is pushed back to where it came from.
    #[must_use]
    pub fn meet(
        &self,
        table: &Table,
        cushion: &Cushion,
        (ball, state): (&Ball, &State),
        restitution: Option<f64>,
    ) -> Rebound {
        let plan = |v: DVec3| DVec2::new(v.x, v.z);
        let (_, mut away) = cushion.nearest(plan(state.position));
        if !state.motion.flies() && away.dot(plan(state.velocity)) > 0.0 {
            away = -away;
        }
        let contact = CushionContact {
            normal: DVec3::new(away.x, 0.0, away.y),
            nose_height: self.nose_height(table.nose_height, ball, cushion),
            nose: table.nose,
            restitution,
        };
        self.rebound(ball, state, &contact)
    }

    /// Velocities after the rebound; position and motion label are left as they are. A ball that leaves the cushion
    /// is returned unchanged.
    #[must_use]
    pub fn rebound(&self, ball: &Ball, state: &State, contact: &CushionContact) -> Rebound {
        let normal = if state.motion == Motion::Airborne {
            contact.normal_in_space(ball, state)
        } else {
            contact.normal
        };
        if state.velocity.dot(normal) >= 0.0 {
            return Rebound {
                state: *state,
                impulse: 0.0,
            };
        }
        let mut after = if state.motion == Motion::Airborne {
            self.throw(ball, state, contact, normal)
        } else if ball.spins {
            self.roll(ball, state, contact)
        } else {
            self.mirror(state, contact)
        };
        // An inclined impact that gives back little, or rubs the ball downwards, leaves it wedged between nose and slate
        // and still on its way in; the slate, which no cushion law knows, then takes up the rest.
        let inward = after.velocity.dot(normal).min(0.0);
        after.velocity -= inward * normal;
        Rebound {
            state: after,
            impulse: ball.mass * (after.velocity - state.velocity).dot(normal),
        }
    }

    /// Restitution alone, for a ball on the slate.
    fn mirror(&self, state: &State, contact: &CushionContact) -> State {
        let restitution = self.own_restitution();
        Mirror { restitution }.reflect(state, contact)
    }

    /// A ball in flight: no cloth, no slate.
    fn throw(&self, ball: &Ball, state: &State, contact: &CushionContact, normal: DVec3) -> State {
        let into = -state.velocity.dot(contact.normal);
        let along = state.velocity.cross(contact.normal).y;
        let restitution = contact
            .restitution
            .unwrap_or_else(|| self.restitution(-state.velocity.dot(normal)));
        let friction = self.friction(into.max(0.0), along);
        impulse::throw(ball, state, normal, restitution, friction)
    }

    /// The law's own restitution for a ball that comes with this speed in m/s along the normal.
    #[must_use]
    pub fn restitution(&self, speed: f64) -> f64 {
        self.own_restitution().at(speed)
    }
}
