//! Free practice: nothing is wrong, the turn never passes, and what falls is counted.

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use crate::game::rules::area::Area;
use crate::game::rules::call::Call;
use crate::game::rules::facts::Facts;
use crate::game::rules::ruling::Ruling;
use crate::game::rules::standing::Standing;
use crate::game::rules::targets::{On, in_play};
use crate::game::rules::verdict::{Choice, TableChange};
use crate::game::rules::{Code, RuleSet, Setting, setting};
use crate::physics::scene::{Rack, Scene};

/// Free practice with this rack.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct FreePractice {
    /// What is racked, again when all of it has fallen.
    pub rack: Rack,
}

impl Default for FreePractice {
    fn default() -> Self {
        Self {
            rack: Rack::EightBall,
        }
    }
}

impl RuleSet for FreePractice {
    fn code(&self) -> Code {
        Code {
            name: "practice",
            title: "Free practice",
            edition: "no rules",
            equipment: "pool",
        }
    }

    fn settings(&self) -> Vec<Setting> {
        vec![setting(
            "rack",
            self.rack,
            "what is racked, again when all of it has fallen",
        )]
    }

    fn players(&self) -> RangeInclusive<usize> {
        1..=1
    }

    fn has_pockets(&self) -> bool {
        self.rack != Rack::ThreeCushion
    }

    fn counts_points(&self) -> bool {
        true
    }

    fn rack(&self) -> Rack {
        self.rack
    }

    fn begin(&mut self, standing: &mut Standing, scene: &Scene) {
        standing.in_hand = Some(Area::anywhere(&scene.table));
    }

    fn targets(&self, standing: &Standing, scene: &Scene, on: &mut On) {
        let cue = self.cue_ball(standing, scene);
        on.first = in_play(scene).filter(|&ball| ball != cue).collect();
        on.pot.clone_from(&on.first);
    }

    fn judge(&mut self, standing: &mut Standing, facts: &Facts, _call: &Call, ruling: &mut Ruling) {
        ruling.made = facts.object_potted().map(|potted| potted.ball).collect();
        standing.scores[standing.turn] += ruling.made.len() as i32;
        let left = in_play(ruling.spotter.scene())
            .filter(|&ball| ball != facts.cue)
            .count();
        let fell = facts.scratch().is_some() || facts.off.contains(&facts.cue);
        if left == 0 {
            standing.rerack(standing.turn);
            ruling.table = TableChange::Rerack;
        }
        if fell || left == 0 {
            standing.in_hand = Some(Area::anywhere(&facts.scene.table));
        }
    }

    fn choose(&mut self, _: &mut Standing, _: &Scene, _: Choice, _: &mut Ruling) {}
}
