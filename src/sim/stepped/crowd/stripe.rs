//! A stripe of rows of cells: what one thread works on by itself.

use std::ops::Range;

use glam::DVec2;

use crate::physics::ball::Ball;
use crate::physics::laws::Laws;
use crate::physics::roots::RootError;
use crate::physics::table::Table;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::cells::{Cells, MARKED, Record, Sorted};
use crate::sim::stepped::crowd::census::Tally;
use crate::sim::stepped::crowd::rows::Near;
use crate::sim::stepped::crowd::turned::{Contact, Turned};
use crate::sim::stepped::crowd::walls::Walls;

/// How much two balls may overlap before they are set apart, as a share of their distance at contact.
const DEEP: f64 = 1e-4;

/// What holds for all balls during one stretch of time: the tick, or a part of it. Times are on the clock of the crowd.
#[derive(Clone, Copy)]
pub(super) struct Stretch<'a> {
    pub laws: &'a Laws,
    pub table: &'a Table,
    /// The constants of every ball.
    pub ball: Ball,
    pub walls: &'a Walls,
    pub cells: Cells,
    pub start: f64,
    pub end: f64,
    /// Balls that get further than this from the middle of their path are looked after one by one, m.
    pub cut: f64,
    /// Largest acceleration, m/s².
    pub bend: f64,
}

impl Stretch<'_> {
    /// The distance of centres at contact, m.
    #[inline]
    pub fn reach(&self) -> f64 {
        2.0 * self.ball.radius
    }

    /// What two balls must come near enough to meet.
    pub fn near(&self) -> Near {
        let size = f64::max(self.table.length, self.table.width);
        let rounding = 1e-5 * self.reach() + 4.0 * f64::from(f32::EPSILON) * size;
        let length = self.end - self.start;
        let wide = self.reach() + length * length * self.bend + rounding;
        Near {
            wide: wide as f32,
            edge: (wide + 2.0 * self.cut + rounding) as f32,
        }
    }

    /// Two balls nearer than this are set apart, m²: a contact that was seen in time is off by rounding only.
    #[inline]
    pub fn least_square(&self) -> f64 {
        let least = self.reach() * (1.0 - DEEP);
        least * least
    }

    /// How far a ball gets from the middle of the path it began on, m.
    #[inline]
    pub fn freedom<B: Body>(&self, body: &B) -> f64 {
        let length = self.end - self.start;
        let square = body.velocity(self.start).length_squared();
        let free = 0.5 * length * f64::from((square as f32).sqrt());
        if B::BENDS && square > 0.0 {
            free + 0.5 * length * length * self.bend
        } else {
            free
        }
    }

    #[inline]
    pub fn is_fast<B: Body>(&self, body: &B) -> bool {
        self.freedom(body) > self.cut
    }

    /// A ball as its cell knows it, the cell, and how far it gets.
    #[inline]
    pub fn record<B: Body>(&self, body: &B, slot: u32, tally: &mut Tally) -> (Record, u32, f64) {
        let length = self.end - self.start;
        let middle = body.position(self.start + 0.5 * length);
        let velocity = body.velocity(self.start);
        let square = velocity.length_squared();
        tally.speed = if square > tally.speed {
            square
        } else {
            tally.speed
        };
        tally.squares += square;
        tally.stopped += u64::from(square == 0.0);
        let free = self.freedom(body);
        let mut record = Record::new(middle, length * velocity, slot);
        let [column, row] = self.cells.at(middle);
        let key = (row * self.cells.columns + column) as u32;
        let is_fast = free > self.cut;
        let ends = B::BENDS && body.change() <= self.end;
        if is_fast || ends || !self.walls.is_clear(middle) {
            record.ball |= MARKED;
        }
        (record, key, free)
    }

    /// How far a ball gets from the middle of its path between `from` and the end, m.
    #[inline]
    pub fn extent<B: Body>(&self, body: &B, from: f64) -> f64 {
        let left = self.end - from;
        let speed = body.velocity(from).length();
        let bend = if B::BENDS { left * self.bend } else { 0.0 };
        0.5 * left * (speed + bend)
    }
}

