//! What the player wants to see.

use bevy::prelude::*;
use glam::DVec3;

/// From where the player looks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum CameraMode {
    /// Behind the cue, along the aim.
    #[default]
    BehindCue,
    /// From above, the whole table.
    Overhead,
    /// Freely around a point of the table.
    Orbit,
    /// Beside the ball that is struck, moving with it.
    Follow,
    /// A camera of the scene, by its place in [`SceneCameras`].
    Scene(usize),
}

impl CameraMode {
    /// The next of the cameras that every table has.
    #[must_use]
    pub fn next(self) -> Self {
        match self {
            Self::BehindCue => Self::Overhead,
            Self::Overhead => Self::Orbit,
            Self::Orbit => Self::Follow,
            Self::Follow | Self::Scene(_) => Self::BehindCue,
        }
    }
}

/// A camera that a scene names.
#[derive(Clone, Debug, PartialEq)]
pub enum SceneCamera {
    /// Straight down on the whole table.
    Overhead,
    /// Behind the cue.
    BehindCue,
    /// Beside the ball with this name, moving with it.
    Follow(String),
    /// From a fixed place to a fixed point, m, with the angle from the lower to the upper edge of the picture, rad.
    Fixed {
        /// The place.
        eye: DVec3,
        /// The point in the middle of the picture.
        target: DVec3,
        /// The angle.
        fov: f64,
    },
}

/// The cameras that the scene on the table names, in its order.
#[derive(Resource, Clone, Debug, Default, PartialEq)]
pub struct SceneCameras(pub Vec<SceneCamera>);

impl SceneCameras {
    /// The mode that shows what the camera in this place shows. What every table has is not a mode of its own.
    #[must_use]
    pub fn mode(&self, place: usize) -> Option<CameraMode> {
        Some(match self.0.get(place)? {
            SceneCamera::Overhead => CameraMode::Overhead,
            SceneCamera::BehindCue => CameraMode::BehindCue,
            SceneCamera::Follow(_) | SceneCamera::Fixed { .. } => CameraMode::Scene(place),
        })
    }

    /// The modes of all of them.
    pub fn modes(&self) -> impl Iterator<Item = CameraMode> {
        (0..self.0.len()).filter_map(|place| self.mode(place))
    }

    /// The camera of the scene that comes after this one; none if the scene names no camera.
    #[must_use]
    pub fn after(&self, mode: CameraMode) -> Option<CameraMode> {
        let next = self.modes().position(|other| other == mode);
        let next = next.map_or(0, |at| at + 1);
        self.mode(next).or_else(|| self.mode(0))
    }
}

/// What the other half of a shared picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Beside {
    /// Nothing: the picture is not shared.
    #[default]
    Nothing,
    /// The same table through another camera.
    Camera(CameraMode),
    /// The same stroke by other laws, through the same camera: see [`twin`](crate::game::twin).
    Laws,
}

/// What is shown. Only the player changes it, by a control or by opening a scene that names its cameras.
#[derive(Resource, Clone, Copy, Debug, PartialEq, Eq)]
pub struct View {
    /// From where.
    pub camera: CameraMode,
    /// What stands beside it.
    pub beside: Beside,
    /// The aim line, the ghost ball and what follows from them.
    pub guides: bool,
    /// The paths of all balls for the present aim.
    pub preview: bool,
    /// The paths of the last shot.
    pub trails: bool,
}

impl Default for View {
    fn default() -> Self {
        Self {
            camera: CameraMode::default(),
            beside: Beside::default(),
            guides: true,
            preview: true,
            trails: false,
        }
    }
}

impl View {
    /// A second camera beside the first. Asked again, the picture is whole again.
    pub fn toggle_second(&mut self, cameras: &SceneCameras) {
        self.beside = match self.beside {
            Beside::Camera(_) => Beside::Nothing,
            _ => Beside::Camera(self.second(cameras)),
        };
    }

    /// The camera that goes best beside the first: another one of the scene, else one that shows what the first does not.
    #[must_use]
    pub fn second(&self, cameras: &SceneCameras) -> CameraMode {
        let of_scene = cameras.after(self.camera);
        let of_scene = of_scene.filter(|mode| *mode != self.camera);
        of_scene.unwrap_or(match self.camera {
            CameraMode::Overhead => CameraMode::Follow,
            _ => CameraMode::Overhead,
        })
    }

    /// Other laws beside those of the table, or the whole picture again.
    pub fn toggle_laws(&mut self) {
        self.beside = match self.beside {
            Beside::Laws => Beside::Nothing,
            _ => Beside::Laws,
        };
    }
}

/// The camera through which the player aims. Beside it there may be another one.
#[derive(Component, Clone, Copy, Debug, Default)]
pub struct FirstEye;

/// The player moves the camera within its mode.
#[derive(Message, Clone, Copy, Debug, Default, PartialEq)]
pub struct CameraInput {
    /// Turn around the point looked at, in rad: x to the right, y upwards.
    pub orbit: Vec2,
    /// Closer by this power of e; below zero farther away.
    pub zoom: f32,
    /// Shift of the point looked at in m on the cloth, to the right and away from the camera.
    pub pan: Vec2,
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<View>()
        .init_resource::<SceneCameras>()
        .add_message::<CameraInput>();
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_scene() -> SceneCameras {
        SceneCameras(vec![
            SceneCamera::Overhead,
            SceneCamera::Follow("cue".to_owned()),
            SceneCamera::BehindCue,
        ])
    }

    #[test]
    fn the_cameras_of_a_scene_are_gone_through_in_a_ring() {
        let cameras = of_scene();
        let mut mode = CameraMode::Orbit;
        let mut seen = Vec::new();
        for _ in 0..4 {
            mode = cameras.after(mode).expect("there are three");
            seen.push(mode);
        }
        let (overhead, follow) = (CameraMode::Overhead, CameraMode::Scene(1));
        assert_eq!(seen, [overhead, follow, CameraMode::BehindCue, overhead]);
        assert_eq!(SceneCameras::default().after(mode), None);
    }

    #[test]
    fn a_second_camera_is_never_the_first_and_goes_away_when_asked_again() {
        for cameras in [
            of_scene(),
            SceneCameras::default(),
            SceneCameras(vec![SceneCamera::Overhead]),
        ] {
            let modes = [
                CameraMode::BehindCue,
                CameraMode::Overhead,
                CameraMode::Orbit,
            ];
            for camera in modes
                .into_iter()
                .chain([CameraMode::Follow])
                .chain(cameras.modes())
            {
                let mut view = View {
                    camera,
                    ..View::default()
                };
                assert_ne!(view.second(&cameras), camera);
                view.toggle_second(&cameras);
                assert_eq!(view.beside, Beside::Camera(view.second(&cameras)));
                view.toggle_laws();
                assert_eq!(view.beside, Beside::Laws);
                view.toggle_second(&cameras);
                view.toggle_second(&cameras);
                assert_eq!(view.beside, Beside::Nothing);
            }
        }
    }
}
