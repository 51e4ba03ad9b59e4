//! A stripe of rows of cells: what one thread works on by itself.

use std::ops::Range;

use glam::DVec2;

use crate::physics::ball::Ball;
use crate::physics::laws::Laws;
use crate::physics::roots::RootError;
use crate::physics::table::Table;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::caught::{Caught, Cluster, Leg, Seed};
use crate::sim::stepped::crowd::cells::{Cells, Link, MARKED, Record, Row, Sorted, roomy};
use crate::sim::stepped::crowd::census::Tally;
use crate::sim::stepped::crowd::walls::Walls;

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
    /// How much further a ball may get by a contact before more than its links must be looked at, m.
    pub spare: f64,
    /// The most that any ball linked by cells may get, m.
    pub most: f64,
    /// Largest acceleration, m/s².
    pub bend: f64,
}

impl Stretch<'_> {
    /// The distance of centres at contact, m.
    #[inline]
    pub fn reach(&self) -> f64 {
        2.0 * self.ball.radius
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
        let square = body.velocity(self.start).length_squared();
        tally.speed = tally.speed.max(square);
        tally.squares += square;
        tally.stopped += u64::from(square == 0.0);
        let free = self.freedom(body);
        let mut record = Record::new(middle, (free + self.spare) as f32, slot);
        if free > self.cut {
            record.free = f32::NAN;
        }
        let [column, row] = self.cells.at(middle);
        let key = (row * self.cells.columns + column) as u32;
        let ends = B::BENDS && body.change() <= self.end;
        if ends || !self.walls.is_clear(middle) {
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
    /// Records of balls that may do more than move on.
    pub marked: Vec<u32>,
    /// Balls near each other, both ways.
    pub links: Vec<Link>,
    pub fast: Vec<u32>,
    /// Fast balls that get beyond the stripe.
    pub wide_fast: Vec<u32>,
    /// How far the fastest ball gets from the middle of its path, m.
    pub fastest: f64,
    /// How far a ball has got from the middle of the path it began the stretch on, m.
    pub wander: f64,
    pub caught: Vec<Caught>,
    pub legs: Vec<Leg<B>>,
    pub clusters: Vec<Cluster>,
    pub seeds: Vec<Seed>,
    /// Clusters that reach beyond the stripe.
    pub wide: Vec<u32>,
    /// Caught balls at home elsewhere.
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
            links: Vec::new(),
            fast: Vec::new(),
            wide_fast: Vec::new(),
            fastest: 0.0,
            wander: 0.0,
            caught: Vec::new(),
            legs: Vec::new(),
            clusters: Vec::new(),
            seeds: Vec::new(),
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
        staged.resize(home.len(), (Record::new(DVec2::ZERO, 0.0, 0), ELSEWHERE));
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
            fastest = fastest.max(free);
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
        for &(record, key) in self.staged.iter().chain(&self.coming) {
            if key != ELSEWHERE {
                let cell = &mut self.moving.first[(key - base) as usize];
                *cell -= 1;
                self.moving.records[*cell as usize] = record;
            }
        }
        self.moving.sort_rows(stretch.cells.columns);
        self.still.unlink();
        self.links.clear();
        self.marked.clear();
        self.fast.clear();
        let Sorted { records, slots, .. } = &mut self.moving;
        slots.resize(records.len(), 0);
        for (at, (record, slot)) in (0..).zip(records.iter_mut().zip(slots)) {
            if record.ball & MARKED != 0 {
                record.ball &= !MARKED;
                self.marked.push(at);
            }
            if record.free.is_nan() {
                self.fast.push(at);
            }
            *slot = record.ball;
        }
        self.wander = 0.0;
        self.caught.clear();
        self.legs.clear();
        self.clusters.clear();
        self.seeds.clear();
        self.wide.clear();
        self.foreign.clear();
    }

    /// The records of a row of cells, and the index of the first.
    #[inline]
    pub fn row<'a>(&self, sorted: &'a Sorted, row: usize, columns: usize) -> (usize, &'a [Record]) {
        if sorted.records.is_empty() {
            return (0, &[]);
        }
        let begin = (row - self.rows.start) * columns;
        let (from, to) = (
            sorted.first[begin] as usize,
            sorted.first[begin + columns] as usize,
        );
        (from, &sorted.records[from..to])
    }

    /// Lists the pairs of a row of moving balls here with another row, here or in another stripe, that are near enough to
    /// meet. With `still` the other row is one of balls at rest.
    pub fn find_close(
        &self,
        stretch: &Stretch,
        row: usize,
        (other, other_row, still): (&Self, usize, bool),
        lanes: &Row,
        close: &mut Vec<[u32; 2]>,
    ) {
        let columns = stretch.cells.columns;
        let (begin, mine) = self.row(&self.moving, row, columns);
        let one = place::of(self.index, begin);
        let reach = roomy(stretch.reach());
        // No ball that is linked by cells gets further.
        let most = roomy(stretch.most);
        if row == other_row && !still {
            lanes.pairs(mine, reach, most, |i, k| {
                close.push([one + i as u32, one + k as u32]);
            });
            return;
        }
        let sorted = if still { &other.still } else { &other.moving };
        let mark = if still { place::STILL } else { 0 };
        let two = place::of(other.index, other.row(sorted, other_row, columns).0) | mark;
        lanes.pairs_with(mine, reach, most, |i, k| {
            close.push([one + i as u32, two + k as u32]);
        });
    }

    /// Puts the balls that were caught and are at home here on their last legs, and sums up what was done.
    pub fn commit(&mut self, home: &mut [B]) {
        for (id, ball) in (0..).zip(&self.caught) {
            if ball.place & place::STILL != 0 {
                self.foreign.push(id);
            } else if ball.last != ball.first {
                match home.get_mut((ball.slot as usize).wrapping_sub(self.home.start)) {
                    Some(body) => *body = self.legs[ball.last as usize].body,
                    None => self.foreign.push(id),
                }
            }
        }
        for (index, cluster) in self.clusters.iter().enumerate() {
            if cluster.parent == place::of(self.index, index) {
                let [met, cushions, saturated] = cluster.count;
                self.tally.met += u64::from(met);
                self.tally.cushions += u64::from(cushions);
                self.tally.saturated += u64::from(saturated);
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
    pub fn sort_still(&mut self, cells: &Cells, spare: f64, balls: &[(DVec2, u32)]) {
        let base = self.rows.start * cells.columns;
        let count = self.rows.len() * cells.columns;
        let Sorted { first, .. } = &mut self.still;
        first.clear();
        let cell_of = |place: DVec2| {
            let [column, row] = cells.at(place);
            row * cells.columns + column - base
        };
        if !balls.is_empty() {
            first.resize(count + 1, 0);
        }
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
            self.still.records[at] = Record::new(*place, spare as f32, *slot);
        }
        if !balls.is_empty() {
            self.still.sort_rows(cells.columns);
            let slots = self.still.records.iter().map(|record| record.ball);
            self.still.slots.clear();
            self.still.slots.extend(slots);
        }
    }
}
