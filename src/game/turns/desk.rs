//! What players ask for.

use bevy::prelude::*;
use glam::DVec2;

use crate::game::aim::Aim;
use crate::game::matches::{Hindrance, Match, Mind, Phase, PlayedShot, Refused, Session};
use crate::game::placing;
use crate::game::practice::{BREAK_SPEED, Placed, PracticeCommand, put_down};
use crate::game::replay::{Playback, Replay};
use crate::game::rules::Game;
use crate::game::saying::Saying;
use crate::game::turns::saves::let_go;
use crate::game::turns::{MatchStore, TurnCommand, TurnNews, Turns, is_computers};
use crate::physics::cue::Shot;
use crate::physics::exact::{Limits, solve};
use crate::physics::scene::Scene;
use crate::sim::clock::Clock;
use crate::sim::messages::LoadScene;

/// Speed of the cue in m/s that a turn begins with.
const SPEED: f64 = 2.0;

/// Commands of practice are another thing in a match: a ball put down by hand is the cue ball in hand, going back is
/// going back in the match, and another table or rack leaves the match.
pub(super) fn give_way(
    mut asked: MessageReader<PracticeCommand>,
    mut turns: ResMut<Turns>,
    mut commands: MessageWriter<TurnCommand>,
    mut news: MessageWriter<TurnNews>,
    mut balls: Placed,
) {
    for command in asked.read() {
        if !turns.is_on() {
            continue;
        }
        match *command {
            PracticeCommand::Rack(_) | PracticeCommand::Table(_) => let_go(&mut turns, &mut news),
            PracticeCommand::Retry | PracticeCommand::Undo => {
                commands.write(TurnCommand::Undo);
            }
            PracticeCommand::PlaceBall { ball, x, z } => {
                if let Err(refused) = place(&mut turns, ball, DVec2::new(x, z), &mut balls) {
                    news.write(TurnNews::Refused(refused));
                }
            }
            // A match cannot be done again: what is taken back in it is played anew.
            PracticeCommand::Redo | PracticeCommand::CueBallInHand => {}
        }
    }
}

/// Puts the cue ball down as near to a place as it may lie; in practice any ball.
fn place(turns: &mut Turns, ball: usize, at: DVec2, balls: &mut Placed) -> Result<(), Refused> {
    if !turns.may_strike() {
        return Ok(());
    }
    let Some(session) = &mut turns.session else {
        return Ok(());
    };
    let (table, on) = (session.game().table(), session.game().targets());
    if matches!(session.game().setup().game, Game::FreePractice(_)) {
        let spot = placing::nearest_free(&table, ball, at).unwrap_or(at);
        session.input(|game| game.lay(ball, spot))?;
    } else if ball == on.cue {
        // Without a cue ball in hand the match refuses, and says why.
        let spot = on
            .in_hand
            .and_then(|area| area.place(&table, ball, at))
            .unwrap_or(at);
        session.place(spot)?;
    } else {
        return Err(Refused::NotNow {
            what: "moving this ball",
            now: Hindrance::NotTheCueBall,
        });
    }
    put_down(balls, &session.game().table(), ball);
    Ok(())
}

/// Does what was asked for.
#[expect(
    clippy::too_many_arguments,
    reason = "a system names everything it reads"
)]
pub(super) fn obey(
    mut commands: MessageReader<TurnCommand>,
    mut turns: ResMut<Turns>,
    mut news: MessageWriter<TurnNews>,
    mut load: MessageWriter<LoadScene>,
    mut replay: ResMut<Replay>,
    store: Res<MatchStore>,
    clock: Res<Clock>,
    time: Res<Time>,
) {
    for command in commands.read() {
        let turns = &mut *turns;
        let before = turns.game().map(|game| (game.rack(), game.shots().len()));
        match command {
            TurnCommand::Begin { setup, like } => match Match::new((**setup).clone(), like) {
                Ok(game) => begin(turns, Session::new(game, store.0.clone()), &mut news),
                Err(refused) => {
                    news.write(TurnNews::Refused(refused));
                    continue;
                }
            },
            TurnCommand::Resume => {
                let Some(store) = store.0.clone() else {
                    news.write(TurnNews::Failed(Saying::new(
                        "match-not-saved-here",
                        &[],
                        "Matches are not saved here.",
                    )));
                    continue;
                };
                if let Some(session) = &turns.session {
                    session.finish_saving();
                }
                match Session::resume(store) {
                    Ok(session) => begin(turns, session, &mut news),
                    Err(error) => {
                        news.write(TurnNews::Failed(Saying::of(
                            "match-not-resumed",
                            vec![("reason", error.to_string().as_str().into())],
                            "The saved match cannot be read; the file stays as it is. {reason}",
                        )));
                        continue;
                    }
                }
            }
            TurnCommand::Leave => {
                let_go(turns, &mut news);
                continue;
            }
            TurnCommand::Hurry => {
                if let Some(computer) = &turns.computer {
                    computer.hurry();
                }
                continue;
            }
            TurnCommand::Watch(shot) => {
                if !clock.moving
                    && let Err(why) = watch(turns, *shot, &mut replay)
                {
                    news.write(TurnNews::Failed(why));
                }
                continue;
            }
            _ if clock.moving || turns.stroke.is_some() => continue,
            command => {
                if let Err(refused) = ask(turns, command, &mut news) {
                    news.write(TurnNews::Refused(refused));
                    continue;
                }
            }
        }
        if matches!(command, TurnCommand::Call(_)) {
            continue;
        }
        let Some(game) = turns.game() else {
            continue;
        };
        let is_new = before != Some((game.rack(), game.shots().len()));
        if is_new || !matches!(command, TurnCommand::Concede) {
            load.write(LoadScene(game.table()));
            turns.cue_is_due = true;
        }
        turns.computer = None;
        turns.since = time.elapsed_secs_f64();
    }
}

