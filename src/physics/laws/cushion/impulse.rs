//! Rigid impact along the true contact normal in space, with Coulomb friction.
//!
//! Jₙ = (1 + e) m |v·n| along n, from the nose to the centre; against the slip at the nose min(μ Jₙ, (2/7) m |u|). A
//! ball in flight keeps all of the outcome: every cushion law throws it so, with its own e and μ. A ball on the slate
//! keeps its vertical velocity; what the nose drives into the table is lost.
//!
//! Source: the impulse law of a homogeneous sphere with Coulomb friction, as in Alciatore, TP A.14, for two balls; as
//! used for cushions by pooltool, `impulse_frictional_inelastic`.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::cushion::{CushionContact, Cushioning, Inclination};
use crate::physics::laws::restitution::{NoseFriction, Restitution};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};
use crate::physics::table::Cushion;

/// A rigid, rough nose.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Impulse {
    /// Coefficient of restitution along the normal in space, 0 to 1.
    pub restitution: Restitution,
    /// Coefficient of friction between ball and nose.
    pub friction: NoseFriction,
    /// Where the nose touches.
    #[serde(default)]
    pub inclination: Inclination,
}

impl Default for Impulse {
    /// Restitution and friction as for [`super::Han2005`].
    fn default() -> Self {
        Self {
            restitution: 0.85.into(),
            friction: 0.2.into(),
            inclination: Inclination::Touching,
        }
    }
}

impl Cushioning for Impulse {
    const SOURCE: Source = Source {
        paper: "Coulomb impact of a sphere as in Alciatore, TP A.14; pooltool, impulse_frictional_inelastic",
        formula: "Jₙ = (1 + e) m |v·n| in space, min(μ Jₙ, (2/7) m |u|) across it",
        leaves_out: "the cloth under the ball, and give along the rubber",
    };

    fn rebound(&self, ball: &Ball, state: &State, contact: &CushionContact) -> State {
        let (sin, cos) = self.inclination.of(ball, contact);
        let normal = cos * contact.normal - sin * DVec3::Y;
        let into = -state.velocity.dot(contact.normal);
        let along = state.velocity.cross(contact.normal).y;
        let restitution = contact
            .restitution
            .unwrap_or_else(|| self.restitution.at(into));
        let mut after = throw(
            ball,
            state,
            normal,
            restitution,
            self.friction.at(into, along),
        );
        after.velocity.y = state.velocity.y;
        after
    }

    fn restitution(&self) -> Restitution {
        self.restitution
    }

    fn friction(&self, into: f64, along: f64) -> f64 {
        self.friction.at(into, along)
    }

    fn nose_height(&self, height: f64, ball: &Ball, cushion: &Cushion) -> f64 {
        self.inclination.nose_height(height, ball, cushion)
    }
}

/// Velocities of a ball thrown back along a unit normal that points to its centre.
pub(super) fn throw(
    ball: &Ball,
    state: &State,
    normal: DVec3,
    restitution: f64,
    friction: f64,
) -> State {
    let mut after = *state;
    let closing = -state.velocity.dot(normal);
    if closing <= 0.0 {
        return after;
    }
    let change = (1.0 + restitution) * closing;
    after.velocity += change * normal;
    if !ball.spins {
        return after;
    }
    let slip =
        state.velocity + closing * normal - ball.radius * state.angular_velocity.cross(normal);
    let speed = slip.length();
    if speed > 0.0 {
        let rub = -(friction * change).min(2.0 / 7.0 * speed) / speed * slip;
        after.velocity += rub;
        after.angular_velocity -= 2.5 / ball.radius * normal.cross(rub);
    }
    after
}

impl Check for Impulse {
    fn parameters(&self) -> Vec<Parameter> {
        let mut parameters = self.restitution.parameters(super::RESTITUTION);
        parameters.extend(self.friction.parameters(super::FRICTION));
        parameters
    }
}
