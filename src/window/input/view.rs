//! Keys that change what is seen and heard, and how fast.

use bevy::prelude::*;

use super::Actions;
use crate::game::settings::Settings;
use crate::game::view::{Beside, CameraInput, CameraMode, SceneCameras, View};
use crate::sim::clock::Clock;
use crate::window::action::Action;
use crate::window::felt;

/// How much faster than life a held key plays.
const FAST: f32 = 8.0;
/// Powers of e by which a held key zooms in a second.
const ZOOM_RATE: f32 = 1.2;

/// Radians by which a held key turns the camera in a second.
const ORBIT_RATE: f32 = 1.2;
/// Metres by which a held key moves the camera in a second.
const PAN_RATE: f32 = 0.6;

/// Cameras, guides, trails, zoom, sound.
pub(super) fn switch(
    actions: Actions,
    time: Res<Time<Real>>,
    cameras: Res<SceneCameras>,
    mut view: ResMut<View>,
    mut settings: ResMut<Settings>,
    mut camera: MessageWriter<CameraInput>,
    mut before: Local<CameraMode>,
) {
    // With the finer steps, the camera beside the first.
    let is_second = actions.pressed(&Action::Fine);
    if actions.just_pressed(&Action::Camera) {
        match view.beside {
            Beside::Camera(mode) if is_second => view.beside = Beside::Camera(mode.next()),
            _ => view.camera = view.camera.next(),
        }
    }
    if actions.just_pressed(&Action::SceneCamera) {
        match view.beside {
            Beside::Camera(mode) if is_second => {
                view.beside = Beside::Camera(cameras.after(mode).unwrap_or(mode.next()));
            }
            _ => view.camera = cameras.after(view.camera).unwrap_or(view.camera.next()),
        }
    }
    if actions.just_pressed(&Action::SecondCamera) {
        view.toggle_second(&cameras);
    }
    if actions.just_pressed(&Action::OtherLaws) {
        view.toggle_laws();
    }
    if actions.just_pressed(&Action::Overhead) {
        if view.camera == CameraMode::Overhead {
            view.camera = *before;
        } else {
            *before = view.camera;
            view.camera = CameraMode::Overhead;
        }
    }
    if actions.just_pressed(&Action::Guides) {
        view.guides = !view.guides;
    }
    if actions.just_pressed(&Action::Preview) {
        view.preview = !view.preview;
    }
    if actions.just_pressed(&Action::Trails) {
        view.trails = !view.trails;
    }
    if actions.just_pressed(&Action::Mute) {
        settings.volume.muted = !settings.volume.muted;
    }
    let way = |more, less| f32::from(actions.pressed(&more)) - f32::from(actions.pressed(&less));
    let turn = Vec2::new(
        way(Action::LookRight, Action::LookLeft),
        way(Action::LookUp, Action::LookDown),
    );
    if turn != Vec2::ZERO {
        let seconds = felt(&time).as_secs_f32();
        camera.write(if actions.pressed(&Action::Fine) {
            CameraInput {
                pan: PAN_RATE * seconds * turn,
                ..default()
            }
        } else {
            CameraInput {
                orbit: ORBIT_RATE * seconds * turn,
                ..default()
            }
        });
    }
    for (action, sign) in [(Action::ZoomIn, 1.0), (Action::ZoomOut, -1.0)] {
        if actions.pressed(&action) {
            camera.write(CameraInput {
                zoom: sign * ZOOM_RATE * felt(&time).as_secs_f32(),
                ..default()
            });
        }
    }
}

/// Makes dead time short: while the key is held and balls move, the table runs faster. Ticks stay as long as they are.
pub(super) fn fast_forward(actions: Actions, clock: Res<Clock>, mut time: ResMut<Time<Virtual>>) {
    let speed = if actions.pressed(&Action::FastForward) && clock.moving {
        FAST
    } else {
        1.0
    };
    if time.relative_speed().to_bits() != speed.to_bits() {
        time.set_relative_speed(speed);
    }
}
