//! Keys of the replay.

use bevy::prelude::*;

use super::Actions;
use crate::game::replay::{Replay, ReplayCommand};
use crate::window::action::Action;

/// Whether the balls show a replay.
pub(super) fn is_on(replay: Res<Replay>) -> bool {
    replay.is_active()
}

/// Sends what the viewer asks of the replay.
pub(super) fn command(
    actions: Actions,
    replay: Res<Replay>,
    mut commands: MessageWriter<ReplayCommand>,
) {
    let pressed = |action| actions.just_pressed(&action);
    if pressed(Action::Replay) {
        commands.write(if replay.is_active() {
            ReplayCommand::Stop
        } else {
            ReplayCommand::Start
        });
    }
    let Some(playback) = &replay.0 else { return };
    for (action, command) in [
        (Action::Close, ReplayCommand::Stop),
        (Action::ReplayHold, ReplayCommand::TogglePlay),
        (Action::Strike, ReplayCommand::TogglePlay),
        (Action::ReplayBackwards, ReplayCommand::Rate(-playback.rate)),
        (
            Action::ReplaySlower,
            ReplayCommand::Rate(0.5 * playback.rate),
        ),
        (
            Action::ReplayFaster,
            ReplayCommand::Rate(2.0 * playback.rate),
        ),
        (Action::ReplayNext, ReplayCommand::StepEvent(true)),
        (Action::ReplayPrevious, ReplayCommand::StepEvent(false)),
        (Action::ReplayLoop, ReplayCommand::ToggleLoop),
    ] {
        if pressed(action) {
            commands.write(command);
        }
    }
}
