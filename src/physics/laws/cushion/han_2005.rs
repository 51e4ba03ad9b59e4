//! Rigid impact of a sphere with the nose of a cushion, with friction.
//!
//! The nose stands at height h, so the contact normal is inclined by θ, sin θ = h/R − 1. Along it the impulse is
//! (1 + e) m c, c the closing speed along the horizontal normal times cos θ; across it friction sticks with
//! (2/7) m |s| or slides with μ times the normal impulse. The vertical part of the outcome is dropped.
//!
//! Source: Han, "Dynamics in carom and three cushion billiards", J. Mech. Sci. Tech. 19 (2005) 976, eqs 14 to 20;
//! his own fits of e and μ are [`Restitution::HAN`] and [`NoseFriction::HAN`]. A ball pressed into the cloth by the nose feels no extra table friction here.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::cushion::{CushionContact, Cushioning};
use crate::physics::laws::restitution::{NoseFriction, Restitution};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// Han's cushion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Han2005 {
    /// Coefficient of restitution along the inclined normal, 0 to 1.
    pub restitution: Restitution,
    /// Coefficient of friction between ball and rubber.
    pub friction: NoseFriction,
}

impl Default for Han2005 {
    /// The mean of Alciatore's ranges for pool cushions.
    fn default() -> Self {
        Self {
            restitution: 0.85.into(),
            friction: 0.2.into(),
        }
    }
}

impl Cushioning for Han2005 {
    const SOURCE: Source = Source {
        paper: "Han, J. Mech. Sci. Tech. 19 (2005) 976, eqs 14 to 20; fits eq. 26",
        formula: "Jₙ = (1 + e) m c along the inclined normal, min(μ Jₙ, (2/7) m |s|) across it",
        leaves_out: "the cloth under a ball that the nose presses down, and the vertical outcome",
    };

    fn rebound(&self, ball: &Ball, state: &State, contact: &CushionContact) -> State {
        // Han's axes: x into the cushion, z up, y = z × x.
        let x = -contact.normal;
        let z = DVec3::Y;
        let y = z.cross(x);
        let (v, w) = (state.velocity, state.angular_velocity);
        let (v_x, v_y, v_z) = (v.dot(x), v.dot(y), v.dot(z));
        let (w_x, w_y, w_z) = (w.dot(x), w.dot(y), w.dot(z));
        let restitution = contact
            .restitution
            .unwrap_or_else(|| self.restitution.at(v_x));
        let friction = self.friction.at(v_x, v_y);
        let (m, r) = (ball.mass, ball.radius);
        let sin = contact.sine(ball);
        let cos = (1.0 - sin * sin).sqrt();

        // Slip at the nose (eq. 14) and impulses in the frame of the inclined normal (eqs 17 and 20).
        let s_x = v_x * sin - v_z * cos + r * w_y;
        let s_y = -v_y - r * w_z * cos + r * w_x * sin;
        let slip = (s_x * s_x + s_y * s_y).sqrt();
        let normal = m * (1.0 + restitution) * v_x * cos;
        let sticking = (2.0 / 7.0) * m * slip;
        let scale = if sticking <= friction * normal {
            (2.0 / 7.0) * m
        } else {
            friction * normal / slip
        };
        let (p_xe, p_ye) = (s_x * scale, s_y * scale);
        let p_x = -p_xe * sin - normal * cos;
        let p_y = p_ye;
        let p_z = p_xe * cos - normal * sin;

        let k = r / ball.inertia();
        let mut after = *state;
        after.velocity += (p_x * x + p_y * y) / m;
        after.angular_velocity +=
            k * (-p_y * sin * x + (p_x * sin - p_z * cos) * y + p_y * cos * z);
        after
    }

    fn restitution(&self) -> Restitution {
        self.restitution
    }

    fn friction(&self, into: f64, along: f64) -> f64 {
        self.friction.at(into, along)
    }
}

impl Check for Han2005 {
    fn parameters(&self) -> Vec<Parameter> {
        let mut parameters = self.restitution.parameters(super::RESTITUTION);
        parameters.extend(self.friction.parameters(super::FRICTION));
        parameters
    }
}
