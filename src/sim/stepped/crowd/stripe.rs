//! A stripe of rows of cells: what one thread works on by itself.

use std::ops::Range;

use glam::DVec2;

use crate::physics::roots::RootError;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::cells::{Cells, Record, Sorted};
use crate::sim::stepped::crowd::census::Tally;
use crate::sim::stepped::crowd::frame::{Frame, Wander};
use crate::sim::stepped::crowd::pairs::Close;
use crate::sim::stepped::crowd::stretch::Stretch;
use crate::sim::stepped::crowd::turned::{Contact, Turned};

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
    /// How far a ball that was turned gets from the middle of the path it began the stretch on, along x or z, m.
    pub wander: Wander,
    pub turned: Turned<B>,
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
            wander: Wander::new(0.0),
            turned: Turned::default(),
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
        let count = self.rows.len() * cells.columns;
        self.moving.first.clear();
        self.moving.first.resize(count + 1, 0);
        let first = &mut self.moving.first[..count];
        let base = self.rows.start * cells.columns;
        let mut tally = Tally::default();
        self.staged.clear();
        let home = (self.home.start as u32..).zip(&bodies[self.home.clone()]);
        let leaving = &mut self.leaving;
        self.staged.extend(home.map(|(slot, body)| {
            let (record, key) = stretch.record(body, slot, &mut tally);
            if let Some(first) = first.get_mut((key as usize).wrapping_sub(base)) {
                *first += 1;
                (record, key)
            } else {
                leaving.push((record, key));
                (record, ELSEWHERE)
            }
        }));
        self.tally = tally;
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
        let Sorted { first, records, .. } = &mut self.moving;
        for list in [&self.staged, &self.coming] {
            for (record, key) in list {
                if *key != ELSEWHERE {
                    let cell = &mut first[(key - base) as usize];
                    *cell -= 1;
                    records[*cell as usize] = *record;
                }
            }
        }
        self.moving.sort_rows(stretch.cells.columns);
        self.moving.list(&mut self.marked);
        self.wander = Wander::new(0.0);
        self.turned.clear(stretch.start);
        self.waiting.clear();
        self.wide.clear();
        self.foreign.clear();
    }

    /// Lists the pairs of a row of moving balls here with itself and the row after it, if that is here, that may meet.
    pub fn find_close_here(&self, stretch: &Stretch, row: usize, close: &mut Close) {
        let (row, columns) = (row - self.rows.start, stretch.cells.columns);
        let (mine, near) = (self.moving.row(row, columns), stretch.near());
        let next = (row + 1).min(self.rows.len() - 1);
        let end = if next > row {
            self.moving.row(next, columns)[1]
        } else {
            0
        };
        let (frame, first) = (
            Frame::new(&stretch.cells),
            self.moving.first_of(next, columns),
        );
        let start = |x| first[frame.column(x)];
        let one = place::of(self.index, 0);
        let Close { pairs, found } = close;
        let take = |i, k| pairs.push([one + i, one + k]);
        let lanes = &self.moving.lanes;
        lanes.pairs::<true>(mine, (lanes, end, start), near, found, take);
    }

    /// Lists the pairs of a row of moving balls here with another row, here or in another stripe, that may meet. With
    /// `still` the other row is one of balls at rest.
    pub fn find_close(
        &self,
        stretch: &Stretch,
        row: usize,
        (other, other_row, still): (&Self, usize, bool),
        close: &mut Close,
    ) {
        let columns = stretch.cells.columns;
        let sorted = if still { &other.still } else { &other.moving };
        let mark = if still { place::STILL } else { 0 };
        let (one, two) = (place::of(self.index, 0), place::of(other.index, 0) | mark);
        let mine = self.moving.row(row - self.rows.start, columns);
        let other_row = other_row - other.rows.start;
        let [_, end] = sorted.row(other_row, columns);
        if end == 0 {
            return;
        }
        let (frame, first) = (
            Frame::new(&stretch.cells),
            sorted.first_of(other_row, columns),
        );
        let start = |x| first[frame.column(x)];
        let Close { pairs, found } = close;
        let take = |i, k| pairs.push([one + i, two + k]);
        let theirs = (&sorted.lanes, end, start);
        self.moving
            .lanes
            .pairs::<false>(mine, theirs, stretch.near(), found, take);
    }

    /// Puts the balls that were turned and are at home here on their last paths.
    pub fn commit(&mut self, home: &mut [B]) {
        for (index, (ball, body)) in (0..).zip(self.turned.all()) {
            let at = (ball.slot as usize).wrapping_sub(self.home.start);
            match home.get_mut(at) {
                Some(before) if ball.place & place::STILL == 0 => *before = *body,
                _ => self.foreign.push(index),
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
        self.still.list(&mut Vec::new());
    }
}
