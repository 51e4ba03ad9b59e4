//! What lies on the table and how it is seen and heard, for the mouse.

use bevy::prelude::DetectChangesMut;
use bevy_egui::egui;

use super::Desk;
use crate::game::practice::PracticeCommand;
use crate::game::view::CameraMode;
use crate::physics::scene::Rack;
use crate::physics::table::Preset;

/// Lays out the buttons for table, view and sound.
pub(super) fn show(ui: &mut egui::Ui, desk: &mut Desk) {
    ui.horizontal_wrapped(|ui| {
        let can_retry = desk.practice.history.has_shot();
        if ui
            .add_enabled(can_retry, egui::Button::new("Retry"))
            .clicked()
        {
            desk.commands.write(PracticeCommand::Retry);
        }
        let steps = desk.practice.history.len();
        let undo = egui::Button::new(format!("Undo ({steps})"));
        if ui.add_enabled(steps > 0, undo).clicked() {
            desk.commands.write(PracticeCommand::Undo);
        }
        for (rack, name) in [
            (Rack::EightBall, "Rack 8-ball"),
            (Rack::NineBall, "Rack 9-ball"),
        ] {
            if ui.button(name).clicked() {
                desk.commands.write(PracticeCommand::Rack(rack));
            }
        }
    });
    ui.horizontal_wrapped(|ui| {
        let still = !desk.clock.moving;
        let mut placing = desk.practice.placing;
        ui.add_enabled_ui(still, |ui| {
            ui.toggle_value(&mut placing, "Place balls")
                .on_hover_text("While this is on, dragging a ball moves it.");
            if ui.button("Cue ball in hand").clicked() {
                desk.commands.write(PracticeCommand::CueBallInHand);
            }
        });
        if placing != desk.practice.placing {
            desk.practice.placing = placing;
        }
    });
    tables(ui, desk);
    let mut view = *desk.view;
    ui.horizontal_wrapped(|ui| {
        for (mode, name) in [
            (CameraMode::BehindCue, "Behind cue"),
            (CameraMode::Overhead, "Overhead"),
            (CameraMode::Orbit, "Free"),
        ] {
            ui.selectable_value(&mut view.camera, mode, name);
        }
        ui.checkbox(&mut view.guides, "Guides");
        ui.checkbox(&mut view.preview, "Preview");
        ui.checkbox(&mut view.trails, "Trails");
    });
    desk.view.set_if_neq(view);
    let mut volume = *desk.volume;
    ui.horizontal(|ui| {
        ui.label("Sound");
        ui.spacing_mut().slider_width = 120.0;
        ui.add(egui::Slider::new(&mut volume.level, 0.0..=1.0).show_value(false));
        ui.checkbox(&mut volume.muted, "Mute");
    });
    desk.volume.set_if_neq(volume);
}

fn tables(ui: &mut egui::Ui, desk: &mut Desk) {
    let present = &desk.playfield.table;
    let shown = Preset::NAMED
        .iter()
        .find(|preset| preset.table() == *present)
        .map_or("own", name);
    ui.horizontal(|ui| {
        ui.label("Table");
        egui::ComboBox::from_id_salt("table")
            .selected_text(shown)
            .show_ui(ui, |ui| {
                for preset in &Preset::NAMED {
                    let label = name(preset);
                    if ui.selectable_label(label == shown, label).clicked() {
                        desk.commands.write(PracticeCommand::Table(*preset));
                        ui.close();
                    }
                }
            });
        ui.label("and rack again");
    });
}

fn name(preset: &Preset) -> &'static str {
    match preset {
        Preset::NineFoot => "9 ft pool",
        Preset::EightFoot => "8 ft pool",
        Preset::SevenFoot => "7 ft pool",
        Preset::Snooker => "12 ft snooker",
        Preset::Carom => "Carom",
        Preset::Box { .. } => "Box",
    }
}
