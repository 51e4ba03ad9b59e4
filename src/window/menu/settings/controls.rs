//! Every action with its controls: click one and press another.

use bevy::prelude::*;
use bevy_egui::egui;
use leafwing_input_manager::InputControlKind;
use leafwing_input_manager::prelude::Actionlike;

use super::ask::Asking;
use crate::game::settings::Settings;
use crate::window::action::{Action, Bindings, CONTROLS, Control, Topic};
use crate::window::language::Language;
use crate::window::page::{AddPages, Page, PageId};

pub(super) fn plugin(app: &mut App) {
    app.add_page(
        Page {
            id: PageId("settings-controls"),
            title: "settings-controls",
            place: Some((PageId::SETTINGS, 40)),
        },
        show,
    );
}

fn show(
    InMut(ui): InMut<egui::Ui>,
    language: Res<Language>,
    bindings: Res<Bindings>,
    mut settings: ResMut<Settings>,
    mut asking: ResMut<Asking>,
) {
    if let Some(question) = asking.0 {
        let what = language.text(&question.action.key()).to_owned();
        ui.strong(language.with("controls-press", &[("what", what.into())]));
        ui.label(language.text("controls-cancel"));
        return;
    }
    ui.label(language.text("controls-hint"));
    let clashes = clashes(&bindings);
    if clashes > 0 {
        ui.colored_label(
            ui.visuals().warn_fg_color,
            language.with("controls-clashes", &[("count", clashes.into())]),
        );
    }
    let reset = egui::Button::new(language.text("controls-reset"));
    if ui
        .add_enabled(!settings.bindings.is_empty(), reset)
        .clicked()
    {
        settings.bindings.clear();
    }
    for topic in Topic::ALL {
        ui.add_space(6.0);
        ui.strong(language.text(topic.key()));
        for line in CONTROLS.iter().filter(|line| line.topic == topic) {
            row(
                ui,
                line.action,
                &language,
                &bindings,
                &mut settings,
                &mut asking,
            );
        }
    }
}

/// Controls that do more than one thing.
fn clashes(bindings: &Bindings) -> usize {
    bindings
        .iter()
        .flat_map(|(action, controls)| controls.iter().map(move |control| (action, *control)))
        .filter(|(action, control)| bindings.clash(*action, *control).is_some())
        .count()
}

/// An action: what it does, its controls, another control, as at first.
fn row(
    ui: &mut egui::Ui,
    action: Action,
    language: &Language,
    bindings: &Bindings,
    settings: &mut ResMut<Settings>,
    asking: &mut ResMut<Asking>,
) {
    let controls = bindings.of(action);
    ui.label(language.text(&action.key()));
    ui.horizontal_wrapped(|ui| {
        ui.add_space(16.0);
        for (slot, control) in controls.iter().enumerate() {
            if is_fixed(*control) {
                ui.monospace(control.name(language));
                continue;
            }
            if control_button(ui, action, *control, language, bindings).clicked() {
                asking.ask(action, Some(slot));
            }
            let remove = ui
                .small_button("×")
                .on_hover_text(language.text("controls-remove"));
            if remove.clicked() {
                let mut left = controls.to_vec();
                left.remove(slot);
                Bindings::rebind(&mut settings.bindings, action, &left);
            }
        }
        if action.input_control_kind() != InputControlKind::Button {
            return;
        }
        let add = ui
            .small_button("+")
            .on_hover_text(language.text("controls-add"));
        if add.clicked() {
            asking.ask(action, None);
        }
        let is_changed = settings.bindings.contains_key(&format!("{action:?}"));
        if is_changed
            && ui
                .small_button(language.text("controls-reset-one"))
                .clicked()
        {
            settings.bindings.remove(&format!("{action:?}"));
        }
    });
}

/// The wheel and the movement of the mouse can be nothing else.
fn is_fixed(control: Control) -> bool {
    control.kind() != InputControlKind::Button
}

/// The name of a control; one that does something else too says so.
fn control_button(
    ui: &mut egui::Ui,
    action: Action,
    control: Control,
    language: &Language,
    bindings: &Bindings,
) -> egui::Response {
    let text = egui::RichText::new(control.name(language)).monospace();
    let Some(other) = bindings.clash(action, control) else {
        return ui.button(text);
    };
    let what = language.text(&other.key()).to_owned();
    ui.button(text.color(ui.visuals().warn_fg_color))
        .on_hover_text(language.with("controls-clash", &[("what", what.into())]))
}
