//! Rules of games as pure functions: a table before the stroke, what was called, and the record of the stroke give a
//! [`Verdict`].
//!
//! A [`GameState`] is plain data: which game with which options ([`Game`]), and where it [`Standing`]s. Ask
//! [`GameState::targets`] what is on, [`GameState::judge`] after a stroke, [`GameState::choose`] when there is something
//! to choose, and [`Verdict::table_after`] for the table to play on.
//!
//! A new rule set is one file with a type that is [`RuleSet`], and its line in the list `games!` below.

pub mod area;
pub mod call;
pub mod eight_ball;
pub mod facts;
pub mod foul;
pub mod free;
pub mod jump;
pub mod lag;
pub mod nine_ball;
mod pool;
pub mod rotation;
mod ruling;
pub mod snooker;
pub mod snookered;
pub mod spot;
mod standing;
pub mod straight;
mod targets;
pub mod ten_ball;
pub mod three_cushion;
pub mod verdict;
pub mod wording;

pub use area::Area;
pub use call::Call;
pub use eight_ball::{EightBall, EightFirst};
pub use facts::Facts;
pub use foul::Foul;
pub use free::FreePractice;
pub use nine_ball::NineBall;
pub use ruling::Ruling;
pub use snooker::Snooker;
pub use spot::Spotted;
pub use standing::Standing;
pub use straight::StraightPool;
pub use targets::{CallNeeded, On};
pub use ten_ball::TenBall;
pub use three_cushion::ThreeCushion;
pub use verdict::{Choice, Note, Over, Reason, TableChange, Verdict};

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use crate::game::racking;
use crate::physics::ball::Motion;
use crate::physics::record::Record;
use crate::physics::scene::{Rack, Scene};

/// One option of a rule set, to list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setting {
    /// Its name.
    pub name: &'static str,
    /// Its value.
    pub value: String,
    /// What it may be, and what that means.
    pub meaning: &'static str,
}

/// An option as it is set.
fn setting(name: &'static str, value: impl std::fmt::Debug, meaning: &'static str) -> Setting {
    Setting {
        name,
        value: format!("{value:?}"),
        meaning,
    }
}

/// What a game is called and where its rules come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Code {
    /// What files and commands call the game.
    pub name: &'static str,
    /// Its title.
    pub title: &'static str,
    /// The code and its date.
    pub edition: &'static str,
    /// The built-in equipment that it is played with.
    pub equipment: &'static str,
}

/// The rules of one game: its options, and what it remembers beside the [`Standing`].
pub trait RuleSet {
    /// Name and source.
    fn code(&self) -> Code;

    /// The options as they are set.
    fn settings(&self) -> Vec<Setting>;

    /// For how many players it is.
    fn players(&self) -> RangeInclusive<usize> {
        2..=2
    }

    /// Whether points are counted, else only who wins a rack.
    fn counts_points(&self) -> bool {
        false
    }

    /// Whether what it remembers can be, for this many players: what is asked of a saved game.
    ///
    /// # Errors
    /// The field, its value and what is wrong.
    fn check(&self, _players: usize) -> Result<(), String> {
        Ok(())
    }

    /// Whether it is played on a table with pockets.
    fn has_pockets(&self) -> bool {
        true
    }

    /// How the balls are set up for the opening.
    fn rack(&self) -> Rack;

    /// Forgets the last rack; called before each.
    fn begin(&mut self, standing: &mut Standing, scene: &Scene);

    /// The cue ball of the player at the table.
    fn cue_ball(&self, _standing: &Standing, scene: &Scene) -> usize {
        scene.ball_named("cue").unwrap_or(0)
    }

    /// What is on, apart from what the standing says by itself.
    fn targets(&self, standing: &Standing, scene: &Scene, on: &mut On);

    /// Judges a stroke: changes itself and the standing, writes the rest into the verdict.
    fn judge(&mut self, standing: &mut Standing, facts: &Facts, call: &Call, ruling: &mut Ruling);

    /// Carries out a choice that was offered.
    fn choose(
        &mut self,
        standing: &mut Standing,
        scene: &Scene,
        choice: Choice,
        ruling: &mut Ruling,
    );
}

