//! A computer player at the cue: it thinks beside the game, shows what it means, and strikes.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Instant;

use bevy::prelude::*;
use bevy::tasks::{AsyncComputeTaskPool, Task, block_on};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::game::aim::Aim;
use crate::game::matches::{Match, Phase};
use crate::game::players::choosing::choose;
use crate::game::players::contest::execute;
use crate::game::players::{Level, Plan, Progress, Thinking};
use crate::game::replay::Replay;
use crate::game::rules::Choice;
use crate::game::saying::Saying;
use crate::game::turns::{TurnNews, Turns, level_name};
use crate::physics::cue::Shot;
use crate::sim::clock::Clock;
use crate::sim::messages::{LoadScene, Strike};

/// Seconds for which a player shows what it means to do before it strikes.
const SHOWN: f64 = 1.2;

/// Seconds within which a thought ends: less than that on a machine of today, so that it counts on a slow one only.
const LONGEST: f64 = 0.9;

/// Share of [`SHOWN`] after which the cue is drawn back.
const STILL: f64 = 0.5;

/// What a thought comes to.
#[derive(Clone, Copy, Debug)]
enum Decision {
    Choice(Choice),
    /// What is meant, and what the hand makes of it.
    Stroke(Plan, Shot),
}

/// What the thought and the game both see.
#[derive(Debug, Default)]
struct Shared {
    hurry: AtomicBool,
    progress: Mutex<Option<Progress>>,
}

#[derive(Debug)]
enum Stage {
    Thinks(Task<Result<Decision, String>>, Instant),
    Shows {
        shot: Shot,
        /// Seconds since it began to.
        shown: f64,
        thought: f64,
    },
    /// It cannot go on, and has said so.
    Stuck,
}

/// A computer player whose turn it is.
#[derive(Debug)]
pub(super) struct AtTheCue {
    stage: Stage,
    shared: Arc<Shared>,
}

impl AtTheCue {
    /// Begins to think about a match.
    fn think(game: &Match, level: Level) -> Self {
        let shared = Arc::new(Shared::default());
        let (seen, game) = (shared.clone(), game.clone());
        let pool = AsyncComputeTaskPool::get();
        let task = pool.spawn(async move { decide(&game, &level, &seen) });
        Self {
            stage: Stage::Thinks(task, Instant::now()),
            shared,
        }
    }

    /// Ends thinking and showing.
    pub(super) fn hurry(&self) {
        self.shared.hurry.store(true, Ordering::Relaxed);
    }

    fn is_hurried(&self) -> bool {
        self.shared.hurry.load(Ordering::Relaxed)
    }

    /// How far it has come, while it thinks.
    pub(super) fn progress(&self) -> Option<Progress> {
        if !matches!(self.stage, Stage::Thinks(..)) {
            return None;
        }
        *self.shared.progress.lock().ok()?
    }

    /// Seconds it thought, once it has decided.
    pub(super) fn thought(&self) -> Option<f64> {
        match self.stage {
            Stage::Shows { thought, .. } => Some(thought),
            _ => None,
        }
    }
}

/// Seeds of one stroke: of the errors that are rehearsed, and of the error of the hand. They come from the match, so that
/// it can be played again.
fn seeds(game: &Match) -> (u64, u64) {
    let count = game.shots().len() as u64 + 1;
    let mixed = game.setup().seed.wrapping_mul(0xA24B_AED4_963E_E407) ^ count.rotate_left(32);
    (mixed, mixed.wrapping_add(0x9FB2_1C65_1E98_DF25))
}

/// From a match to what the player at the table does. Unless it is hurried, or has thought for too long, the outcome depends
/// on the match alone.
fn decide(game: &Match, level: &Level, shared: &Shared) -> Result<Decision, String> {
    let table = game.table();
    if game.phase() == Phase::Choose {
        let last = game.shots().len().checked_sub(1);
        let before = last.and_then(|shot| game.replay(shot));
        let before = before.unwrap_or_else(|| table.clone());
        let choice = choose(game.state(), &table, &before, level);
        let first = game.state().standing.choices.first().copied();
        return choice
            .or(first)
            .map(Decision::Choice)
            .ok_or_else(|| "there is nothing to choose".to_owned());
    }
    let (think, hand) = seeds(game);
    let mut thinking =
        Thinking::new(game.state(), &table, level, think).map_err(|error| error.to_string())?;
    let begun = Instant::now();
    while !shared.hurry.load(Ordering::Relaxed) && thinking.step() {
        thinking.press(begun.elapsed().as_secs_f64() / LONGEST);
        if let Ok(mut progress) = shared.progress.lock() {
            *progress = Some(thinking.progress());
        }
    }
    let plan = thinking.plan();
    let mut placed = game.clone();
    if let Some(spot) = plan.spot {
        placed.place(spot).map_err(|refused| refused.to_string())?;
    }
    let table = placed.table();
    let cue = game.state().cue_ball(&table);
    let mut rng = ChaCha8Rng::seed_from_u64(hand);
    let shot = execute(&table, cue, level, &plan.shot, &mut rng);
    Ok(Decision::Stroke(plan, shot))
}

