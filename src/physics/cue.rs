//! The cue and the stroke.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::laws::{Check, Parameter};

/// A cue.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Cue {
    /// Mass in kg.
    pub mass: f64,
    /// Restitution of the tip, 0 to 1.
    pub tip_restitution: f64,
    /// Mass in kg at the front of the shaft that a sideways hit has to move: the cause of squirt.
    pub end_mass: f64,
    /// Largest offset of the contact from the centre of the ball, in R, at which the tip still grips.
    pub miscue_offset: f64,
}

impl Default for Cue {
    /// A 20 oz playing cue with a leather tip (Alciatore's FAQ); end mass a thirtieth of a pool ball.
    fn default() -> Self {
        Self {
            mass: 0.567,
            tip_restitution: 0.73,
            end_mass: 0.005_67,
            miscue_offset: 0.5,
        }
    }
}

impl Check for Cue {
    fn parameters(&self) -> Vec<Parameter> {
        vec![
            Parameter::new("mass", self.mass, 1e-3, 1e3),
            Parameter::new("tip_restitution", self.tip_restitution, 0.0, 1.0),
            Parameter::new("end_mass", self.end_mass, 0.0, 1e3),
            Parameter::new("miscue_offset", self.miscue_offset, 0.0, 0.99),
        ]
    }
}

/// One stroke of the cue.
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
