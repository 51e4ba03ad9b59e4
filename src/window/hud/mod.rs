//! What lies over the picture: a line of status, notices, the help with every key.

mod halves;
mod help;
mod labels;
mod notice;
mod replay;
mod status;

use bevy::prelude::*;
use bevy_egui::EguiPrimaryContextPass;
use bevy_egui::input::EguiWantsInput;
use leafwing_input_manager::prelude::ActionState;

use crate::game::practice::Practice;
use crate::game::replay::Replay;
use crate::sim::stepped::crowd::is_crowd;
use crate::window::WindowSystems;
use crate::window::action::Action;
use crate::window::page::{AddPages, Open, Page, PageId, Screen};

/// Whether the help is open.
#[derive(Resource, Debug, Default)]
struct Help {
    open: bool,
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Help>()
        .init_resource::<notice::Notices>()
        .add_page(
            Page {
                id: PageId::HELP,
                title: "help-title",
                place: Some((PageId::MAIN, 40)),
            },
            help::page,
        )
        .add_systems(Startup, notice::welcome)
        .add_systems(PreUpdate, keys.in_set(WindowSystems::Close))
        .add_systems(Update, notice::listen)
        .add_systems(
            EguiPrimaryContextPass,
            (
                labels::show,
                halves::show.run_if(in_state(Screen::Table)),
                (status::show.run_if(not(is_crowd)), replay::show)
                    .chain()
                    .run_if(in_state(Screen::Table)),
                notice::show,
                help::show.run_if(in_state(Screen::Table)),
            )
                .chain()
                .in_set(WindowSystems::Overlay),
        );
}

/// Opens the help; closes what is open; opens the menu.
fn keys(
    actions: Single<&ActionState<Action>>,
    egui: Res<EguiWantsInput>,
    replay: Res<Replay>,
    mut help: ResMut<Help>,
    mut practice: ResMut<Practice>,
    mut open: ResMut<Open>,
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
    } else {
        open.go(PageId::MAIN);
    }
}
