//! The cue and the stroke.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::Ball;
use crate::physics::laws::{Check, Parameter};

/// What a tip is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Tip {
    /// The leather of a playing cue.
    Leather,
    /// The hard tip of a break or jump cue.
    Phenolic,
}

impl Tip {
    /// Every kind of tip.
    pub const ALL: [Self; 2] = [Self::Leather, Self::Phenolic];

    /// Restitution as measured, least and greatest (Alciatore, FAQ on cue tips).
    #[must_use]
    pub fn measured_restitution(self) -> (f64, f64) {
        match self {
            Self::Leather => (0.71, 0.75),
            Self::Phenolic => (0.81, 0.87),
        }
    }

    /// The middle of what is measured.
    #[must_use]
    pub fn restitution(self) -> f64 {
        match self {
            Self::Leather => 0.73,
            Self::Phenolic => 0.84,
        }
    }
}

/// The shape of a cue: a cone from the tip to the butt.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Stick {
    /// From tip to butt, m.
    pub length: f64,
    /// Diameter at the tip, m.
    pub tip_width: f64,
    /// Diameter at the butt, m.
    pub butt_width: f64,
}

impl Default for Stick {
    /// 58 in long, 13 mm at the tip (at most 14 mm by the WPA) and 29 mm at the butt.
    fn default() -> Self {
        Self {
            length: 1.473,
            tip_width: 0.013,
            butt_width: 0.029,
        }
    }
}

/// A cue.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Cue {
    /// Mass in kg.
    pub mass: f64,
    /// Restitution of the tip, 0 to 1; see [`Tip`].
    pub tip_restitution: f64,
    /// Radius in m of the sphere to which the end of the tip is rounded. It changes no stroke, because a [`Shot`] names the
    /// contact, but it says where the tip has to be held for that contact: see [`tip_offset`](Self::tip_offset).
    pub tip_radius: f64,
    /// Mass in kg at the front of the shaft that a sideways hit has to move: the cause of squirt.
    pub end_mass: f64,
    /// Largest offset of the contact from the centre of the ball, in R, at which the tip still grips: the sine of its
    /// angle of friction, see [`tip_friction`](Self::tip_friction).
    pub miscue_offset: f64,
    /// Its shape.
    pub stick: Stick,
}

impl Default for Cue {
    /// A 20 oz playing cue with a leather tip that slips at half the radius (Alciatore's FAQ); the tip rounded like a US
    /// nickel, 10.6 mm, as pooltool has it; end mass a thirtieth of a pool ball (TP A.31).
    fn default() -> Self {
        Self {
            mass: 0.567,
            tip_restitution: Tip::Leather.restitution(),
            tip_radius: 0.010_6,
            end_mass: 0.005_67,
            miscue_offset: 0.5,
            stick: Stick::default(),
        }
    }
}

impl Cue {
    /// The same cue with another tip.
    #[must_use]
    pub fn with_tip(self, tip: Tip) -> Self {
        Self {
            tip_restitution: tip.restitution(),
            ..self
        }
    }

    /// Offset of the middle of the tip, in R, that makes a contact at an offset of 1 R on this ball. Tip and ball touch on
    /// the line of their centres, so it is 1 + r/R: a round tip has to be held farther out than it hits.
    #[must_use]
    pub fn tip_offset(&self, ball: &Ball) -> f64 {
        1.0 + self.tip_radius / ball.radius
    }

    /// The coefficient of friction between tip and ball that belongs to the miscue offset. Where the contact lies b from
    /// the centre the cue leans asin b from the normal, and friction holds it while tan asin b ≤ μ. Alciatore's 0.6 gives
    /// 0.514 R, his miscue limit of 0.5 R gives 0.577.
    #[must_use]
    pub fn tip_friction(&self) -> f64 {
        let b = self.miscue_offset;
        b / (1.0 - b * b).sqrt()
    }

    /// The miscue offset in R of a tip with this coefficient of friction.
    #[must_use]
    pub fn miscue_offset_of(friction: f64) -> f64 {
        friction / (1.0 + friction * friction).sqrt()
    }
}

