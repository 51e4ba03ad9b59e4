//! The score above the table, and below it whatever the player at the table may say or choose.

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

use crate::game::matches::{Match, Phase};
use crate::game::replay::Replay;
use crate::game::rules::{Call, CallNeeded, wording};
use crate::game::turns::{TurnCommand, Turns};
use crate::window::action::{Action, Bindings};
use crate::window::language::Language;
use crate::window::match_ui::call::Pointing;
use crate::window::match_ui::report;
use crate::window::page::Open;
use crate::window::page::panel_id;

/// Lays out the score.
#[expect(
    clippy::too_many_arguments,
    reason = "a system names everything it reads"
)]
pub(super) fn show(
    mut contexts: EguiContexts,
    language: Res<Language>,
    bindings: Res<Bindings>,
    turns: Res<Turns>,
    replay: Res<Replay>,
    mut pointing: ResMut<Pointing>,
    mut open: ResMut<Open>,
    mut commands: MessageWriter<TurnCommand>,
) -> Result {
    let Some(game) = turns.game() else {
        return Ok(());
    };
    let context = contexts.ctx_mut()?;
    egui::Area::new(panel_id(context, "score"))
        .anchor(egui::Align2::CENTER_TOP, egui::vec2(0.0, 8.0))
        .show(context, |ui| {
            egui::Frame::popup(ui.style()).show(ui, |ui| {
                ui.vertical_centered(|ui| {
                    score(ui, game, &language);
                    if replay.is_active() {
                        return;
                    }
                    match turns.phase() {
                        None => {}
                        Some(Phase::Play) if turns.is_computers() => {
                            thought(ui, &turns, &language, &mut commands);
                        }
                        Some(Phase::Choose) if turns.is_computers() => {}
                        Some(Phase::Play) => {
                            let key = |action| bindings.name(action, &language);
                            before_the_stroke(
                                ui,
                                game,
                                &language,
                                [key(Action::Call), key(Action::Place)],
                                &mut pointing,
                                &mut commands,
                            );
                        }
                        Some(Phase::Choose) => {
                            ui.horizontal_wrapped(|ui| {
                                for choice in &game.state().standing.choices {
                                    if ui.button(language.say(&choice.saying())).clicked() {
                                        commands.write(TurnCommand::Choose(*choice));
                                    }
                                }
                            });
                        }
                        Some(Phase::RackOver) => {
                            let next = ui.button(language.text("match-next-rack"));
                            if next.clicked() {
                                commands.write(TurnCommand::NextRack);
                            }
                        }
                        Some(Phase::Over { winner }) => {
                            let name = winner.and_then(|i| game.setup().players.get(i));
                            let text = match name {
                                Some(player) => language
                                    .with("match-won", &[("name", player.name.as_str().into())]),
                                None => language.text("match-drawn").to_owned(),
                            };
                            ui.strong(text);
                            ui.horizontal(|ui| {
                                if ui.button(language.text("match-report")).clicked() {
                                    open.go(report::PAGE);
                                }
                                if ui.button(language.text("match-leave")).clicked() {
                                    commands.write(TurnCommand::Leave);
                                }
                            });
                        }
                    }
                });
            });
        });
    Ok(())
}

/// Names, racks, points; who is at the table stands out.
fn score(ui: &mut egui::Ui, game: &Match, language: &Language) {
    let standing = &game.state().standing;
    let racks = game.racks_won();
    let points = game.setup().game.rules().counts_points();
    ui.horizontal(|ui| {
        for (index, player) in game.setup().players.iter().enumerate() {
            if index > 0 {
                ui.separator();
            }
            let (name, racks) = (&player.name, racks[index]);
            let text = if points {
                format!("{name}  {racks}  ({})", standing.scores[index])
            } else {
                format!("{name}  {racks}")
            };
            let text = egui::RichText::new(text);
            let at_table = index == standing.turn && standing.over.is_none();
            if at_table {
                ui.label(text.strong().underline());
            } else {
                ui.label(text);
            }
        }
        ui.separator();
        let race = game.setup().race;
        ui.weak(language.with("match-race-to", &[("racks", race.into())]));
    });
    if standing.over.is_none() {
        let (table, on) = (game.table(), game.targets());
        let names: Vec<String> = wording::alone(&table, &on.first)
            .iter()
            .map(|name| language.say(name))
            .collect();
        if !names.is_empty() && names.len() < 16 {
            let balls = names.join(", ");
            ui.weak(language.with("match-on", &[("balls", balls.into())]));
        }
    }
}

