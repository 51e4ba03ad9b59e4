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

/// A leg that is only looked at.
#[derive(Debug)]
pub(super) struct Seen<'a, B> {
    pub body: &'a B,
    pub from: f64,
    pub impacts: u16,
    pub turns: u16,
}

/// A leg without its path.
#[derive(Clone, Copy, Debug, Default)]
struct Mark {
    from: f64,
    impacts: u16,
    turns: u16,
}

/// Where a ball that was turned lies, and where it is at home.
#[derive(Clone, Copy, Debug)]
pub(super) struct Home {
    pub place: u32,
    pub slot: u32,
}

/// The balls whose paths do not just go on, in the order in which they were turned first, counted from one: a ball is
/// known by this number with [`TURNED`], and any other by its slot. Whether a ball was turned is as good as chance, so
/// nothing here depends on it by a branch.
#[derive(Debug)]
pub(super) struct Turned<B> {
    count: u32,
    /// At least so many.
    bodies: Vec<B>,
    homes: Vec<Home>,
    /// The first is that of all balls that were not turned.
    marks: Vec<Mark>,
}

impl<B> Default for Turned<B> {
    fn default() -> Self {
        Self {
            count: 0,
            bodies: Vec::new(),
            homes: Vec::new(),
            marks: vec![Mark::default()],
        }
    }
}

impl<B: Copy> Turned<B> {
    /// Nobody has been turned in a stretch that begins at this time.
    pub fn clear(&mut self, start: f64) {
        self.count = 0;
        self.marks[0].from = start;
    }

    /// The path of a ball; those that were not turned are still on the ones they `began`.
    #[inline(always)]
    pub fn seen<'a>(&'a self, ball: u32, began: &'a [B]) -> Seen<'a, B> {
        let (is_turned, number) = (ball >> 31, ball & !TURNED);
        let list = if is_turned == 0 { began } else { &self.bodies };
        let mark = &self.marks[(number & is_turned.wrapping_neg()) as usize];
        Seen {
            body: &list[(number - is_turned) as usize],
            from: mark.from,
            impacts: mark.impacts,
            turns: mark.turns,
        }
    }

    /// How often a ball has been turned.
    #[inline(always)]
    pub fn turns(&self, ball: u32) -> u16 {
        let number = (ball & !TURNED) & (ball >> 31).wrapping_neg();
        self.marks[number as usize].turns
    }

    /// Slot of a ball.
    #[inline]
    pub fn slot(&self, ball: u32) -> u32 {
        if ball & TURNED == 0 {
            ball
        } else {
            self.homes[(ball & !TURNED) as usize - 1].slot
        }
    }

    /// Puts the ball at a place on another path; what it is known by from now on.
    #[inline(always)]
    pub fn turn(&mut self, ball: u32, place: u32, (body, from, impacts): (B, f64, u16)) -> u32 {
        let is_new = ball & TURNED == 0;
        self.count += u32::from(is_new);
        let number = if is_new { self.count } else { ball & !TURNED };
        let index = number as usize - 1;
        if index == self.bodies.len() {
            self.bodies.push(body);
            self.homes.push(Home { place, slot: ball });
            self.marks.push(Mark::default());
        }
        let turns = self.turns(ball).wrapping_add(1);
        self.bodies[index] = body;
        self.marks[index + 1] = Mark {
            from,
            impacts,
            turns,
        };
        let home = &mut self.homes[index];
        let slot = if is_new { ball } else { home.slot };
        *home = Home { place, slot };
        TURNED | number
    }

    /// Where each is at home, and the path it is on.
    pub fn all(&self) -> impl Iterator<Item = (&Home, &B)> {
        let homes = &self.homes[..self.count as usize];
        homes.iter().zip(&self.bodies)
    }

    /// The same of one of them, by its place in that order.
    pub fn at(&self, index: usize) -> (Home, B) {
        (self.homes[index], self.bodies[index])
    }
}
