//! The help: every action of the table of controls, by topic.

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

use super::Help;
use crate::window::action::{CONTROLS, Control, Topic};

/// Lays out the help, and the button that opens it.
pub(super) fn show(mut contexts: EguiContexts, mut help: ResMut<Help>) -> Result {
    let context = contexts.ctx_mut()?;
    if !help.open {
        egui::Area::new(egui::Id::new("help button"))
            .anchor(egui::Align2::LEFT_TOP, egui::vec2(8.0, 8.0))
            .show(context, |ui| {
                if ui.button("Help (H)").clicked() {
                    help.open = true;
                }
            });
        return Ok(());
    }
    let mut open = true;
    egui::Window::new("Keys and mouse")
        .open(&mut open)
        .anchor(egui::Align2::LEFT_TOP, egui::vec2(8.0, 8.0))
        .resizable(false)
        .collapsible(false)
        .max_height(context.content_rect().height() - 60.0)
        .vscroll(true)
        .show(context, |ui| {
            for topic in Topic::ALL {
                ui.strong(topic.title());
                egui::Grid::new(topic.title())
                    .num_columns(2)
                    .striped(true)
                    .spacing([12.0, 2.0])
                    .show(ui, |ui| {
                        for line in CONTROLS.iter().filter(|line| line.topic == topic) {
                            let names: Vec<String> =
                                line.controls.iter().copied().map(Control::name).collect();
                            ui.monospace(names.join(", "));
                            ui.label(line.what);
                            ui.end_row();
                        }
                    });
                ui.add_space(4.0);
            }
        });
    if !open {
        help.open = false;
    }
    Ok(())
}
