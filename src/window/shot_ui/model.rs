//! Which laws hold and who solves them.

use bevy_egui::egui;

use super::Desk;
use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::BallBallLaw;
use crate::physics::laws::cushion::CushionLaw;
use crate::physics::laws::motion::MotionLaw;
use crate::physics::scene::{Solver, Stepped};
use crate::window::language::Language;

/// Grids on offer, cells along x and z; `None` tests every pair.
const GRIDS: [Option<(u32, u32)>; 3] = [None, Some((20, 20)), Some((50, 50))];

/// Lays out the choices. They can be changed while nothing moves.
pub(super) fn show(ui: &mut egui::Ui, desk: &mut Desk) {
    let mut laws = desk.playfield.laws;
    let mut solver = desk.playfield.solver;
    let language = desk.language.clone();
    ui.add_enabled_ui(!desk.clock.moving, |ui| {
        laws_of(ui, &language, &mut laws);
        ui.separator();
        solver_of(ui, &language, &mut solver, &laws);
    });
    // The coursework model has no closed form, so only the stepped solver can play it.
    if !laws.motion.is_closed_form() && solver == Solver::Exact {
        solver = Solver::Stepped(Stepped::default());
    }
    if laws != desk.playfield.laws || solver != desk.playfield.solver {
        desk.playfield.laws = laws;
        desk.playfield.solver = solver;
    }
}

fn laws_of(ui: &mut egui::Ui, language: &Language, laws: &mut Laws) {
    ui.horizontal(|ui| {
        for (preset, name) in [
            (Laws::default(), "laws-pool"),
            (Laws::ideal(), "laws-ideal"),
            (Laws::coursework(), "laws-coursework"),
        ] {
            if ui
                .selectable_label(*laws == preset, language.text(name))
                .clicked()
            {
                *laws = preset;
            }
        }
    });
    egui::Grid::new("laws").num_columns(2).show(ui, |ui| {
        choice(
            ui,
            language.text("laws-friction"),
            &mut laws.motion,
            // A slope is for crowds: on one nothing comes to rest, and no shot ends.
            MotionLaw::all()
                .into_iter()
                .filter(|law| law.pull() == glam::DVec3::ZERO)
                .collect(),
        );
        choice(
            ui,
            language.text("laws-balls"),
            &mut laws.ball_ball,
            BallBallLaw::all(),
        );
        choice(
            ui,
            language.text("laws-cushions"),
            &mut laws.cushion,
            CushionLaw::all(),
        );
    });
}

/// A box with one entry for each registered law of a class. Another law comes with its default parameters.
fn choice<L: Copy + std::fmt::Debug>(ui: &mut egui::Ui, label: &str, law: &mut L, all: Vec<L>) {
    ui.label(label);
    let present = name(law);
    egui::ComboBox::from_id_salt(label)
        .selected_text(&present)
        .show_ui(ui, |ui| {
            for other in all {
                let other_name = name(&other);
                let is_present = other_name == present;
                if ui.selectable_label(is_present, other_name).clicked() {
                    if !is_present {
                        *law = other;
                    }
                    ui.close();
                }
            }
        });
    ui.end_row();
}

/// The name of a law without its parameters.
fn name(law: &impl std::fmt::Debug) -> String {
    let all = format!("{law:?}");
    all.split('(').next().unwrap_or_default().to_owned()
}

fn solver_of(ui: &mut egui::Ui, language: &Language, solver: &mut Solver, laws: &Laws) {
    ui.horizontal(|ui| {
        ui.label(language.text("solver"));
        let is_exact = *solver == Solver::Exact;
        if ui
            .selectable_label(!is_exact, language.text("solver-stepped"))
            .clicked()
            && is_exact
        {
            *solver = Solver::Stepped(Stepped::default());
        }
        let exact = ui.add_enabled(
            laws.motion.is_closed_form(),
            egui::Button::selectable(is_exact, language.text("solver-exact")),
        );
        if exact.clicked() {
            *solver = Solver::Exact;
        }
    });
    let Solver::Stepped(stepped) = solver else {
        return;
    };
    ui.horizontal(|ui| {
        ui.label(language.text("solver-ticks"));
        let mut rate = 1.0 / stepped.tick;
        let drag = egui::DragValue::new(&mut rate)
            .range(10.0..=2000.0)
            .speed(1.0)
            .max_decimals(3)
            .suffix(" /s");
        if ui.add(drag).changed() && rate > 0.0 {
            stepped.tick = 1.0 / rate;
        }
    });
    ui.horizontal_wrapped(|ui| {
        ui.label(language.text("solver-grid"));
        for grid in GRIDS {
            let name = grid.map_or(language.text("solver-no-grid").to_owned(), |(x, z)| {
                format!("{x} × {z}")
            });
            ui.selectable_value(&mut stepped.grid, grid, name);
        }
        if let Some((x, z)) = &mut stepped.grid {
            for cells in [x, z] {
                ui.add(egui::DragValue::new(cells).range(1..=500));
            }
        }
    });
    ui.checkbox(&mut stepped.locate, language.text("solver-locate"));
}
