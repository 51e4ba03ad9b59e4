//! Aiming with keys: a tap is one step, a held key goes on.

use std::time::Duration;

use bevy::prelude::*;
use leafwing_input_manager::prelude::ActionState;

use super::{Actions, fineness};
use crate::game::aim::Aim;
use crate::game::practice::Practice;
use crate::game::target;
use crate::sim::playfield::{BallQuery, Playfield, snapshot};
use crate::window::action::Action;
use crate::window::felt;

/// How long a key is held before it goes on by itself.
const PAUSE: Duration = Duration::from_millis(300);
/// Steps per second of a held key.
const RATE: f64 = 20.0;

/// Degrees of heading a step.
const TURN_DEG: f64 = 1.0;
/// Degrees of elevation a step.
const RAISE_DEG: f64 = 1.0;
/// Offset of the tip a step, R.
const SHIFT: f64 = 0.05;
/// Speed a step, m/s.
const POWER: f64 = 0.1;

/// Turns, raises and shifts the cue.
pub(super) fn aim(
    actions: Actions,
    time: Res<Time<Real>>,
    practice: Res<Practice>,
    mut aim: ResMut<Aim>,
    mut held: ResMut<HeldKey>,
    playfield: Res<Playfield>,
    balls: BallQuery,
) {
    // The same keys move balls then.
    if practice.placing {
        return;
    }
    let mut steps = |more, less| held.steps(&actions, &time, more, less);
    let fine = fineness(&actions);
    let turn = steps(Action::AimLeft, Action::AimRight) * TURN_DEG * fine;
    let raise = steps(Action::ElevationUp, Action::ElevationDown) * RAISE_DEG * fine;
    let side = steps(Action::SideRight, Action::SideLeft) * SHIFT * fine;
    let height = steps(Action::HeightUp, Action::HeightDown) * SHIFT * fine;
    let power = steps(Action::PowerUp, Action::PowerDown) * POWER * fine;
    let shot = aim.shot;
    if turn != 0.0 {
        aim.turn_deg(turn);
    }
    if raise != 0.0 {
        aim.set_elevation(shot.elevation + raise.to_radians());
    }
    if side != 0.0 || height != 0.0 {
        aim.set_tip(shot.side + side, shot.height + height);
    }
    if power != 0.0 {
        aim.set_speed(shot.speed + power);
    }
    if actions.just_pressed(&Action::Center) {
        aim.set_tip(0.0, 0.0);
        aim.set_elevation(0.0);
    }
    for (action, step) in [(Action::NextBallLeft, 1), (Action::NextBallRight, -1)] {
        if actions.just_pressed(&action) {
            let scene = snapshot(&playfield, &balls);
            if let Some(heading) = target::beside(&scene, aim.ball, aim.shot.heading, step) {
                aim.set_heading(heading);
            }
        }
    }
}

/// The key pressed last of those that go on while they are held, and since when.
#[derive(Resource, Debug, Default)]
pub(super) struct HeldKey(Option<(Action, Duration)>);

impl HeldKey {
    /// Steps of one action less those of its opposite in this frame.
    pub(super) fn steps(
        &mut self,
        actions: &ActionState<Action>,
        time: &Time<Real>,
        more: Action,
        less: Action,
    ) -> f64 {
        steps(actions, more, time, &mut self.0) - steps(actions, less, time, &mut self.0)
    }
}

/// Steps of this action in this frame.
fn steps(
    actions: &ActionState<Action>,
    action: Action,
    time: &Time<Real>,
    held: &mut Option<(Action, Duration)>,
) -> f64 {
    // A stick goes on at once, and the finer the less it is moved.
    let moved = f64::from(actions.button_value(&action));
    if actions.pressed(&action) && moved < 1.0 {
        return RATE * moved * moved * felt(time).as_secs_f64();
    }
    if actions.just_pressed(&action) {
        *held = Some((action, time.elapsed()));
        return 1.0;
    }
    if !actions.pressed(&action) {
        return 0.0;
    }
    match held {
        Some((which, _)) if *which != action => 0.0,
        Some((_, since)) if time.elapsed() < *since + PAUSE => 0.0,
        _ => RATE * felt(time).as_secs_f64(),
    }
}
