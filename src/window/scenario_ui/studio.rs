//! The panel in which layouts are built: the ball that is chosen, exact places, balls that come and go, undo and redo,
//! saving and sharing.

use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};
use glam::DVec2;

use super::heat::{self, Heat};
use super::share::{self, Asked, OwnScenes};
use super::stage::Stage;
use crate::game::aim::{Aim, Swing};
use crate::game::practice::{Practice, PracticeCommand};
use crate::game::snap;
use crate::game::studio::StudioCommand;
use crate::physics::scene::Scene;
use crate::scenarios::own::Own;
use crate::sim::clock::Clock;
use crate::sim::playfield::{BallQuery, Playfield, snapshot};
use crate::window::language::Language;
use crate::window::page::panel_id;

/// Width of the panel in points.
const WIDTH: f32 = 300.0;

/// The balls that can be added.
const NAMES: [&str; 16] = [
    "cue", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14", "15",
];

/// Differences below this, in m or diamonds, are rounding of the text shown, not the player's wish.
const SHOWN: f64 = 0.5e-6;

/// What the panel is set to.
#[derive(Resource, Debug)]
pub struct Studio {
    /// Whether it is open.
    pub open: bool,
    /// The name under which is saved.
    pub name: String,
    /// The title of the scene.
    pub title: String,
    /// What to look for in it.
    pub look_for: String,
    /// Whether what must happen in the scene that was opened is kept.
    pub keeps_expectations: bool,
    /// A shared text that is typed or pasted.
    pub text: String,
    /// The scene whose words are shown.
    seen: Option<String>,
    /// What was saved, as far as the panel knows.
    saved: Vec<String>,
}

impl Default for Studio {
    fn default() -> Self {
        Self {
            open: false,
            name: String::new(),
            title: String::new(),
            look_for: String::new(),
            keeps_expectations: true,
            text: String::new(),
            seen: None,
            saved: Vec::new(),
        }
    }
}

impl Studio {
    /// Takes over the words of a scene that has been opened.
    fn look_at(&mut self, stage: &Stage) {
        let on = stage.on_table();
        let seen = on.map(|on| on.name.clone());
        if seen == self.seen {
            return;
        }
        self.seen = seen;
        // The file of one scene is not to be overwritten with another.
        let file = format!("{}.ron", self.name);
        if on.is_none_or(|on| !on.name.ends_with(&file)) {
            self.name.clear();
        }
        if let Some(on) = on {
            self.title.clone_from(&on.scenario.title);
            self.look_for.clone_from(&on.scenario.look_for);
            self.keeps_expectations = true;
        }
    }
}

/// Everything the panel shows and changes.
#[derive(SystemParam)]
pub(super) struct Bench<'w, 's> {
    studio: ResMut<'w, Studio>,
    practice: ResMut<'w, Practice>,
    heat: ResMut<'w, Heat>,
    own: Res<'w, OwnScenes>,
    stage: Res<'w, Stage>,
    aim: Res<'w, Aim>,
    clock: Res<'w, Clock>,
    playfield: Res<'w, Playfield>,
    balls: BallQuery<'w, 's>,
    language: Res<'w, Language>,
    commands: MessageWriter<'w, PracticeCommand>,
    builds: MessageWriter<'w, StudioCommand>,
    asks: MessageWriter<'w, Asked>,
    swings: MessageWriter<'w, Swing>,
}

/// Lays out the panel.
pub(super) fn show(mut contexts: EguiContexts, mut bench: Bench) -> Result {
    if !bench.studio.open {
        return Ok(());
    }
    let stage = &bench.stage;
    bench.studio.bypass_change_detection().look_at(stage);
    let context = contexts.ctx_mut()?;
    let room = context.content_rect();
    let mut is_open = true;
    egui::Window::new(bench.language.text("studio-title"))
        .id(panel_id(context, "studio"))
        .open(&mut is_open)
        .default_pos(room.left_top() + egui::vec2(334.0, 44.0))
        .auto_sized()
        .show(context, |ui| {
            ui.set_width(WIDTH);
            egui::ScrollArea::vertical()
                .max_height(room.height() - 130.0)
                .show(ui, |ui| contents(ui, &mut bench));
        });
    if !is_open {
        bench.studio.open = false;
        bench.practice.placing = false;
    }
    Ok(())
}

