//! The laws of the house, one file a published law.
//!
//! [`Laws`] names one choice per class. Both solvers, the aim preview, the computer players and the tests call the
//! same functions. A new law is one file, one enum variant and one entry in the `all()` of its class.

pub mod ball_ball;
pub mod cluster;
pub mod coursework;
pub mod cue_ball;
pub mod cushion;
pub mod motion;
pub mod pocket;
pub mod slate;

use serde::{Deserialize, Serialize};

use ball_ball::BallBallLaw;
use cushion::CushionLaw;
use motion::{Cloth, MotionLaw};
use pocket::PocketLaw;
use slate::SlateLaw;

/// One choice of law per class. What is absent is not modelled and costs nothing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Laws {
    /// Free motion.
    pub motion: MotionLaw,
    /// Impact of two balls.
    pub ball_ball: BallBallLaw,
    /// Impact of a ball and a cushion.
    pub cushion: CushionLaw,
    /// Impact of a ball and the slate.
    pub slate: SlateLaw,
    /// Capture by a pocket.
    pub pocket: PocketLaw,
}

impl Default for Laws {
    /// Pool as it is played: Coulomb cloth, Marlow's throw, Han's cushion.
    fn default() -> Self {
        Self {
            motion: MotionLaw::Coulomb(Cloth::default()),
            ball_ball: BallBallLaw::Frictional(ball_ball::Frictional::default()),
            cushion: CushionLaw::Han2005(cushion::Han2005::default()),
            slate: SlateLaw::default(),
            pocket: PocketLaw::default(),
        }
    }
}

impl Laws {
    /// No cloth, no friction, nothing lost: the ideal gas of billiard theory.
    #[must_use]
    pub fn ideal() -> Self {
        Self {
            motion: MotionLaw::Frictionless,
            ball_ball: BallBallLaw::Frictionless(ball_ball::Frictionless { restitution: 1.0 }),
            cushion: CushionLaw::Mirror(cushion::Mirror { restitution: 1.0 }),
            slate: SlateLaw::default(),
            pocket: PocketLaw::default(),
        }
    }

    /// The complete model of the coursework report.
    #[must_use]
    pub fn coursework() -> Self {
        Self {
            motion: MotionLaw::Coursework(coursework::Coursework::default()),
            ..Self::ideal()
        }
    }
}

impl Check for Laws {
    fn parameters(&self) -> Vec<Parameter> {
        let classes: [(&str, Vec<Parameter>); 4] = [
            ("motion", self.motion.parameters()),
            ("ball_ball", self.ball_ball.parameters()),
            ("cushion", self.cushion.parameters()),
            ("slate", self.slate.parameters()),
        ];
        classes
            .into_iter()
            .flat_map(|(class, parameters)| parameters.into_iter().map(move |p| p.within(class)))
            .collect()
    }
}

/// A number that a user may set, with the range in which its law is meant.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Path of the field, such as `cushion.restitution`.
    pub field: String,
    /// The value given.
    pub value: f64,
    /// Smallest allowed value.
    pub least: f64,
    /// Largest allowed value.
    pub most: f64,
    /// Where the range comes from, and what has been measured; empty if the range is only a matter of arithmetic.
    pub basis: &'static str,
}

impl Parameter {
    /// A parameter with its allowed range, ends included.
    #[must_use]
    pub fn new(field: &str, value: f64, least: f64, most: f64) -> Self {
        Self {
            field: field.to_owned(),
            value,
            least,
            most,
            basis: "",
        }
    }

    /// The same parameter with the source of its range, and what has been measured: part of the message that refuses a
    /// value.
    #[must_use]
    pub fn basis(mut self, basis: &'static str) -> Self {
        self.basis = basis;
        self
    }

    /// The same parameter with its field path prefixed.
    #[must_use]
    pub fn within(mut self, parent: &str) -> Self {
        self.field = format!("{parent}.{}", self.field);
        self
    }

    /// Whether the value lies in its range; false for NaN.
    #[must_use]
    pub fn is_allowed(&self) -> bool {
        self.value >= self.least && self.value <= self.most
    }
}

/// Something with parameters that can be out of range.
pub trait Check {
    /// Every parameter with its allowed range.
    fn parameters(&self) -> Vec<Parameter>;
}
