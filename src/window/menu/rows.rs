//! The rows that pages are made of.

use bevy_egui::egui;

use crate::window::language::Language;

/// A large button over the whole width.
pub(super) fn entry(ui: &mut egui::Ui, text: &str) -> egui::Response {
    let text = egui::RichText::new(text).size(17.0);
    ui.add(egui::Button::new(text).min_size(egui::vec2(0.0, 30.0)))
}

/// A heading of a part of a page.
pub(super) fn heading(ui: &mut egui::Ui, text: &str) {
    ui.add_space(6.0);
    ui.strong(text);
}

/// Something that is on or off. The key with `-hint` behind it explains it.
pub(super) fn switch(ui: &mut egui::Ui, language: &Language, key: &str, on: &mut bool) {
    let response = ui.checkbox(on, language.text(key));
    let hint = format!("{key}-hint");
    if let Some(hint) = language.find(&hint) {
        response.on_hover_text(hint);
    }
}

/// One of several: all are seen at once, so that the focus reaches each.
pub(super) fn choice<T: PartialEq>(
    ui: &mut egui::Ui,
    title: &str,
    value: &mut T,
    all: impl IntoIterator<Item = (T, String)>,
) {
    ui.horizontal_wrapped(|ui| {
        ui.label(title);
        for (one, name) in all {
            ui.selectable_value(value, one, name);
        }
    });
}

/// A share from 0 to 1.
pub(super) fn share(ui: &mut egui::Ui, title: &str, value: &mut f32) {
    ui.label(title);
    ui.spacing_mut().slider_width = 220.0;
    let slider = egui::Slider::new(value, 0.0..=1.0)
        .step_by(0.05)
        .custom_formatter(|share, _| format!("{:.0} %", 100.0 * share))
        .custom_parser(|text| Some(text.trim_end_matches(['%', ' ']).parse::<f64>().ok()? / 100.0));
    ui.add(slider);
    ui.end_row();
}
