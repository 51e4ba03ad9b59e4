//! Dragging: the cue, a ball, the camera. And the wheel.

use bevy::input::mouse::{AccumulatedMouseScroll, MouseScrollUnit};
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::input::EguiWantsInput;
use glam::{DVec2, DVec3};

use super::motion::Motion;
use super::{Actions, fineness, on_panel};
use crate::game::aim::Aim;
use crate::game::practice::{Practice, PracticeCommand};
use crate::game::rules::CallNeeded;
use crate::game::rules::call::pointed_at;
use crate::game::turns::Turns;
use crate::game::view::{Beside, CameraInput, CameraMode, FirstEye, View};
use crate::physics::cue::Shot;
use crate::sim::clock::Clock;
use crate::sim::components::{BallIndex, MotionKind, Position, Radius};
use crate::window::action::Action;

/// Degrees of heading for a pixel.
const TURN_DEG: f64 = 0.1;
/// Radians of the camera for a pixel.
const ORBIT: f32 = 0.005;
/// Metres of the camera for a pixel.
const PAN: f32 = 0.002;
/// Speed in m/s for a notch of the wheel.
const POWER: f64 = 0.1;
/// Power of e by which a notch of the wheel zooms.
const ZOOM: f32 = 0.12;
/// Pixels of a touchpad that count as a notch.
const NOTCH: f32 = 100.0;
/// How far beside a ball the pointer may be to take it, in R.
const GRASP: f64 = 1.4;

/// Pixels by which a click may move.
const CLICK: f32 = 4.0;

/// What the left button holds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Held {
    /// Nothing.
    #[default]
    Nothing,
    /// The cue.
    Cue,
    /// A ball or a pocket that is called by a click: the cue, once the pointer has gone this far in pixels.
    Call(f32),
    /// A ball by its index, and where it was taken, seen from its centre, m.
    Ball(usize, DVec2),
}

/// What the buttons hold since they were pressed on the table.
#[derive(Resource, Debug, Default)]
pub(super) struct Grip {
    /// With the left button.
    held: Held,
    /// Whether the right button holds the camera.
    look: bool,
    /// Where on the table the pointer was in the last frame, m.
    last: Option<DVec2>,
}

/// The pointer and the camera it looks through.
#[derive(bevy::ecs::system::SystemParam)]
pub(super) struct Pointer<'w, 's> {
    window: Query<'w, 's, &'static Window, With<PrimaryWindow>>,
    camera:
        Query<'w, 's, (&'static Camera, &'static GlobalTransform, Has<FirstEye>), With<Camera3d>>,
}

impl Pointer<'_, '_> {
    /// Where the pointer is, and the camera under it: the picture may be shared by two.
    fn eye(&self) -> Option<(Vec2, &Camera, &GlobalTransform, bool)> {
        let at = self.window.single().ok()?.cursor_position()?;
        self.camera.iter().find_map(|(camera, place, is_first)| {
            let half = camera.logical_viewport_rect()?;
            let is_here = camera.is_active && half.contains(at);
            is_here.then_some((at, camera, place, is_first))
        })
    }

    /// From where the picture under the pointer is seen.
    fn mode(&self, view: &View) -> CameraMode {
        match (self.eye(), view.beside) {
            (Some((.., false)), Beside::Camera(mode)) => mode,
            _ => view.camera,
        }
    }

    fn ray(&self) -> Option<(DVec3, DVec3)> {
        let (at, camera, place, _) = self.eye()?;
        let ray = camera.viewport_to_world(place, at).ok()?;
        Some((ray.origin.as_dvec3(), ray.direction.as_dvec3()))
    }

    /// Where the pointer meets the plane at this height in m, as x and z.
    fn on_plane(&self, height: f64) -> Option<DVec2> {
        let (origin, direction) = self.ray()?;
        let along = (height - origin.y) / direction.y;
        let point = origin + along * direction;
        (along.is_finite() && along > 0.0).then_some(DVec2::new(point.x, point.z))
    }

    /// Whether a click here calls a ball or a pocket.
    fn calls(&self, turns: &Turns) -> bool {
        let Some(game) = turns.game().filter(|_| turns.may_strike()) else {
            return false;
        };
        let (table, on) = (game.table(), game.targets());
        let height = table.balls[on.cue].ball.radius;
        self.on_plane(height)
            .zip(self.on_plane(0.0))
            .filter(|_| on.call_needed != CallNeeded::No)
            .is_some_and(|(high, low)| pointed_at(&table, &on, high, low).is_some())
    }
}

type Balls<'w, 's> = Query<
    'w,
    's,
    (
        &'static BallIndex,
        &'static Position,
        &'static Radius,
        &'static MotionKind,
    ),
>;

