//! A call by pointing: a click on a ball, a click on a pocket.

use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::input::EguiWantsInput;
use glam::DVec2;

use crate::game::rules::call::{nearest_ball, nearest_pocket};
use crate::game::rules::{Call, CallNeeded};
use crate::game::turns::{TurnCommand, Turns};

/// Pixels by which a click may move.
const CLICK: f32 = 4.0;
/// How far beside a ball or the edge of a pocket a click may be, m.
const REACH: f64 = 0.03;

/// What has been pointed at.
#[derive(Resource, Debug, Default)]
pub(super) struct Pointing {
    /// Whether clicks are calls.
    pub on: bool,
    /// The ball.
    pub ball: Option<usize>,
    /// The pocket.
    pub pocket: Option<usize>,
    /// Where the button went down.
    pressed: Option<Vec2>,
}

impl Pointing {
    /// The call, once everything it needs has been pointed at; then no more is asked for.
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
    if !pointing.on || !turns.may_strike() {
        return;
    }
    let Some(game) = turns.game() else { return };
    let Some(at) = window.single().ok().and_then(Window::cursor_position) else {
        return;
    };
    if buttons.just_pressed(MouseButton::Left) {
        pointing.pressed = (!egui.wants_any_pointer_input()).then_some(at);
    }
    if !buttons.just_released(MouseButton::Left) {
        return;
    }
    let clicked = pointing
        .pressed
        .take()
        .is_some_and(|pressed| pressed.distance(at) <= CLICK);
    let Some((camera, place)) = camera.single().ok().filter(|_| clicked) else {
        return;
    };
    let Ok(ray) = camera.viewport_to_world(place, at) else {
        return;
    };
    let (table, on) = (game.table(), game.targets());
    let on_height = |height: f64| {
        let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        let along = (height - origin.y) / direction.y;
        let point = origin + along * direction;
        (along.is_finite() && along > 0.0).then_some(DVec2::new(point.x, point.z))
    };
    let radius = table.balls[on.cue].ball.radius;
    let ball = on_height(radius).and_then(|at| nearest_ball(&table, &on.pot, at, REACH));
    if ball.is_some() {
        pointing.ball = ball;
    } else if let Some(at) = on_height(0.0)
        && let Some(pocket) = nearest_pocket(&table.table, at)
    {
        let hole = &table.table.pockets[pocket];
        if at.distance(hole.center) <= hole.radius + REACH {
            pointing.pocket = Some(pocket);
        }
    }
    if let Some(call) = pointing.take_call(on.call_needed) {
        commands.write(TurnCommand::Call(call));
    }
}
