//! Language, sizes, motion, marks on balls, toggles.

use bevy::prelude::*;
use bevy_egui::egui;

use super::rows;
use crate::game::settings::Settings;
use crate::window::language::{LANGUAGES, Language};
use crate::window::page::{AddPages, Page, PageId};

/// Sizes of letters and panels on offer.
const SCALES: [f32; 8] = [0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0];

pub(super) fn plugin(app: &mut App) {
    app.add_page(
        Page {
            id: PageId("settings-general"),
            title: "settings-general",
            place: Some((PageId::SETTINGS, 10)),
        },
        show,
    );
}

fn show(InMut(ui): InMut<egui::Ui>, language: Res<Language>, mut settings: ResMut<Settings>) {
    let mut wish = settings.clone();
    // Named in themselves: whoever cannot read the present language finds their own.
    let languages = LANGUAGES
        .iter()
        .map(|one| (Some(one.code.to_owned()), one.name.to_owned()));
    let system = (None, language.text("language-system").to_owned());
    rows::choice(
        ui,
        language.text("settings-language"),
        &mut wish.language,
        std::iter::once(system).chain(languages),
    );
    let scales = SCALES.map(|scale| (scale, format!("{:.0} %", 100.0 * scale)));
    rows::choice(ui, language.text("settings-scale"), &mut wish.scale, scales);
    if ui.ctx().zoom_factor() < settings.scale {
        ui.label(language.text("settings-scale-less"));
    }
    rows::heading(ui, language.text("settings-motion"));
    rows::switch(
        ui,
        &language,
        "settings-reduced-motion",
        &mut wish.reduced_motion,
    );
    rows::switch(ui, &language, "settings-pause", &mut wish.pause_in_menu);
    rows::heading(ui, language.text("settings-marks"));
    rows::switch(ui, &language, "settings-labels", &mut wish.marks.labels);
    rows::switch(ui, &language, "settings-patterns", &mut wish.marks.patterns);
    rows::heading(ui, language.text("settings-toggles"));
    ui.label(language.text("settings-toggles-hint"));
    for (key, on) in [
        ("settings-toggle-fine", &mut wish.toggles.fine),
        ("settings-toggle-very-fine", &mut wish.toggles.very_fine),
        ("settings-toggle-stroke", &mut wish.toggles.stroke),
        (
            "settings-toggle-fast-forward",
            &mut wish.toggles.fast_forward,
        ),
    ] {
        rows::switch(ui, &language, key, on);
    }
    settings.set_if_neq(wish);
}