/// A computer player thinks.
fn thought(
    ui: &mut egui::Ui,
    turns: &Turns,
    language: &Language,
    commands: &mut MessageWriter<TurnCommand>,
) {
    ui.horizontal(|ui| {
        let progress = turns.progress();
        let share = progress.map_or(1.0, |progress| progress.share as f32);
        ui.add(egui::ProgressBar::new(share).desired_width(120.0));
        if let Some(best) = progress.and_then(|progress| progress.best) {
            let percent = format!("{:.0} %", 100.0 * best.chance);
            ui.weak(language.with("match-sees", &[("chance", percent.into())]));
        }
        if ui.button(language.text("match-hurry")).clicked() {
            commands.write(TurnCommand::Hurry);
        }
    });
}

/// What a person may call, and that the cue ball is in hand; the keys are those that call what is aimed
/// at and that take the ball up.
fn before_the_stroke(
    ui: &mut egui::Ui,
    game: &Match,
    language: &Language,
    [call_key, place_key]: [String; 2],
    pointing: &mut Pointing,
    commands: &mut MessageWriter<TurnCommand>,
) {
    let on = game.targets();
    let table = game.table();
    if on.in_hand.is_some() {
        let key = [("key", place_key.into())];
        ui.label(language.with("match-in-hand", &key));
    }
    let called = game.called();
    ui.horizontal_wrapped(|ui| {
        if on.call_needed != CallNeeded::No {
            ui.toggle_value(&mut pointing.by_name, language.text("match-call"));
            let said = match called {
                Call::Pot { ball, pocket } => format!(
                    "{} → {}",
                    language.say(&wording::ball_alone(&table, ball)),
                    language.say(&wording::pocket(&table, pocket))
                ),
                Call::Nominate { ball } => language.say(&wording::ball_alone(&table, ball)),
                _ => String::new(),
            };
            if !said.is_empty() {
                ui.strong(said);
            }
        }
        let mut say = |ui: &mut egui::Ui, call: Call, key: &str| {
            if ui
                .selectable_label(called == call, language.text(key))
                .clicked()
            {
                let call = if called == call { Call::Nothing } else { call };
                commands.write(TurnCommand::Call(call));
            }
        };
        if on.may_call_safety {
            say(ui, Call::Safety, "match-safety");
        }
        if on.may_push_out {
            say(ui, Call::PushOut, "match-push-out");
        }
    });
    if on.call_needed == CallNeeded::No {
        return;
    }
    if pointing.by_name {
        chosen_by_name(ui, game, language, pointing, commands);
    }
    if called == Call::Nothing {
        ui.weak(language.with("match-call-hint", &[("key", call_key.into())]));
    }
}

/// The same call without pointing: balls and pockets by their names.
fn chosen_by_name(
    ui: &mut egui::Ui,
    game: &Match,
    language: &Language,
    pointing: &mut Pointing,
    commands: &mut MessageWriter<TurnCommand>,
) {
    let (on, table) = (game.targets(), game.table());
    ui.horizontal_wrapped(|ui| {
        for ball in &on.pot {
            let chosen = pointing.ball == Some(*ball);
            let name = language.say(&wording::ball_alone(&table, *ball));
            if ui.selectable_label(chosen, name).clicked() {
                pointing.ball = Some(*ball);
            }
        }
    });
    if on.call_needed == CallNeeded::BallAndPocket {
        ui.horizontal_wrapped(|ui| {
            for pocket in &on.pockets {
                let chosen = pointing.pocket == Some(*pocket);
                let name = language.say(&wording::pocket(&table, *pocket));
                if ui.selectable_label(chosen, name).clicked() {
                    pointing.pocket = Some(*pocket);
                }
            }
        });
    }
    if let Some(call) = pointing.take_call(on.call_needed) {
        commands.write(TurnCommand::Call(call));
    }
}
