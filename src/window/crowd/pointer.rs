//! The pointer over a crowd: a click takes a ball to watch, a drag moves the table below the eye, the wheel zooms. The
//! right button turns the camera as it does everywhere.

use bevy::input::mouse::{AccumulatedMouseScroll, MouseScrollUnit};
use bevy::prelude::*;
use bevy::window::{CursorMoved, PrimaryWindow};
use bevy_egui::input::EguiWantsInput;
use leafwing_input_manager::prelude::ActionState;

use crate::game::view::{CameraInput, FirstEye};
use crate::game::watch::{Watch, met_by_ray};
use crate::sim::components::{BallIndex, MotionKind, Position, Radius};
use crate::window::action::Action;

/// Pixels that a click may move.
const CLICK: f32 = 4.0;
/// Power of e by which a notch of the wheel zooms.
const ZOOM: f32 = 0.16;
/// Pixels of a touchpad that count as a notch.
const NOTCH: f32 = 100.0;
/// A ball smaller than this many pixels is taken as if it had them.
const FINGER: f32 = 3.0;

/// What the left button does.
#[derive(Resource, Debug, Default)]
pub(super) struct Grasp {
    /// How far the pointer has gone since the button went down on the table, pixels.
    way: Option<f32>,
}

type Eye<'w, 's> = Query<'w, 's, (&'static Camera, &'static GlobalTransform), With<FirstEye>>;

/// Takes the ball under the pointer when the button comes up where it went down.
pub(super) fn press(
    actions: Single<&ActionState<Action>>,
    egui: Res<EguiWantsInput>,
    window: Query<&Window, With<PrimaryWindow>>,
    eye: Eye,
    balls: Query<(&BallIndex, &Position, &Radius, &MotionKind)>,
    mut grasp: ResMut<Grasp>,
    mut watch: ResMut<Watch>,
) {
    if actions.just_pressed(&Action::Drag) && !egui.wants_any_pointer_input() {
        grasp.way = Some(0.0);
    }
    if actions.pressed(&Action::Drag) {
        return;
    }
    if grasp.way.take().is_none_or(|way| way > CLICK) {
        return;
    }
    let Some(at) = window.single().ok().and_then(Window::cursor_position) else {
        return;
    };
    let Ok((camera, place)) = eye.single() else {
        return;
    };
    let (Ok(ray), Some((_, _, radius, _))) =
        (camera.viewport_to_world(place, at), balls.iter().next())
    else {
        return;
    };
    let on_screen = pixel(camera, place) * f64::from(FINGER);
    let in_play = balls
        .iter()
        .filter(|ball| ball.3.0.in_play())
        .map(|(index, position, ..)| (index.0, position.0));
    watch.chosen = met_by_ray(
        ray.origin.as_dvec3(),
        ray.direction.as_dvec3(),
        radius.0.max(on_screen),
        in_play,
    );
}

/// Length in m that is a pixel wide where the middle of the picture shows the table.
fn pixel(camera: &Camera, place: &GlobalTransform) -> f64 {
    let Some(size) = camera.logical_viewport_size() else {
        return 0.0;
    };
    let away = -place.translation().y / place.forward().y.min(-0.05);
    f64::from(2.0 * away / (camera.clip_from_view().y_axis.y * size.y.max(1.0)))
}

/// Moves the table with the pointer.
pub(super) fn drag(
    actions: Single<&ActionState<Action>>,
    mut moved: MessageReader<CursorMoved>,
    eye: Eye,
    mut grasp: ResMut<Grasp>,
    mut watch: ResMut<Watch>,
    mut camera: MessageWriter<CameraInput>,
) {
    // The way to where the button goes down is no drag, however slow the frames are.
    if actions.just_pressed(&Action::Drag) {
        moved.clear();
        return;
    }
    let way: Vec2 = moved.read().filter_map(|moved| moved.delta).sum();
    let (Some(gone), Ok((lens, place))) = (&mut grasp.way, eye.single()) else {
        return;
    };
    *gone += way.length();
    if *gone <= CLICK || way == Vec2::ZERO {
        return;
    }
    // Whoever drags looks elsewhere.
    watch.follow = false;
    let pixel = pixel(lens, place) as f32;
    camera.write(CameraInput {
        pan: pixel * Vec2::new(-way.x, way.y),
        ..default()
    });
}

/// Zooms.
pub(super) fn wheel(
    actions: Single<&ActionState<Action>>,
    egui: Res<EguiWantsInput>,
    scroll: Res<AccumulatedMouseScroll>,
    mut camera: MessageWriter<CameraInput>,
) {
    let mut notches = actions.value(&Action::PowerWheel);
    if scroll.unit == MouseScrollUnit::Pixel {
        notches /= NOTCH;
    }
    if notches != 0.0 && !egui.wants_any_pointer_input() {
        camera.write(CameraInput {
            zoom: ZOOM * notches,
            ..default()
        });
    }
}
