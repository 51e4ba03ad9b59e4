//! The one panel of photo mode.

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

use crate::window::action::{Action, Bindings};
use crate::window::language::Language;
use crate::window::photo::Photo;
use crate::window::photo::shoot::Shoot;

/// Apertures that can be set.
const STOPS: [f32; 9] = [0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0, 5.6, 8.0];

pub(super) fn show(
    mut contexts: EguiContexts,
    language: Res<Language>,
    bindings: Res<Bindings>,
    mut photo: ResMut<Photo>,
    mut shoot: MessageWriter<Shoot>,
) -> Result {
    let context = contexts.ctx_mut()?;
    let photo = &mut *photo;
    let key = |action| {
        let first = bindings.of(action).first();
        first.map_or_else(String::new, |control| control.name(&language))
    };
    if !photo.panel {
        return Ok(());
    }
    egui::Window::new(language.text("photo-title"))
        .id(egui::Id::new("photo"))
        .anchor(egui::Align2::RIGHT_BOTTOM, [-12.0, -12.0])
        .collapsible(false)
        .resizable(false)
        .show(context, |ui| {
            let lens = &mut photo.lens;
            egui::Grid::new("lens").num_columns(2).show(ui, |ui| {
                let row = |ui: &mut egui::Ui, label: &str, slider: egui::Slider| {
                    let label = ui.label(language.text(label));
                    ui.add(slider).labelled_by(label.id);
                    ui.end_row();
                };
                let mut degrees = lens.fov.to_degrees();
                let fov = egui::Slider::new(&mut degrees, 5.0..=105.0).suffix("°");
                row(ui, "photo-fov", fov);
                lens.fov = degrees.to_radians();
                let mut degrees = lens.roll.to_degrees();
                let roll = egui::Slider::new(&mut degrees, -90.0..=90.0).suffix("°");
                row(ui, "photo-roll", roll);
                lens.roll = degrees.to_radians();
                let exposure = egui::Slider::new(&mut lens.exposure, -3.0..=3.0);
                row(ui, "photo-exposure", exposure);
                let focus = egui::Slider::new(&mut lens.focus, 0.05..=10.0)
                    .logarithmic(true)
                    .suffix(" m");
                let before = focus_of(ui, &language, focus);
                if before {
                    lens.auto_focus = false;
                }
            });
            ui.checkbox(&mut lens.auto_focus, language.text("photo-auto-focus"));
            ui.horizontal_wrapped(|ui| {
                ui.label(language.text("photo-aperture"));
                ui.selectable_value(&mut lens.stop, None, language.text("photo-aperture-none"));
                for stop in STOPS {
                    ui.selectable_value(&mut lens.stop, Some(stop), format!("f/{stop}"));
                }
            });
            ui.horizontal(|ui| {
                ui.label(language.text("photo-size"));
                for multiple in 1..=4 {
                    ui.selectable_value(&mut lens.multiple, multiple, format!("{multiple}×"));
                }
            });
            ui.horizontal(|ui| {
                let take = format!("{} ({})", language.text("photo-take"), key(Action::Strike));
                if ui.button(take).clicked() {
                    shoot.write(Shoot);
                }
                let leave = format!("{} ({})", language.text("photo-leave"), key(Action::Photo));
                if ui.button(leave).clicked() {
                    photo.on = false;
                }
            });
            let values = [("panel", key(Action::Panel).into())];
            ui.weak(language.with("photo-hint", &values));
            if let Some((news, is_failure)) = &photo.news {
                let text = egui::RichText::new(news);
                ui.label(if *is_failure {
                    text.color(egui::Color32::LIGHT_RED)
                } else {
                    text.strong()
                });
            }
        });
    Ok(())
}

/// The slider of the focus; whether it was moved.
fn focus_of(ui: &mut egui::Ui, language: &Language, slider: egui::Slider) -> bool {
    let label = ui.label(language.text("photo-focus"));
    let moved = ui.add(slider).labelled_by(label.id).changed();
    ui.end_row();
    moved
}
