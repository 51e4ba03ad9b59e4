//! The page of a match: figures of the players, and every shot to see again.

use bevy::prelude::*;
use bevy_egui::egui;

use crate::game::matches::Phase;
use crate::game::rules::wording;
use crate::game::turns::{TurnCommand, Turns};
use crate::window::language::Language;
use crate::window::page::{AddPages, Open, Page, PageId};

/// The page.
pub(super) const PAGE: PageId = PageId("match-report");

pub(super) fn plugin(app: &mut App) {
    app.add_page(
        Page {
            id: PAGE,
            title: "match-report",
            place: Some((PageId::MAIN, 13)),
        },
        show,
    );
}

fn show(
    InMut(ui): InMut<egui::Ui>,
    language: Res<Language>,
    turns: Res<Turns>,
    mut open: ResMut<Open>,
    mut commands: MessageWriter<TurnCommand>,
) {
    let Some(game) = turns.game() else {
        ui.label(language.text("match-none"));
        return;
    };
    let setup = game.setup();
    ui.label(language.say(&wording::title(&setup.game)));
    let figures = game.statistics();
    egui::Grid::new("figures").striped(true).show(ui, |ui| {
        ui.label("");
        for player in &setup.players {
            ui.strong(&player.name);
        }
        ui.end_row();
        let mut row = |key: &str, value: &dyn Fn(usize) -> String| {
            ui.label(language.text(key));
            for index in 0..figures.len() {
                ui.label(value(index));
            }
            ui.end_row();
        };
        row("match-racks", &|i| figures[i].racks.to_string());
        row("match-shots", &|i| figures[i].shots.to_string());
        row("match-pots", &|i| figures[i].pots.to_string());
        row("match-fouls", &|i| figures[i].fouls.to_string());
        row("match-break-pots", &|i| {
            format!("{} / {}", figures[i].breaks_with_pot, figures[i].breaks)
        });
        row("match-best-run", &|i| figures[i].best_run.to_string());
        row("match-thought", &|i| {
            format!("{:.1} s", figures[i].average_thought())
        });
    });
    ui.horizontal(|ui| {
        let playing = matches!(game.phase(), Phase::Play | Phase::Choose);
        let mine = playing && !turns.is_computers();
        let concede = egui::Button::new(language.text("match-concede"));
        if ui.add_enabled(mine, concede).clicked() {
            commands.write(TurnCommand::Concede);
            open.close();
        }
        if ui.button(language.text("match-leave")).clicked() {
            commands.write(TurnCommand::Leave);
            open.close();
        }
    });
    ui.separator();
    ui.label(language.text("match-all-shots"));
    let scene = game.table();
    let names: Vec<String> = setup.players.iter().map(|p| p.name.clone()).collect();
    for (index, shot) in game.shots().iter().enumerate().rev() {
        ui.horizontal(|ui| {
            if ui.button(language.text("match-watch")).clicked() {
                commands.write(TurnCommand::Watch(index));
                open.close();
            }
            let player = names.get(shot.player()).map_or("", String::as_str);
            let mut parts = vec![format!("{}. {player}", index + 1)];
            let made = shot.made.iter();
            let made = made.map(|ball| language.say(&wording::ball_alone(&scene, *ball)));
            parts.extend(made.map(|ball| format!("+{ball}")));
            parts.extend(shot.fouls.iter().map(|foul| language.say(&foul.rule())));
            let over = shot.over.iter();
            parts.extend(over.map(|over| language.say(&over.saying(&scene, &names))));
            ui.label(parts.join(" · "));
        });
    }
}
