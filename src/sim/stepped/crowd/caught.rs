//! What is known of balls whose paths do not just go on: legs, contacts, clusters.

use std::cmp::Ordering;

/// No ball, leg, seed.
pub(super) const NONE: u32 = u32::MAX;

/// What will happen to a ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Its kind of motion changes.
    Change,
    /// It meets the cushion of this index.
    Cushion(u32),
    /// It meets another caught ball.
    Ball(u32),
}

/// One thing that will happen if no path changes before.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact {
    /// Time on the clock of the crowd, s.
    pub time: f64,
    /// Which of two contacts at the same time comes first: kind, then numbers of the scene.
    pub order: u64,
    /// The caught ball.
    pub ball: u32,
    pub kind: Kind,
    /// The legs of the two balls it was found for.
    pub legs: [u32; 2],
}

impl Contact {
    /// The order of a change of motion, a cushion or a ball at the same time.
    pub fn order(kind: u64, other: u32, ball: u32) -> u64 {
        kind << 62 | u64::from(other) << 31 | u64::from(ball)
    }
}

impl PartialEq for Contact {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Contact {}

impl PartialOrd for Contact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Contact {
    /// The earliest is the greatest, as the heap wants it.
    fn cmp(&self, other: &Self) -> Ordering {
        let times = other.time.total_cmp(&self.time);
        times.then_with(|| other.order.cmp(&self.order))
    }
}

/// A ball whose path does not just go on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Caught {
    pub place: u32,
    pub slot: u32,
    /// Index in the scene.
    pub number: u32,
    /// The leg it began the stretch on, and the last one.
    pub first: u32,
    pub last: u32,
    pub impacts: u32,
    /// How far it may get before more than its links must be looked at.
    pub free: f32,
    /// When it leaves the leg it began on, and until when that leg has been held against all others.
    pub turn: f64,
    pub held: f64,
    pub cluster: u32,
    /// The next ball of the cluster.
    pub next: u32,
}

/// A leg of the path of a caught ball.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg<B> {
    pub body: B,
    pub from: f64,
    /// The leg before.
    pub before: u32,
}

/// A contact of two balls on the paths they began the stretch on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seed {
    pub contact: Contact,
    pub next: u32,
}

/// Balls and seeds as chains, with the first and the last of each.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cluster {
    /// The cluster that has taken this one up; itself if none.
    pub parent: u32,
    pub balls: [u32; 2],
    pub seeds: [u32; 2],
    pub solved: bool,
    /// Contacts with balls, with cushions, and balls that no longer bounce.
    pub count: [u32; 3],
}
