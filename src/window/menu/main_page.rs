//! The page that the menu opens with.

use bevy::prelude::*;
use bevy_egui::egui;

use super::rows;
use crate::window::language::Language;
use crate::window::page::{AddPages, Open, Page, PageId, Pages};

pub(super) fn plugin(app: &mut App) {
    app.add_page(
        Page {
            id: PageId::MAIN,
            title: "menu-title",
            place: None,
        },
        show,
    );
}

fn show(
    InMut(ui): InMut<egui::Ui>,
    language: Res<Language>,
    pages: Res<Pages>,
    mut open: ResMut<Open>,
    mut commands: Commands,
) {
    ui.vertical_centered_justified(|ui| {
        if rows::entry(ui, language.text("menu-resume")).clicked() {
            open.close();
        }
        for page in pages.below(PageId::MAIN) {
            if rows::entry(ui, language.text(page.title)).clicked() {
                open.go(page.id);
            }
        }
        if rows::entry(ui, language.text("menu-quit")).clicked() {
            commands.write_message(AppExit::Success);
        }
    });
}
