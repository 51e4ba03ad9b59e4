//! Trick shots and the studio: the page that lists the library, the panel of what must happen, the panel in which layouts
//! are built, saved and shared.

mod heat;
mod page;
mod panel;
mod seats;
mod share;
mod stage;
mod still;
mod studio;
mod tricks;

use bevy::prelude::*;
use bevy_egui::EguiPrimaryContextPass;
use bevy_egui::input::egui_wants_any_keyboard_input;
use leafwing_input_manager::prelude::ActionState;

use crate::game::practice::Practice;
use crate::game::replay::Replay;
use crate::sim::SimSystems;
use crate::window::WindowSystems;
use crate::window::action::Action;
use crate::window::page::{AddPages, Page, PageId};
use stage::Ask;

pub use heat::Heat;
pub use seats::seats;
pub use share::OwnScenes;
pub(super) use stage::begin;
pub use stage::{OnTable, Stage, Turn};
pub use studio::Studio;

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Stage>()
        .init_resource::<tricks::Stills>()
        .init_resource::<studio::Studio>()
        .init_resource::<heat::Heat>()
        .init_resource::<OwnScenes>()
        .init_resource::<share::Clipboard>()
        .add_message::<Ask>()
        .add_message::<share::Asked>()
        .add_page(
            Page {
                id: PageId("tricks"),
                title: "tricks-title",
                place: Some((PageId::MAIN, 12)),
            },
            page::show,
        )
        .add_systems(
            PreUpdate,
            (
                seats::follow.run_if(resource_exists_and_changed::<Stage>),
                keys.run_if(not(egui_wants_any_keyboard_input)),
            )
                .chain()
                .in_set(WindowSystems::Scenes),
        )
        .add_systems(
            PreUpdate,
            share::obey
                .after(WindowSystems::Scenes)
                .run_if(on_message::<share::Asked>),
        )
        .add_systems(FixedUpdate, stage::watch.after(SimSystems::Judge))
        .add_systems(
            Update,
            (stage::obey.run_if(on_message::<Ask>), stage::judge).chain(),
        )
        .add_systems(Last, stage::open)
        .add_systems(
            EguiPrimaryContextPass,
            (panel::show, studio::show)
                .chain()
                .in_set(WindowSystems::Scenes),
        );
}

/// Opens the studio; shows, tries and changes trick shots.
fn keys(
    actions: Single<&ActionState<Action>>,
    stage: Res<Stage>,
    replay: Res<Replay>,
    mut studio: ResMut<studio::Studio>,
    mut practice: ResMut<Practice>,
    mut asks: MessageWriter<Ask>,
) {
    if actions.just_pressed(&Action::Studio) {
        studio.open = !studio.open;
        practice.placing = studio.open;
    }
    if stage.on_table().is_none() || replay.is_active() {
        return;
    }
    for (action, ask) in [
        (Action::PlayTrick, Ask::Play),
        (Action::TryTrick, Ask::Try),
        (Action::PreviousTrick, Ask::Neighbour(-1)),
        (Action::NextTrick, Ask::Neighbour(1)),
    ] {
        if actions.just_pressed(&action) {
            asks.write(ask);
        }
    }
}
