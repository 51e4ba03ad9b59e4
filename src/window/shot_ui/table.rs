//! What lies on the table and how it is seen and heard, for the mouse.

use bevy::prelude::DetectChangesMut;
use bevy_egui::egui;

use super::Desk;
use crate::game::practice::PracticeCommand;
use crate::game::target;
use crate::game::view::{Beside, CameraMode};
use crate::physics::scene::Rack;
use crate::physics::table::Preset;
use crate::sim::playfield::snapshot;
use crate::window::action::Action;

/// Lays out the buttons for table, view and sound.
pub(super) fn show(ui: &mut egui::Ui, desk: &mut Desk) {
    let language = desk.language.clone();
    let text = |key| language.text(key);
    // What would end a match, or is not played in it, is not to be clicked by mistake.
    let is_free = !desk.turns.is_agreed();
    let takes_back = is_free || desk.turns.game().is_some_and(|game| game.setup().undo);
    let places = is_free || desk.turns.places_cue_ball();
    ui.horizontal_wrapped(|ui| {
        let can_retry = takes_back && desk.practice.history.has_shot();
        if ui
            .add_enabled(can_retry, egui::Button::new(text("table-retry")))
            .clicked()
        {
            desk.commands.write(PracticeCommand::Retry);
        }
        let steps = desk.practice.history.len();
        let undo = egui::Button::new(language.with("table-undo", &[("steps", steps.into())]));
        if ui.add_enabled(takes_back && steps > 0, undo).clicked() {
            desk.commands.write(PracticeCommand::Undo);
        }
        for (rack, name) in [
            (Rack::EightBall, "rack-eight-ball"),
            (Rack::NineBall, "rack-nine-ball"),
        ] {
            let rack_up = ui.add_enabled(is_free, egui::Button::new(text(name)));
            if rack_up.clicked() {
                desk.commands.write(PracticeCommand::Rack(rack));
            }
        }
    });
    ui.horizontal_wrapped(|ui| {
        let still = !desk.clock.moving;
        let mut placing = desk.practice.placing;
        ui.add_enabled_ui(still && places, |ui| {
            ui.toggle_value(&mut placing, text("table-place"))
                .on_hover_text(text("table-place-hint"));
            if ui.button(text("table-in-hand")).clicked() {
                desk.commands.write(PracticeCommand::CueBallInHand);
            }
        });
        if placing != desk.practice.placing {
            desk.practice.placing = placing;
        }
    });
    ui.add_enabled_ui(is_free, |ui| tables(ui, desk));
    let mut view = *desk.view;
    ui.horizontal_wrapped(|ui| {
        for (mode, name) in [
            (CameraMode::BehindCue, "camera-behind"),
            (CameraMode::Overhead, "camera-overhead"),
            (CameraMode::Orbit, "camera-free"),
            (CameraMode::Follow, "camera-follow"),
        ] {
            ui.selectable_value(&mut view.camera, mode, text(name));
        }
        let two = matches!(view.beside, Beside::Camera(_));
        if ui.selectable_label(two, text("view-second")).clicked() {
            view.toggle_second(&desk.cameras);
        }
        let laws = view.beside == Beside::Laws;
        if ui.selectable_label(laws, text("view-laws")).clicked() {
            view.toggle_laws();
        }
        ui.checkbox(&mut view.guides, text("view-guides"));
        ui.checkbox(&mut view.preview, text("view-preview"));
        ui.checkbox(&mut view.trails, text("view-trails"));
    });
    desk.view.set_if_neq(view);
    ui.horizontal(|ui| {
        for (key, step) in [("table-next-left", 1), ("table-next-right", -1)] {
            if ui.button(text(key)).clicked() {
                let scene = snapshot(&desk.playfield, &desk.balls);
                let (ball, heading) = (desk.aim.ball, desk.aim.shot.heading);
                if let Some(heading) = target::beside(&scene, ball, heading, step) {
                    desk.aim.set_heading(heading);
                }
            }
        }
    });
    ui.horizontal(|ui| {
        let fast = desk.latched.iter().any(|one| one == Action::FastForward);
        if ui
            .selectable_label(fast, text("view-fast-forward"))
            .clicked()
        {
            desk.latched.flip(Action::FastForward);
        }
    });
    let mut volume = desk.settings.volume;
    ui.horizontal(|ui| {
        ui.label(text("settings-sound"));
        ui.spacing_mut().slider_width = 120.0;
        ui.add(egui::Slider::new(&mut volume.level, 0.0..=1.0).show_value(false));
        ui.checkbox(&mut volume.muted, text("sound-mute"));
    });
    if volume != desk.settings.volume {
        desk.settings.volume = volume;
    }
}

fn tables(ui: &mut egui::Ui, desk: &mut Desk) {
    let language = desk.language.clone();
    let present = &desk.playfield.table;
    let shown = Preset::NAMED
        .iter()
        .find(|preset| preset.table() == *present)
        .map_or("table-own", key);
    ui.horizontal(|ui| {
        ui.label(language.text("topic-table"));
        egui::ComboBox::from_id_salt("table")
            .selected_text(language.text(shown))
            .show_ui(ui, |ui| {
                for preset in &Preset::NAMED {
                    let key = key(preset);
                    let name = language.text(key);
                    if ui.selectable_label(key == shown, name).clicked() {
                        desk.commands.write(PracticeCommand::Table(*preset));
                        ui.close();
                    }
                }
            });
        ui.label(language.text("table-rack-again"));
    });
}

fn key(preset: &Preset) -> &'static str {
    match preset {
        Preset::NineFoot => "table-nine-foot",
        Preset::EightFoot => "table-eight-foot",
        Preset::SevenFoot => "table-seven-foot",
        Preset::Snooker => "table-snooker",
        Preset::Carom => "table-carom",
        Preset::Box { .. } => "table-box",
    }
}
