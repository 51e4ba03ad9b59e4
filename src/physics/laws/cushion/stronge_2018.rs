//! Impact of a sphere with a compliant nose: restitution along the normal, friction and tangential give across it.
//!
//! The rubber yields along the normal and across it like two springs with frequencies ωₙ and ωₜ. Depending on the ratio
//! k of tangential to normal speed the contact sticks at first and slips at the end, slips, sticks and slips, or slips
//! all the way. With βₜ = 7/2 for a homogeneous sphere, η² = βₜ/(ωₜ/ωₙ)², time in units of 1/ωₙ:
//!
//! | k | phases |
//! |---|---|
//! | k < μ η² | stick, slip |
//! | between | slip, stick, slip |
//! | k > μ βₜ and k > μ ((1 + e) βₜ − η²/e) | slip |
//!
//! Sources: Stronge, Impact Mechanics, 2nd ed. (2018), section 5.4 (tangential compliance); as used for cushions by
//! pooltool. Homogeneous in speed. The vertical part of the outcome is dropped; the cloth's push is not modelled.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::cushion::{CushionContact, Cushioning};
use crate::physics::laws::restitution::Restitution;
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};
use crate::physics::table::Cushion;

/// βₜ of a homogeneous sphere.
const BETA: f64 = 3.5;

/// Where in the second half of the contact a gap between spring and cone is looked for, as shares of it.
const GAPS: [f64; 8] = [1e-6, 1e-3, 0.03, 0.125, 0.25, 0.5, 0.75, 0.9];

/// Where the nose is taken to touch the ball.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Inclination {
    /// Where a sphere that rests against an edge at the height of the nose is touched: sin θ = h/R − 1.
    #[default]
    Touching,
    /// As the peer pooltool has it, for comparison only: along the line from the axis of the nose to the centre of a
    /// ball whose distance in plan is R, so tan θ = h/R − 1, and with R plus its radius in place of R for a jaw.
    Peer,
}

impl Inclination {
    /// Sine and cosine of the angle by which the line from the centre of a ball on the slate to the nose rises.
    pub(super) fn of(self, ball: &Ball, contact: &CushionContact) -> (f64, f64) {
        match self {
            Self::Touching => {
                let sin = contact.sine(ball);
                (sin, (1.0 - sin * sin).sqrt())
            }
            Self::Peer => {
                let rise = contact.nose_height / ball.radius - 1.0;
                let length = (1.0 + rise * rise).sqrt();
                (rise / length, 1.0 / length)
            }
        }
    }

    /// The height of the nose to be used for this stretch of cushion: only the peer's geometry of jaws differs.
    pub(super) fn nose_height(self, height: f64, ball: &Ball, cushion: &Cushion) -> f64 {
        match (self, cushion) {
            (Self::Peer, Cushion::Arc(arc)) => {
                ball.radius + (height - ball.radius) * ball.radius / (ball.radius + arc.radius)
            }
            _ => height,
        }
    }
}

/// Stronge's compliant cushion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stronge2018 {
    /// Coefficient of restitution along the inclined normal, 0 to 1.
    pub restitution: Restitution,
    /// Coefficient of friction between ball and rubber.
    pub friction: f64,
    /// ωₜ/ωₙ, between 1 and 2.
    pub frequency_ratio: f64,
    /// Where the nose touches.
    #[serde(default)]
    pub inclination: Inclination,
}

impl Default for Stronge2018 {
    /// Restitution and friction as for [`super::Han2005`]; the ratio of pooltool's default set.
    fn default() -> Self {
        Self {
            restitution: 0.85.into(),
            friction: 0.2,
            frequency_ratio: 1.8,
            inclination: Inclination::Touching,
        }
    }
}