fn begin(turns: &mut Turns, session: Session, news: &mut MessageWriter<TurnNews>) {
    let_go(turns, news);
    turns.session = Some(session);
    news.write(TurnNews::Begun);
}

/// Another scene on the table ends the match: what it was played on is no longer there.
pub(super) fn make_room(
    mut scenes: MessageReader<LoadScene>,
    mut turns: ResMut<Turns>,
    mut news: MessageWriter<TurnNews>,
) {
    let Some(LoadScene(scene)) = scenes.read().last() else {
        return;
    };
    let is_its_own = |own: &Scene| {
        let mut pairs = scene.balls.iter().zip(&own.balls);
        scene.table == own.table
            && (scene.laws, scene.cue) == (own.laws, own.cue)
            && scene.balls.len() == own.balls.len()
            && pairs.all(|(one, other)| (&one.name, one.ball) == (&other.name, other.ball))
    };
    if turns.game().is_some_and(|game| !is_its_own(&game.table())) {
        let_go(&mut turns, &mut news);
    }
}

/// What is for the match itself to decide.
fn ask(
    turns: &mut Turns,
    command: &TurnCommand,
    news: &mut MessageWriter<TurnNews>,
) -> Result<(), Refused> {
    let Some(session) = &mut turns.session else {
        return Err(Refused::NotNow {
            what: "this",
            now: Hindrance::NoMatch,
        });
    };
    let theirs = is_computers(session.game())
        && matches!(session.game().phase(), Phase::Play | Phase::Choose);
    match command {
        TurnCommand::Call(_) | TurnCommand::Choose(_) | TurnCommand::Concede if theirs => {
            return Err(Refused::NotNow {
                what: "this",
                now: Hindrance::NotTheirTurn,
            });
        }
        TurnCommand::Call(call) => session.input(|game| game.call(*call))?,
        TurnCommand::Choose(choice) => {
            let player = session.game().state().standing.turn;
            let verdict = session.choose(*choice)?;
            turns.said = Some((player, verdict));
            news.write(TurnNews::Chosen {
                player,
                choice: *choice,
            });
        }
        TurnCommand::NextRack => session.input(Match::next_rack)?,
        TurnCommand::Concede => session.input(Match::concede)?,
        TurnCommand::Undo => {
            let shots = session.game().shots();
            let persons = |shot: &PlayedShot| {
                let player = session.game().setup().players.get(shot.player());
                player.is_some_and(|player| player.mind == Mind::Person)
            };
            let back = shots.iter().rev().position(persons).map_or(1, |at| at + 1);
            session.input(|game| game.undo(back))?;
            turns.said = None;
        }
        _ => {}
    }
    Ok(())
}

/// Shows a shot again: its scene is solved once more, to the same bits.
fn watch(turns: &Turns, shot: usize, replay: &mut Replay) -> Result<(), Saying> {
    let Some(scene) = turns.game().and_then(|game| game.replay(shot)) else {
        let values = vec![("number", (shot + 1).into())];
        let english = "There is no shot number {number}.";
        return Err(Saying::of("match-no-shot", values, english));
    };
    let mut record = solve(&scene, Limits::default()).map_err(|error| {
        let values = vec![("reason", error.to_string().as_str().into())];
        let english = "The shot cannot be played again: {reason}";
        Saying::of("match-not-shown", values, english)
    })?;
    // When it is over the balls lie as the match left them, not as this shot did.
    if let Some(game) = turns.game() {
        let states = game.table().balls.iter().map(|ball| ball.state).collect();
        record.end = states;
    }
    replay.0 = Some(Playback {
        record,
        time: 0.0,
        rate: 1.0,
        playing: true,
        looping: false,
    });
    Ok(())
}

/// Takes up the cue for the player at the table: at a ball that is on.
pub(super) fn take_cue(mut turns: ResMut<Turns>, mut aim: ResMut<Aim>) {
    turns.cue_is_due = false;
    let Some(game) = turns.game() else { return };
    let (table, on) = (game.table(), game.targets());
    let from = table.balls[on.cue].state.position;
    aim.ball = on.cue;
    aim.draw_back = 0.0;
    aim.set_tip(0.0, 0.0);
    aim.set_elevation(0.0);
    aim.set_speed(if on.is_break { BREAK_SPEED } else { SPEED });
    let nearest = on.first.iter().min_by(|a, b| {
        let far = |ball: usize| (table.balls[ball].state.position - from).length_squared();
        far(**a).total_cmp(&far(**b))
    });
    if let Some(ball) = nearest {
        aim.set_heading(Shot::heading_between(
            from,
            table.balls[*ball].state.position,
        ));
    }
}
