//! From where a scenario is to be seen.

use serde::{Deserialize, Serialize};

use crate::physics::scene::{Scene, within};
use crate::scenarios::file::{FieldError, LayoutError};

/// A camera. The first of a scenario is the one with which it opens; two are shown side by side.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Camera {
    /// Straight down on the whole table.
    Overhead,
    /// Behind the cue ball, along the cue.
    BehindCue,
    /// Beside a ball, moving with it.
    Follow(String),
    /// From a fixed place to a fixed point.
    Fixed {
        /// The place, m.
        eye: (f64, f64, f64),
        /// The point in the middle of the picture, m.
        target: (f64, f64, f64),
        /// The angle from the lower to the upper edge of the picture, degrees.
        #[serde(default = "Camera::field_of_view")]
        fov_deg: f64,
    },
}

impl Camera {
    fn field_of_view() -> f64 {
        45.0
    }

    /// Finds what makes this camera of `cameras[i]` useless in a scene.
    pub(super) fn check(&self, i: usize, scene: &Scene) -> Result<(), LayoutError> {
        let refuse = |field: &str, value: String, problem: &str| {
            Err(FieldError::Untestable {
                field: format!("cameras[{i}].{field}"),
                value,
                problem: problem.to_owned(),
            }
            .into())
        };
        match self {
            Self::BehindCue if scene.shot.is_none() => {
                refuse("BehindCue", "BehindCue".to_owned(), "the scene has no shot")
            }
            Self::Follow(ball) if scene.ball_named(ball).is_none() => {
                refuse("Follow", format!("`{ball}`"), "there is no such ball")
            }
            Self::Overhead | Self::BehindCue | Self::Follow(_) => Ok(()),
            Self::Fixed {
                eye,
                target,
                fov_deg,
            } => {
                for (name, place) in [("eye", eye), ("target", target)] {
                    for (axis, value) in [("x", place.0), ("y", place.1), ("z", place.2)] {
                        within(
                            format_args!("cameras[{i}].{name}.{axis}"),
                            value,
                            -100.0,
                            100.0,
                        )?;
                    }
                }
                within(format_args!("cameras[{i}].fov_deg"), *fov_deg, 1.0, 170.0)?;
                if eye == target {
                    return refuse(
                        "target",
                        format!("{target:?}"),
                        "the eye is at the same place",
                    );
                }
                Ok(())
            }
        }
    }
}