impl Check for Cue {
    fn parameters(&self) -> Vec<Parameter> {
        let stick = &self.stick;
        vec![
            Parameter::new("mass", self.mass, 1e-3, 1e3)
                .basis("kg; playing cues 0.45 to 0.71, the most the WPA allows"),
            Parameter::new("tip_restitution", self.tip_restitution, 0.0, 1.0).basis(
                "above 1 a stroke would make energy; leather measures 0.71 to 0.75, phenolic 0.81 to 0.87, Alciatore, FAQ \
                 on cue tips",
            ),
            Parameter::new("tip_radius", self.tip_radius, 0.0, 0.1)
                .basis("m; tips are rounded like a dime, 0.009, or a nickel, 0.0106"),
            Parameter::new("end_mass", self.end_mass, 0.0, 1e3)
                .basis("kg; a twentieth to a thirtieth of a ball, Alciatore, TP A.31"),
            Parameter::new("miscue_offset", self.miscue_offset, 0.0, 0.99)
                .basis("R; tips slip beyond about 0.5, Alciatore, FAQ on miscues"),
            Parameter::new("stick.length", stick.length, 0.1, 10.0)
                .basis("m; at least 1.016 by the WPA"),
            Parameter::new("stick.tip_width", stick.tip_width, 1e-4, 0.1)
                .basis("m; at most 0.014 by the WPA"),
            Parameter::new("stick.butt_width", stick.butt_width, 1e-4, 0.2)
                .basis("m; butts are about 0.03 thick"),
        ]
    }
}

/// One stroke of the cue.
///
/// `side` and `height` say where the ball is touched, not where the tip is held: so the same shot is the same stroke with
/// any tip, and the formulas hold as they are printed. Who places a tip converts with [`Cue::tip_offset`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shot {
    /// Direction of the cue in the plane in rad, counter-clockwise seen from above from the x axis.
    pub heading: f64,
    /// Angle of the cue above the horizontal in rad.
    pub elevation: f64,
    /// Contact to the shooter's right of the centre, in R: right english.
    pub side: f64,
    /// Contact above the centre, square to the cue, in R: follow; below zero draw.
    pub height: f64,
    /// Speed of the cue at impact in m/s.
    pub speed: f64,
}

impl Default for Shot {
    fn default() -> Self {
        Self {
            heading: 0.0,
            elevation: 0.0,
            side: 0.0,
            height: 0.0,
            speed: 2.0,
        }
    }
}

impl Shot {
    /// Unit vector of the heading in the plane.
    #[must_use]
    pub fn forward(&self) -> DVec3 {
        DVec3::new(libm::cos(self.heading), 0.0, -libm::sin(self.heading))
    }

    /// Unit vector along which the cue moves.
    #[must_use]
    pub fn along(&self) -> DVec3 {
        libm::cos(self.elevation) * self.forward() - libm::sin(self.elevation) * DVec3::Y
    }

    /// Unit vector from the centre of the ball to the point that the tip touches. An offset beyond 1 gives the rim of the
    /// ball, not of length 1.
    #[must_use]
    pub fn contact(&self) -> DVec3 {
        let forward = self.forward();
        let right = forward.cross(DVec3::Y);
        let (sin, cos) = (libm::sin(self.elevation), libm::cos(self.elevation));
        let along = cos * forward - sin * DVec3::Y;
        let up = sin * forward + cos * DVec3::Y;
        let offset = self.offset();
        let depth = (1.0 - offset * offset).max(0.0).sqrt();
        self.side * right + self.height * up - depth * along
    }

    /// The heading in rad from one point to another.
    #[must_use]
    pub fn heading_between(from: DVec3, to: DVec3) -> f64 {
        libm::atan2(-(to.z - from.z), to.x - from.x)
    }

    /// Distance of the contact from the centre of the ball in R.
    #[must_use]
    pub fn offset(&self) -> f64 {
        (self.side * self.side + self.height * self.height).sqrt()
    }
}

impl Check for Shot {
    fn parameters(&self) -> Vec<Parameter> {
        vec![
            Parameter::new("heading", self.heading, -1e3, 1e3),
            Parameter::new("elevation", self.elevation, 0.0, 1.56),
            Parameter::new("side", self.side, -0.99, 0.99),
            Parameter::new("height", self.height, -0.99, 0.99),
            Parameter::new("offset", self.offset(), 0.0, 0.99),
            Parameter::new("speed", self.speed, 0.0, 100.0),
        ]
    }
}