fn contents(ui: &mut egui::Ui, bench: &mut Bench) {
    let language = bench.language.clone();
    let scene = snapshot(&bench.playfield, &bench.balls);
    let is_still = !bench.clock.moving;
    ui.add_enabled_ui(is_still, |ui| {
        history(ui, &language, bench);
        ui.separator();
        layout(ui, &language, bench, &scene);
        ui.separator();
        words(ui, &language, bench);
    });
    ui.separator();
    egui::CollapsingHeader::new(language.text("heat-title"))
        .id_salt("heat-title")
        .show(ui, |ui| {
            let (stage, studio, aim) = (&bench.stage, &bench.studio, &bench.aim);
            let laid = || share::scenario(stage, studio, aim, &bench.playfield, &bench.balls);
            ui.add_enabled_ui(is_still, |ui| {
                heat::show(ui, &language, &mut bench.heat, laid);
            });
        });
}

fn history(ui: &mut egui::Ui, language: &Language, bench: &mut Bench) {
    ui.horizontal(|ui| {
        let (done, undone) = {
            let history = &bench.practice.history;
            (history.len(), history.undone())
        };
        for (key, steps, command) in [
            ("table-undo", done, PracticeCommand::Undo),
            ("studio-redo", undone, PracticeCommand::Redo),
        ] {
            let text = language.with(key, &[("steps", steps.into())]);
            if ui.add_enabled(steps > 0, egui::Button::new(text)).clicked() {
                bench.commands.write(command);
            }
        }
        if ui.button(language.text("number-strike")).clicked() {
            bench.swings.write(Swing);
        }
    });
    let mut placing = bench.practice.placing;
    ui.checkbox(&mut placing, language.text("studio-drag"));
    if placing != bench.practice.placing {
        bench.practice.placing = placing;
    }
}

/// The ball that is chosen, where it lies, and what becomes of it.
fn layout(ui: &mut egui::Ui, language: &Language, bench: &mut Bench, scene: &Scene) {
    let in_play = |ball: &usize| {
        let placed = scene.balls.get(*ball);
        placed.is_some_and(|placed| placed.state.motion.in_play())
    };
    let chosen = bench
        .practice
        .chosen
        .filter(in_play)
        .unwrap_or(bench.aim.ball);
    ui.horizontal(|ui| {
        ui.label(language.text("studio-ball"));
        let name = |ball: usize| scene.balls.get(ball).map_or("", |placed| &placed.name);
        egui::ComboBox::from_id_salt("studio-ball")
            .width(70.0)
            .selected_text(name(chosen))
            .show_ui(ui, |ui| {
                for ball in (0..scene.balls.len()).filter(in_play) {
                    if ui.selectable_label(ball == chosen, name(ball)).clicked() {
                        bench.practice.chosen = Some(ball);
                        ui.close();
                    }
                }
            });
        ui.menu_button(language.text("studio-add"), |ui| {
            ui.horizontal_wrapped(|ui| {
                for name in NAMES {
                    let is_free = scene.ball_named(name).is_none();
                    if is_free && ui.button(name).clicked() {
                        bench.builds.write(StudioCommand::Add(name.to_owned()));
                        ui.close();
                    }
                }
            });
        });
        let can_go = chosen != bench.aim.ball && scene.balls.len() > 1;
        let remove = egui::Button::new(language.text("studio-remove"));
        if ui.add_enabled(can_go, remove).clicked() {
            bench.builds.write(StudioCommand::Remove(chosen));
        }
    });
    if !in_play(&chosen) {
        return;
    }
    numbers(ui, language, bench, scene, chosen);
    ui.horizontal_wrapped(|ui| {
        let other = snap::nearest_ball(scene, chosen);
        let to_ball = egui::Button::new(language.text("studio-to-ball"));
        if ui.add_enabled(other.is_some(), to_ball).clicked()
            && let Some(other) = other
        {
            bench
                .builds
                .write(StudioCommand::FreezeToBall(chosen, other));
        }
        for (key, command) in [
            ("studio-to-rail", StudioCommand::FreezeToRail(chosen)),
            ("studio-to-diamond", StudioCommand::ToDiamond(chosen)),
        ] {
            if ui.button(language.text(key)).clicked() {
                bench.builds.write(command);
            }
        }
        let is_struck = chosen == bench.aim.ball;
        if ui
            .selectable_label(is_struck, language.text("studio-struck"))
            .clicked()
        {
            bench.builds.write(StudioCommand::StrikeBall(chosen));
        }
    });
}

