//! The stroke as a file names it.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::physics::cue::Shot;
use crate::physics::scene::{PlannedShot, Scene};
use crate::scenarios::file::error::{FieldError, LayoutError};

/// A stroke. The direction is one of `heading`, `heading_deg` and `aim_at`; without any of them it is along x, towards
/// the foot. At most one of `elevation` and `elevation_deg` is given.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Shot")]
pub(super) struct ShotEntry {
    /// Name of the struck ball.
    ball: String,
    /// rad, counter-clockwise seen from above from the x axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    heading: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    heading_deg: Option<f64>,
    /// Name of the ball whose centre the cue points at.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    aim_at: Option<String>,
    /// rad.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    elevation: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    elevation_deg: Option<f64>,
    /// In R, to the shooter's right.
    #[serde(default)]
    side: f64,
    /// In R, above the centre.
    #[serde(default)]
    height: f64,
    /// Speed of the cue, m/s.
    speed: f64,
}

impl ShotEntry {
    /// The entry of a shot; none if it strikes a ball that is not there.
    pub(super) fn of(scene: &Scene, planned: &PlannedShot) -> Option<Self> {
        let shot = &planned.shot;
        Some(Self {
            ball: scene.balls.get(planned.ball)?.name.clone(),
            heading: Some(shot.heading),
            elevation: Some(shot.elevation),
            side: shot.side,
            height: shot.height,
            speed: shot.speed,
            ..Self::default()
        })
    }

    pub(super) fn planned(&self, scene: &Scene) -> Result<PlannedShot, LayoutError> {
        let ball = named(scene, "shot.ball", &self.ball)?;
        let heading = match (self.heading, self.heading_deg, &self.aim_at) {
            (None, None, None) => 0.0,
            (Some(heading), None, None) => heading,
            (None, Some(degrees), None) => degrees.to_radians(),
            (None, None, Some(target)) => {
                let target = named(scene, "shot.aim_at", target)?;
                let place = |i: usize| scene.balls[i].state.position;
                let (from, to) = (place(ball), place(target));
                if DVec2::new(to.x - from.x, to.z - from.z) == DVec2::ZERO {
                    let name = scene.balls[target].name.clone();
                    return Err(FieldError::NoDirection { name }.into());
                }
                Shot::heading_between(from, to)
            }
            (heading, degrees, target) => {
                return Err(FieldError::OneOf {
                    parent: "shot".to_owned(),
                    choices: "`heading`, `heading_deg`, `aim_at`",
                    count: usize::from(heading.is_some())
                        + usize::from(degrees.is_some())
                        + usize::from(target.is_some()),
                }
                .into());
            }
        };
        let elevation = match (self.elevation, self.elevation_deg) {
            (Some(_), Some(_)) => {
                return Err(FieldError::OneOf {
                    parent: "shot".to_owned(),
                    choices: "`elevation`, `elevation_deg`",
                    count: 2,
                }
                .into());
            }
            (Some(elevation), None) => elevation,
            (None, degrees) => degrees.unwrap_or(0.0).to_radians(),
        };
        Ok(PlannedShot {
            ball,
            shot: Shot {
                heading,
                elevation,
                side: self.side,
                height: self.height,
                speed: self.speed,
            },
        })
    }
}

/// Most names listed in an error.
const LISTED: usize = 20;

fn named(scene: &Scene, field: &'static str, name: &str) -> Result<usize, FieldError> {
    scene.ball_named(name).ok_or_else(|| {
        let mut known: Vec<String> = scene
            .balls
            .iter()
            .take(LISTED)
            .map(|ball| format!("`{}`", ball.name))
            .collect();
        if scene.balls.len() > LISTED {
            known.push(format!("{} more", scene.balls.len() - LISTED));
        }
        if known.is_empty() {
            known.push("none".to_owned());
        }
        FieldError::NoSuchBall {
            field,
            name: name.to_owned(),
            known: known.join(", "),
        }
    })
}
