//! The panel of a scenario: what to look for, what must happen and whether it did, how near a try came.

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

use super::page::{look_for, title};
use super::stage::{Ask, OnTable, Stage, Turn};
use crate::game::view::{Beside, SceneCameras, View};
use crate::scenarios::expect::Standing;
use crate::window::action::{Action, Bindings};
use crate::window::language::Language;
use crate::window::page::panel_id;

/// Width of the panel in points.
const WIDTH: f32 = 300.0;

const MET: egui::Color32 = egui::Color32::from_rgb(96, 214, 122);
const MISSED: egui::Color32 = egui::Color32::from_rgb(255, 122, 110);

/// Lays out the panel while a scenario in which something must happen lies on the table.
pub(super) fn show(
    mut contexts: EguiContexts,
    stage: Res<Stage>,
    language: Res<Language>,
    bindings: Res<Bindings>,
    cameras: Res<SceneCameras>,
    mut view: ResMut<View>,
    mut asks: MessageWriter<Ask>,
) -> Result {
    let Some(on) = stage.on_table().filter(|on| !on.scenario.expect.is_empty()) else {
        return Ok(());
    };
    let context = contexts.ctx_mut()?;
    let named = |key, action| {
        let name = language.text(key);
        match bindings.of(action).first() {
            Some(control) => format!("{name} ({})", control.name(&language)),
            None => name.to_owned(),
        }
    };
    let mut is_open = true;
    let heading = title(&language, &on.name, &on.scenario.title);
    egui::Window::new(heading)
        .id(panel_id(context, "scenario"))
        .open(&mut is_open)
        .default_pos(context.content_rect().left_top() + egui::vec2(8.0, 44.0))
        .auto_sized()
        .show(context, |ui| {
            ui.set_width(WIDTH);
            contents(ui, &language, on);
            ui.separator();
            ui.horizontal_wrapped(|ui| {
                for (key, action, ask) in [
                    ("trick-play", Action::PlayTrick, Ask::Play),
                    ("trick-try", Action::TryTrick, Ask::Try),
                    ("trick-previous", Action::PreviousTrick, Ask::Neighbour(-1)),
                    ("trick-next", Action::NextTrick, Ask::Neighbour(1)),
                ] {
                    if ui.button(named(key, action)).clicked() {
                        asks.write(ask);
                    }
                }
            });
            let mut seen = *view;
            ui.horizontal_wrapped(|ui| {
                let second = matches!(seen.beside, Beside::Camera(_));
                let text = named("view-second", Action::SecondCamera);
                if ui.selectable_label(second, text).clicked() {
                    seen.toggle_second(&cameras);
                }
                let laws = seen.beside == Beside::Laws;
                let text = named("view-laws", Action::OtherLaws);
                if ui.selectable_label(laws, text).clicked() {
                    seen.toggle_laws();
                }
                if let Some(next) = cameras.after(seen.camera) {
                    let text = named("view-scene-camera", Action::SceneCamera);
                    if ui.button(text).clicked() {
                        seen.camera = next;
                    }
                }
            });
            view.set_if_neq(seen);
        });
    if !is_open {
        asks.write(Ask::Forget);
    }
    Ok(())
}

fn contents(ui: &mut egui::Ui, language: &Language, on: &OnTable) {
    let scenario = &on.scenario;
    if !scenario.look_for.is_empty() {
        let look_for = look_for(language, &on.name, &scenario.look_for);
        ui.add(egui::Label::new(look_for).wrap());
    }
    if !scenario.description.is_empty() {
        egui::CollapsingHeader::new(language.text("trick-more"))
            .id_salt("trick-more")
            .show(ui, |ui| {
                ui.add(egui::Label::new(&scenario.description).wrap())
            });
    }
    ui.separator();
    for (i, expected) in scenario.expect.iter().enumerate() {
        let mark = on.marks.get(i);
        let standing = mark.map_or(Standing::Open, |(_, standing)| *standing);
        let (word, tint) = match standing {
            Standing::Open => ("trick-open", ui.visuals().weak_text_color()),
            Standing::Met => ("trick-met", MET),
            Standing::Missed => ("trick-missed", MISSED),
        };
        ui.horizontal_wrapped(|ui| {
            // A word beside the colour, for whoever cannot tell colours.
            ui.colored_label(tint, egui::RichText::new(language.text(word)).strong());
            ui.label(language.phrase(&expected.wanted()));
            if let Some((outcome, _)) = mark.filter(|_| standing != Standing::Open) {
                ui.weak(format!("({})", language.phrase(&outcome.seen)));
            }
        });
    }
    let key = match on.turn {
        Turn::Waiting => "trick-waiting",
        Turn::Shown => "trick-shown",
        Turn::Tried => "trick-tried",
        Turn::Free => "trick-free",
    };
    ui.weak(language.text(key));
    if let Some(score) = on.score {
        let score = [("score", score.into())];
        let text = egui::RichText::new(language.with("trick-score", &score));
        ui.label(text.strong().size(17.0));
    }
    if let Some(best) = on.best {
        let values = [("best", best.into()), ("tries", on.tries.into())];
        ui.label(language.with("trick-best", &values));
    }
}
