//! What lies over the picture: a line of status, notices, the help with every key.

mod help;
mod notice;
mod replay;
mod status;

use bevy::prelude::*;
use bevy_egui::input::EguiWantsInput;
use bevy_egui::{EguiPreUpdateSet, EguiPrimaryContextPass};
use leafwing_input_manager::plugin::InputManagerSystem;
use leafwing_input_manager::prelude::ActionState;

use crate::game::practice::Practice;
use crate::game::replay::Replay;
use crate::window::WindowSystems;
use crate::window::action::Action;

/// Whether the help is open.
#[derive(Resource, Debug, Default)]
struct Help {
    open: bool,
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Help>()
        .init_resource::<notice::Notices>()
        .add_systems(Startup, notice::welcome)
        .add_systems(
            PreUpdate,
            // Before the others, so that all see the same state when a key closes one thing after the other.
            keys.after(InputManagerSystem::ManualControl)
                .after(EguiPreUpdateSet::ProcessInput)
                .before(WindowSystems::Input),
        )
        .add_systems(Update, notice::listen)
        .add_systems(
            EguiPrimaryContextPass,
            (status::show, replay::show, notice::show, help::show)
                .chain()
                .in_set(WindowSystems::Overlay),
        );
}

/// Opens the help; closes what is open; quits when asked twice.
#[expect(clippy::too_many_arguments, reason = "everything that can be closed")]
fn keys(
    actions: Single<&ActionState<Action>>,
    egui: Res<EguiWantsInput>,
    time: Res<Time<Real>>,
    replay: Res<Replay>,
    mut help: ResMut<Help>,
    mut practice: ResMut<Practice>,
    mut notices: ResMut<notice::Notices>,
    mut commands: Commands,
) {
    if egui.wants_any_keyboard_input() {
        return;
    }
    if actions.just_pressed(&Action::Help) {
        help.open = !help.open;
    }
    if !actions.just_pressed(&Action::Close) {
        return;
    }
    if help.open {
        help.open = false;
    } else if replay.is_active() {
        // The replay itself is left by its own keys.
    } else if practice.placing {
        practice.placing = false;
    } else if notices.quits(time.elapsed()) {
        // Through commands: anybody may quit, in no order.
        commands.write_message(AppExit::Success);
    }
}
