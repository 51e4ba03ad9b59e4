//! The stroke: by hand, at the speed of the hand, or as a swing to the power that is set.

use bevy::prelude::*;
use bevy_egui::input::EguiWantsInput;

use super::Actions;
use super::motion::Motion;
use crate::game::aim::{Aim, Swing};
use crate::game::practice::Practice;
use crate::game::turns::Turns;
use crate::sim::clock::Clock;
use crate::sim::messages::Strike;
use crate::window::action::Action;

/// Pixels of a full backstroke.
const PULL: f64 = 240.0;
/// Pixels per second of the fastest stroke.
const TOP_HAND: f64 = 2400.0;
/// Pixels per second below which a push is no stroke.
const LEAST_HAND: f64 = 120.0;
/// Share of a full backstroke that makes a push a stroke.
const LEAST_PULL: f64 = 0.08;
/// Seconds of a push over which its speed is taken.
const PUSH: f64 = 0.08;
/// Seconds of the backswing, and of the swing forward.
const BACK: f64 = 0.35;
/// Seconds from the end of the backswing to the ball.
const FORWARD: f64 = 0.08;

/// What the cue is doing.
#[derive(Resource, Debug, Default)]
pub(super) enum Cueing {
    /// Lies at the ball.
    #[default]
    Idle,
    /// Swings by itself since this many seconds.
    Swinging(f64),
    /// In the hand.
    InHand(Hand),
    /// The stroke by hand is done; the key is still held.
    Done,
}

/// A stroke by hand so far.
#[derive(Debug, Default)]
pub(super) struct Hand {
    /// How far the cue is back now, 0 to 1.
    back: f64,
    /// How far it was back at most.
    furthest: f64,
    /// Seconds and pixels of the frames of the present push, oldest first.
    push: Vec<(f64, f64)>,
}

impl Cueing {
    pub(super) fn is_idle(&self) -> bool {
        matches!(self, Self::Idle)
    }
}

impl Hand {
    /// Moves the cue by these pixels towards the player in a frame of this many seconds.
    fn pull(&mut self, pixels: f64, seconds: f64) {
        self.back = (self.back + pixels / PULL).min(1.0);
        self.furthest = self.furthest.max(self.back);
        if pixels < 0.0 {
            self.push.push((seconds, -pixels));
        } else if pixels > 0.0 {
            self.push.clear();
        }
    }

    /// Speed of the hand in pixels per second at the end of the push.
    fn speed(&self) -> f64 {
        let (mut seconds, mut pixels) = (0.0, 0.0);
        for frame in self.push.iter().rev() {
            seconds += frame.0;
            pixels += frame.1;
            if seconds >= PUSH {
                break;
            }
        }
        if seconds > 0.0 { pixels / seconds } else { 0.0 }
    }
}

/// Asks for a swing with the key; a cue ball in hand is only put down by it.
pub(super) fn ask(
    actions: Actions,
    turns: Res<Turns>,
    mut practice: ResMut<Practice>,
    mut swings: MessageWriter<Swing>,
) {
    if !actions.just_pressed(&Action::Strike) {
        return;
    }
    if practice.placing && turns.places_cue_ball() {
        practice.placing = false;
    } else {
        swings.write(Swing);
    }
}

/// Follows the hand; the stroke falls when the cue comes back to the ball.
#[expect(
    clippy::too_many_arguments,
    reason = "a system names everything it reads"
)]
pub(super) fn by_hand(
    actions: Actions,
    time: Res<Time<Real>>,
    clock: Res<Clock>,
    egui: Res<EguiWantsInput>,
    motion: Res<Motion>,
    mut cueing: ResMut<Cueing>,
    mut aim: ResMut<Aim>,
    mut strikes: MessageWriter<Strike>,
) {
    if !actions.pressed(&Action::Stroke) {
        if matches!(*cueing, Cueing::InHand(_) | Cueing::Done) {
            *cueing = Cueing::Idle;
            aim.draw_back = 0.0;
        }
        return;
    }
    let busy = clock.moving || egui.wants_any_keyboard_input() || egui.wants_any_pointer_input();
    if cueing.is_idle() && actions.just_pressed(&Action::Stroke) && !busy {
        *cueing = Cueing::InHand(Hand::default());
    }
    let Cueing::InHand(hand) = &mut *cueing else {
        return;
    };
    let pixels = f64::from(motion.0.y);
    hand.pull(pixels, time.delta_secs_f64());
    if hand.back > 0.0 {
        aim.draw_back = hand.back;
        return;
    }
    aim.draw_back = 0.0;
    let speed = hand.speed();
    if hand.furthest >= LEAST_PULL && speed >= LEAST_HAND {
        aim.set_speed(speed / TOP_HAND * Aim::TOP_SPEED);
        strikes.write(Strike {
            ball: aim.ball,
            shot: aim.shot,
        });
        *cueing = Cueing::Done;
    } else {
        *hand = Hand::default();
    }
}

/// Swings the cue back and forth, then strikes.
pub(super) fn swing(
    time: Res<Time<Real>>,
    clock: Res<Clock>,
    mut swings: MessageReader<Swing>,
    mut cueing: ResMut<Cueing>,
    mut aim: ResMut<Aim>,
    mut strikes: MessageWriter<Strike>,
) {
    let asked = swings.read().count() > 0;
    if asked && cueing.is_idle() && !clock.moving && aim.shot.speed > 0.0 {
        *cueing = Cueing::Swinging(0.0);
        return;
    }
    let Cueing::Swinging(since) = &mut *cueing else {
        return;
    };
    *since += time.delta_secs_f64();
    let power = 0.1 + 0.9 * aim.shot.speed / Aim::TOP_SPEED;
    if *since < BACK {
        let share = *since / BACK;
        aim.draw_back = power * share * share * (3.0 - 2.0 * share);
    } else if *since < BACK + FORWARD {
        let share = (*since - BACK) / FORWARD;
        aim.draw_back = power * (1.0 - share * share);
    } else {
        *cueing = Cueing::Idle;
        aim.draw_back = 0.0;
        strikes.write(Strike {
            ball: aim.ball,
            shot: aim.shot,
        });
    }
}
