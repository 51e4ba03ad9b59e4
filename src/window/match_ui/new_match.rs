//! The page on which a match is agreed on.

use bevy::prelude::*;
use bevy_egui::egui;

use crate::game::matches::{Breaks, Mind, Player, Setup};
use crate::game::players::Level;
use crate::game::rules::{Game, wording};
use crate::game::saying::Saying;
use crate::game::turns::{MatchStore, TurnCommand, TurnNews, Turns};
use crate::physics::scene::{Scene, Solver};
use crate::scenarios::preset;
use crate::sim::playfield::{BallQuery, Playfield, snapshot};
use crate::window::language::Language;
use crate::window::page::{AddPages, Open, Page, PageId};

/// Most racks that win a match.
const LONGEST: u32 = 25;
/// Tables from this length in m on are snooker tables.
const LONGEST_POOL_TABLE: f64 = 3.0;

/// The page.
const PAGE: PageId = PageId("match");

/// What is agreed on so far.
#[derive(Resource, Debug)]
struct Draft {
    game: usize,
    names: [String; 2],
    /// Index into [`Level::ALL`], or a person.
    levels: [Option<usize>; 2],
    race: u32,
    breaks: Breaks,
    undo: bool,
    /// Counts the matches, so that no two have the same racks.
    begun: u64,
}

impl Default for Draft {
    fn default() -> Self {
        Self {
            game: 0,
            names: [String::new(), String::new()],
            levels: [None, Some(1)],
            race: 3,
            breaks: Breaks::Alternate,
            undo: false,
            begun: 0,
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Draft>().add_page(
        Page {
            id: PAGE,
            title: "match-title",
            place: Some((PageId::MAIN, 12)),
        },
        show,
    );
}

/// What a match is played with: the table that is there, if the game is played on such a one; else the game's own.
fn equipment(setup: &Setup, here: Scene) -> Result<Scene, String> {
    let wanted = setup.game.rules().code().equipment;
    let fits = wanted == "pool"
        && setup.check(&here.table).is_ok()
        && here.table.length < LONGEST_POOL_TABLE
        && !here.solver.is_crowd()
        && here.laws.motion.is_closed_form();
    if fits {
        return Ok(Scene {
            solver: Solver::Exact,
            ..here
        });
    }
    let preset = preset::open(wanted).map_err(|error| error.to_string())?;
    Ok(preset.equipment.scene())
}

/// What both agree on besides the players.
fn terms(ui: &mut egui::Ui, draft: &mut Draft, language: &Language) {
    ui.add_space(6.0);
    ui.horizontal_wrapped(|ui| {
        ui.label(language.text("match-race"));
        ui.add(egui::DragValue::new(&mut draft.race).range(1..=LONGEST));
        ui.label(language.text("match-breaks"));
        for (breaks, key) in [
            (Breaks::Alternate, "match-breaks-alternate"),
            (Breaks::Winner, "match-breaks-winner"),
            (Breaks::Loser, "match-breaks-loser"),
        ] {
            ui.selectable_value(&mut draft.breaks, breaks, language.text(key));
        }
    });
    ui.checkbox(&mut draft.undo, language.text("match-undo"));
    ui.add_space(8.0);
}

/// The name of a player: the one typed, or what everybody is called.
fn name(draft: &Draft, index: usize, language: &Language) -> String {
    let typed = draft.names[index].trim();
    match draft.levels[index] {
        _ if !typed.is_empty() => typed.to_owned(),
        Some(level) => Level::ALL[level].name.to_owned(),
        None => language.with("match-player", &[("number", (index + 1).into())]),
    }
}

#[expect(
    clippy::too_many_arguments,
    reason = "a system names everything it reads"
)]
fn show(
    InMut(ui): InMut<egui::Ui>,
    language: Res<Language>,
    turns: Res<Turns>,
    store: Res<MatchStore>,
    playfield: Res<Playfield>,
    balls: BallQuery,
    time: Res<Time<Real>>,
    mut draft: ResMut<Draft>,
    mut open: ResMut<Open>,
    mut commands: MessageWriter<TurnCommand>,
    mut news: MessageWriter<TurnNews>,
) {
    let draft = &mut *draft;
    let games = Game::all();
    ui.label(language.text("match-game"));
    ui.horizontal_wrapped(|ui| {
        for (index, game) in games.iter().enumerate() {
            let title = language.say(&wording::title(game));
            ui.selectable_value(&mut draft.game, index, title);
        }
    });
    let Some(game) = games.get(draft.game) else {
        draft.game = 0;
        return;
    };
    ui.weak(game.rules().code().edition);
    let count = (*game.rules().players().end()).min(2);
    for index in 0..count {
        ui.add_space(6.0);
        ui.horizontal_wrapped(|ui| {
            let hint = name(draft, index, &language);
            ui.add(
                egui::TextEdit::singleline(&mut draft.names[index])
                    .hint_text(hint)
                    .char_limit(40)
                    .desired_width(140.0),
            );
            ui.selectable_value(
                &mut draft.levels[index],
                None,
                language.text("match-person"),
            );
            for (level, known) in Level::ALL.iter().enumerate() {
                ui.selectable_value(&mut draft.levels[index], Some(level), known.name)
                    .on_hover_text(language.text(known.key));
            }
        });
        if let Some(level) = draft.levels[index] {
            ui.weak(language.text(Level::ALL[level].key));
        }
    }
    terms(ui, draft, &language);
    ui.horizontal(|ui| {
        let begin = egui::RichText::new(language.text("match-begin")).size(18.0);
        if ui
            .add(
                egui::Button::new(begin)
                    .min_size(egui::vec2(120.0, 32.0))
                    .fill(ui.visuals().selection.bg_fill),
            )
            .clicked()
        {
            draft.begun += 1;
            let players = (0..count)
                .map(|index| Player {
                    name: name(draft, index, &language),
                    mind: draft.levels[index].map_or(Mind::Person, |level| Mind::Computer {
                        level: Level::ALL[level].name.to_owned(),
                    }),
                })
                .collect();
            let setup = Setup {
                game: game.clone(),
                players,
                race: draft.race,
                breaks: draft.breaks,
                first: 0,
                // The racks of two matches differ; what a match does with its seed is the same everywhere.
                seed: time.elapsed().as_nanos() as u64 ^ draft.begun.rotate_left(40),
                undo: draft.undo,
            };
            match equipment(&setup, snapshot(&playfield, &balls)) {
                Ok(like) => {
                    commands.write(TurnCommand::Begin {
                        setup: Box::new(setup),
                        like: Box::new(like),
                    });
                    open.close();
                }
                Err(error) => {
                    let values = vec![("reason", error.as_str().into())];
                    let english = "The match cannot be begun: {reason}";
                    let failed = Saying::of("match-not-begun", values, english);
                    news.write(TurnNews::Failed(failed));
                }
            }
        }
        let resume = egui::Button::new(language.text("match-resume"));
        let saved = store
            .0
            .as_ref()
            .is_some_and(|store| !turns.is_on() && !store.names().is_empty());
        if ui.add_enabled(saved, resume).clicked() {
            commands.write(TurnCommand::Resume);
            open.close();
        }
    });
}
