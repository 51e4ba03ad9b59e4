//! What a rule set says of a stroke while it judges.

use crate::game::rules::area::Area;
use crate::game::rules::foul::Foul;
use crate::game::rules::spot::Spotter;
use crate::game::rules::verdict::{Note, TableChange};
use crate::physics::scene::Scene;

/// Everything that a verdict says beside where the game stands afterwards, see [`super::Verdict`].
#[derive(Clone, Debug)]
pub struct Ruling {
    /// As in the verdict.
    pub fouls: Vec<Foul>,
    /// As in the verdict.
    pub made: Vec<usize>,
    /// Puts balls back; holds the table as the stroke left it.
    pub spotter: Spotter,
    /// As in the verdict.
    pub table: TableChange,
    /// As in the verdict.
    pub notes: Vec<Note>,
    /// Where the cue ball could be put down before the stroke.
    pub in_hand: Option<Area>,
}

impl Ruling {
    /// Begins with the table as the stroke left it, and where the cue ball could be put down before.
    #[must_use]
    pub fn new(left: Scene, in_hand: Option<Area>) -> Self {
        Self {
            fouls: Vec::new(),
            made: Vec::new(),
            spotter: Spotter::new(left),
            table: TableChange::Keep,
            notes: Vec::new(),
            in_hand,
        }
    }
}
