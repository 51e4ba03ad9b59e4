//! What all games on a table with six pockets and one cue ball share (WPA general rules, edition of 23 June 2025).

use crate::game::rules::area::Area;
use crate::game::rules::call::Call;
use crate::game::rules::facts::{Facts, Potted};
use crate::game::rules::foul::Foul;
use crate::game::rules::spot::{Spotter, Touching};
use crate::game::rules::standing::Standing;
use crate::game::rules::targets::number;

/// Object balls that a break without a pot must drive to cushions.
pub(super) const DRIVEN: usize = 4;

/// The fouls of the cue ball and of balls off the table, which hold for every stroke.
pub(super) fn general(facts: &Facts) -> Vec<Foul> {
    let mut fouls: Vec<Foul> = wrong_cue_ball(facts).into_iter().collect();
    if let Some(pocket) = facts.scratch() {
        fouls.push(Foul::Scratch { pocket });
    }
    if facts.off.contains(&facts.cue) {
        fouls.push(Foul::CueBallOff);
    }
    fouls.extend(facts.object_off().map(|ball| Foul::BallOff { ball }));
    fouls
}

/// The stroke of another ball than the cue ball.
pub(super) fn wrong_cue_ball(facts: &Facts) -> Option<Foul> {
    let struck = facts.stroke()?.ball;
    (struck != facts.cue).then_some(Foul::WrongCueBall { struck })
}

/// The fouls of a stroke at balls on the table: which ball is met first, and that something reaches a cushion. `on` are
/// the balls that may be met first, `in_hand` where the cue ball was put down.
pub(super) fn contact(facts: &Facts, on: &[usize], in_hand: Option<Area>) -> Vec<Foul> {
    let mut fouls = Vec::new();
    let Some(&hit) = facts.first.first() else {
        return vec![Foul::NoContact];
    };
    // Of two balls met at once the player is given the right one.
    if !facts.first.iter().any(|ball| on.contains(ball)) {
        let on = on.to_vec();
        fouls.push(Foul::WrongBall { hit, on });
    }
    fouls.extend(from_string(facts, in_hand));
    if facts.object_potted().next().is_none() && !facts.is_cushion_reached() {
        fouls.push(Foul::NoCushion);
    }
    fouls
}

/// From behind the head string the first ball met must lie on or past the string, unless the cue ball crosses it first.
pub(super) fn from_string(facts: &Facts, in_hand: Option<Area>) -> Option<Foul> {
    let string = facts.scene.table.head_spot().x;
    if in_hand != Some(Area::behind_head_string(&facts.scene.table)) {
        return None;
    }
    let behind = |ball: &&usize| facts.scene.balls[**ball].state.position.x < string;
    let all_behind = facts.first.iter().all(|ball| behind(&ball));
    let hit = *facts.first.first()?;
    (all_behind && !facts.crosses_before_contact(string)).then_some(Foul::BehindString { hit })
}

/// Whether a pot is the one that was called, or needs no call because everybody saw it coming.
pub(super) fn is_called(facts: &Facts, potted: &Potted, call: &Call) -> bool {
    match *call {
        Call::Pot { ball, pocket } => potted.ball == ball && potted.pocket == pocket,
        Call::Nothing => facts.is_obvious(potted),
        _ => false,
    }
}

/// Puts balls back on the foot spot, in the order of their numbers.
pub(super) fn spot(spotter: &mut Spotter, balls: impl Iterator<Item = usize>) {
    let mut balls: Vec<usize> = balls.collect();
    balls.sort_by_key(|&ball| number(spotter.scene(), ball));
    let foot = spotter.scene().table.foot_spot();
    for ball in balls {
        spotter.on_long_line(ball, foot, Touching::Object);
    }
}

/// The turn passes after a foul, with the cue ball in hand there.
pub(super) fn hand_over(standing: &mut Standing, area: Area) {
    standing.pass();
    standing.in_hand = Some(area);
}

/// How an opening break went.
pub(super) struct Break {
    /// Object balls potted.
    pub(super) potted: usize,
    /// Object balls driven to cushions.
    pub(super) driven: usize,
}

impl Break {
    pub(super) fn of(facts: &Facts) -> Self {
        Self {
            potted: facts.object_potted().count(),
            driven: facts.driven_to_cushions(),
        }
    }

    /// Whether it was hard enough: a ball potted, or four driven to cushions.
    pub(super) fn is_legal(&self) -> bool {
        self.potted > 0 || self.driven >= DRIVEN
    }
}
