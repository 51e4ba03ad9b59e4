//! The help: every action with its controls, by topic; over the table and as a page of the menu.

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

use super::Help;
use crate::window::action::{Action, Bindings, CONTROLS, Topic};
use crate::window::language::Language;
use crate::window::page::panel_id;
use crate::window::page::{Open, PageId};

/// Least width of a column in points: the controls of all topics line up.
const COLUMN: f32 = 120.0;

/// Lays out the help, or the buttons that open it and the menu.
pub(super) fn show(
    mut contexts: EguiContexts,
    language: Res<Language>,
    bindings: Res<Bindings>,
    mut help: ResMut<Help>,
    mut open: ResMut<Open>,
) -> Result {
    let context = contexts.ctx_mut()?;
    let margin = egui::vec2(8.0, 8.0);
    if !help.open {
        let labelled = |key, action| {
            let name = language.text(key);
            match bindings.of(action).first() {
                Some(control) => format!("{name} ({})", control.name(&language)),
                None => name.to_owned(),
            }
        };
        egui::Area::new(panel_id(context, "corner"))
            .anchor(egui::Align2::LEFT_TOP, margin)
            .show(context, |ui| {
                ui.horizontal(|ui| {
                    if ui.button(labelled("menu-open", Action::Close)).clicked() {
                        open.go(PageId::MAIN);
                    }
                    if ui.button(labelled("help-open", Action::Help)).clicked() {
                        help.open = true;
                    }
                });
            });
        return Ok(());
    }
    let height = context.content_rect().height();
    let mut is_open = true;
    egui::Window::new(language.text("help-title"))
        .id(egui::Id::new("help"))
        .open(&mut is_open)
        .anchor(egui::Align2::LEFT_TOP, margin)
        .auto_sized()
        .collapsible(false)
        .show(context, |ui| {
            egui::ScrollArea::vertical()
                .max_height(height - 80.0)
                .show(ui, |ui| topics(ui, &language, &bindings));
        });
    if !is_open {
        help.open = false;
    }
    Ok(())
}

/// The same in the menu.
pub(super) fn page(InMut(ui): InMut<egui::Ui>, language: Res<Language>, bindings: Res<Bindings>) {
    topics(ui, &language, &bindings);
}

/// Every action with its controls.
fn topics(ui: &mut egui::Ui, language: &Language, bindings: &Bindings) {
    for topic in Topic::ALL {
        let title = language.text(topic.key());
        ui.strong(title);
        egui::Grid::new(topic.key())
            .num_columns(2)
            .striped(true)
            .min_col_width(COLUMN)
            .spacing([12.0, 2.0])
            .show(ui, |ui| {
                for line in CONTROLS.iter().filter(|line| line.topic == topic) {
                    let controls = bindings.of(line.action).iter();
                    let names: Vec<String> =
                        controls.map(|control| control.name(language)).collect();
                    ui.add(
                        egui::Label::new(egui::RichText::new(names.join(", ")).monospace()).wrap(),
                    );
                    ui.add(egui::Label::new(language.text(&line.action.key())).wrap());
                    ui.end_row();
                }
            });
        ui.add_space(4.0);
    }
}
