//! 8-ball (WPA rules of play, edition of 23 June 2025).

use serde::{Deserialize, Serialize};

use crate::game::rules::area::Area;
use crate::game::rules::call::Call;
use crate::game::rules::facts::Facts;
use crate::game::rules::foul::Foul;
use crate::game::rules::pool::{self, Break};
use crate::game::rules::ruling::Ruling;
use crate::game::rules::standing::Standing;
use crate::game::rules::targets::{CallNeeded, On, number, numbered};
use crate::game::rules::verdict::{Choice, Note, Reason, TableChange};
use crate::game::rules::{Code, RuleSet, Setting, setting};
use crate::physics::scene::{Rack, Scene};

/// What it is to meet the 8 first while the table is open. Codes differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum EightFirst {
    /// A foul (WPA).
    #[default]
    Foul,
    /// Allowed, but nothing potted counts and the turn passes, as the Billiard Congress of America had it.
    NoScore,
    /// Allowed, as in some leagues.
    Legal,
}

/// How far the rack has come.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Phase {
    /// Before the break.
    #[default]
    Break,
    /// Broken; nobody has a group yet.
    Open,
    /// This player has the solids.
    Closed {
        /// Index of the player.
        solids: usize,
    },
}

/// The rules of 8-ball, and the groups.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct EightBall {
    /// What it is to meet the 8 first while the table is open.
    pub eight_first_on_open: EightFirst,
    /// Turns without a pot before a warning, and after as many again the rack is broken again; `None` never.
    pub stalemate_after: Option<u32>,
    /// How far the rack has come.
    pub phase: Phase,
}

impl Default for EightBall {
    fn default() -> Self {
        Self {
            eight_first_on_open: EightFirst::default(),
            stalemate_after: Some(20),
            phase: Phase::Break,
        }
    }
}

fn is_solid(number: u8) -> bool {
    (1..=7).contains(&number)
}

fn is_stripe(number: u8) -> bool {
    (9..=15).contains(&number)
}

impl EightBall {
    /// Whether a player has the solids; `None` while nobody has a group.
    #[must_use]
    pub fn has_solids(&self, player: usize) -> Option<bool> {
        match self.phase {
            Phase::Closed { solids } => Some(solids == player),
            _ => None,
        }
    }

    /// Balls on for a pot: the own group, or the 8 when none of it is left; on an open table both groups.
    fn wanted(&self, player: usize, scene: &Scene) -> Vec<usize> {
        let Some(solids) = self.has_solids(player) else {
            return numbered(scene, |number| number != 8);
        };
        let own = numbered(scene, if solids { is_solid } else { is_stripe });
        if own.is_empty() {
            return numbered(scene, |number| number == 8);
        }
        own
    }

    fn judge_break(standing: &mut Standing, facts: &Facts, ruling: &mut Ruling) -> Phase {
        let table = &facts.scene.table;
        ruling.fouls = pool::general(facts);
        if facts.first.is_empty() {
            ruling.fouls.push(Foul::NoContact);
        }
        ruling.fouls.extend(pool::from_string(
            facts,
            Some(Area::behind_head_string(table)),
        ));
        let broken = Break::of(facts);
        let foul = !ruling.fouls.is_empty();
        let cue_gone = facts.scratch().is_some() || facts.off.contains(&facts.cue);
        let eight = facts.scene.ball_named("8");
        let is_eight = |ball: usize| Some(ball) == eight;
        let eight_fell = facts.object_potted().any(|potted| is_eight(potted.ball));
        let eight_gone = eight_fell || facts.object_off().any(is_eight);
        if eight_gone {
            pool::spot(&mut ruling.spotter, eight.into_iter());
        }
        let choices = &mut standing.choices;
        if foul {
            if !cue_gone {
                choices.push(Choice::Accept);
            }
            choices.push(Choice::InHand);
            if eight_fell {
                choices.push(Choice::Break);
            }
            if !broken.is_legal() {
                let driven = broken.driven;
                ruling.notes.push(Note::IllegalBreak { driven });
                choices.extend([Choice::Break, Choice::TheyBreak]);
            }
            standing.pass();
            if standing.choices == [Choice::InHand] {
                standing.choices.clear();
                standing.in_hand = Some(Area::behind_head_string(table));
            }
        } else if !broken.is_legal() {
            let driven = broken.driven;
            ruling.notes.push(Note::IllegalBreak { driven });
            choices.extend([Choice::Accept, Choice::Break, Choice::TheyBreak]);
            standing.pass();
        } else if eight_fell {
            choices.extend([Choice::Accept, Choice::Break]);
        } else if broken.potted == 0 {
            standing.pass();
        }
        if !foul {
            let made = facts.object_potted().map(|potted| potted.ball);
            ruling.made = made.filter(|&ball| !is_eight(ball)).collect();
        }
        Phase::Open
    }

