//! The picture: how much work it may be, how the table looks, whether time slows down for show.

use bevy::prelude::*;
use bevy_egui::egui;

use super::{equipment, rows};
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
    let mut wish = (settings.quality, settings.slow_motion);
    let all = [
        (Quality::Automatic, "quality-automatic"),
        (Quality::Low, "quality-low"),
        (Quality::Medium, "quality-medium"),
        (Quality::High, "quality-high"),
        (Quality::Ultra, "quality-ultra"),
    ]
    .map(|(quality, key)| (quality, language.text(key).to_owned()));
    rows::choice(ui, language.text("settings-quality"), &mut wish.0, all);
    ui.label(language.text("settings-quality-hint"));
    equipment::look(ui, &language, settings.reborrow());
    let still = settings.reduced_motion;
    let slow = egui::Checkbox::new(&mut wish.1, language.text("settings-slow-motion"));
    ui.add_enabled(!still, slow);
    if still {
        ui.weak(language.text("settings-slow-motion-still"));
    }
    if wish != (settings.quality, settings.slow_motion) {
        (settings.quality, settings.slow_motion) = wish;
    }
}
