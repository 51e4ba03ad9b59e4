//! What is on: for the computer players, the display and the preview.

use serde::{Deserialize, Serialize};

use crate::game::rules::area::Area;
use crate::game::rules::verdict::Choice;
use crate::physics::scene::Scene;

/// What has to be said before the stroke.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum CallNeeded {
    /// Nothing.
    #[default]
    No,
    /// Ball and pocket, unless the shot is obvious.
    BallAndPocket,
    /// A ball.
    Ball,
}

/// What is on for the player at the table.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "what may be called is a list of permissions"
)]
pub struct On {
    /// Index of the ball to strike.
    pub cue: usize,
    /// Balls that the cue ball may meet first.
    pub first: Vec<usize>,
    /// Balls whose pot, as the rules ask, continues the turn or wins.
    pub pot: Vec<usize>,
    /// Pockets that count.
    pub pockets: Vec<usize>,
    /// What has to be said.
    pub call_needed: CallNeeded,
    /// Whether a push out may be called.
    pub may_push_out: bool,
    /// Whether a safety may be called.
    pub may_call_safety: bool,
    /// Where the cue ball may be put down first, if it is in hand.
    pub in_hand: Option<Area>,
    /// What has to be chosen before anything else; empty if nothing has.
    pub choices: Vec<Choice>,
    /// Whether this is the opening stroke.
    pub is_break: bool,
    /// Whether any ball may be nominated as a free ball.
    pub free_ball: bool,
}

/// Object balls in play, by number or name as `wanted` says; the balls of numbered sets are `1` to `15`.
pub(super) fn numbered(scene: &Scene, wanted: impl Fn(u8) -> bool) -> Vec<usize> {
    in_play(scene)
        .filter(|&ball| number(scene, ball).is_some_and(&wanted))
        .collect()
}

/// The number on a ball.
pub(super) fn number(scene: &Scene, ball: usize) -> Option<u8> {
    scene.balls.get(ball)?.name.parse().ok()
}

/// Every ball in play.
pub(super) fn in_play(scene: &Scene) -> impl Iterator<Item = usize> {
    (0..scene.balls.len()).filter(|&ball| scene.balls[ball].state.motion.in_play())
}