impl Stronge2018 {
    /// Slip that is left in the direction of the slip before, as a multiple of the closing speed, for a slip of
    /// `k` closing speeds before.
    fn tangential(&self, e: f64, k: f64) -> f64 {
        let (mu, ratio) = (self.friction, self.frequency_ratio);
        if mu == 0.0 {
            return k;
        }
        let eta = BETA / (ratio * ratio);
        // Slip that ends in compression, k < μ βₜ, cannot last all the way, whatever the second bound says for e < ωₙ/ωₜ.
        if k > mu * BETA.max((1.0 + e) * BETA - eta / e) {
            return k - mu * BETA * (1.0 + e);
        }
        let quarter = std::f64::consts::FRAC_PI_2;
        let (turn, end) = (quarter, (1.0 + e) * quarter);
        // The normal force after the turn falls like the sine of this phase.
        let phase = |t: f64| t / e + quarter * (1.0 - 1.0 / e);
        // The slip while sticking, as a spring that starts at time t₁ with stretch u and speed v; speeds against the
        // direction of slip count negative, as in the book.
        let (start, stretch, speed) = if k < mu * eta {
            (0.0, 0.0, -k)
        } else if k <= mu * BETA {
            let t = libm::acos(((k / mu - BETA) / (eta - BETA)).clamp(-1.0, 1.0));
            (
                t,
                mu * eta * libm::sin(t),
                -k + mu * BETA * (1.0 - libm::cos(t)),
            )
        } else {
            let cos = ((k / mu - BETA) / (eta / e - e * BETA)).clamp(-1.0, 1.0);
            let t = e * (libm::acos(cos) - quarter * (1.0 - 1.0 / e));
            let late = phase(t);
            (
                t,
                mu * eta * libm::sin(late),
                -k + mu * BETA * (1.0 - e * libm::cos(late)),
            )
        };
        let spring = |t: f64| {
            let angle = ratio * (t - start);
            stretch * libm::cos(angle) - speed / ratio * libm::sin(angle)
        };
        let excess = |t: f64| spring(t).abs() / mu - eta * libm::sin(phase(t));
        // Sticking that begins after the turn begins with spring and cone touching, a double root, and near the end of its
        // range the gap behind it is hardly wider than rounding. So the search starts where the gap is wide; where there is
        // none, sticking lasts to the end.
        let from = turn.max(start);
        let widest = GAPS
            .map(|share| from + share * (end - from))
            .into_iter()
            .min_by(|a, b| excess(*a).total_cmp(&excess(*b)))
            .filter(|time| excess(*time) < -1e-12);
        let slip_at = widest.map_or(end, |time| crossing(excess, time, end));
        let angle = ratio * (slip_at - start);
        let sticking = ratio * stretch * libm::sin(angle) + speed * libm::cos(angle);
        BETA * mu * e * (1.0 + libm::cos(phase(slip_at))) - sticking
    }
}

impl Cushioning for Stronge2018 {
    const SOURCE: Source = Source {
        paper: "Stronge, Impact Mechanics, 2nd ed. (2018), section 5.4",
        formula: "springs along and across the normal, ωₜ/ωₙ given: stick, slip, or both in turn",
        leaves_out: "the cloth under the ball",
    };

    fn rebound(&self, ball: &Ball, state: &State, contact: &CushionContact) -> State {
        // The formulas divide by e; a blow without any rebound is the limit.
        let restitution = contact
            .restitution
            .unwrap_or_else(|| self.restitution.at(-state.velocity.dot(contact.normal)))
            .max(1e-6);
        let (sin, cos) = self.inclination.of(ball, contact);
        let normal = cos * contact.normal - sin * DVec3::Y;
        let slip = state.velocity - ball.radius * state.angular_velocity.cross(normal);
        let closing = slip.dot(normal);
        let across = slip - closing * normal;
        let speed = across.length();
        let mut after = *state;
        if closing >= 0.0 {
            // The ball climbs away from an inclined nose though it moves towards it in plan.
            after.velocity -=
                (1.0 + restitution) * state.velocity.dot(contact.normal) * contact.normal;
            return after;
        }
        let mut impulse = -(1.0 + restitution) * closing * normal;
        if speed > 0.0 {
            let left = self.tangential(restitution, speed / -closing) * -closing;
            impulse += ((left - speed) / BETA / speed) * across;
        }
        after.velocity += impulse;
        after.angular_velocity -= (2.5 / ball.radius) * normal.cross(impulse);
        after.velocity.y = state.velocity.y;
        after
    }

    fn restitution(&self) -> Restitution {
        self.restitution
    }

    fn friction(&self, _into: f64, _along: f64) -> f64 {
        self.friction
    }

    fn nose_height(&self, height: f64, ball: &Ball, cushion: &Cushion) -> f64 {
        self.inclination.nose_height(height, ball, cushion)
    }
}

/// The time in [a, b] at which a function that is negative at a becomes positive, to 1e-15, by regula falsi with the
/// correction of Anderson & Björck (1973), at most 60 steps; an end where there is no change of sign.
fn crossing(f: impl Fn(f64) -> f64, mut a: f64, mut b: f64) -> f64 {
    let (mut fa, mut fb) = (f(a), f(b));
    if fa >= 0.0 {
        return a;
    }
    if fb <= 0.0 {
        return b;
    }
    for _ in 0..60 {
        let t = b - fb * (b - a) / (fb - fa);
        let ft = f(t);
        if ft == 0.0 || (b - a).abs() <= 1e-15 {
            return t;
        }
        if (ft > 0.0) == (fb > 0.0) {
            let scale = 1.0 - ft / fb;
            fa *= if scale > 0.0 { scale } else { 0.5 };
        } else {
            (a, fa) = (b, fb);
        }
        (b, fb) = (t, ft);
    }
    b
}

impl Check for Stronge2018 {
    fn parameters(&self) -> Vec<Parameter> {
        let mut parameters = self.restitution.parameters(super::RESTITUTION);
        parameters.extend([
            Parameter::new("friction", self.friction, 0.0, 2.0).basis(super::FRICTION),
            Parameter::new("frequency_ratio", self.frequency_ratio, 1.000_001, 2.0),
        ]);
        parameters
    }
}
