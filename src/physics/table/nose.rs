//! The nose of a cushion in profile: where a ball meets it.

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What a ball meets of a cushion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Nose {
    /// A wall without top: every ball touches it when its centre is R away in plan, however high it flies. The walls of
    /// boxes, and of models that know no profile.
    #[default]
    Wall,
    /// A rounded edge at the nose height: a ball touches it where spheres touch, so one on the slate is a little nearer
    /// than R in plan, and one that flies high enough clears it.
    Round {
        /// Radius of the rounding in m; 0 is the sharp edge of the papers.
        #[serde(default)]
        radius: f64,
    },
}

impl Nose {
    /// Distance in plan in m from the nose line at which a ball of this radius on the slate touches a nose at this
    /// height; for a wall its radius. A ball that the nose passes over has none: it counts as touching with its centre.
    #[inline]
    #[must_use]
    pub fn reach(&self, nose_height: f64, radius: f64) -> f64 {
        self.reach_at(nose_height, radius, radius).unwrap_or(0.0)
    }

    /// The same for a ball whose centre is at any height in m; `None` if it passes over or under the nose.
    #[must_use]
    pub fn reach_at(&self, nose_height: f64, radius: f64, height: f64) -> Option<f64> {
        match *self {
            Self::Wall => Some(radius),
            Self::Round { radius: rounding } => {
                let (length, rise) = (radius + rounding, nose_height - height);
                let square = length * length - rise * rise;
                (square >= 0.0).then(|| square.sqrt() - rounding)
            }
        }
    }

    /// Sine of the angle by which the line from the centre of a ball at this height to what it touches rises.
    #[must_use]
    pub fn sine(&self, nose_height: f64, radius: f64, height: f64) -> f64 {
        let rounding = match *self {
            Self::Wall => 0.0,
            Self::Round { radius } => radius,
        };
        ((nose_height - height) / (radius + rounding)).clamp(-1.0, 1.0)
    }

    /// Unit vector in space from what is touched to the centre of a ball at this height, for a horizontal unit vector
    /// from the nose to the ball and their distance in plan in m: as they are, not as they would be at the very contact,
    /// or a ball that leaves along its nose would be found to approach again by rounding. A wall always pushes level.
    #[must_use]
    pub fn normal(&self, level: DVec3, nose_height: f64, distance: f64, height: f64) -> DVec3 {
        match *self {
            Self::Wall => level,
            Self::Round { radius } => {
                let offset = (distance + radius) * level + (height - nose_height) * DVec3::Y;
                offset.try_normalize().unwrap_or(level)
            }
        }
    }
}
