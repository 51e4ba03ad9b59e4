//! 10-ball (WPA rules of play, edition of 23 June 2025).

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use crate::game::rules::area::Area;
use crate::game::rules::call::Call;
use crate::game::rules::facts::Facts;
use crate::game::rules::pool;
use crate::game::rules::rotation::{self, Clean, Phase};
use crate::game::rules::ruling::Ruling;
use crate::game::rules::standing::Standing;
use crate::game::rules::targets::{CallNeeded, On, numbered};
use crate::game::rules::verdict::{Choice, Note, Reason};
use crate::game::rules::{Code, RuleSet, Setting, setting};
use crate::physics::scene::{Rack, Scene};

/// Which pots have to be called. Codes differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Calls {
    /// Every pot.
    #[default]
    EveryBall,
    /// Only that of the 10.
    TenOnly,
}

/// What a 10 called and potted before the other balls is worth. Codes differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum EarlyTen {
    /// It wins.
    #[default]
    Wins,
    /// It is spotted, and the turn goes on.
    Spotted,
}

/// The rules of 10-ball, and how far the rack has come.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct TenBall {
    /// Which pots have to be called.
    pub calls: Calls,
    /// What a 10 before the other balls is worth.
    pub early_ten: EarlyTen,
    /// Whether three fouls in a row lose the rack.
    pub three_fouls: bool,
    /// How far the rack has come.
    pub phase: Phase,
}

impl Default for TenBall {
    fn default() -> Self {
        Self {
            calls: Calls::EveryBall,
            early_ten: EarlyTen::Wins,
            three_fouls: true,
            phase: Phase::Break,
        }
    }
}

impl TenBall {
    /// Balls that count as potted as they must be.
    fn made(&self, facts: &Facts, call: &Call, ten: Option<usize>) -> Vec<usize> {
        facts
            .object_potted()
            .filter(|potted| {
                let free = self.calls == Calls::TenOnly && Some(potted.ball) != ten;
                (free && *call != Call::Safety) || pool::is_called(facts, potted, call)
            })
            .map(|potted| potted.ball)
            .collect()
    }

    fn after_good(
        &self,
        standing: &mut Standing,
        facts: &Facts,
        call: &Call,
        ten: Option<usize>,
        ruling: &mut Ruling,
    ) {
        let made = self.made(facts, call, ten);
        let fell: Vec<usize> = facts.object_potted().map(|potted| potted.ball).collect();
        let ten_made = ten.filter(|ten| made.contains(ten));
        if let Some(ball) = ten_made {
            let alone = numbered(facts.scene, |number| number != 10).is_empty();
            if self.early_ten == EarlyTen::Wins || alone {
                standing.end(Some(standing.turn), Reason::WinningBall { ball });
                ruling.made = made;
                return;
            }
        }
        rotation::spot_if_gone(facts, ten, ruling);
        if !made.is_empty() {
            standing.barren = 0;
        } else if fell.is_empty() {
            standing.pass();
        } else {
            ruling.notes.push(match call {
                Call::Safety => Note::Safety,
                _ => Note::NotCalled { balls: fell },
            });
            rotation::offer_hand_back(standing);
        }
        ruling.made = made;
    }
}

impl RuleSet for TenBall {
    fn code(&self) -> Code {
        Code {
            name: "10-ball",
            title: "10-ball",
            edition: "WPA rules of play, 23 June 2025",
            equipment: "pool",
        }
    }

    fn settings(&self) -> Vec<Setting> {
        vec![
            setting(
                "calls",
                self.calls,
                "EveryBall or TenOnly: which pots have to be called",
            ),
            setting(
                "early_ten",
                self.early_ten,
                "Wins or Spotted: the 10, called and potted before the other balls",
            ),
            setting(
                "three_fouls",
                self.three_fouls,
                "three fouls in a row lose the rack, with a warning after the second",
            ),
        ]
    }

    fn players(&self) -> RangeInclusive<usize> {
        2..=8
    }

    fn rack(&self) -> Rack {
        Rack::TenBall
    }

    fn begin(&mut self, standing: &mut Standing, scene: &Scene) {
        self.phase = Phase::Break;
        standing.in_hand = Some(Area::behind_head_string(&scene.table));
    }

    fn targets(&self, _standing: &Standing, scene: &Scene, on: &mut On) {
        on.first = rotation::lowest(scene);
        on.pot = numbered(scene, |_| true);
        on.is_break = self.phase == Phase::Break;
        on.may_push_out = self.phase == Phase::PushOut;
        on.may_call_safety = self.phase != Phase::Break;
        if on.may_call_safety {
            on.call_needed = CallNeeded::BallAndPocket;
        }
    }

    fn judge(&mut self, standing: &mut Standing, facts: &Facts, call: &Call, ruling: &mut Ruling) {
        let ten = facts.scene.ball_named("10");
        let held = (ten, self.three_fouls);
        let clean = rotation::judge(&mut self.phase, held, standing, facts, call, ruling);
        match clean {
            Some(Clean::Break) => {
                // Nothing is called on the break: whatever falls keeps the table, and the 10 comes back.
                self.phase = Phase::PushOut;
                rotation::spot_if_gone(facts, ten, ruling);
                ruling.made = facts.object_potted().map(|potted| potted.ball).collect();
                if ruling.made.is_empty() {
                    standing.pass();
                }
            }
            Some(Clean::Later) => self.after_good(standing, facts, call, ten, ruling),
            None => {}
        }
    }

    fn choose(
        &mut self,
        standing: &mut Standing,
        _scene: &Scene,
        choice: Choice,
        _ruling: &mut Ruling,
    ) {
        rotation::choose(standing, choice);
    }
}
