//! The letters of the panels: those of egui, with its monospaced font for signs that the others lack, as arrows.

use bevy_egui::egui;

/// The fonts of the panels.
#[must_use]
pub fn fonts() -> egui::FontDefinitions {
    let mut fonts = egui::FontDefinitions::default();
    let signs = fonts.families.get(&egui::FontFamily::Monospace).cloned();
    let letters = fonts
        .families
        .entry(egui::FontFamily::Proportional)
        .or_default();
    for font in signs.unwrap_or_default() {
        if !letters.contains(&font) {
            letters.push(font);
        }
    }
    fonts
}
