//! How loud what is.

use bevy::prelude::*;
use bevy_egui::egui;

use super::rows;
use crate::game::settings::Settings;
use crate::game::volume::SoundKind;
use crate::window::language::Language;
use crate::window::page::{AddPages, Page, PageId};

pub(super) fn plugin(app: &mut App) {
    app.add_page(
        Page {
            id: PageId("settings-sound"),
            title: "settings-sound",
            place: Some((PageId::SETTINGS, 30)),
        },
        show,
    );
}

fn show(InMut(ui): InMut<egui::Ui>, language: Res<Language>, mut settings: ResMut<Settings>) {
    let mut volume = settings.volume;
    rows::switch(ui, &language, "sound-mute", &mut volume.muted);
    egui::Grid::new("volumes").num_columns(2).show(ui, |ui| {
        rows::share(ui, language.text("sound-all"), &mut volume.level);
        for kind in SoundKind::ALL {
            rows::share(ui, language.text(kind_key(kind)), volume.of(kind));
        }
    });
    if volume != settings.volume {
        settings.volume = volume;
    }
}

fn kind_key(kind: SoundKind) -> &'static str {
    match kind {
        SoundKind::Balls => "sound-balls",
        SoundKind::Cushions => "sound-cushions",
        SoundKind::Pockets => "sound-pockets",
        SoundKind::Cue => "sound-cue",
        SoundKind::Rolling => "sound-rolling",
        SoundKind::Interface => "sound-interface",
    }
}
