//! The panel of a crowd, in the place of the shot panel.

use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};
use leafwing_input_manager::prelude::ActionState;

use crate::game::practice;
use crate::game::view::{CameraMode, View};
use crate::game::watch::{Colouring, Watch};
use crate::physics::ball::Ball;
use crate::sim::clock::Clock;
use crate::sim::components::{AngularVelocity, Mass, Radius};
use crate::sim::messages::LoadScene;
use crate::sim::playfield::Playfield;
use crate::sim::recorder::Recorder;
use crate::sim::stepped::crowd::{Census, Crowd};
use crate::window::action::Action;
use crate::window::crowd::dials;
use crate::window::crowd::numbers::{self, Numbers};
use crate::window::crowd::pace::{self, Cost};
use crate::window::crowd::pack::Packed;
use crate::window::crowd::scenes::{self, Loading};
use crate::window::language::Language;
use crate::window::page::SidePanel;

/// Width of the panel in points.
const WIDTH: f32 = 262.0;

/// Whether the panel is open.
#[derive(Resource, Debug)]
pub(super) struct Panel {
    open: bool,
}

impl Default for Panel {
    fn default() -> Self {
        Self { open: true }
    }
}

/// Everything the panel shows and changes.
#[derive(SystemParam)]
pub(super) struct Desk<'w, 's> {
    panel: ResMut<'w, Panel>,
    watch: ResMut<'w, Watch>,
    view: ResMut<'w, View>,
    playfield: ResMut<'w, Playfield>,
    clock: ResMut<'w, Clock>,
    time: ResMut<'w, Time<Virtual>>,
    loading: ResMut<'w, Loading>,
    load: MessageWriter<'w, LoadScene>,
    recorder: Res<'w, Recorder>,
    crowd: Res<'w, Crowd>,
    census: Res<'w, Census>,
    numbers: Res<'w, Numbers>,
    packed: Res<'w, Packed>,
    language: Res<'w, Language>,
    cost: Res<'w, Cost>,
    balls: Query<'w, 's, (&'static Mass, &'static Radius, Has<AngularVelocity>)>,
    commands: Commands<'w, 's>,
}

/// Opens and closes the panel.
pub(super) fn toggle(actions: Single<&ActionState<Action>>, mut panel: ResMut<Panel>) {
    if actions.just_pressed(&Action::Panel) {
        panel.open = !panel.open;
    }
}

