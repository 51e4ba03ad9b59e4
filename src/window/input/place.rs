//! Placing balls with keys: the keys of heading and power move the ball that is chosen, as it is seen on the screen; the
//! keys for the next ball choose another one.

use bevy::prelude::*;
use glam::{DVec2, DVec3};

use super::keys::HeldKey;
use super::{Actions, fineness};
use crate::game::aim::Aim;
use crate::game::practice::{Practice, PracticeCommand};
use crate::game::turns::Turns;
use crate::physics::cue::Shot;
use crate::sim::clock::Clock;
use crate::sim::components::{BallIndex, MotionKind, Position};
use crate::window::action::Action;

/// Metres a step.
const STEP: f64 = 0.01;

/// Where keys have asked for the ball to be since the last tick: which ball, where it was then, and the wish.
#[derive(Resource, Debug, Default)]
pub(super) struct Wish(Option<(usize, DVec2, DVec2)>);

type Balls<'w, 's> = Query<'w, 's, (&'static BallIndex, &'static Position, &'static MotionKind)>;

/// Chooses and moves a ball while balls are placed.
#[expect(clippy::too_many_arguments, reason = "keys, time, balls, wishes")]
pub(super) fn by_keys(
    actions: Actions,
    time: Res<Time<Real>>,
    mut practice: ResMut<Practice>,
    clock: Res<Clock>,
    turns: Res<Turns>,
    balls: Balls,
    camera: Query<&GlobalTransform, With<Camera3d>>,
    mut aim: ResMut<Aim>,
    mut held: ResMut<HeldKey>,
    mut wished: ResMut<Wish>,
    mut commands: MessageWriter<PracticeCommand>,
) {
    if !practice.placing || clock.moving {
        wished.0 = None;
        return;
    }
    let mut in_play: Vec<(usize, DVec2)> = balls
        .iter()
        .filter(|ball| ball.2.0.in_play())
        .map(|ball| (ball.0.0, DVec2::new(ball.1.0.x, ball.1.0.z)))
        .collect();
    in_play.sort_by_key(|(index, _)| *index);
    // In a match only the cue ball may be in hand.
    if turns.places_cue_ball() {
        practice.chosen = Some(aim.ball);
        in_play.retain(|(index, _)| *index == aim.ball);
    }
    let present = practice.chosen.unwrap_or(aim.ball);
    let is = |ball: usize| in_play.iter().position(|(index, _)| *index == ball);
    let Some(mut at) = is(present).or_else(|| is(aim.ball)) else {
        return;
    };
    for (action, step) in [
        (Action::NextBallRight, 1),
        (Action::NextBallLeft, in_play.len() - 1),
    ] {
        if actions.just_pressed(&action) {
            at = (at + step) % in_play.len();
            // The cue points at the ball that is chosen, so that one sees which it is.
            let to = in_play[at].1;
            if let Some((_, from)) = in_play.iter().find(|(index, _)| *index == aim.ball)
                && to != *from
            {
                let level = |at: DVec2| DVec3::new(at.x, 0.0, at.y);
                aim.set_heading(Shot::heading_between(level(*from), level(to)));
            }
        }
    }
    let (ball, place) = in_play[at];
    if practice.chosen != Some(ball) {
        practice.chosen = Some(ball);
    }
    let step = STEP * fineness(&actions);
    let mut steps = |more, less| held.steps(&actions, &time, more, less);
    let asked = DVec2::new(
        steps(Action::AimRight, Action::AimLeft),
        steps(Action::PowerDown, Action::PowerUp),
    );
    let way = step * seen_from(camera.single().ok(), asked);
    if way == DVec2::ZERO {
        return;
    }
    // Between two ticks a wish goes on from the last one; what the table made of it counts from then on.
    let from = match wished.0 {
        Some((who, seen, wish)) if who == ball && seen == place => wish,
        _ => place,
    };
    let wish = from + way;
    wished.0 = Some((ball, place, wish));
    commands.write(PracticeCommand::PlaceBall {
        ball,
        x: wish.x,
        z: wish.y,
    });
}

/// A way to the right and towards the player on the screen, as a way on the table, x and z.
fn seen_from(camera: Option<&GlobalTransform>, asked: DVec2) -> DVec2 {
    let right = camera.map_or(DVec3::X, |place| place.right().as_vec3().as_dvec3());
    let right = DVec2::new(right.x, right.z).normalize_or(DVec2::X);
    asked.x * right + asked.y * DVec2::new(-right.y, right.x)
}
