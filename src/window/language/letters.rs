//! The letters of the panels: those of egui, with its monospaced font for signs that the others lack, as arrows.

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

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

/// Gives the panels their fonts, once for each context.
pub(super) fn lend(mut contexts: EguiContexts, mut done: Local<bool>) -> Result {
    if !*done {
        contexts.ctx_mut()?.set_fonts(fonts());
        *done = true;
    }
    Ok(())
}