/// Lays out the panel, or the button that brings it back.
pub(super) fn show(mut contexts: EguiContexts, mut desk: Desk) -> Result {
    if !desk.playfield.solver.is_crowd() {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let panel = SidePanel {
        name: "crowd",
        title: desk.language.text("crowd-title").to_owned(),
        width: WIDTH,
        below: 60.0,
    };
    let open = panel.show(context, desk.panel.open, |ui| contents(ui, &mut desk));
    if open != desk.panel.open {
        desk.panel.open = open;
    }
    Ok(())
}

fn contents(ui: &mut egui::Ui, desk: &mut Desk) {
    let language = desk.language.clone();
    buttons(ui, desk);
    look(ui, desk);
    ui.separator();
    let first = desk.balls.iter().next();
    let ball = first.map(|(mass, radius, spins)| Ball {
        mass: mass.0,
        radius: radius.0,
        spins,
    });
    let mut watch = *desk.watch;
    numbers::show_ball(ui, &language, &mut watch, &desk.crowd, ball);
    desk.watch.set_if_neq(watch);
    ui.separator();
    let count = desk.packed.sheet.count();
    let spins = ball.is_some_and(|ball| ball.spins);
    let is_other = dials::show(
        ui,
        &mut desk.playfield,
        &mut desk.clock,
        &mut desk.loading,
        &desk.recorder,
        &language,
        (count, spins),
    );
    if is_other {
        desk.commands.run_system_cached(dials::classify);
    }
    ui.separator();
    egui::CollapsingHeader::new(language.text("crowd-numbers"))
        .id_salt("numbers")
        .default_open(true)
        .show(ui, |ui| {
            numbers::show(
                ui,
                &desk.numbers,
                &desk.census,
                &desk.packed,
                &desk.cost,
                &desk.clock,
                &language,
            );
        });
    egui::CollapsingHeader::new(language.text("crowd-scenes"))
        .id_salt("scenes")
        .show(ui, |ui| scenes::list(ui, &language, &mut desk.loading));
    egui::CollapsingHeader::new(language.text("crowd-controls"))
        .id_salt("controls")
        .show(ui, |ui| ui.label(language.text("crowd-controls-text")));
}

fn buttons(ui: &mut egui::Ui, desk: &mut Desk) {
    let language = desk.language.clone();
    ui.horizontal_wrapped(|ui| {
        let hold = if desk.time.is_paused() {
            "crowd-go-on"
        } else {
            "crowd-hold"
        };
        if ui.button(language.text(hold)).clicked() {
            pace::hold(&mut desk.time);
        }
        if ui.button(language.text("crowd-begin-again")).clicked() {
            pace::begin_again(
                &mut desk.time,
                &mut desk.load,
                &desk.recorder,
                &desk.playfield,
            );
        }
        if ui.button(language.text("crowd-leave")).clicked() {
            desk.load.write(LoadScene(practice::opening()));
            desk.time.unpause();
        }
        if let Some(what) = desk.loading.what() {
            ui.spinner();
            ui.label(what);
        }
    });
}

fn look(ui: &mut egui::Ui, desk: &mut Desk) {
    let language = desk.language.clone();
    let mut view = *desk.view;
    ui.horizontal(|ui| {
        for (mode, name) in [
            (CameraMode::Overhead, "crowd-overhead"),
            (CameraMode::Orbit, "crowd-free"),
        ] {
            ui.selectable_value(&mut view.camera, mode, language.text(name));
        }
    });
    desk.view.set_if_neq(view);
    let mut watch = *desk.watch;
    ui.horizontal(|ui| {
        ui.label(language.text("crowd-colour"));
        for (colouring, name) in [
            (Colouring::Speed, "crowd-by-speed"),
            (Colouring::Spin, "crowd-by-spin"),
            (Colouring::Number, "crowd-by-number"),
        ] {
            ui.selectable_value(&mut watch.colouring, colouring, language.text(name));
        }
    });
    desk.watch.set_if_neq(watch);
    let hottest = desk.packed.hottest;
    match watch.colouring {
        Colouring::Speed => scale(ui, &format!("{:.2} m/s", hottest.speed)),
        Colouring::Spin if desk.packed.spins => scale(ui, &format!("{:.0} rad/s", hottest.spin)),
        Colouring::Spin => {
            ui.label(egui::RichText::new(language.text("crowd-no-spin")).weak());
        }
        Colouring::Number => {}
    }
}

/// The colours from cold to hot, as the shader mixes them.
fn scale(ui: &mut egui::Ui, hottest: &str) {
    ui.horizontal(|ui| {
        ui.label("0");
        let size = egui::vec2(150.0, 10.0);
        let (rect, _) = ui.allocate_exact_size(size, egui::Sense::hover());
        let stops = [
            [39, 49, 149],
            [26, 144, 207],
            [64, 191, 101],
            [243, 197, 39],
            [233, 49, 33],
        ];
        let mut mesh = egui::Mesh::default();
        for (i, [r, g, b]) in (0_u32..).zip(stops) {
            let x = egui::lerp(rect.x_range(), i as f32 / 4.0);
            let colour = egui::Color32::from_rgb(r, g, b);
            mesh.colored_vertex(egui::pos2(x, rect.top()), colour);
            mesh.colored_vertex(egui::pos2(x, rect.bottom()), colour);
            if i > 0 {
                let k = 2 * i;
                mesh.add_triangle(k - 2, k - 1, k);
                mesh.add_triangle(k, k - 1, k + 1);
            }
        }
        ui.painter().add(mesh);
        ui.label(hottest);
    });
}
