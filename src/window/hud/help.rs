//! The help: every action of the table of controls, by topic.

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

use super::Help;
use crate::window::action::{CONTROLS, Control, Topic};

/// Least width of a column in points: the controls of all topics line up.
const COLUMN: f32 = 120.0;

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
    let height = context.content_rect().height();
    let mut open = true;
    egui::Window::new("Keys and mouse")
        .open(&mut open)
        .anchor(egui::Align2::LEFT_TOP, egui::vec2(8.0, 8.0))
        .auto_sized()
        .collapsible(false)
        .show(context, |ui| {
            egui::ScrollArea::vertical()
                .max_height(height - 80.0)
                .show(ui, topics);
        });
    if !open {
        help.open = false;
    }
    Ok(())
}

/// Every action with its controls.
fn topics(ui: &mut egui::Ui) {
    for topic in Topic::ALL {
        ui.strong(topic.title());
        egui::Grid::new(topic.title())
            .num_columns(2)
            .striped(true)
            .min_col_width(COLUMN)
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
}
