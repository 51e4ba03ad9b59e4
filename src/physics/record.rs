//! What happened: the ordered events of a shot and the closed-form pieces of every path.

use serde::{Deserialize, Serialize};

use crate::physics::ball::{Motion, State};
use crate::physics::laws::motion::Piece;

/// One ball at one event.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Participant {
    /// Index of the ball in the scene.
    pub ball: usize,
    /// Just before the event.
    pub before: State,
    /// Just after the event.
    pub after: State,
}

/// What kind of event.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum EventKind {
    /// The cue struck a ball.
    Strike {
        /// The tip slipped off.
        miscue: bool,
    },
    /// Two balls met.
    BallBall,
    /// A ball met a cushion.
    Cushion {
        /// Index of the cushion in the table.
        cushion: usize,
    },
    /// A ball came down on the slate.
    Slate,
    /// A falling ball met the rim or the liner of a pocket.
    Rim {
        /// Index of the pocket in the table.
        pocket: usize,
    },
    /// A ball left the table.
    OffTable,
    /// A pocket took a ball.
    Pocketed {
        /// Index of the pocket in the table.
        pocket: usize,
    },
    /// A ball changed its kind of motion on its own: slide to roll, roll to rest.
    Motion {
        /// The kind before.
        from: Motion,
        /// The kind after.
        to: Motion,
    },
}

/// One event.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// Seconds since the start of the scene.
    pub time: f64,
    /// What happened.
    pub kind: EventKind,
    /// The ball it happened to.
    pub first: Participant,
    /// The other ball of a collision.
    pub second: Option<Participant>,
    /// Impulse in N s; zero for pockets and changes of motion.
    pub impulse: f64,
}

impl Event {
    /// The balls that took part.
    pub fn participants(&self) -> impl Iterator<Item = &Participant> {
        std::iter::once(&self.first).chain(self.second.as_ref())
    }
}

/// Why a simulation ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum EndReason {
    /// Every ball came to rest or was pocketed.
    Rest,
    /// The time limit of the scene was reached.
    TimeLimit,
    /// The event limit was reached.
    EventLimit,
    /// Nothing can ever happen again, though balls still move.
    Quiet,
}

/// A closed-form piece of one ball's path, from `time` until the next piece of that ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPiece {
    /// Seconds since the start of the scene at which the piece begins.
    pub time: f64,
    /// The path.
    pub piece: Piece,
}

/// Everything that happened in a scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// Events in order of time.
    pub events: Vec<Event>,
    /// For each ball the pieces of its path in order of time.
    pub paths: Vec<Vec<PathPiece>>,
    /// State of each ball at the end.
    pub end: Vec<State>,
    /// Time of the end in s.
    pub end_time: f64,
    /// Why it ended.
    pub reason: Option<EndReason>,
}

impl Record {
    /// The state of a ball at any time between the start and the end.
    #[must_use]
    pub fn state_at(&self, ball: usize, time: f64) -> State {
        if time >= self.end_time {
            return self.end[ball];
        }
        let pieces = &self.paths[ball];
        let next = pieces.partition_point(|piece| piece.time <= time);
        let current = &pieces[next.saturating_sub(1)];
        current.piece.at((time - current.time).max(0.0))
    }
}
