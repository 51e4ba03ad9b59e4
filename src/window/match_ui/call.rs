//! A call by pointing: a click on a ball, a click on a pocket; or with a key, what is aimed at.

use std::f32::consts::FRAC_PI_2;

use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::input::EguiWantsInput;
use glam::DVec2;
use leafwing_input_manager::prelude::ActionState;

use crate::game::aim::Aim;
use crate::game::aimed;
use crate::game::equip::Told;
use crate::game::matches::Match;
use crate::game::replay::Replay;
use crate::game::rules::call::{Pointed, pointed_at};
use crate::game::rules::{Call, CallNeeded, On};
use crate::game::saying::Saying;
use crate::game::turns::{TurnCommand, Turns};
use crate::physics::scene::Scene;
use crate::sim::clock::Clock;
use crate::window::action::Action;

/// Pixels by which a click may move.
const CLICK: f32 = 4.0;
/// Height of the rings above the slate, m.
const ABOVE: f32 = 0.003;
const COLOR: Color = Color::srgb(0.95, 0.85, 0.4);

/// What has been pointed at.
#[derive(Resource, Debug, Default)]
pub(super) struct Pointing {
    /// Whether the names are shown too.
    pub by_name: bool,
    /// The ball.
    pub ball: Option<usize>,
    /// The pocket.
    pub pocket: Option<usize>,
    /// Where the button went down.
    pressed: Option<Vec2>,
}

impl Pointing {
    /// The call, once everything it needs has been pointed at; then it begins anew.
    pub(super) fn take_call(&mut self, needed: CallNeeded) -> Option<Call> {
        let call = match needed {
            CallNeeded::No => return None,
            CallNeeded::Ball => Call::Nominate { ball: self.ball? },
            CallNeeded::BallAndPocket => Call::Pot {
                ball: self.ball?,
                pocket: self.pocket?,
            },
        };
        *self = Self::default();
        Some(call)
    }
}

/// What may be called by whoever is at the table.
fn due(turns: &Turns) -> Option<(Scene, On)> {
    let game = turns.game().filter(|_| turns.may_strike())?;
    let on = game.targets();
    (on.call_needed != CallNeeded::No).then(|| (game.table(), on))
}

/// Reads a click as a ball or a pocket.
pub(super) fn point(
    buttons: Res<ButtonInput<MouseButton>>,
    window: Query<&Window, With<PrimaryWindow>>,
    camera: Query<(&Camera, &GlobalTransform), With<Camera3d>>,
    egui: Res<EguiWantsInput>,
    turns: Res<Turns>,
    mut pointing: ResMut<Pointing>,
    mut commands: MessageWriter<TurnCommand>,
) {
    let pressed = buttons.just_pressed(MouseButton::Left);
    let released = buttons.just_released(MouseButton::Left);
    if !pressed && !released {
        return;
    }
    let Some(at) = window.single().ok().and_then(Window::cursor_position) else {
        return;
    };
    if pressed {
        pointing.pressed = (!egui.wants_any_pointer_input()).then_some(at);
    }
    if !released {
        return;
    }
    let clicked = pointing
        .pressed
        .take()
        .is_some_and(|pressed| pressed.distance(at) <= CLICK);
    // The picture may be shared by two cameras.
    let mut eyes = camera.iter();
    let eye = eyes.find(|(camera, _)| {
        let half = camera.logical_viewport_rect();
        camera.is_active && half.is_some_and(|half| half.contains(at))
    });
    let Some((camera, place)) = eye.filter(|_| clicked) else {
        return;
    };
    let (Ok(ray), Some((table, on))) = (camera.viewport_to_world(place, at), due(&turns)) else {
        return;
    };
    let meets = |height: f64| {
        let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        let along = (height - origin.y) / direction.y;
        let point = origin + along * direction;
        (along.is_finite() && along > 0.0).then_some(DVec2::new(point.x, point.z))
    };
    let radius = table.balls[on.cue].ball.radius;
    match meets(radius)
        .zip(meets(0.0))
        .and_then(|(high, low)| pointed_at(&table, &on, high, low))
    {
        Some(Pointed::Ball(ball)) => pointing.ball = Some(ball),
        Some(Pointed::Pocket(pocket)) => pointing.pocket = Some(pocket),
        None => return,
    }
    if let Some(call) = pointing.take_call(on.call_needed) {
        commands.write(TurnCommand::Call(call));
    }
}

/// Calls what is aimed at.
pub(super) fn by_key(
    actions: Single<&ActionState<Action>>,
    turns: Res<Turns>,
    aim: Res<Aim>,
    mut pointing: ResMut<Pointing>,
    mut commands: MessageWriter<TurnCommand>,
    mut told: MessageWriter<Told>,
) {
    if !actions.just_pressed(&Action::Call) {
        return;
    }
    let Some((table, on)) = due(&turns) else {
        return;
    };
    let called = turns.game().map_or(Call::Nothing, Match::called);
    if let Some(call) = aimed::call(&table, &on, &aim.shot, called) {
        (pointing.ball, pointing.pocket) = (None, None);
        commands.write(TurnCommand::Call(call));
    } else {
        told.write(Told {
            text: Saying::new(
                "match-nothing-aimed",
                &[],
                "Aim at a ball that is on first.",
            ),
            is_failure: true,
        });
    }
}

/// Rings on the cloth around what is called, or pointed at so far.
pub(super) fn mark(
    turns: Res<Turns>,
    replay: Res<Replay>,
    clock: Res<Clock>,
    pointing: Res<Pointing>,
    mut gizmos: Gizmos,
) {
    if clock.moving || replay.is_active() {
        return;
    }
    let Some((table, _)) = due(&turns) else {
        return;
    };
    let called = turns.game().map_or(Call::Nothing, Match::called);
    let ball = pointing.ball.or(called.ball());
    let pocket = pointing.pocket.or(match called {
        Call::Pot { pocket, .. } if pointing.ball.is_none() => Some(pocket),
        _ => None,
    });
    let mut ring = |at: DVec2, radius: f64| {
        let lying = Quat::from_rotation_x(FRAC_PI_2);
        let place = Vec3::new(at.x as f32, ABOVE, at.y as f32);
        gizmos.circle(Isometry3d::new(place, lying), radius as f32, COLOR);
    };
    if let Some(ball) = ball.and_then(|ball| table.balls.get(ball)) {
        let at = ball.state.position;
        ring(DVec2::new(at.x, at.z), 1.5 * ball.ball.radius);
    }
    if let Some(pocket) = pocket.and_then(|pocket| table.table.pockets.get(pocket)) {
        ring(pocket.center, 1.05 * pocket.radius);
    }
}
