//! A match: players, racks, score and every shot, as a pure state machine without a world.
//!
//! Ask [`Match::phase`] what comes next. Give it what a player does: [`Match::place`] the cue ball, [`Match::call`],
//! [`Match::played`] with the record of a stroke, [`Match::choose`], [`Match::next_rack`], [`Match::concede`],
//! [`Match::undo`]. Each refuses what is not allowed and then changes nothing.

mod check;
mod inputs;
mod refusals;
pub mod saved;
pub mod saver;
pub mod session;
mod shots;
pub mod statistics;
pub mod store;

pub use refusals::{Hindrance, NoPlace, Refused};
pub use saved::SavedError;
pub use session::Session;
pub use shots::{Lie, PlayedShot};
pub use statistics::Statistics;
pub use store::Store;

use serde::{Deserialize, Serialize};

use crate::game::rules::{Call, Game, GameState, On, Over};
use crate::physics::cue::Shot;
use crate::physics::scene::{PlannedShot, Scene};

/// Who moves the cue of a player.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Mind {
    /// Somebody at this machine.
    Person,
    /// The computer, at the level with this name.
    Computer {
        /// Name of the level.
        level: String,
    },
}

/// A player of a match.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Player {
    /// What others call them.
    pub name: String,
    /// Who moves the cue.
    pub mind: Mind,
}

/// Who breaks the next rack.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Breaks {
    /// The players in turn.
    #[default]
    Alternate,
    /// Who won the last rack.
    Winner,
    /// Who lost the last rack; with more than two players, who comes after the winner.
    Loser,
}

/// What is agreed on before a match.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Setup {
    /// The game with its options.
    pub game: Game,
    /// The players, in the order of their turns.
    pub players: Vec<Player>,
    /// Racks that win the match.
    pub race: u32,
    /// Who breaks after the first rack.
    pub breaks: Breaks,
    /// Who breaks first: index of the player.
    pub first: usize,
    /// Decides the order of the balls in every rack.
    pub seed: u64,
    /// Whether shots may be taken back.
    pub undo: bool,
}

/// The end of one rack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RackEnd {
    /// Which rack, from 0.
    pub rack: u32,
    /// How it ended.
    pub over: Over,
}

/// What a match waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// The player at the table has something to choose.
    Choose,
    /// The player at the table plays; a cue ball in hand may be placed first.
    Play,
    /// The rack is over: [`Match::next_rack`].
    RackOver,
    /// The match is over.
    Over {
        /// Who won; nobody if it is drawn.
        winner: Option<usize>,
    },
}

/// A match.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Match {
    /// What was agreed on.
    pub(super) setup: Setup,
    /// Table, laws, cue and balls, as the first rack was set up.
    pub(super) base: Scene,
    /// Which rack is played, from 0.
    pub(super) rack: u32,
    /// Where the rack stands.
    pub(super) state: GameState,
    /// Where the balls lie.
    pub(super) lie: Lie,
    /// What the player at the table has called.
    pub(super) call: Call,
    /// Every shot so far.
    pub(super) shots: Vec<PlayedShot>,
    /// How the racks so far ended.
    pub(super) ends: Vec<RackEnd>,
}

impl Match {
    /// Sets up the first rack with the table, the laws, the cue and the kinds of balls of a scene.
    ///
    /// # Errors
    /// [`Refused`] if the players, the race or the table do not fit the game.
    pub fn new(setup: Setup, like: &Scene) -> Result<Self, Refused> {
        setup.check(&like.table)?;
        let seed = rack_seed(setup.seed, 0);
        let (state, base) = GameState::start(
            setup.game.clone(),
            setup.players.len(),
            setup.first,
            like,
            seed,
        );
        base.check().map_err(Refused::Scene)?;
        Ok(Self {
            lie: Lie::of(&base),
            base,
            setup,
            rack: 0,
            state,
            call: Call::Nothing,
            shots: Vec::new(),
            ends: Vec::new(),
        })
    }

    /// What was agreed on.
    #[must_use]
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// Where the rack stands.
    #[must_use]
    pub fn state(&self) -> &GameState {
        &self.state
    }

    /// Which rack is played, from 0.
    #[must_use]
    pub fn rack(&self) -> u32 {
        self.rack
    }

    /// Every shot so far.
    #[must_use]
    pub fn shots(&self) -> &[PlayedShot] {
        &self.shots
    }

    /// How the racks so far ended.
    #[must_use]
    pub fn ends(&self) -> &[RackEnd] {
        &self.ends
    }

    /// What the player at the table has called.
    #[must_use]
    pub fn called(&self) -> Call {
        self.call
    }

    /// The table as it lies.
    #[must_use]
    pub fn table(&self) -> Scene {
        self.lie.on(&self.base)
    }

    /// What is on for the player at the table.
    #[must_use]
    pub fn targets(&self) -> On {
        self.state.targets(&self.table())
    }

    /// The table with a stroke of the player at it: what a solver plays.
    #[must_use]
    pub fn scene_with(&self, shot: Shot) -> Scene {
        let mut scene = self.table();
        let ball = self.state.cue_ball(&scene);
        scene.shot = Some(PlannedShot { ball, shot });
        scene
    }

    /// The scene of a shot that was played, the stroke included: solving it plays it again, to the last bit. `None` if there
    /// is no such shot.
    #[must_use]
    pub fn replay(&self, shot: usize) -> Option<Scene> {
        self.shots.get(shot).map(|played| played.scene(&self.base))
    }

    /// Racks won by each player.
    #[must_use]
    pub fn racks_won(&self) -> Vec<u32> {
        let mut won = vec![0; self.setup.players.len()];
        for end in &self.ends {
            if let Some(winner) = end.over.winner.and_then(|winner| won.get_mut(winner)) {
                *winner += 1;
            }
        }
        won
    }

    /// What the match waits for.
    #[must_use]
    pub fn phase(&self) -> Phase {
        let won = self.racks_won();
        if let Some(winner) = won.iter().position(|racks| *racks >= self.setup.race) {
            return Phase::Over {
                winner: Some(winner),
            };
        }
        if self.setup.race == 1 && !self.ends.is_empty() {
            return Phase::Over { winner: None };
        }
        if self.state.standing.over.is_some() {
            Phase::RackOver
        } else if self.state.standing.choices.is_empty() {
            Phase::Play
        } else {
            Phase::Choose
        }
    }

    /// Who breaks the next rack.
    #[must_use]
    fn next_breaker(&self) -> usize {
        let players = self.setup.players.len();
        let in_turn = (self.setup.first + self.rack as usize + 1) % players;
        let last = self.ends.last().and_then(|end| end.over.winner);
        match (self.setup.breaks, last) {
            (Breaks::Winner, Some(winner)) => winner,
            (Breaks::Loser, Some(winner)) => (winner + 1) % players,
            _ => in_turn,
        }
    }
}

/// The seed of a rack: `SplitMix64` (Steele, Lea & Flood 2014) of the seed of the match and the number of the rack.
fn rack_seed(seed: u64, rack: u32) -> u64 {
    let mut mixed = seed.wrapping_add(u64::from(rack + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15));
    mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    mixed ^ (mixed >> 31)
}