    fn judge_later(
        &mut self,
        standing: &mut Standing,
        facts: &Facts,
        call: &Call,
        in_hand: Option<Area>,
        ruling: &mut Ruling,
    ) {
        let mut on = On::default();
        self.targets(standing, facts.scene, &mut on);
        ruling.fouls = pool::general(facts);
        ruling
            .fouls
            .extend(pool::contact(facts, &on.first, in_hand));
        let foul = !ruling.fouls.is_empty();
        let (player, opponent) = (standing.turn, standing.next_player());

        let made: Vec<usize> = facts
            .object_potted()
            .filter(|potted| on.pot.contains(&potted.ball) && pool::is_called(facts, potted, call))
            .map(|potted| potted.ball)
            .filter(|_| !foul && !self.is_void(facts))
            .collect();
        if let Some(eight) = facts.scene.ball_named("8") {
            let gone = facts.potted(eight).is_some() || facts.off.contains(&eight);
            if gone && made.contains(&eight) {
                ruling.made = made;
                standing.end(Some(player), Reason::WinningBall { ball: eight });
                return;
            }
            if gone {
                standing.end(Some(opponent), Reason::LosingBall { ball: eight });
                return;
            }
        }
        if foul {
            pool::hand_over(standing, Area::anywhere(&facts.scene.table));
        } else if made.is_empty() {
            let balls: Vec<usize> = facts.object_potted().map(|potted| potted.ball).collect();
            if *call == Call::Safety {
                ruling.notes.push(Note::Safety);
            } else if !balls.is_empty() {
                ruling.notes.push(Note::NotCalled { balls });
            }
            standing.pass();
        } else {
            standing.barren = 0;
            self.decide_groups(player, opponent, facts, &made, ruling);
        }
        ruling.made = made;
        self.look_for_stalemate(standing, ruling);
    }

    /// Whether nothing potted counts because the 8 was met first on an open table.
    fn is_void(&self, facts: &Facts) -> bool {
        self.phase == Phase::Open
            && self.eight_first_on_open == EightFirst::NoScore
            && facts
                .first
                .iter()
                .all(|&ball| number(facts.scene, ball) == Some(8))
    }

    /// The first ball potted as called on an open table decides the groups.
    fn decide_groups(
        &mut self,
        player: usize,
        opponent: usize,
        facts: &Facts,
        made: &[usize],
        ruling: &mut Ruling,
    ) {
        let first = made.first().and_then(|&ball| number(facts.scene, ball));
        let (Phase::Open, Some(first)) = (self.phase, first) else {
            return;
        };
        let solids = is_solid(first);
        self.phase = Phase::Closed {
            solids: if solids { player } else { opponent },
        };
        ruling.notes.push(Note::Group { player, solids });
    }

    fn look_for_stalemate(&mut self, standing: &mut Standing, ruling: &mut Ruling) {
        let Some(after) = self.stalemate_after else {
            return;
        };
        if standing.barren >= 2 * after {
            ruling.notes.push(Note::Stalemate);
            self.rerack(standing, standing.breaker, ruling);
        } else if standing.barren == after && ruling.made.is_empty() {
            ruling.notes.push(Note::StalemateWarning);
        }
    }

    fn rerack(&mut self, standing: &mut Standing, breaker: usize, ruling: &mut Ruling) {
        self.phase = Phase::Break;
        standing.rerack(breaker);
        standing.in_hand = Some(Area::behind_head_string(&ruling.spotter.scene().table));
        ruling.table = TableChange::Rerack;
    }
}

impl RuleSet for EightBall {
    fn code(&self) -> Code {
        Code {
            name: "8-ball",
            title: "8-ball",
            edition: "WPA rules of play, 23 June 2025",
            equipment: "pool",
        }
    }

    fn settings(&self) -> Vec<Setting> {
        vec![
            setting(
                "eight_first_on_open",
                self.eight_first_on_open,
                "Foul, NoScore or Legal: to meet the 8 first while nobody has a group",
            ),
            setting(
                "stalemate_after",
                self.stalemate_after,
                "turns without a pot before a warning; after as many again the same player breaks again",
            ),
        ]
    }

    fn check(&self, players: usize) -> Result<(), String> {
        match self.phase {
            Phase::Closed { solids } if solids >= players => Err(format!(
                "phase.solids: {solids} is no player, there are {players}"
            )),
            _ => Ok(()),
        }
    }

    fn rack(&self) -> Rack {
        Rack::EightBall
    }

    fn begin(&mut self, standing: &mut Standing, scene: &Scene) {
        self.phase = Phase::Break;
        standing.in_hand = Some(Area::behind_head_string(&scene.table));
    }

    fn targets(&self, standing: &Standing, scene: &Scene, on: &mut On) {
        on.pot = self.wanted(standing.turn, scene);
        on.first = on.pot.clone();
        match self.phase {
            Phase::Break => {
                on.is_break = true;
                on.first = numbered(scene, |_| true);
            }
            Phase::Open => {
                if self.eight_first_on_open != EightFirst::Foul {
                    on.first = numbered(scene, |_| true);
                }
                (on.call_needed, on.may_call_safety) = (CallNeeded::BallAndPocket, true);
            }
            Phase::Closed { .. } => {
                (on.call_needed, on.may_call_safety) = (CallNeeded::BallAndPocket, true);
            }
        }
    }

    fn judge(&mut self, standing: &mut Standing, facts: &Facts, call: &Call, ruling: &mut Ruling) {
        if self.phase == Phase::Break {
            self.phase = Self::judge_break(standing, facts, ruling);
        } else {
            let in_hand = ruling.in_hand;
            self.judge_later(standing, facts, call, in_hand, ruling);
        }
    }

    fn choose(
        &mut self,
        standing: &mut Standing,
        scene: &Scene,
        choice: Choice,
        ruling: &mut Ruling,
    ) {
        match choice {
            Choice::InHand => standing.in_hand = Some(Area::behind_head_string(&scene.table)),
            Choice::Break => self.rerack(standing, standing.turn, ruling),
            Choice::TheyBreak => self.rerack(standing, standing.last_player(), ruling),
            _ => {}
        }
    }
}
