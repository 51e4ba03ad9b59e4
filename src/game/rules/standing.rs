//! What all games have in common: whose turn it is, the score, what may be chosen, whether it is over.

use serde::{Deserialize, Serialize};

use crate::game::rules::area::Area;
use crate::game::rules::verdict::{Choice, Over, Reason};

/// Where a rack, frame or game stands.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Standing {
    /// Number of players.
    pub players: usize,
    /// Who is at the table, or has something to choose.
    pub turn: usize,
    /// Who broke, or breaks.
    pub breaker: usize,
    /// Points of each player.
    pub scores: Vec<i32>,
    /// Fouls in a row of each player.
    pub fouls: Vec<u32>,
    /// Where the cue ball may be put down, if it is in hand.
    pub in_hand: Option<Area>,
    /// What the player at the table has to choose from before playing; empty if there is nothing to choose.
    pub choices: Vec<Choice>,
    /// How it ended, if it did.
    pub over: Option<Over>,
    /// Order of the balls in this rack.
    pub seed: u64,
    /// Strokes played.
    pub shots: u32,
    /// Turns since a ball was last potted as the rules ask.
    pub barren: u32,
}

impl Standing {
    /// Before the first stroke.
    #[must_use]
    pub fn new(players: usize, breaker: usize, seed: u64) -> Self {
        Self {
            players,
            turn: breaker,
            breaker,
            scores: vec![0; players],
            fouls: vec![0; players],
            in_hand: None,
            choices: Vec::new(),
            over: None,
            seed,
            shots: 0,
            barren: 0,
        }
    }

    /// The player who comes after the one at the table; alone one comes after oneself.
    #[must_use]
    pub fn next_player(&self) -> usize {
        (self.turn + 1) % self.players
    }

    /// The player who came before the one at the table.
    #[must_use]
    pub fn last_player(&self) -> usize {
        (self.turn + self.players - 1) % self.players
    }

    /// The turn passes.
    pub fn pass(&mut self) {
        self.turn = self.next_player();
        self.barren += 1;
    }

    /// It is over.
    pub fn end(&mut self, winner: Option<usize>, reason: Reason) {
        self.over = Some(Over { winner, reason });
        self.choices.clear();
        self.in_hand = None;
    }

    /// Counts a foul, or a stroke without one, of the player at the table. Gives the fouls in a row.
    pub fn count_foul(&mut self, foul: bool) -> u32 {
        let fouls = &mut self.fouls[self.turn];
        *fouls = if foul { *fouls + 1 } else { 0 };
        *fouls
    }

    /// The balls are racked again and this player breaks.
    pub fn rerack(&mut self, breaker: usize) {
        self.turn = breaker;
        self.breaker = breaker;
        self.seed = self.seed.wrapping_add(0x9E37_79B9_7F4A_7C15);
        self.fouls.fill(0);
        self.in_hand = None;
        self.choices.clear();
        self.barren = 0;
    }
}
