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

/// Points between panels.
const GAP: f32 = 8.0;
/// Least width of the score in points.
const NARROW: f32 = 300.0;

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
    let room = room(context);
    egui::Area::new(panel_id(context, "score"))
        .pivot(egui::Align2::CENTER_TOP)
        .fixed_pos(room.center_top())
        .show(context, |ui| {
            ui.set_max_width(room.width());
            egui::Frame::popup(ui.style()).show(ui, |ui| {
                ui.vertical(|ui| {
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

/// The room above the table that other panels leave: between them, or below the corner where that is too narrow.
fn room(context: &egui::Context) -> egui::Rect {
    let screen = context.content_rect().shrink(GAP);
    let lies = |id: egui::Id| {
        context.memory(|memory| {
            let is_there = |order| {
                let layer = egui::LayerId::new(order, id);
                memory.areas().visible_last_frame(&layer)
            };
            let seen = is_there(egui::Order::Middle) || is_there(egui::Order::Foreground);
            memory.area_rect(id).filter(|_| seen)
        })
    };
    let corner = lies(panel_id(context, "corner"))
        .unwrap_or(egui::Rect::from_min_size(screen.min, egui::Vec2::ZERO));
    let panels = ["shot", "studio", "scenario"].map(|name| panel_id(context, name));
    let right = panels
        .into_iter()
        .chain([egui::Id::new("shot panel button")])
        .filter_map(lies)
        .filter(|rect| rect.top() < corner.bottom() + 3.0 * GAP && rect.left() > corner.right())
        .map(|rect| rect.left() - GAP)
        .fold(screen.right(), f32::min);
    let between = corner.right() + GAP;
    let from = if right - between >= NARROW {
        egui::pos2(between, screen.top())
    } else {
        egui::pos2(screen.left(), corner.bottom() + GAP)
    };
    let width = (right - from.x).max(NARROW);
    egui::Rect::from_min_size(from, egui::vec2(width, screen.height()))
}

/// Numbers that follow each other as from one to the other, as 1–7, 9.
fn in_short(names: &[String]) -> String {
    let number = |name: &String| name.parse::<u32>().ok();
    let mut parts: Vec<String> = Vec::new();
    let mut rest = names;
    while let Some(first) = rest.first() {
        let follows =
            |pair: &[String]| number(&pair[0]).is_some_and(|one| number(&pair[1]) == Some(one + 1));
        let run = 1 + rest.windows(2).take_while(|pair| follows(pair)).count();
        if run > 2 {
            parts.push(format!("{first}–{}", rest[run - 1]));
            rest = &rest[run..];
        } else {
            parts.push(first.clone());
            rest = &rest[1..];
        }
    }
    parts.join(", ")
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
            let balls = in_short(&names);
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
        ui.add(egui::Label::new(language.with("match-in-hand", &key)).wrap());
    }
    let called = game.called();
    ui.horizontal_wrapped(|ui| {
        if on.call_needed != CallNeeded::No {
            ui.toggle_value(&mut pointing.by_name, language.text("match-call"));
            let said = match called {
                Call::Pot { ball, pocket } => format!(
                    "{} ▶ {}",
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
        let hint = language.with("match-call-hint", &[("key", call_key.into())]);
        ui.add(egui::Label::new(egui::RichText::new(hint).weak()).wrap());
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

#[cfg(test)]
mod tests {
    use super::in_short;

    #[test]
    fn numbers_that_follow_each_other_are_told_in_short() {
        let short = |names: &[&str]| {
            let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
            in_short(&names)
        };
        assert_eq!(short(&["1", "2", "3", "4", "6", "7", "9"]), "1–4, 6, 7, 9");
        assert_eq!(short(&["yellow", "green", "8"]), "yellow, green, 8");
        assert_eq!(short(&["15"]), "15");
        assert_eq!(short(&[]), "");
    }
}
