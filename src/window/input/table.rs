//! Keys that change what lies on the table.

use bevy::prelude::*;

use super::Actions;
use crate::game::equip::Told;
use crate::game::matches::{Hindrance, Refused};
use crate::game::practice::{Practice, PracticeCommand};
use crate::game::turns::Turns;
use crate::physics::scene::Rack;
use crate::window::action::Action;

/// Sends what the player asks of the table. In a match a key neither racks again, which would leave it, nor moves what is
/// not in hand.
pub(super) fn command(
    actions: Actions,
    turns: Res<Turns>,
    mut practice: ResMut<Practice>,
    mut commands: MessageWriter<PracticeCommand>,
    mut told: MessageWriter<Told>,
) {
    let next = match practice.rack {
        Rack::EightBall => Rack::NineBall,
        _ => Rack::EightBall,
    };
    let mut refuse = |now| {
        let refused = Refused::NotNow { what: "this", now };
        told.write(Told {
            text: refused.saying(),
            is_failure: true,
        });
    };
    for (action, command) in [
        (Action::Retry, PracticeCommand::Retry),
        (Action::Undo, PracticeCommand::Undo),
        (Action::Redo, PracticeCommand::Redo),
    ] {
        if actions.just_pressed(&action) {
            commands.write(command);
        }
    }
    if actions.just_pressed(&Action::Rack) {
        if turns.is_on() {
            refuse(Hindrance::MatchOn);
        } else {
            commands.write(PracticeCommand::Rack(next));
        }
    }
    let place = actions.just_pressed(&Action::Place);
    let in_hand = actions.just_pressed(&Action::InHand);
    if turns.is_on() && (place || in_hand) {
        match turns.hinders_placing() {
            Some(now) => refuse(now),
            None => practice.placing = in_hand || !practice.placing,
        }
    } else if place {
        practice.placing = !practice.placing;
    } else if in_hand {
        commands.write(PracticeCommand::CueBallInHand);
    }
}

/// A cue ball in hand is put down by whatever comes next: the keys that aim, or those that strike, which then only put it
/// down. Keys that move it are those of [`place`](super::place).
pub(super) fn put_down(actions: Actions, turns: Res<Turns>, mut practice: ResMut<Practice>) {
    if !practice.placing || !turns.places_cue_ball() {
        return;
    }
    let goes_on = [
        Action::NextBallLeft,
        Action::NextBallRight,
        Action::SideLeft,
        Action::SideRight,
        Action::HeightUp,
        Action::HeightDown,
        Action::ElevationUp,
        Action::ElevationDown,
        Action::Center,
        Action::Stroke,
    ];
    if goes_on.iter().any(|action| actions.just_pressed(action)) {
        practice.placing = false;
    }
}
