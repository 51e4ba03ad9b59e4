//! The cells of a crowd, and what of a ball lies in them.

use std::ops::Range;

use glam::DVec2;
use wide::f64x2;

use crate::sim::stepped::crowd::rows::Lanes;

/// A ball on its way into its cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record {
    /// The middle of the path of this tick along x and z, and how far it moves in this tick if nothing happens, m.
    pub numbers: [f32; 4],
    /// Slot of the ball; with [`MARKED`] one that may do more than move on.
    pub ball: u32,
}

/// Marks a ball that is on another path than the one it began the tick on: the rest is its place among those.
pub(super) const TURNED: u32 = 1 << 31;
/// Marks, while records are sorted, a ball that may do more than move on: meet a cushion, change its kind of motion, or
/// get further than its cell allows.
pub(super) const MARKED: u32 = 1 << 31;

impl Record {
    #[inline]
    pub fn new(middle: DVec2, way: DVec2, ball: u32) -> Self {
        Self {
            numbers: [middle.x as f32, middle.y as f32, way.x as f32, way.y as f32],
            ball,
        }
    }
}

/// Records sorted by cell, and in a row of cells by `x`.
#[derive(Debug, Default)]
pub(super) struct Sorted {
    /// Index of the first record of each cell, and the number of all.
    pub first: Vec<u32>,
    pub records: Vec<Record>,
    pub lanes: Lanes,
    /// The slot of each ball; with [`TURNED`] its place among those that are on another path.
    pub balls: Vec<u32>,
    /// Whether something waits for a ball that is not due yet.
    pub held: Vec<bool>,
}

impl Sorted {
    /// Makes room for so many records.
    pub fn resize(&mut self, count: usize) {
        self.records
            .resize(count, Record::new(DVec2::ZERO, DVec2::ZERO, 0));
        // Nothing waits any more when a tick is over.
        self.held.resize(count, false);
    }

    /// Sorts each row of so many cells.
    pub fn sort_rows(&mut self, columns: usize) {
        for row in self.first.windows(columns + 1).step_by(columns) {
            let row = &mut self.records[row[0] as usize..row[columns] as usize];
            for k in 1..row.len() {
                let record = row[k];
                let mut at = k;
                while at > 0 && row[at - 1].numbers[0] > record.numbers[0] {
                    row[at] = row[at - 1];
                    at -= 1;
                }
                if at < k {
                    row[at] = record;
                }
            }
        }
    }

    /// Takes what the records tell into lists, and lists those that are marked.
    pub fn list(&mut self, marked: &mut Vec<u32>) {
        self.lanes.fill(&self.records);
        self.balls.resize(self.records.len(), 0);
        marked.clear();
        for (at, (ball, record)) in (0..).zip(self.balls.iter_mut().zip(&self.records)) {
            *ball = record.ball & !MARKED;
            if record.ball & MARKED != 0 {
                marked.push(at);
            }
        }
    }

    /// Places of a row of so many cells.
    #[inline]
    pub fn row(&self, row: usize, columns: usize) -> [u32; 2] {
        if self.records.is_empty() {
            return [0; 2];
        }
        [self.first[row * columns], self.first[(row + 1) * columns]]
    }

    /// The first place in each cell of a row of so many cells.
    #[inline]
    pub fn first_of(&self, row: usize, columns: usize) -> &[u32] {
        &self.first[row * columns..(row + 1) * columns]
    }

    /// The places of some columns of some rows of so many cells.
    #[inline]
    pub fn ranges(
        &self,
        rows: Range<usize>,
        count: usize,
        columns: Range<usize>,
    ) -> impl Iterator<Item = [u32; 2]> {
        let (begin, end) = (columns.start, columns.end);
        let first = &self.first[..];
        rows.map(move |row| [first[row * count + begin], first[row * count + end]])
    }

    /// Takes a ball away: nothing is near it any more.
    pub fn clear(&mut self, at: usize) {
        self.lanes.set(at, Lanes::NOBODY);
    }
}

/// How the table is cut. Cells at the edge reach to infinity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cells {
    pub least: DVec2,
    pub per_cell: DVec2,
    pub columns: usize,
    pub rows: usize,
}

impl Cells {
    /// Cells of about this size.
    pub fn new(table: DVec2, size: DVec2) -> Self {
        let count = (table / size).floor().max(DVec2::ONE);
        Self {
            least: -0.5 * table,
            per_cell: count / table,
            columns: count.x as usize,
            rows: count.y as usize,
        }
    }

    /// Column and row.
    #[inline]
    pub fn at(&self, place: DVec2) -> [usize; 2] {
        let at = (pair(place) - pair(self.least)) * pair(self.per_cell) - f64x2::splat(0.5);
        let last = f64x2::new([(self.columns - 1) as f64, (self.rows - 1) as f64]);
        // To the nearest, which cuts the table as well as any other way, without the cost of a cast.
        let at = at.fast_max(f64x2::splat(0.0)).fast_min(last) + f64x2::splat(COUNTED);
        at.to_array().map(|at| at.to_bits() as u32 as usize)
    }

    /// How many cells away something this far can be, along x and z.
    pub fn span(&self, reach: f64) -> [usize; 2] {
        let span = (reach * self.per_cell).ceil();
        [(span.x as usize).max(1), (span.y as usize).max(1)]
    }
}

/// 2^52: the bits of a number from here on count its distance from here.
const COUNTED: f64 = 4_503_599_627_370_496.0;

#[inline]
fn pair(numbers: DVec2) -> f64x2 {
    f64x2::new([numbers.x, numbers.y])
}
