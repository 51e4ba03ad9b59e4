//! Settings: a page for each kind, and one that leads to them.

mod ask;
mod controls;
mod general;
mod picture;
mod sound;

pub(super) use ask::{asks, is_asking};

use bevy::prelude::*;
use bevy_egui::egui;

use super::{equipment, rows};
use crate::game::settings::{Settings, SettingsFile};
use crate::window::language::Language;
use crate::window::page::{AddPages, Open, Page, PageId, Pages};

pub(super) fn plugin(app: &mut App) {
    app.add_page(
        Page {
            id: PageId::SETTINGS,
            title: "settings-title",
            place: Some((PageId::MAIN, 30)),
        },
        show,
    )
    .add_plugins((
        general::plugin,
        picture::plugin,
        sound::plugin,
        controls::plugin,
        ask::plugin,
    ));
}

fn show(
    InMut(ui): InMut<egui::Ui>,
    language: Res<Language>,
    pages: Res<Pages>,
    file: Res<SettingsFile>,
    mut settings: ResMut<Settings>,
    mut open: ResMut<Open>,
) {
    ui.vertical_centered_justified(|ui| {
        for page in pages.below(PageId::SETTINGS) {
            if rows::entry(ui, language.text(page.title)).clicked() {
                open.go(page.id);
            }
        }
        let as_at_first = *settings == Settings::default();
        let reset = egui::Button::new(language.text("settings-reset"));
        if ui.add_enabled(!as_at_first, reset).clicked() {
            *settings = Settings::default();
        }
    });
    if let Some(file) = &file.0 {
        let file = file.display().to_string();
        ui.weak(language.with("settings-kept", &[("file", file.into())]));
    }
}
