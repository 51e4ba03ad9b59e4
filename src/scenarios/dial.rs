//! The five numbers of a stroke, as a person turns them.

use serde::{Deserialize, Serialize};

use crate::physics::cue::Shot;

/// A number of a stroke.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Dial {
    /// Degrees, counter-clockwise seen from above from the x axis.
    Heading,
    /// Speed of the cue, m/s.
    Speed,
    /// Contact to the right of the centre, R.
    Side,
    /// Contact above the centre, R.
    Height,
    /// Degrees above the horizontal.
    Elevation,
}

impl Dial {
    /// Every number.
    pub const ALL: [Self; 5] = [
        Self::Heading,
        Self::Speed,
        Self::Side,
        Self::Height,
        Self::Elevation,
    ];

    /// What the command line calls it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Heading => "heading",
            Self::Speed => "speed",
            Self::Side => "side",
            Self::Height => "height",
            Self::Elevation => "elevation",
        }
    }

    /// The unit in which it is given.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Heading | Self::Elevation => "degrees",
            Self::Speed => "m/s",
            Self::Side | Self::Height => "R",
        }
    }

    /// How far off a good player is, in this unit: the numbers that make robust and delicate shots comparable. Heading after
    /// the width of a pot at 2 m, the tip a millimetre and a half.
    #[must_use]
    pub fn human_error(self) -> f64 {
        match self {
            Self::Heading => 0.2,
            Self::Speed | Self::Side | Self::Height => 0.05,
            Self::Elevation => 1.0,
        }
    }

    /// The value in a stroke.
    #[must_use]
    pub fn get(self, shot: &Shot) -> f64 {
        match self {
            Self::Heading => shot.heading.to_degrees(),
            Self::Speed => shot.speed,
            Self::Side => shot.side,
            Self::Height => shot.height,
            Self::Elevation => shot.elevation.to_degrees(),
        }
    }

    /// Turns it to a value.
    pub fn set(self, shot: &mut Shot, value: f64) {
        match self {
            Self::Heading => shot.heading = value.to_radians(),
            Self::Speed => shot.speed = value,
            Self::Side => shot.side = value,
            Self::Height => shot.height = value,
            Self::Elevation => shot.elevation = value.to_radians(),
        }
    }

    /// The ends between which it can be turned, the offset of the tip kept where the tip grips.
    #[must_use]
    pub fn limits(self, shot: &Shot, miscue_offset: f64) -> (f64, f64) {
        let across = |other: f64| {
            let most = (miscue_offset * miscue_offset - other * other)
                .max(0.0)
                .sqrt();
            (-most, most)
        };
        match self {
            Self::Heading => (f64::NEG_INFINITY, f64::INFINITY),
            Self::Speed => (0.0, 20.0),
            Self::Side => across(shot.height),
            Self::Height => across(shot.side),
            Self::Elevation => (0.0, 89.0),
        }
    }
}
