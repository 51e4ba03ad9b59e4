//! What the player wants to see.

use bevy::prelude::*;

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
}

/// What is shown. Only the player changes it: nothing in the program takes the chosen view away.
#[derive(Resource, Clone, Copy, Debug, PartialEq, Eq)]
pub struct View {
    /// From where.
    pub camera: CameraMode,
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
            guides: true,
            preview: true,
            trails: false,
        }
    }
}

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
    app.init_resource::<View>().add_message::<CameraInput>();
}