/// Lets the computer player whose turn it is think, show and strike.
#[expect(
    clippy::too_many_arguments,
    reason = "a system names everything it reads"
)]
pub(super) fn play(
    mut turns: ResMut<Turns>,
    mut aim: ResMut<Aim>,
    mut strikes: MessageWriter<Strike>,
    mut load: MessageWriter<LoadScene>,
    mut news: MessageWriter<TurnNews>,
    clock: Res<Clock>,
    replay: Res<Replay>,
    time: Res<Time>,
) {
    if clock.moving || replay.is_active() || turns.cue_is_due {
        return;
    }
    let due = matches!(turns.phase(), Some(Phase::Play | Phase::Choose));
    let Some(level) = turns.game().filter(|_| due).and_then(level_name) else {
        turns.bypass_change_detection().computer = None;
        return;
    };
    let level = Level::named(level);
    let turns = &mut *turns;
    let Some(session) = &mut turns.session else {
        return;
    };
    let Some(computer) = &mut turns.computer else {
        turns.computer = Some(if let Some(level) = level {
            AtTheCue::think(session.game(), level)
        } else {
            let name = level_name(session.game()).unwrap_or_default();
            news.write(TurnNews::Failed(Saying::of(
                "match-no-level",
                vec![("name", name.into())],
                "There is no computer player called {name}.",
            )));
            AtTheCue {
                stage: Stage::Stuck,
                shared: Arc::default(),
            }
        });
        return;
    };
    let hurried = computer.is_hurried();
    match &mut computer.stage {
        Stage::Stuck => {}
        Stage::Shows { shot, shown, .. } => {
            *shown += time.delta_secs_f64();
            let back = (*shown / SHOWN - STILL) / (1.0 - STILL);
            aim.draw_back = back.clamp(0.0, 1.0);
            if hurried || *shown >= SHOWN {
                aim.draw_back = 0.0;
                strikes.write(Strike {
                    ball: aim.ball,
                    shot: *shot,
                });
            }
        }
        Stage::Thinks(task, begun) => {
            if !task.is_finished() {
                return;
            }
            let thought = begun.elapsed().as_secs_f64();
            let player = session.game().state().standing.turn;
            let done = match block_on(task) {
                Ok(Decision::Choice(choice)) => session
                    .choose(choice)
                    .map(|verdict| {
                        turns.said = Some((player, verdict));
                        news.write(TurnNews::Chosen { player, choice });
                        load.write(LoadScene(session.game().table()));
                        turns.cue_is_due = true;
                        None
                    })
                    .map_err(|refused| refused.to_string()),
                Ok(Decision::Stroke(plan, shot)) => {
                    if let Some(spot) = plan.spot
                        && session.place(spot).is_ok()
                    {
                        load.write(LoadScene(session.game().table()));
                    }
                    // What may not be called goes without saying.
                    let _ = session.input(|game| game.call(plan.call));
                    aim.ball = session.game().state().cue_ball(&session.game().table());
                    aim.shot = plan.shot;
                    aim.wish = plan.shot.elevation;
                    Ok(Some(Stage::Shows {
                        shot,
                        shown: 0.0,
                        thought,
                    }))
                }
                Err(why) => Err(why),
            };
            match done {
                Ok(Some(stage)) => computer.stage = stage,
                Ok(None) => turns.computer = None,
                Err(why) => {
                    news.write(TurnNews::Failed(Saying::of(
                        "match-stuck",
                        vec![("reason", why.as_str().into())],
                        "The computer player cannot go on: {reason}",
                    )));
                    computer.stage = Stage::Stuck;
                }
            }
        }
    }
}