/// Typed places: m, and diamonds.
fn numbers(ui: &mut egui::Ui, language: &Language, bench: &mut Bench, scene: &Scene, ball: usize) {
    let at = scene.balls[ball].state.position;
    let plan = DVec2::new(at.x, at.z);
    let mut metres = plan;
    let mut diamonds = scene.table.diamonds_of(plan);
    let shown = diamonds;
    let half = 0.5 * DVec2::new(scene.table.length, scene.table.width);
    egui::Grid::new("numbers of the studio")
        .num_columns(4)
        .show(ui, |ui| {
            let mut number = |key, value: &mut f64, (least, most): (f64, f64), step, unit| {
                ui.label(language.text(key));
                let drag = egui::DragValue::new(value)
                    .speed(step)
                    .range(least..=most)
                    .clamp_existing_to_range(false)
                    .min_decimals(3)
                    .max_decimals(6)
                    .update_while_editing(false)
                    .suffix(unit);
                ui.add_sized([92.0, 18.0], drag);
            };
            number("studio-x", &mut metres.x, (-half.x, half.x), 0.001, " m");
            number("studio-z", &mut metres.y, (-half.y, half.y), 0.001, " m");
            ui.end_row();
            let mut number = |key, value: &mut f64, most: f64| {
                ui.label(language.text(key));
                let drag = egui::DragValue::new(value)
                    .speed(0.01)
                    .range(0.0..=most)
                    .clamp_existing_to_range(false)
                    .min_decimals(2)
                    .max_decimals(5)
                    .update_while_editing(false);
                ui.add_sized([92.0, 18.0], drag);
            };
            number("studio-across", &mut diamonds.x, 4.0);
            number("studio-along", &mut diamonds.y, 8.0);
            ui.end_row();
        });
    let wish = if (metres - plan).abs().max_element() > SHOWN {
        metres
    } else if (diamonds - shown).abs().max_element() > SHOWN {
        scene.table.at_diamonds(diamonds)
    } else {
        return;
    };
    let (x, z) = (wish.x, wish.y);
    bench
        .commands
        .write(PracticeCommand::PlaceBall { ball, x, z });
}

/// What the scene is called; saving, reopening, sharing.
fn words(ui: &mut egui::Ui, language: &Language, bench: &mut Bench) {
    let studio = &mut *bench.studio;
    egui::Grid::new("words of the studio")
        .num_columns(2)
        .show(ui, |ui| {
            for (key, text) in [
                ("studio-scene-title", &mut studio.title),
                ("studio-look-for", &mut studio.look_for),
                ("studio-name", &mut studio.name),
            ] {
                ui.label(language.text(key));
                ui.add(egui::TextEdit::singleline(text).desired_width(190.0));
                ui.end_row();
            }
        });
    let expects = bench.stage.on_table();
    if expects.is_some_and(|on| !on.scenario.expect.is_empty()) {
        ui.checkbox(
            &mut studio.keeps_expectations,
            language.text("studio-expect"),
        );
    }
    ui.horizontal_wrapped(|ui| {
        let name = studio.name.trim();
        let save = egui::Button::new(language.text("studio-save"));
        if ui.add_enabled(!name.is_empty(), save).clicked() {
            bench.asks.write(Asked::Save(name.to_owned()));
        }
        let names = ui.menu_button(language.text("studio-reopen"), |ui| {
            if studio.saved.is_empty() {
                ui.weak(language.text("studio-none"));
            }
            let mut opened = None;
            for name in &studio.saved {
                if ui.button(name).clicked() {
                    opened = Some(name.clone());
                    ui.close();
                }
            }
            if let Some(name) = opened {
                studio.name.clone_from(&name);
                bench.asks.write(Asked::Reopen(name));
            }
        });
        if names.response.clicked() {
            studio.saved = bench.own.0.as_ref().map(Own::names).unwrap_or_default();
        }
        if ui.button(language.text("studio-copy")).clicked() {
            bench.asks.write(Asked::Copy);
        }
        if ui.button(language.text("studio-paste")).clicked() {
            bench.asks.write(Asked::Paste);
        }
    });
    ui.horizontal(|ui| {
        let field = egui::TextEdit::singleline(&mut studio.text)
            .hint_text(language.text("studio-text"))
            .desired_width(190.0);
        let entered = ui.add(field).lost_focus() && ui.input(|i| i.key_pressed(egui::Key::Enter));
        let text = studio.text.trim();
        let load = egui::Button::new(language.text("load"));
        let load = ui.add_enabled(!text.is_empty(), load).clicked();
        if (load || entered) && !text.is_empty() {
            bench.asks.write(Asked::Open(text.to_owned()));
            studio.text.clear();
        }
    });
}