/// Writes [`Game`] from the list of rule sets.
macro_rules! games {
    ($($(#[doc = $doc:literal])* $name:ident),+ $(,)?) => {
        /// A game with its options and what it remembers.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        pub enum Game {
            $($(#[doc = $doc])* $name($name)),+
        }

        impl Game {
            /// Every game with the options of its preset.
            #[must_use]
            pub fn all() -> Vec<Self> {
                vec![$(Self::$name($name::default())),+]
            }

            /// Its rules.
            #[must_use]
            pub fn rules(&self) -> &dyn RuleSet {
                match self {
                    $(Self::$name(rules) => rules),+
                }
            }

            fn rules_mut(&mut self) -> &mut dyn RuleSet {
                match self {
                    $(Self::$name(rules) => rules),+
                }
            }
        }
    };
}

games! {
    /// 8-ball.
    EightBall,
    /// 9-ball.
    NineBall,
    /// 10-ball.
    TenBall,
    /// Straight pool.
    StraightPool,
    /// Snooker.
    Snooker,
    /// Three-cushion.
    ThreeCushion,
    /// Free practice.
    FreePractice,
}

impl Game {
    /// The game that a person calls by this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::all()
            .into_iter()
            .find(|game| game.rules().code().name == name)
    }
}

/// A rack with its balls in the order of their numbers, so that a ball has the same index in every rack of a match.
fn racked(like: &Scene, rack: Rack, seed: u64) -> Scene {
    let mut scene = racking::racked(like, like.table.clone(), rack, seed);
    // The cue ball and balls without numbers keep their order before the others.
    let number = |name: &str| name.parse::<u8>().unwrap_or(0);
    scene.balls.sort_by_key(|ball| number(&ball.name));
    scene
}

/// Where a game stands: everything that the rules need to know.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GameState {
    /// The game.
    pub game: Game,
    /// What all games have in common.
    pub standing: Standing,
}

impl GameState {
    /// A new rack with the table set up for it, like a scene in everything but the balls. The breaker is a player's index;
    /// the seed decides the order of the balls where it is free.
    #[must_use]
    pub fn start(
        mut game: Game,
        players: usize,
        breaker: usize,
        like: &Scene,
        seed: u64,
    ) -> (Self, Scene) {
        let scene = racked(like, game.rules().rack(), seed);
        let mut standing = Standing::new(players, breaker, seed);
        game.rules_mut().begin(&mut standing, &scene);
        (Self { game, standing }, scene)
    }

    /// Index of the cue ball of the player at the table.
    #[must_use]
    pub fn cue_ball(&self, scene: &Scene) -> usize {
        self.game.rules().cue_ball(&self.standing, scene)
    }

    /// What is on for the player at the table.
    #[must_use]
    pub fn targets(&self, scene: &Scene) -> On {
        let mut on = On {
            cue: self.cue_ball(scene),
            pockets: (0..scene.table.pockets.len()).collect(),
            in_hand: self.standing.in_hand,
            choices: self.standing.choices.clone(),
            ..On::default()
        };
        if self.standing.over.is_none() {
            self.game.rules().targets(&self.standing, scene, &mut on);
        }
        on
    }

    /// Judges a stroke: the table before it, what was called, and what happened.
    #[must_use]
    pub fn judge(&self, before: &Scene, record: &Record, call: &Call) -> Verdict {
        let mut next = self.clone();
        let facts = Facts::new(before, record, self.cue_ball(before));
        let mut after = spot::left_behind(before, &record.end);
        for potted in &facts.potted {
            after.balls[potted.ball].state.motion = Motion::Pocketed;
        }
        let mut ruling = Ruling::new(after, next.standing.in_hand.take());
        for (ball, spot) in &facts.fell_late {
            ruling.spotter.put(*ball, *spot);
            ruling.notes.push(Note::PutBack { ball: *ball });
        }
        let standing = &mut next.standing;
        standing.shots += 1;
        standing.choices.clear();
        next.game
            .rules_mut()
            .judge(standing, &facts, call, &mut ruling);
        let pocketed = facts.object_potted().map(|potted| potted.ball).collect();
        self.verdict(next, ruling, pocketed)
    }

    /// Carries out a choice of the player at the table. `None` if it was not offered.
    #[must_use]
    pub fn choose(&self, scene: &Scene, choice: Choice) -> Option<Verdict> {
        if !self.standing.choices.contains(&choice) {
            return None;
        }
        let mut next = self.clone();
        next.standing.choices.clear();
        let mut ruling = Ruling::new(scene.clone(), None);
        next.game
            .rules_mut()
            .choose(&mut next.standing, scene, choice, &mut ruling);
        Some(self.verdict(next, ruling, Vec::new()))
    }

    fn verdict(&self, next: Self, ruling: Ruling, pocketed: Vec<usize>) -> Verdict {
        let scores = next.standing.scores.iter().zip(&self.standing.scores);
        Verdict {
            fouls: ruling.fouls,
            pocketed,
            made: ruling.made,
            spotted: ruling.spotter.spotted,
            table: ruling.table,
            points: scores.map(|(after, before)| after - before).collect(),
            notes: ruling.notes,
            next,
        }
    }
}
