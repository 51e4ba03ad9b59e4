//! How much work the picture may be.

use bevy::prelude::*;
use bevy_egui::egui;

use super::rows;
use crate::game::settings::{Quality, Settings};
use crate::window::language::Language;
use crate::window::page::{AddPages, Page, PageId};

pub(super) fn plugin(app: &mut App) {
    app.add_page(
        Page {
            id: PageId("settings-picture"),
            title: "settings-picture",
            place: Some((PageId::SETTINGS, 20)),
        },
        show,
    );
}

fn show(InMut(ui): InMut<egui::Ui>, language: Res<Language>, mut settings: ResMut<Settings>) {
    let mut quality = settings.quality;
    let all = [
        (Quality::Automatic, "quality-automatic"),
        (Quality::Low, "quality-low"),
        (Quality::High, "quality-high"),
    ]
    .map(|(quality, key)| (quality, language.text(key).to_owned()));
    rows::choice(ui, language.text("settings-quality"), &mut quality, all);
    ui.label(language.text("settings-quality-hint"));
    if quality != settings.quality {
        settings.quality = quality;
    }
}
