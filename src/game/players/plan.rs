//! What a player has decided, and what led there.

use glam::DVec2;

use crate::game::players::idea::Kind;
use crate::game::rules::Call;
use crate::physics::cue::Shot;

/// A shot with everything that goes with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// What kind of shot it is.
    pub kind: Kind,
    /// Where the cue ball in hand is put first; none if it is not in hand.
    pub spot: Option<DVec2>,
    /// What is said.
    pub call: Call,
    /// The stroke.
    pub shot: Shot,
    /// Probability of winning that the player sees in it.
    pub value: f64,
    /// Probability with which it works, as the player sees it.
    pub chance: f64,
}

/// How far a thought has come: to show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// From 0 to 1.
    pub share: f64,
    /// Shots rehearsed so far.
    pub trials: u32,
    /// The best shot so far.
    pub best: Option<Plan>,
}
