//! What happens around a stroke in a match.

use bevy::prelude::*;

use crate::game::turns::saves::let_go;
use crate::game::turns::{TurnNews, Turns};
use crate::physics::record::EndReason;
use crate::sim::messages::{AtRest, Failed, LoadScene, Strike, Struck};
use crate::sim::playfield::Playfield;
use crate::sim::recorder::Recorder;

/// Strokes that are not the player's to play do not reach the table, and those that are find the laws and the cue of the
/// match there: it is replayed and saved with them. Who practises with others leaves the match.
pub(super) fn veto(
    mut turns: ResMut<Turns>,
    mut strikes: ResMut<Messages<Strike>>,
    mut playfield: ResMut<Playfield>,
    mut news: MessageWriter<TurnNews>,
) {
    let Some(game) = turns.game() else { return };
    if strikes.is_empty() {
        return;
    }
    let table = game.table();
    let cue = game.state().cue_ball(&table);
    let agreed = (table.laws, table.cue, table.solver);
    if (playfield.laws, playfield.cue, playfield.solver) != agreed {
        if !turns.is_agreed() {
            let_go(&mut turns, &mut news);
            return;
        }
        (playfield.laws, playfield.cue, playfield.solver) = agreed;
    }
    let may = turns.may_strike();
    let allowed: Vec<Strike> = strikes
        .drain()
        .filter(|strike| may && strike.ball == cue)
        .collect();
    strikes.write_batch(allowed);
}

/// Remembers the stroke that has been struck.
pub(super) fn begin(
    mut strikes: MessageReader<Strike>,
    mut struck: MessageReader<Struck>,
    mut turns: ResMut<Turns>,
    time: Res<Time>,
) {
    let strike = strikes.read().last().copied();
    if struck.read().count() == 0 || !turns.is_on() {
        return;
    }
    let computer = turns.computer.take();
    let thought = computer
        .and_then(|computer| computer.thought())
        .unwrap_or_else(|| (time.elapsed_secs_f64() - turns.since).max(0.0));
    turns.stroke = strike.map(|strike| (strike.shot, thought));
}

/// The balls rest: the referee speaks, and the table is laid out as that leaves it.
pub(super) fn judge(
    mut at_rest: MessageReader<AtRest>,
    mut turns: ResMut<Turns>,
    mut load: MessageWriter<LoadScene>,
    mut news: MessageWriter<TurnNews>,
    recorder: Res<Recorder>,
    time: Res<Time>,
) {
    let Some(AtRest { time: end }) = at_rest.read().last().copied() else {
        return;
    };
    let Some((shot, thought)) = turns.stroke.take() else {
        return;
    };
    let turns = &mut *turns;
    let Some(session) = &mut turns.session else {
        return;
    };
    let player = session.game().state().standing.turn;
    let record = recorder.record(end, Some(EndReason::Rest));
    match session.played(shot, &record, thought) {
        Ok(verdict) => {
            turns.said = Some((player, verdict));
            news.write(TurnNews::Judged);
        }
        Err(refused) => {
            news.write(TurnNews::Refused(refused));
        }
    }
    load.write(LoadScene(session.game().table()));
    turns.cue_is_due = true;
    turns.since = time.elapsed_secs_f64();
}

/// A stroke that the solver cannot follow was not played: the table lies as before.
pub(super) fn recover(
    mut failed: MessageReader<Failed>,
    mut turns: ResMut<Turns>,
    mut load: MessageWriter<LoadScene>,
) {
    if failed.read().count() == 0 || turns.stroke.take().is_none() {
        return;
    }
    if let Some(game) = turns.game() {
        load.write(LoadScene(game.table()));
        turns.cue_is_due = true;
    }
}