/// Where a ball lies: the stripe and the index of its record there.
pub(super) mod place {
    /// Bits of the index in a stripe.
    pub const BITS: u32 = 24;
    /// Most stripes.
    pub const STRIPES: usize = 64;
    /// Marks a place among the balls that rested when they were last sorted.
    pub const STILL: u32 = 1 << 31;
    const INDEX: u32 = (1 << BITS) - 1;

    #[inline]
    pub fn of(stripe: usize, index: usize) -> u32 {
        (stripe as u32) << BITS | index as u32
    }

    #[inline]
    pub fn stripe(place: u32) -> usize {
        (place >> BITS) as usize & (STRIPES - 1)
    }

    #[inline]
    pub fn index(place: u32) -> usize {
        (place & INDEX) as usize
    }
}

/// The key of a ball that is in another stripe.
const ELSEWHERE: u32 = u32::MAX;

/// A stripe and the scratch memory of its work.
pub(super) struct Stripe<B> {
    pub index: usize,
    pub rows: Range<usize>,
    /// The balls that were here when they were last sorted.
    pub home: Range<usize>,
    staged: Vec<(Record, u32)>,
    /// Balls that have left for another stripe, and where they are.
    pub leaving: Vec<(Record, u32)>,
    pub coming: Vec<(Record, u32)>,
    pub moving: Sorted,
    pub still: Sorted,
    /// Records of balls that may do more than move on, in order.
    pub marked: Vec<u32>,
    /// How far the fastest ball gets from the middle of its path, m.
    pub fastest: f64,
    /// How far a ball that was turned gets from the middle of the path it began the stretch on, m.
    pub wander: f64,
    pub turned: Vec<Turned<B>>,
    /// Contacts that wait.
    pub waiting: Vec<Contact>,
    /// Balls that may meet something beyond the stripe.
    pub wide: Vec<u32>,
    /// Turned balls at home elsewhere.
    pub foreign: Vec<u32>,
    pub tally: Tally,
    pub failure: Option<(u32, RootError)>,
}

impl<B: Body> Stripe<B> {
    pub fn new(index: usize, rows: Range<usize>, home: Range<usize>) -> Self {
        Self {
            index,
            rows,
            home,
            staged: Vec::new(),
            leaving: Vec::new(),
            coming: Vec::new(),
            moving: Sorted::default(),
            still: Sorted::default(),
            marked: Vec::new(),
            fastest: 0.0,
            wander: 0.0,
            turned: Vec::new(),
            waiting: Vec::new(),
            wide: Vec::new(),
            foreign: Vec::new(),
            tally: Tally::default(),
            failure: None,
        }
    }

    /// Finds the cells of the balls at home here.
    pub fn stage(&mut self, stretch: &Stretch, bodies: &[B]) {
        let cells = stretch.cells;
        self.failure = None;
        self.leaving.clear();
        self.coming.clear();
        self.fastest = 0.0;
        let count = self.rows.len() * cells.columns;
        self.moving.first.clear();
        self.moving.first.resize(count + 1, 0);
        let base = self.rows.start * cells.columns;
        let home = self.home.clone();
        let mut staged = std::mem::take(&mut self.staged);
        staged.resize(
            home.len(),
            (Record::new(DVec2::ZERO, DVec2::ZERO, 0), ELSEWHERE),
        );
        let (mut fastest, mut tally) = (0.0_f64, Tally::default());
        for (slot, (body, staged)) in
            (home.start as u32..).zip(bodies[home].iter().zip(&mut staged))
        {
            let (record, key, free) = stretch.record(body, slot, &mut tally);
            let cell = (key as usize).wrapping_sub(base);
            *staged = (record, key);
            if cell < count {
                self.moving.first[cell] += 1;
            } else {
                self.leaving.push((record, key));
                staged.1 = ELSEWHERE;
            }
            fastest = if free > fastest { free } else { fastest };
        }
        self.staged = staged;
        (self.fastest, self.tally) = (fastest, tally);
    }

    /// The row of a key.
    pub fn row_of(key: u32, columns: usize) -> usize {
        key as usize / columns
    }

