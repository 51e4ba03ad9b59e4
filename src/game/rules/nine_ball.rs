//! 9-ball (WPA rules of play, edition of 23 June 2025).

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use crate::game::rules::area::Area;
use crate::game::rules::call::Call;
use crate::game::rules::facts::Facts;
use crate::game::rules::rotation::{self, Clean, Phase};
use crate::game::rules::ruling::Ruling;
use crate::game::rules::standing::Standing;
use crate::game::rules::targets::{On, numbered};
use crate::game::rules::verdict::{Choice, Note, Reason};
use crate::game::rules::{Code, RuleSet, Setting, setting};
use crate::physics::scene::{Rack, Scene};

/// Balls that the optional rule for breaks asks for.
const BREAK_POINTS: usize = 3;

/// The rules of 9-ball, and how far the rack has come.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct NineBall {
    /// Whether the 9 is racked on the foot spot, else the 1.
    pub nine_on_foot_spot: bool,
    /// Whether a break has to make three points.
    pub three_point_break: bool,
    /// Whether three fouls in a row lose the rack.
    pub three_fouls: bool,
    /// How far the rack has come.
    pub phase: Phase,
}

impl Default for NineBall {
    fn default() -> Self {
        Self {
            nine_on_foot_spot: true,
            three_point_break: false,
            three_fouls: true,
            phase: Phase::Break,
        }
    }
}

impl NineBall {
    fn after_break(&mut self, standing: &mut Standing, facts: &Facts, ruling: &mut Ruling) {
        let nine = facts.scene.ball_named("9");
        let points = rotation::break_points(facts);
        if self.three_point_break && points < BREAK_POINTS {
            self.phase = Phase::Later;
            ruling.notes.push(Note::ThreePointBreak { points });
            rotation::spot_if_gone(facts, nine, ruling);
            rotation::offer_hand_back(standing);
        } else {
            self.phase = Phase::PushOut;
            Self::after_good(standing, facts, ruling);
        }
    }

    /// After a stroke without a foul: the 9 wins, any ball continues.
    fn after_good(standing: &mut Standing, facts: &Facts, ruling: &mut Ruling) {
        let nine = facts.scene.ball_named("9");
        ruling.made = facts.object_potted().map(|potted| potted.ball).collect();
        if let Some(ball) = nine.filter(|ball| ruling.made.contains(ball)) {
            standing.end(Some(standing.turn), Reason::WinningBall { ball });
        } else if ruling.made.is_empty() {
            standing.pass();
        } else {
            standing.barren = 0;
        }
    }
}

impl RuleSet for NineBall {
    fn code(&self) -> Code {
        Code {
            name: "9-ball",
            title: "9-ball",
            edition: "WPA rules of play, 23 June 2025",
            equipment: "pool",
        }
    }

    fn settings(&self) -> Vec<Setting> {
        vec![
            setting(
                "nine_on_foot_spot",
                self.nine_on_foot_spot,
                "the 9 is racked on the foot spot, else the 1",
            ),
            setting(
                "three_point_break",
                self.three_point_break,
                "a break must make three points: balls potted and balls that reach the head string",
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
        if self.nine_on_foot_spot {
            Rack::NineOnSpot
        } else {
            Rack::NineBall
        }
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
    }

    fn judge(&mut self, standing: &mut Standing, facts: &Facts, call: &Call, ruling: &mut Ruling) {
        let held = (facts.scene.ball_named("9"), self.three_fouls);
        let clean = rotation::judge(&mut self.phase, held, standing, facts, call, ruling);
        match clean {
            Some(Clean::Break) => self.after_break(standing, facts, ruling),
            Some(Clean::Later) => Self::after_good(standing, facts, ruling),
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