/// Takes what lies under the pointer when a button goes down, and lets go when it comes up.
#[expect(
    clippy::too_many_arguments,
    reason = "everything that may lie under a pointer"
)]
pub(super) fn grip(
    actions: Actions,
    egui: Res<EguiWantsInput>,
    mut practice: ResMut<Practice>,
    clock: Res<Clock>,
    turns: Res<Turns>,
    pointer: Pointer,
    balls: Balls,
    mut grip: ResMut<Grip>,
) {
    if !actions.pressed(&Action::Drag) {
        grip.held = Held::Nothing;
        grip.last = None;
    }
    if !actions.pressed(&Action::Look) {
        grip.look = false;
    }
    if on_panel(&egui) {
        return;
    }
    if actions.just_pressed(&Action::Look) {
        grip.look = true;
    }
    if actions.just_pressed(&Action::Drag) {
        // A cue ball in hand is taken whatever the keys do; who turns the cue instead has put it down.
        let in_hand = turns.places_cue_ball();
        let cue = turns.game().filter(|_| in_hand);
        let cue = cue.map(|game| game.state().cue_ball(&game.table()));
        let taken = under(&pointer, &balls)
            .filter(|_| (practice.placing || in_hand) && !clock.moving)
            .filter(|held| match held {
                Held::Ball(ball, _) => cue.is_none_or(|cue| cue == *ball),
                _ => false,
            });
        let calls = || pointer.calls(&turns).then_some(Held::Call(0.0));
        grip.held = taken.or_else(calls).unwrap_or(Held::Cue);
        if let Held::Ball(ball, _) = grip.held {
            practice.chosen = Some(ball);
        } else if in_hand && practice.placing {
            practice.placing = false;
        }
    }
}

/// The ball nearest to the eye under the pointer.
fn under(pointer: &Pointer, balls: &Balls) -> Option<Held> {
    let (origin, direction) = pointer.ray()?;
    balls
        .iter()
        .filter(|ball| ball.3.0.in_play())
        .filter_map(|(index, position, radius, _)| {
            let to = position.0 - origin;
            let depth = to.dot(direction);
            let aside = (to - depth * direction).length();
            (aside <= GRASP * radius.0).then_some((depth, index.0, position.0, radius.0))
        })
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .and_then(|(_, index, center, radius)| {
            let at = pointer.on_plane(radius)?;
            Some(Held::Ball(index, at - DVec2::new(center.x, center.z)))
        })
}

/// Turns the cue. From overhead it points at the pointer; fine, it follows the pointer by a part of its way.
pub(super) fn aim(
    actions: Actions,
    view: Res<View>,
    pointer: Pointer,
    balls: Balls,
    motion: Res<Motion>,
    mut grip: ResMut<Grip>,
    mut aim: ResMut<Aim>,
) {
    if let Held::Call(gone) = &mut grip.held {
        *gone += motion.0.length();
        if *gone > CLICK {
            grip.held = Held::Cue;
        }
    }
    if grip.held != Held::Cue {
        return;
    }
    let fine = fineness(&actions);
    if pointer.mode(&view) != CameraMode::Overhead {
        let moved = motion.0.x;
        if moved != 0.0 {
            aim.turn_deg(-TURN_DEG * fine * f64::from(moved));
        }
        return;
    }
    let Some((_, center, radius, _)) = balls.iter().find(|ball| ball.0.0 == aim.ball) else {
        return;
    };
    let Some(now) = pointer.on_plane(radius.0) else {
        return;
    };
    let heading = |to: DVec2| Shot::heading_between(center.0, DVec3::new(to.x, center.0.y, to.y));
    let before = grip.last.replace(now);
    if before == Some(now) || now.distance(DVec2::new(center.0.x, center.0.z)) < radius.0 {
        return;
    }
    if fine < 1.0 {
        let Some(before) = before else { return };
        let way = heading(now) - heading(before);
        // The short way round.
        let way = way - std::f64::consts::TAU * (way / std::f64::consts::TAU).round();
        let turned = aim.shot.heading + fine * way;
        aim.set_heading(turned);
    } else {
        aim.set_heading(heading(now));
    }
}

/// Moves the ball that is held.
pub(super) fn place(
    pointer: Pointer,
    balls: Balls,
    mut grip: ResMut<Grip>,
    mut commands: MessageWriter<PracticeCommand>,
) {
    let Held::Ball(ball, taken) = grip.held else {
        return;
    };
    let Some((_, _, radius, _)) = balls.iter().find(|held| held.0.0 == ball) else {
        return;
    };
    let Some(now) = pointer.on_plane(radius.0) else {
        return;
    };
    let before = grip.last.replace(now);
    if before.is_some_and(|before| before != now) {
        let wish = now - taken;
        commands.write(PracticeCommand::PlaceBall {
            ball,
            x: wish.x,
            z: wish.y,
        });
    }
}

/// Turns the camera, or moves it.
pub(super) fn look(
    actions: Actions,
    grip: Res<Grip>,
    motion: Res<Motion>,
    mut camera: MessageWriter<CameraInput>,
) {
    // Up on the screen is up in the world.
    let moved = Vec2::new(motion.0.x, -motion.0.y);
    if !grip.look || moved == Vec2::ZERO {
        return;
    }
    camera.write(if actions.pressed(&Action::Fine) {
        CameraInput {
            pan: -PAN * moved,
            ..default()
        }
    } else {
        CameraInput {
            orbit: -ORBIT * moved,
            ..default()
        }
    });
}

/// Power, or zoom while the camera is held.
pub(super) fn wheel(
    actions: Actions,
    egui: Res<EguiWantsInput>,
    scroll: Res<AccumulatedMouseScroll>,
    mut aim: ResMut<Aim>,
    mut camera: MessageWriter<CameraInput>,
) {
    let mut notches = actions.value(&Action::PowerWheel);
    if scroll.unit == MouseScrollUnit::Pixel {
        notches /= NOTCH;
    }
    if notches == 0.0 || on_panel(&egui) {
        return;
    }
    if actions.pressed(&Action::Look) {
        camera.write(CameraInput {
            zoom: ZOOM * notches,
            ..default()
        });
    } else {
        let speed = aim.shot.speed + POWER * fineness(&actions) * f64::from(notches);
        aim.set_speed(speed);
    }
}
