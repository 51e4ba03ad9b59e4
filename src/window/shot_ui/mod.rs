//! The shot panel: every number of the shot, the cue ball to click on, the table, the laws and the solver.
//!
//! It reads and writes resources of [`sim`](crate::sim) and [`game`](crate::game) and asks for everything else by messages,
//! so the game can be played with the mouse alone.

mod cue_ball;
mod equipment;
mod last;
mod model;
mod numbers;
mod table;

use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy_egui::input::egui_wants_any_keyboard_input;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use leafwing_input_manager::prelude::ActionState;

use crate::game::aim::{Aim, Swing};
use crate::game::equip::{ChoosePreset, Equip, PresetInUse};
use crate::game::lift::CueRoom;
use crate::game::practice::{Practice, PracticeCommand};
use crate::game::settings::Settings;
use crate::game::turns::Turns;
use crate::game::view::{SceneCameras, View};
use crate::sim::clock::Clock;
use crate::sim::playfield::{BallQuery, Playfield};
use crate::sim::recorder::Recorder;
use crate::sim::stepped::crowd::is_crowd;
use crate::window::WindowSystems;
use crate::window::action::{Action, Latched};
use crate::window::language::Language;
use crate::window::page::SidePanel;

/// Width of the panel in points.
const WIDTH: f32 = 286.0;

/// Whether the panel is open, and how it is set up.
#[derive(Resource, Debug)]
struct ShotPanel {
    open: bool,
    /// What a step button changes: 1, 0.1, 0.01 or 0.001 of a coarse step.
    step: f64,
    /// A file that the player types.
    preset_file: String,
}

pub(super) fn plugin(app: &mut App) {
    app.insert_resource(ShotPanel {
        open: true,
        step: 1.0,
        preset_file: String::new(),
    })
    .add_systems(
        PreUpdate,
        toggle
            .in_set(WindowSystems::Input)
            .run_if(not(egui_wants_any_keyboard_input))
            .run_if(not(is_crowd)),
    )
    .add_systems(
        EguiPrimaryContextPass,
        show.in_set(WindowSystems::Ui).run_if(not(is_crowd)),
    );
}

/// Everything the panel shows and changes.
#[derive(SystemParam)]
struct Desk<'w, 's> {
    panel: ResMut<'w, ShotPanel>,
    aim: ResMut<'w, Aim>,
    practice: ResMut<'w, Practice>,
    view: ResMut<'w, View>,
    cameras: Res<'w, SceneCameras>,
    settings: ResMut<'w, Settings>,
    playfield: ResMut<'w, Playfield>,
    clock: Res<'w, Clock>,
    recorder: Res<'w, Recorder>,
    balls: BallQuery<'w, 's>,
    swings: MessageWriter<'w, Swing>,
    commands: MessageWriter<'w, PracticeCommand>,
    room: Res<'w, CueRoom>,
    preset: Res<'w, PresetInUse>,
    choose: MessageWriter<'w, ChoosePreset>,
    equip: MessageWriter<'w, Equip>,
    language: Res<'w, Language>,
    latched: ResMut<'w, Latched>,
    turns: Res<'w, Turns>,
}

fn toggle(actions: Single<&ActionState<Action>>, mut panel: ResMut<ShotPanel>) {
    if actions.just_pressed(&Action::Panel) {
        panel.open = !panel.open;
    }
}

/// Lays out the panel, or the button that brings it back.
fn show(mut contexts: EguiContexts, mut desk: Desk) -> Result {
    let context = contexts.ctx_mut()?;
    let panel = SidePanel {
        name: "shot",
        title: desk.language.text("shot-title").to_owned(),
        width: WIDTH,
        below: 120.0,
    };
    let open = panel.show(context, desk.panel.open, |ui| contents(ui, &mut desk));
    if open != desk.panel.open {
        desk.panel.open = open;
    }
    Ok(())
}

fn contents(ui: &mut egui::Ui, desk: &mut Desk) {
    let language = desk.language.clone();
    numbers::show(ui, desk);
    ui.separator();
    table::show(ui, desk);
    ui.separator();
    // A match is played with what was agreed on.
    let is_free = !desk.turns.is_agreed();
    fold(ui, &language, "shot-equipment", |ui| {
        ui.add_enabled_ui(is_free, |ui| equipment::show(ui, desk));
    });
    fold(ui, &language, "shot-last", |ui| last::show(ui, desk));
    fold(ui, &language, "shot-model", |ui| {
        ui.add_enabled_ui(is_free, |ui| model::show(ui, desk));
    });
}

/// A part that is folded away until its heading is clicked.
fn fold(ui: &mut egui::Ui, language: &Language, key: &str, show: impl FnOnce(&mut egui::Ui)) {
    egui::CollapsingHeader::new(language.text(key))
        .id_salt(key)
        .show(ui, show);
}
