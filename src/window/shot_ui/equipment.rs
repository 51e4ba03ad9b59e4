//! What is played with: presets, cloth, balls, tip.

use bevy_egui::egui;

use super::Desk;
use crate::game::equip::{ChoosePreset, Equip};
use crate::physics::cue::Tip;
use crate::physics::cue_path::Obstacle;
use crate::physics::equipment::{BallSet, Equipment};
use crate::physics::laws::motion::{Cloth, MotionLaw};
use crate::scenarios::preset;
use crate::sim::playfield::snapshot;

/// Lays out the choices.
pub(super) fn show(ui: &mut egui::Ui, desk: &mut Desk) {
    presets(ui, desk);
    let still = !desk.clock.moving;
    ui.add_enabled_ui(still, |ui| {
        egui::Grid::new("equipment").num_columns(2).show(ui, |ui| {
            cloths(ui, desk);
            balls(ui, desk);
            tips(ui, desk);
        });
    });
}

fn presets(ui: &mut egui::Ui, desk: &mut Desk) {
    let language = desk.language.clone();
    let named = |name: &str| {
        let key = format!("preset-{}", name.replace('_', "-"));
        language.find(&key).unwrap_or(name).to_owned()
    };
    let in_use = desk.preset.0.clone();
    let shown = in_use
        .as_deref()
        .map_or_else(|| language.text("preset-none").to_owned(), named);
    let mut choice = None;
    ui.horizontal(|ui| {
        ui.label(language.text("equipment-preset"));
        egui::ComboBox::from_id_salt("preset")
            .selected_text(&shown)
            .width(180.0)
            .show_ui(ui, |ui| {
                for asset in preset::BUILT_IN {
                    let chosen = in_use.as_deref() == Some(asset.name);
                    if ui.selectable_label(chosen, named(asset.name)).clicked() {
                        choice = Some(asset.name.to_owned());
                        ui.close();
                    }
                }
            });
    });
    ui.horizontal(|ui| {
        let field = egui::TextEdit::singleline(&mut desk.panel.preset_file)
            .hint_text(language.text("equipment-own"))
            .desired_width(190.0);
        let entered = ui.add(field).lost_focus() && ui.input(|i| i.key_pressed(egui::Key::Enter));
        let typed = desk.panel.preset_file.trim();
        let load = ui
            .add_enabled(!typed.is_empty(), egui::Button::new(language.text("load")))
            .on_hover_text(language.text("equipment-load-hint"));
        if (load.clicked() || entered) && !typed.is_empty() {
            choice = Some(typed.to_owned());
        }
    });
    if let Some(name) = choice {
        desk.choose.write(ChoosePreset(name));
    }
}

fn cloths(ui: &mut egui::Ui, desk: &mut Desk) {
    let MotionLaw::Coulomb(present) = desk.playfield.laws.motion else {
        return;
    };
    let named = |cloth: Cloth| Cloth {
        gravity: present.gravity,
        ..cloth
    };
    let language = desk.language.clone();
    ui.label(language.text("equipment-cloth"));
    ui.horizontal(|ui| {
        for asset in preset::CLOTHS {
            let Ok(cloth) = preset::cloth(asset.name).map(named) else {
                continue;
            };
            let key = format!("cloth-{}", asset.name);
            let name = language.find(&key).unwrap_or(asset.name);
            if ui.selectable_label(cloth == present, name).clicked() && cloth != present {
                desk.playfield.laws.motion = MotionLaw::Coulomb(cloth);
            }
        }
    });
    ui.end_row();
}

fn balls(ui: &mut egui::Ui, desk: &mut Desk) {
    let scene = snapshot(&desk.playfield, &desk.balls);
    let Some(present) = BallSet::in_scene(&scene) else {
        return;
    };
    let language = desk.language.clone();
    ui.label(language.text("equipment-balls"));
    let mut wish = None;
    egui::ComboBox::from_id_salt("balls")
        .selected_text(format!(
            "{:.1} mm, {:.0} g",
            2e3 * present.cue.radius,
            1e3 * present.cue.mass
        ))
        .show_ui(ui, |ui| {
            for asset in preset::BUILT_IN {
                let Ok(preset) = asset.preset() else { continue };
                let balls = preset.equipment.balls;
                let key = format!("preset-{}", asset.name.replace('_', "-"));
                let text = format!(
                    "{}: {:.1} mm, {:.0} g",
                    language.find(&key).unwrap_or(asset.name),
                    2e3 * balls.cue.radius,
                    1e3 * balls.cue.mass
                );
                if ui.selectable_label(balls == present, text).clicked() {
                    wish = Some(balls);
                    ui.close();
                }
            }
        });
    ui.end_row();
    if let Some(balls) = wish {
        desk.equip.write(Equip {
            equipment: Equipment {
                table: scene.table,
                laws: scene.laws,
                cue: scene.cue,
                balls,
            },
            rack: false,
        });
    }
}

fn tips(ui: &mut egui::Ui, desk: &mut Desk) {
    let language = desk.language.clone();
    ui.label(language.text("equipment-tip"));
    ui.horizontal(|ui| {
        let present = desk.playfield.cue;
        for (tip, name) in [
            (Tip::Leather, "tip-leather"),
            (Tip::Phenolic, "tip-phenolic"),
        ] {
            let cue = present.with_tip(tip);
            let (least, most) = tip.measured_restitution();
            let chosen = (least..=most).contains(&present.tip_restitution);
            if ui.selectable_label(chosen, language.text(name)).clicked() && !chosen {
                desk.playfield.cue = cue;
            }
        }
    });
    ui.end_row();
}

/// A line about the room of the cue: what it has to clear, or that it cannot.
pub(super) fn room(ui: &mut egui::Ui, desk: &Desk) {
    let language = &desk.language;
    let text = match desk.room.lift {
        None => language.text("room-none").to_owned(),
        Some(lift) => {
            let angle = format!("{:.2}°", lift.elevation.to_degrees());
            let (key, ball) = match lift.over {
                None => ("room-least", ""),
                Some(Obstacle::Ball(ball)) => (
                    "room-over-ball",
                    desk.balls
                        .iter()
                        .find(|other| other.0.0 == ball)
                        .map_or("?", |other| other.1.0.as_str()),
                ),
                Some(Obstacle::Cushion(_)) => ("room-over-cushion", ""),
                Some(Obstacle::Rail) => ("room-over-rail", ""),
                Some(Obstacle::Slate) => ("room-over-slate", ""),
            };
            language.with(key, &[("angle", angle.into()), ("ball", ball.into())])
        }
    };
    let label = egui::RichText::new(text);
    let raised = desk.aim.shot.elevation > desk.aim.wish;
    ui.label(if raised || desk.room.lift.is_none() {
        label.color(ui.visuals().warn_fg_color)
    } else {
        label.weak()
    });
}
