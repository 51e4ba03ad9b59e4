//! Snooker (WPBSA, official rules of the games of snooker and English billiards, November 2019).

mod fouls;
mod turn;

use serde::{Deserialize, Serialize};

use crate::game::rules::area::Area;
use crate::game::rules::call::Call;
use crate::game::rules::facts::Facts;
use crate::game::rules::ruling::Ruling;
use crate::game::rules::snookered::is_snookered;
use crate::game::rules::spot::{Spotter, Touching};
use crate::game::rules::standing::Standing;
use crate::game::rules::targets::{CallNeeded, On, in_play};
use crate::game::rules::verdict::Choice;
use crate::game::rules::{Code, RuleSet, Setting, setting};
use crate::physics::scene::{COLOURS, Rack, Scene, colour_spot};

/// When a miss is called on top of a foul that missed the ball on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum MissRule {
    /// Whenever neither side needs penalty points, as referees of professionals do: some line can always be played.
    #[default]
    Always,
    /// Only if a ball on could be hit by a straight line.
    ClearWay,
    /// Never.
    Never,
}

/// What is on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum BallOn {
    /// Any red.
    #[default]
    Red,
    /// Any colour, after a red.
    Colour,
    /// The colour with this value: no red is left.
    Sequence {
        /// 2 for yellow to 7 for black.
        value: i32,
    },
}

/// How the offender stood before a foul: what comes back if the balls are put back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Before {
    /// What was on.
    pub on: BallOn,
    /// Whether it was a free ball.
    pub free_ball: bool,
    /// Misses in a row with a clear way, the last one included.
    pub misses: u32,
}

/// The rules of snooker, and what is on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Snooker {
    /// When a miss is called.
    pub miss: MissRule,
    /// Misses in a row with a full ball in clear view that lose the frame; 0 for never.
    pub misses_lose: u32,
    /// What is on.
    pub on: BallOn,
    /// Whether the player at the table has a free ball.
    pub free_ball: bool,
    /// Whether the black was spotted again because the scores were level.
    pub respotted: bool,
    /// Misses in a row with a clear way that the player at the table is replaying.
    pub misses: u32,
    /// How the offender stood, while the balls may be put back.
    pub before: Option<Before>,
}

impl Default for Snooker {
    fn default() -> Self {
        Self {
            miss: MissRule::Always,
            misses_lose: 3,
            on: BallOn::Red,
            free_ball: false,
            respotted: false,
            misses: 0,
            before: None,
        }
    }
}

/// The value of a ball: 1 for a red, 2 for yellow to 7 for black, 0 for any other.
#[must_use]
pub fn value(scene: &Scene, ball: usize) -> i32 {
    let Some(ball) = scene.balls.get(ball) else {
        return 0;
    };
    if ball.name.starts_with("red ") {
        return 1;
    }
    let colour = (2..).zip(COLOURS).find(|(_, name)| *name == ball.name);
    colour.map_or(0, |(value, _)| value)
}

/// Balls in play whose value is wanted.
fn valued(scene: &Scene, wanted: impl Fn(i32) -> bool) -> Vec<usize> {
    in_play(scene)
        .filter(|&ball| value(scene, ball) > 0 && wanted(value(scene, ball)))
        .collect()
}

impl BallOn {
    /// The balls on, without a free ball.
    fn balls(self, scene: &Scene) -> Vec<usize> {
        match self {
            Self::Red => valued(scene, |value| value == 1),
            Self::Colour => valued(scene, |value| value > 1),
            Self::Sequence { value } => valued(scene, |other| other == value),
        }
    }

    /// What the ball on is worth; of any colour, what its cheapest is.
    fn worth(self) -> i32 {
        match self {
            Self::Red => 1,
            Self::Colour => 2,
            Self::Sequence { value } => value,
        }
    }

    /// What is on for a player who comes to this table.
    fn fresh(scene: &Scene) -> Option<Self> {
        if !valued(scene, |value| value == 1).is_empty() {
            return Some(Self::Red);
        }
        let least = valued(scene, |_| true)
            .into_iter()
            .map(|ball| value(scene, ball))
            .min()?;
        Some(Self::Sequence { value: least })
    }

