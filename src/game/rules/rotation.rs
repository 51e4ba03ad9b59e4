//! What 9-ball and 10-ball share: the lowest ball first, the break, the push out, three fouls in a row.

use serde::{Deserialize, Serialize};

use crate::game::rules::area::Area;
use crate::game::rules::call::Call;
use crate::game::rules::facts::Facts;
use crate::game::rules::foul::Foul;
use crate::game::rules::pool::{self, Break, DRIVEN};
use crate::game::rules::ruling::Ruling;
use crate::game::rules::standing::Standing;
use crate::game::rules::targets::{number, numbered};
use crate::game::rules::verdict::{Choice, Note, Reason};
use crate::physics::scene::Scene;

/// How far the rack has come.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Phase {
    /// Before the break.
    #[default]
    Break,
    /// After a legal break: the next stroke may be a push out.
    PushOut,
    /// Later.
    Later,
}

/// The lowest ball on the table: what has to be met first.
pub(super) fn lowest(scene: &Scene) -> Vec<usize> {
    let balls = numbered(scene, |_| true);
    let least = balls.iter().min_by_key(|&&ball| number(scene, ball));
    least.copied().into_iter().collect()
}

/// A stroke without a foul, for the rules of the game to go on with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Clean {
    /// The break.
    Break,
    /// Any later one but a push out.
    Later,
}

/// Judges what both games judge alike: fouls and push outs. `winning` is the ball that must come back if it falls then. None
/// if that was all there is to say.
pub(super) fn judge(
    phase: &mut Phase,
    (winning, three_fouls): (Option<usize>, bool),
    standing: &mut Standing,
    facts: &Facts,
    call: &Call,
    ruling: &mut Ruling,
) -> Option<Clean> {
    let breaks = *phase == Phase::Break;
    let push = *phase == Phase::PushOut && *call == Call::PushOut;
    if breaks {
        break_fouls(facts, ruling);
    } else {
        later_fouls(facts, push, ruling);
    }
    if !ruling.fouls.is_empty() {
        *phase = Phase::Later;
        spot_if_gone(facts, winning, ruling);
        after_foul(standing, facts, three_fouls, ruling);
        return None;
    }
    standing.count_foul(false);
    if breaks {
        return Some(Clean::Break);
    }
    *phase = Phase::Later;
    if push {
        spot_if_gone(facts, winning, ruling);
        offer_hand_back(standing);
        return None;
    }
    Some(Clean::Later)
}

/// The fouls of a break: as of any stroke, but without a pot four balls must reach cushions.
fn break_fouls(facts: &Facts, ruling: &mut Ruling) {
    ruling.fouls = pool::general(facts);
    let in_hand = Some(Area::behind_head_string(&facts.scene.table));
    let contact = pool::contact(facts, &lowest(facts.scene), in_hand);
    let broken = Break::of(facts);
    if broken.is_legal() {
        ruling.fouls.extend(contact);
    } else {
        let others = contact.into_iter();
        ruling
            .fouls
            .extend(others.filter(|foul| *foul != Foul::NoCushion));
        if !facts.first.is_empty() {
            ruling.fouls.push(Foul::WeakBreak {
                driven: broken.driven,
                needed: DRIVEN,
            });
        }
    }
}

/// The fouls of a later stroke. A push out may miss, meet any ball, and leave the cushions alone.
fn later_fouls(facts: &Facts, push: bool, ruling: &mut Ruling) {
    ruling.fouls = pool::general(facts);
    if !push {
        let in_hand = ruling.in_hand;
        let contact = pool::contact(facts, &lowest(facts.scene), in_hand);
        ruling.fouls.extend(contact);
    }
}

/// Puts this ball back if the stroke took it off the table.
pub(super) fn spot_if_gone(facts: &Facts, ball: Option<usize>, ruling: &mut Ruling) {
    let Some(ball) = ball else { return };
    if facts.potted(ball).is_some() || facts.off.contains(&ball) {
        pool::spot(&mut ruling.spotter, std::iter::once(ball));
    }
}

/// After a foul: ball in hand anywhere for the next player; three in a row lose.
fn after_foul(standing: &mut Standing, facts: &Facts, three_fouls: bool, ruling: &mut Ruling) {
    let player = standing.turn;
    let in_a_row = standing.count_foul(true);
    if three_fouls && in_a_row >= 3 {
        let winner = (standing.players == 2).then(|| standing.next_player());
        standing.end(winner, Reason::ThreeFouls);
        return;
    }
    if three_fouls && in_a_row == 2 {
        ruling.notes.push(Note::TwoFouls { player });
    }
    pool::hand_over(standing, Area::anywhere(&facts.scene.table));
}

/// The next player plays or hands the table back.
pub(super) fn offer_hand_back(standing: &mut Standing) {
    standing.pass();
    standing.choices = vec![Choice::Accept, Choice::HandBack];
}

/// Takes the choice of who was offered the table.
pub(super) fn choose(standing: &mut Standing, choice: Choice) {
    if choice == Choice::HandBack {
        standing.turn = standing.last_player();
    }
}

/// Points of the optional rule for breaks: balls potted, and balls whose base reached the head string.
pub(super) fn break_points(facts: &Facts) -> usize {
    let string = facts.scene.table.head_spot().x;
    (0..facts.scene.balls.len())
        .filter(|&ball| ball != facts.cue)
        .filter(|&ball| facts.potted(ball).is_some() || facts.least_x(ball) <= string)
        .count()
}
