//! The cameras that a scenario names.

use bevy::prelude::*;
use glam::DVec3;

use super::stage::Stage;
use crate::game::view::{Beside, CameraMode, SceneCamera, SceneCameras, View};
use crate::scenarios::camera::Camera;
use crate::scenarios::file::Scenario;

/// The cameras of a scenario for the view.
#[must_use]
pub fn seats(scenario: &Scenario) -> SceneCameras {
    let at = |(x, y, z): (f64, f64, f64)| DVec3::new(x, y, z);
    let seat = |camera: &Camera| match camera {
        Camera::Overhead => SceneCamera::Overhead,
        Camera::BehindCue => SceneCamera::BehindCue,
        Camera::Follow(ball) => SceneCamera::Follow(ball.clone()),
        Camera::Fixed {
            eye,
            target,
            fov_deg,
        } => SceneCamera::Fixed {
            eye: at(*eye),
            target: at(*target),
            fov: fov_deg.to_radians(),
        },
    };
    SceneCameras(scenario.cameras.iter().map(seat).collect())
}

/// The cameras come and go with the scenario on the table; one that is opened is seen through its first.
pub(super) fn follow(
    mut stage: ResMut<Stage>,
    mut cameras: ResMut<SceneCameras>,
    mut view: ResMut<View>,
) {
    let on = stage.on_table();
    let now = on.map_or_else(SceneCameras::default, |on| seats(&on.scenario));
    if *cameras != now {
        *cameras = now;
    }
    if stage.bypass_change_detection().take_opened()
        && let Some(first) = cameras.mode(0)
    {
        view.camera = first;
    }
    let is_gone = |mode: CameraMode| {
        matches!(mode, CameraMode::Scene(_)) && !cameras.modes().any(|other| other == mode)
    };
    if is_gone(view.camera) {
        view.camera = CameraMode::default();
    }
    if matches!(view.beside, Beside::Camera(mode) if is_gone(mode)) {
        view.beside = Beside::Camera(view.second(&cameras));
    }
}
