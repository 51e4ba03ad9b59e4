//! The cells of a crowd, and what of a ball lies in them.

use glam::DVec2;

use crate::sim::stepped::crowd::rows::Lanes;

/// A ball on its way into its cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record {
    /// The middle of the path of this tick, m.
    pub x: f32,
    pub z: f32,
    /// How far it moves in this tick along x and z if nothing happens, m.
    pub dx: f32,
    pub dz: f32,
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
            x: middle.x as f32,
            z: middle.y as f32,
            dx: way.x as f32,
            dz: way.y as f32,
            ball,
        }
    }

    /// Where the ball begins the tick along x and z, and how far it gets in it, m.
    #[inline]
    pub fn path(&self) -> [f32; 4] {
        let (x, z) = (self.x - 0.5 * self.dx, self.z - 0.5 * self.dz);
        [x, z, self.dx, self.dz]
    }

    /// The middle of the path, m.
    #[inline]
    pub fn middle(&self) -> DVec2 {
        DVec2::new(f64::from(self.x), f64::from(self.z))
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
                while at > 0 && row[at - 1].x > record.x {
                    row[at] = row[at - 1];
                    at -= 1;
                }
                if at < k {
                    row[at] = record;
                }
            }
        }
    }

    /// Takes what the records tell into lists.
    pub fn list(&mut self) {
        self.lanes.fill(&self.records);
        self.balls.clear();
        self.balls
            .extend(self.records.iter().map(|record| record.ball));
    }

    /// Places of a row of so many cells.
    #[inline]
    pub fn row(&self, row: usize, columns: usize) -> [u32; 2] {
        if self.records.is_empty() {
            return [0; 2];
        }
        [self.first[row * columns], self.first[(row + 1) * columns]]
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
        let at = (place - self.least) * self.per_cell;
        [index(at.x, self.columns), index(at.y, self.rows)]
    }

    /// How many cells away something this far can be, along x and z.
    pub fn span(&self, reach: f64) -> [usize; 2] {
        let span = (reach * self.per_cell).ceil();
        [(span.x as usize).max(1), (span.y as usize).max(1)]
    }
}

/// 2^52: the bits of a number from here on count its distance from here.
const COUNTED: f64 = 4_503_599_627_370_496.0;

/// The index of a cell out of `count`. Rounds to the nearest, which cuts the table as well as any other way, without the
/// cost of a cast.
#[inline]
fn index(at: f64, count: usize) -> usize {
    let (at, last) = (at - 0.5, (count - 1) as f64);
    // Not `max` and `min`, which look after numbers that are none.
    let at = if at > 0.0 { at } else { 0.0 };
    let at = if at < last { at } else { last };
    (at + COUNTED).to_bits() as u32 as usize
}
