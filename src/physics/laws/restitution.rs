//! Restitution and friction of rubber, which may depend on how it is met.
//!
//! Experiments disagree about the sign: Mathavan, Jackson & Parkin (2010, fig. 7a) and Sudo & Shibata (2002) find that a
//! fast ball gets less of its speed back, 0.95 at 1.5 m/s and 0.80 at 3.4 m/s, for rubber that is pressed deep loses more;
//! Han (2005, eq. 26) fits a restitution that rises from 0.51 at 0.5 m/s to 0.76 at 2.5 m/s. A slow ball that is tracked
//! too late has already lost speed to the cloth, so the rise may be no property of the rubber. Both can be chosen.

use serde::{Deserialize, Serialize};

use crate::physics::laws::Parameter;

/// Restitution, by the speed in m/s with which the ball meets the cushion along the horizontal normal. In a scene file
/// a number, `(at_rest: …, fall: …, floor: …)`, or the five fields of [`Restitution::Quadratic`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(
    untagged,
    deny_unknown_fields,
    expecting = "a number, (at_rest, fall, floor) or (at_rest, slope, bend, slowest, fastest)"
)]
pub enum Restitution {
    /// The same at every speed.
    Constant(f64),
    /// `at_rest` − fall · v, between `floor` and 1.
    Linear {
        /// Value at zero speed; above 1 it counts as 1.
        at_rest: f64,
        /// Loss per speed, s/m.
        fall: f64,
        /// The least it falls to.
        floor: f64,
    },
    /// `at_rest` + slope · v + bend · v² for v between `slowest` and `fastest`, and the value at the nearer end outside.
    Quadratic {
        /// Value at zero speed.
        at_rest: f64,
        /// s/m.
        slope: f64,
        /// s²/m².
        bend: f64,
        /// Least speed of the fit, m/s.
        slowest: f64,
        /// Greatest speed of the fit, m/s.
        fastest: f64,
    },
}

impl Restitution {
    /// Han's fit (2005, eq. 26): rises with speed.
    pub const HAN: Self = Self::Quadratic {
        at_rest: 0.39,
        slope: 0.257,
        bend: -0.044,
        slowest: 0.5,
        fastest: 2.5,
    };

    /// Restitution at this normal speed in m/s.
    #[inline]
    #[must_use]
    pub fn at(&self, speed: f64) -> f64 {
        match *self {
            Self::Constant(restitution) => restitution,
            Self::Linear {
                at_rest,
                fall,
                floor,
            } => (at_rest - fall * speed).max(floor).min(1.0),
            Self::Quadratic {
                at_rest,
                slope,
                bend,
                slowest,
                fastest,
            } => {
                let speed = speed.max(slowest).min(fastest);
                (at_rest + speed * (slope + speed * bend)).clamp(0.0, 1.0)
            }
        }
    }

    /// Its numbers, as parameters of a law whose own range of restitution rests on `basis`.
    pub(super) fn parameters(&self, basis: &'static str) -> Vec<Parameter> {
        let part = |field: &str, value, least, most| {
            Parameter::new(&format!("restitution.{field}"), value, least, most).basis(basis)
        };
        match *self {
            Self::Constant(value) => {
                vec![Parameter::new("restitution", value, 0.0, 1.0).basis(basis)]
            }
            Self::Linear {
                at_rest,
                fall,
                floor,
            } => vec![
                part("at_rest", at_rest, 0.0, 2.0),
                part("fall", fall, -10.0, 10.0),
                part("floor", floor, 0.0, 1.0),
            ],
            Self::Quadratic {
                at_rest,
                slope,
                bend,
                slowest,
                fastest,
            } => vec![
                part("at_rest", at_rest, -10.0, 10.0),
                part("slope", slope, -10.0, 10.0),
                part("bend", bend, -10.0, 10.0),
                part("slowest", slowest, 0.0, 1e3),
                part("fastest", fastest, slowest.max(0.0), 1e3),
            ],
        }
    }
}

impl From<f64> for Restitution {
    fn from(restitution: f64) -> Self {
        Self::Constant(restitution)
    }
}

/// Friction between ball and nose. In a scene file a number or `(head_on: …, fall: …)`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(
    untagged,
    deny_unknown_fields,
    expecting = "a number or (head_on, fall)"
)]
pub enum NoseFriction {
    /// The same at every angle.
    Constant(f64),
    /// `head_on` − fall · angle, at least 0, with the angle in rad between path and normal, in plan.
    ByAngle {
        /// Coefficient square into the cushion.
        head_on: f64,
        /// Loss per rad.
        fall: f64,
    },
}

impl NoseFriction {
    /// Han's fit (2005): 0.47 square on, 0.09 along the cushion.
    pub const HAN: Self = Self::ByAngle {
        head_on: 0.471,
        fall: 0.241,
    };

    /// Coefficient for a ball that comes with these speeds into the cushion and along it.
    #[inline]
    #[must_use]
    pub fn at(&self, into: f64, along: f64) -> f64 {
        match *self {
            Self::Constant(friction) => friction,
            Self::ByAngle { head_on, fall } => {
                (head_on - fall * libm::atan2(along.abs(), into)).max(0.0)
            }
        }
    }

    /// Its numbers, as parameters of a law whose own range of friction rests on `basis`.
    pub(super) fn parameters(&self, basis: &'static str) -> Vec<Parameter> {
        match *self {
            Self::Constant(value) => vec![Parameter::new("friction", value, 0.0, 2.0).basis(basis)],
            Self::ByAngle { head_on, fall } => vec![
                Parameter::new("friction.head_on", head_on, 0.0, 2.0).basis(basis),
                Parameter::new("friction.fall", fall, -2.0, 2.0).basis(basis),
            ],
        }
    }
}

impl From<f64> for NoseFriction {
    fn from(friction: f64) -> Self {
        Self::Constant(friction)
    }
}
