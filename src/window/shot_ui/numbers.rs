//! The numbers of the shot: sliders, step buttons and typed values.

use bevy::prelude::DetectChangesMut;
use bevy_egui::egui;

use super::{Desk, cue_ball, equipment};
use crate::game::aim::{Aim, Swing};
use crate::physics::ball::State;
use crate::physics::scene::strike_with;
use crate::sim::components::ball_and_state;
use crate::window::language::Language;

/// One number of the shot as the panel shows it.
struct Number<'a> {
    label: &'a str,
    unit: &'static str,
    least: f64,
    most: f64,
    /// What a step button changes at the coarsest setting.
    step: f64,
}

/// Differences below this are rounding of the text shown, not the player's wish.
const SHOWN: f64 = 0.5e-6;

/// Lays out the cue ball, the numbers and the strike button.
pub(super) fn show(ui: &mut egui::Ui, desk: &mut Desk) {
    let mut aim = *desk.aim;
    let language = desk.language.clone();
    let cue = desk.playfield.cue;
    let ball = desk.balls.iter().find(|ball| ball.0.0 == aim.ball);
    let radius = ball.map_or(0.028, |ball| ball.6.0);
    ui.horizontal(|ui| {
        if let Some((side, height)) = cue_ball::show(ui, &aim.shot, &cue, radius) {
            aim.set_tip(side, height);
        }
        ui.vertical(|ui| {
            effect(ui, desk, &aim);
            if ui.button(language.text("number-center")).clicked() {
                aim.set_tip(0.0, 0.0);
            }
        });
    });
    ui.horizontal(|ui| {
        ui.label(language.text("number-step"));
        for (step, name) in [(1.0, "1"), (0.1, "0.1"), (0.01, "0.01"), (0.001, "0.001")] {
            ui.selectable_value(&mut desk.panel.step, step, name);
        }
    });
    rows(ui, &language, desk.panel.step, &mut aim);
    equipment::room(ui, desk);
    // Only a real change counts as one: the preview is played anew whenever the aim changes.
    desk.aim.set_if_neq(aim);
    ui.horizontal(|ui| {
        let ready = !desk.clock.moving && aim.shot.speed > 0.0;
        let strike = egui::Button::new(
            egui::RichText::new(language.text("number-strike"))
                .strong()
                .size(18.0),
        )
        .min_size(egui::vec2(120.0, 32.0));
        if ui.add_enabled(ready, strike).clicked() {
            desk.swings.write(Swing);
        }
    });
}

fn rows(ui: &mut egui::Ui, language: &Language, step: f64, aim: &mut Aim) {
    egui::Grid::new("numbers").num_columns(3).show(ui, |ui| {
        let heading = Number {
            label: language.text("number-heading"),
            unit: "°",
            least: 0.0,
            most: 360.0,
            step: 1.0,
        };
        if let Some(degrees) = row(ui, &heading, step, aim.heading_deg()) {
            aim.set_heading(degrees.to_radians());
        }
        let elevation = Number {
            label: language.text("number-elevation"),
            unit: "°",
            least: 0.0,
            most: Aim::TOP_ELEVATION.to_degrees(),
            step: 1.0,
        };
        if let Some(degrees) = row(ui, &elevation, step, aim.shot.elevation.to_degrees()) {
            aim.set_elevation(degrees.to_radians());
        }
        let offset = |label| Number {
            label,
            unit: " R",
            least: -Aim::TOP_OFFSET,
            most: Aim::TOP_OFFSET,
            step: 0.1,
        };
        if let Some(side) = row(
            ui,
            &offset(language.text("number-side")),
            step,
            aim.shot.side,
        ) {
            aim.set_tip(side, aim.shot.height);
        }
        if let Some(height) = row(
            ui,
            &offset(language.text("number-height")),
            step,
            aim.shot.height,
        ) {
            aim.set_tip(aim.shot.side, height);
        }
        let speed = Number {
            label: language.text("number-power"),
            unit: " m/s",
            least: 0.0,
            most: Aim::TOP_SPEED,
            step: 1.0,
        };
        if let Some(speed) = row(ui, &speed, step, aim.shot.speed) {
            aim.set_speed(speed);
        }
    });
}

/// A label, a slider, and the value between two step buttons. The new value if the player changed it.
fn row(ui: &mut egui::Ui, number: &Number, step: f64, value: f64) -> Option<f64> {
    let mut wish = None;
    let range = number.least..=number.most;
    ui.label(number.label);
    ui.spacing_mut().slider_width = 90.0;
    let mut slid = value;
    let slider = egui::Slider::new(&mut slid, range.clone())
        .show_value(false)
        .clamping(egui::SliderClamping::Edits);
    if ui.add(slider).changed() {
        wish = Some(slid);
    }
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0;
        if ui.small_button("−").clicked() {
            wish = Some(value - step * number.step);
        }
        let mut typed = value;
        let drag = egui::DragValue::new(&mut typed)
            .speed(0.1 * step * number.step)
            .range(range)
            .clamp_existing_to_range(false)
            .min_decimals(3)
            .max_decimals(6)
            .update_while_editing(false)
            .suffix(number.unit);
        let response = ui.add_sized([86.0, 18.0], drag);
        if response.changed() && (typed - value).abs() > SHOWN {
            wish = Some(typed);
        }
        if ui.small_button("+").clicked() {
            wish = Some(value + step * number.step);
        }
    });
    ui.end_row();
    wish
}

/// What the strike would do, as the solvers will play it.
fn effect(ui: &mut egui::Ui, desk: &Desk, aim: &Aim) {
    let Some(ball) = desk.balls.iter().find(|ball| ball.0.0 == aim.ball) else {
        return;
    };
    let (_, _, position, velocity, spin, mass, radius, motion) = ball;
    let (ball, _) = ball_and_state(position, velocity, spin, mass, radius, motion);
    // A ball that still moves will be struck at rest.
    let state = State::at_rest(position.0);
    let struck = strike_with(
        &desk.playfield.cue,
        &desk.playfield.laws,
        &ball,
        &state,
        &aim.shot,
    );
    let language = &desk.language;
    let speed = [(
        "speed",
        format!("{:.3}", struck.state.velocity.length()).into(),
    )];
    ui.label(language.with("number-ball", &speed));
    let squirt = struck.squirt.to_degrees();
    let key = match squirt {
        s if s > 0.0 => "number-squirt-left",
        s if s < 0.0 => "number-squirt-right",
        _ => "number-squirt",
    };
    let angle = [("angle", format!("{:.3}°", squirt.abs()).into())];
    ui.label(language.with(key, &angle));
    let offset = [("offset", format!("{:.3} R", aim.shot.offset()).into())];
    ui.label(language.with("number-offset", &offset))
        .on_hover_text(language.text("number-offset-hint"));
    if struck.miscue {
        ui.colored_label(
            ui.visuals().error_fg_color,
            language.with(
                "number-miscue",
                &[(
                    "offset",
                    format!("{} R", desk.playfield.cue.miscue_offset).into(),
                )],
            ),
        );
    } else {
        ui.label("");
    }
}
