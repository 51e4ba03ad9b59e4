//! What could be played, before it is rehearsed.

use glam::DVec2;

use crate::game::players::chance::Lane;
use crate::game::rules::{Call, CallNeeded, On};

/// What kind of shot it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A ball straight into a pocket.
    Pot,
    /// A ball into a pocket off a cushion.
    Bank,
    /// A ball onto another that falls.
    Combination,
    /// The cue ball off cushions to a hidden ball.
    Kick,
    /// The cue ball over the balls that hide one.
    Jump,
    /// The cue ball around the balls that hide one.
    Masse,
    /// The cue ball from ball to ball.
    Carom,
    /// Nothing is to fall; the other player is to be left nothing.
    Safety,
    /// The cue ball goes where neither player likes it much, under the rule for the stroke after a break.
    PushOut,
    /// The opening stroke.
    Break,
}

/// Which way the shot goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Line {
    /// The cue ball sends the ball of this lane along it.
    Send(Lane),
    /// The cue ball leaves near this angle in rad; how near is to be found out within this spread in rad to either side.
    Search {
        /// Angle in plan, rad.
        angle: f64,
        /// Half the range that is searched, rad.
        spread: f64,
    },
    /// The cue points along this angle in rad.
    Along(f64),
    /// The cue ball passes a ball along this angle or beyond it, and bends back.
    Past {
        /// Angle in plan of the way that grazes the ball, rad.
        angle: f64,
        /// 1 if the ball is passed where angles are larger, −1 on the other side.
        side: f64,
    },
}

/// One idea.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Idea {
    /// What kind of shot.
    pub kind: Kind,
    /// Where the cue ball in hand is put first.
    pub spot: Option<DVec2>,
    /// What is said.
    pub call: Call,
    /// Which way it goes.
    pub line: Line,
    /// How likely it looks, to sort by.
    pub chance: f64,
}

/// What is said before a pot.
#[must_use]
pub fn call_pot(on: &On, ball: usize, pocket: usize) -> Call {
    match on.call_needed {
        CallNeeded::No => Call::Nothing,
        CallNeeded::BallAndPocket => Call::Pot { ball, pocket },
        CallNeeded::Ball => Call::Nominate { ball },
    }
}

/// What is said before a shot that is to pot nothing and meets this ball first.
#[must_use]
pub fn call_safety(on: &On, ball: usize) -> Call {
    match on.call_needed {
        CallNeeded::Ball => Call::Nominate { ball },
        _ if on.may_call_safety => Call::Safety,
        _ => Call::Nothing,
    }
}