    /// The points that are still to be had, with this on.
    fn remaining(self, scene: &Scene) -> i32 {
        let reds = valued(scene, |value| value == 1).len() as i32;
        let colours: i32 = valued(scene, |value| value > 1)
            .into_iter()
            .map(|ball| value(scene, ball))
            .sum();
        let colour = if self == Self::Colour { 7 } else { 0 };
        8 * reds + colour + colours
    }
}

/// Puts colours back on their spots, the most valuable first; where none is free, as near as possible to their own.
fn respot(spotter: &mut Spotter, mut colours: Vec<usize>) {
    colours.sort_by_key(|&ball| -value(spotter.scene(), ball));
    for ball in colours {
        let scene = spotter.scene();
        let spot_of = |name: &str| colour_spot(&scene.table, name);
        let Some(own) = spot_of(&scene.balls[ball].name) else {
            continue;
        };
        let free = std::iter::once(own)
            .chain(COLOURS.iter().rev().filter_map(|name| spot_of(name)))
            .find(|spot| spotter.is_free(ball, *spot, Touching::Nothing));
        match free {
            Some(spot) => spotter.put(ball, spot),
            None => {
                spotter.on_long_line(ball, own, Touching::Nothing);
            }
        }
    }
}

impl Snooker {
    /// The balls that may be hit first, and whose pot counts: those on, and every ball if one may be nominated freely.
    fn hittable(&self, scene: &Scene) -> Vec<usize> {
        if self.free_ball {
            return valued(scene, |_| true);
        }
        self.on.balls(scene)
    }

    /// Whether the player who comes to this table is snookered on everything that is on.
    fn is_snookered(on: BallOn, scene: &Scene, cue: usize, in_hand: Option<Area>) -> bool {
        is_snookered(scene, cue, in_hand, &on.balls(scene))
    }
}

impl RuleSet for Snooker {
    fn code(&self) -> Code {
        Code {
            name: "snooker",
            title: "Snooker",
            edition: "WPBSA official rules, November 2019",
            equipment: "snooker",
        }
    }

    fn settings(&self) -> Vec<Setting> {
        vec![
            setting(
                "miss",
                self.miss,
                "Always, ClearWay or Never: when a foul that missed the ball on is a miss too",
            ),
            setting(
                "misses_lose",
                self.misses_lose,
                "misses in a row with a full ball in clear view that lose the frame; 0 for never",
            ),
        ]
    }

    fn counts_points(&self) -> bool {
        true
    }

    fn check(&self, _players: usize) -> Result<(), String> {
        let before = self.before.map(|before| before.on);
        for on in [Some(self.on), before].into_iter().flatten() {
            match on {
                BallOn::Sequence { value } if !(2..=7).contains(&value) => {
                    return Err(format!(
                        "on.value: {value} is no colour, they are worth 2 to 7"
                    ));
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn rack(&self) -> Rack {
        Rack::Snooker
    }

    fn begin(&mut self, standing: &mut Standing, scene: &Scene) {
        *self = Self {
            miss: self.miss,
            misses_lose: self.misses_lose,
            ..Self::default()
        };
        standing.in_hand = Some(Area::in_d(&scene.table));
    }

    fn targets(&self, standing: &Standing, scene: &Scene, on: &mut On) {
        on.first = self.hittable(scene);
        on.pot = on.first.clone();
        on.free_ball = self.free_ball;
        on.is_break = standing.shots == 0;
        if self.free_ball || self.on == BallOn::Colour {
            on.call_needed = CallNeeded::Ball;
        }
    }

    fn judge(&mut self, standing: &mut Standing, facts: &Facts, call: &Call, ruling: &mut Ruling) {
        self.judge_stroke(standing, facts, call, ruling);
    }

    fn choose(
        &mut self,
        standing: &mut Standing,
        scene: &Scene,
        choice: Choice,
        ruling: &mut Ruling,
    ) {
        self.carry_out(standing, scene, choice, ruling);
    }
}
