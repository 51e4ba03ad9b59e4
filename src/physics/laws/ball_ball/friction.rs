//! The coefficient of friction between two balls.

use serde::{Deserialize, Serialize};

use crate::physics::laws::{Check, Parameter};

/// How ball-ball friction depends on the speed of slip.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Friction {
    /// The same at every speed.
    Constant(f64),
    /// μ = a + b exp(−c s), s the slip speed in m/s. Fit of Alciatore (TP A.14) to three points of Marlow,
    /// so between 0.1 and 10 m/s only.
    Marlow {
        /// Friction at high speed, 1.
        a: f64,
        /// What is added at zero speed, 1.
        b: f64,
        /// How fast it falls, s/m.
        c: f64,
    },
}

impl Friction {
    /// Marlow's friction with the coefficients of TP A.14.
    pub const MARLOW: Self = Self::Marlow {
        a: 9.951e-3,
        b: 0.108,
        c: 1.088,
    };

    /// The coefficient at this slip speed in m/s.
    #[must_use]
    pub fn coefficient(&self, slip_speed: f64) -> f64 {
        match *self {
            Self::Constant(coefficient) => coefficient,
            Self::Marlow { a, b, c } => a + b * libm::exp(-c * slip_speed),
        }
    }
}

/// What is known of the friction between balls.
const BASIS: &str = "clean balls measure 0.03 to 0.08, Alciatore, physical properties, other sets 0.10 to 0.11, Domenech \
                     2023, and chalk up to 2.5 times as much";

impl Check for Friction {
    fn parameters(&self) -> Vec<Parameter> {
        match *self {
            Self::Constant(coefficient) => {
                vec![Parameter::new("friction", coefficient, 0.0, 2.0).basis(BASIS)]
            }
            Self::Marlow { a, b, c } => vec![
                Parameter::new("friction.a", a, 0.0, 2.0).basis(BASIS),
                Parameter::new("friction.b", b, 0.0, 2.0).basis(BASIS),
                Parameter::new("friction.c", c, 0.0, 1e3)
                    .basis("s/m; Marlow's data give 1.088, Alciatore TP A.14"),
            ],
        }
    }
}
