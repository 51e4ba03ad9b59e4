//! Keys that change what lies on the table.

use bevy::prelude::*;

use super::Actions;
use crate::game::practice::{Practice, PracticeCommand};
use crate::physics::scene::Rack;
use crate::window::action::Action;

/// Sends what the player asks of the table.
pub(super) fn command(
    actions: Actions,
    mut practice: ResMut<Practice>,
    mut commands: MessageWriter<PracticeCommand>,
) {
    let next = match practice.rack {
        Rack::EightBall => Rack::NineBall,
        _ => Rack::EightBall,
    };
    for (action, command) in [
        (Action::Retry, PracticeCommand::Retry),
        (Action::Undo, PracticeCommand::Undo),
        (Action::Redo, PracticeCommand::Redo),
        (Action::Rack, PracticeCommand::Rack(next)),
        (Action::InHand, PracticeCommand::CueBallInHand),
    ] {
        if actions.just_pressed(&action) {
            commands.write(command);
        }
    }
    if actions.just_pressed(&Action::Place) {
        practice.placing = !practice.placing;
    }
}
