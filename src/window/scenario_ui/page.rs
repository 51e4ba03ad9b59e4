//! The page that lists the trick shots.

use bevy::prelude::*;
use bevy_egui::egui;

use super::seats::seats;
use super::stage::Ask;
use super::still;
use super::tricks::{Stills, tricks};
use crate::game::view::{Beside, View};
use crate::window::language::Language;
use crate::window::page::Open;

/// Size of a still picture in points.
const PICTURE: egui::Vec2 = egui::vec2(168.0, 92.0);

/// The title of a scene in the language that is spoken, else its own.
pub(super) fn title<'a>(language: &'a Language, name: &str, own: &'a str) -> &'a str {
    language.find(&format!("scene-{name}")).unwrap_or(own)
}

/// What to look for in a scene in the language that is spoken, else in its own.
pub(super) fn look_for<'a>(language: &'a Language, name: &str, own: &'a str) -> &'a str {
    language.find(&format!("look-{name}")).unwrap_or(own)
}

/// Lays out the list: a picture, a title, what to look for. A choice lays the scene out.
pub(super) fn show(
    InMut(ui): InMut<egui::Ui>,
    language: Res<Language>,
    mut stills: ResMut<Stills>,
    mut open: ResMut<Open>,
    mut view: ResMut<View>,
    mut asks: MessageWriter<Ask>,
) {
    ui.label(language.text("tricks-about"));
    ui.add_space(6.0);
    let mut is_waiting = false;
    for (place, trick) in tricks().iter().enumerate() {
        let scenario = &trick.scenario;
        let still = stills.get(place);
        is_waiting |= still.is_none();
        ui.horizontal_top(|ui| {
            let picture = still::show(ui, still, PICTURE);
            ui.vertical(|ui| {
                let title = title(&language, trick.name, &scenario.title);
                let text = egui::RichText::new(title).strong().size(15.0);
                let button = ui.add(egui::Button::new(text).wrap());
                let about = if scenario.look_for.is_empty() {
                    &scenario.description
                } else {
                    look_for(&language, trick.name, &scenario.look_for)
                };
                ui.add(egui::Label::new(about).wrap());
                let mut shared = None;
                ui.horizontal_wrapped(|ui| {
                    if ui.small_button(language.text("view-second")).clicked() {
                        let cameras = seats(scenario);
                        let first = View {
                            camera: cameras.mode(0).unwrap_or(view.camera),
                            ..*view
                        };
                        shared = Some(Beside::Camera(first.second(&cameras)));
                    }
                    if ui.small_button(language.text("view-laws")).clicked() {
                        shared = Some(Beside::Laws);
                    }
                });
                if let Some(shared) = shared {
                    view.beside = shared;
                }
                if button.clicked() || picture.clicked() || shared.is_some() {
                    asks.write(Ask::LayOut(place));
                    open.close();
                }
            });
        });
        ui.add_space(6.0);
    }
    if is_waiting {
        ui.ctx().request_repaint();
    }
}