    /// Sorts the records of the balls that are here by cell.
    pub fn scatter(&mut self, stretch: &Stretch) {
        let base = (self.rows.start * stretch.cells.columns) as u32;
        let Sorted { first, .. } = &mut self.moving;
        for (_, key) in &self.coming {
            first[(key - base) as usize] += 1;
        }
        let mut sum = 0;
        for first in first.iter_mut() {
            sum += *first;
            *first = sum;
        }
        self.moving.resize(sum as usize);
        self.marked.clear();
        for (record, key) in self.staged.iter().chain(&self.coming) {
            if *key != ELSEWHERE {
                let cell = &mut self.moving.first[(key - base) as usize];
                *cell -= 1;
                let at = *cell as usize;
                self.moving.records[at] = *record;
            }
        }
        self.moving.sort_rows(stretch.cells.columns);
        for (at, record) in (0..).zip(&mut self.moving.records) {
            if record.ball & MARKED != 0 {
                record.ball &= !MARKED;
                self.marked.push(at);
            }
        }
        self.moving.list();
        self.wander = 0.0;
        self.turned.clear();
        self.waiting.clear();
        self.wide.clear();
        self.foreign.clear();
    }

    /// Lists the pairs of a row of moving balls here with another row, here or in another stripe, that may meet. With
    /// `still` the other row is one of balls at rest.
    pub fn find_close(
        &self,
        stretch: &Stretch,
        row: usize,
        (other, other_row, still): (&Self, usize, bool),
        close: &mut Vec<[u32; 2]>,
    ) {
        let columns = stretch.cells.columns;
        let sorted = if still { &other.still } else { &other.moving };
        let mark = if still { place::STILL } else { 0 };
        let (one, two) = (place::of(self.index, 0), place::of(other.index, 0) | mark);
        let (mine, near) = (
            self.moving.row(row - self.rows.start, columns),
            stretch.near(),
        );
        if row == other_row && !still {
            let take = |i, k| close.push([one + i, one + k]);
            self.moving.lanes.pairs(mine, near, take);
        } else {
            let theirs = sorted.row(other_row - other.rows.start, columns);
            let take = |i, k| close.push([one + i, two + k]);
            self.moving
                .lanes
                .pairs_with(mine, &sorted.lanes, theirs, near, take);
        }
    }

    /// Puts the balls that were turned and are at home here on their last paths.
    pub fn commit(&mut self, home: &mut [B]) {
        for (id, ball) in (0..).zip(&self.turned) {
            let at = (ball.slot as usize).wrapping_sub(self.home.start);
            match home.get_mut(at) {
                Some(body) if ball.place & place::STILL == 0 => *body = ball.leg.body,
                _ => self.foreign.push(id),
            }
        }
    }

    /// The records that hold a place here.
    #[inline]
    pub fn sorted(&self, place: u32) -> &Sorted {
        if place & place::STILL == 0 {
            &self.moving
        } else {
            &self.still
        }
    }

    #[inline]
    pub fn sorted_mut(&mut self, place: u32) -> &mut Sorted {
        if place & place::STILL == 0 {
            &mut self.moving
        } else {
            &mut self.still
        }
    }

    /// Sorts balls at rest, given with the places where they lie.
    pub fn sort_still(&mut self, cells: &Cells, balls: &[(DVec2, u32)]) {
        let base = self.rows.start * cells.columns;
        let count = self.rows.len() * cells.columns;
        let Sorted { first, .. } = &mut self.still;
        first.clear();
        if balls.is_empty() {
            return;
        }
        first.resize(count + 1, 0);
        let cell_of = |place: DVec2| {
            let [column, row] = cells.at(place);
            row * cells.columns + column - base
        };
        for (place, _) in balls {
            first[cell_of(*place)] += 1;
        }
        let mut sum = 0;
        for first in first.iter_mut() {
            sum += *first;
            *first = sum;
        }
        self.still.resize(sum as usize);
        for (place, slot) in balls {
            let cell = &mut self.still.first[cell_of(*place)];
            *cell -= 1;
            let at = *cell as usize;
            self.still.records[at] = Record::new(*place, DVec2::ZERO, *slot);
        }
        self.still.sort_rows(cells.columns);
        self.still.list();
    }
}
