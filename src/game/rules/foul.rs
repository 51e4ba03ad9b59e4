//! Fouls; [`super::wording`] has the sentences that explain them.

use serde::{Deserialize, Serialize};

/// What was wrong with a stroke. Balls are indices in the scene, pockets indices in the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Foul {
    /// The cue ball fell.
    Scratch {
        /// Where.
        pocket: usize,
    },
    /// The cue ball left the table.
    CueBallOff,
    /// The cue ball met no ball.
    NoContact,
    /// The cue ball met a ball first that was not on.
    WrongBall {
        /// The ball met.
        hit: usize,
        /// The balls that might have been met.
        on: Vec<usize>,
    },
    /// Nothing was potted, and nothing reached a cushion after the contact.
    NoCushion,
    /// An object ball left the table.
    BallOff {
        /// The ball.
        ball: usize,
    },
    /// From in hand behind the head string the cue ball met a ball behind it without crossing it first.
    BehindString {
        /// The ball met.
        hit: usize,
    },
    /// A break that drove too few balls to cushions, in a game where that is a foul.
    WeakBreak {
        /// Balls driven to cushions.
        driven: usize,
        /// Balls that were needed.
        needed: usize,
    },
    /// A ball was potted that was not on.
    PottedNotOn {
        /// The ball.
        ball: usize,
    },
    /// The cue ball met two balls at once that were not both on.
    Together {
        /// One of them.
        one: usize,
        /// The other.
        other: usize,
    },
    /// The cue ball passed over a ball.
    Jump {
        /// The ball.
        over: usize,
    },
    /// A ball that touched the cue ball was moved by the stroke.
    Push {
        /// The ball.
        ball: usize,
    },
    /// The opponent was left snookered behind the free ball.
    SnookeredBehindFreeBall {
        /// The free ball.
        ball: usize,
    },
    /// The wrong ball was struck with the cue.
    WrongCueBall {
        /// The ball struck.
        struck: usize,
    },
    /// The opponent's frozen ball was shot into.
    IntoFrozen {
        /// The ball.
        ball: usize,
    },
}
