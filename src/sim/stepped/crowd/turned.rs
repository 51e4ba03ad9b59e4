//! Balls on other paths than those they began the tick on, and what will happen.
#![expect(
    clippy::inline_always,
    reason = "the innermost loops of a tick: a call would cost as much as the work"
)]

use crate::sim::stepped::crowd::cells::TURNED;

/// No ball, no contact.
pub(super) const NONE: u32 = u32::MAX;
/// What a contact is. At the same time changes of motion come first, then cushions, then balls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    /// The kind of motion changes.
    Change,
    /// The ball meets the cushion of this index.
    Cushion(u32),
    /// It meets the ball at this place.
    Ball(u32),
}

/// One thing that will happen if no path changes before.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact {
    /// Time on the clock of the crowd, s.
    pub time: f64,
    /// Place of the ball.
    pub ball: u32,
    pub kind: Kind,
    /// How often the two had been turned when it was found.
    pub turns: [u16; 2],
}

impl Contact {
    /// Whether it comes after another.
    #[inline]
    pub fn is_after(&self, other: &Self) -> bool {
        let order = |contact: &Self| (contact.kind, contact.ball);
        self.time > other.time || self.time == other.time && order(self) > order(other)
    }

    /// The other ball, or [`NONE`].
    #[inline]
    pub fn other(&self) -> u32 {
        match self.kind {
            Kind::Ball(other) => other,
            Kind::Change | Kind::Cushion(_) => NONE,
        }
    }
}

/// The path a ball is on, since when, and what it met before in this stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg<B> {
    pub body: B,
    pub from: f64,
    pub impacts: u16,
    /// How often it has been turned.
    pub turns: u16,
}

impl<B> Leg<B> {
    /// The same without a copy of the body.
    #[inline(always)]
    pub fn seen(&self) -> Seen<'_, B> {
        Seen {
            body: &self.body,
            from: self.from,
            impacts: self.impacts,
            turns: self.turns,
        }
    }
}

/// A leg that is only looked at.
#[derive(Debug)]
pub(super) struct Seen<'a, B> {
    pub body: &'a B,
    pub from: f64,
    pub impacts: u16,
    pub turns: u16,
}

/// A ball whose path does not just go on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turned<B> {
    pub leg: Leg<B>,
    pub place: u32,
    pub slot: u32,
}

/// Index among the turned of a ball that is one of them.
#[inline]
pub(super) fn turned(ball: u32) -> Option<usize> {
    (ball & TURNED != 0).then_some((ball & !TURNED) as usize)
}
