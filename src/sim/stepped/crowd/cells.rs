//! The cells of a crowd, and what of a ball lies in them.

use glam::DVec2;
use wide::f32x4;

/// A ball in its cell, 16 bytes: what tells that two balls are too far from each other to meet in this tick. In f32, with
/// room for the rounding in `free`, so that no pair is missed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record {
    /// The middle of the path of this tick, m.
    pub x: f32,
    pub z: f32,
    /// How far the ball may get from there, contacts and all, before more than its links must be looked at, m. Not a
    /// number if it is too fast for its cell.
    pub free: f32,
    /// Slot of the ball; with [`CAUGHT`] its place among the caught.
    pub ball: u32,
}

/// Marks a ball whose path is being worked on.
pub(super) const CAUGHT: u32 = 1 << 31;
/// Marks, while records are sorted, a ball that may do more than move on: meet a cushion or change its kind of motion.
pub(super) const MARKED: u32 = 1 << 31;

/// Added to lengths in f32 that must not become too short by rounding; a share.
const ROUNDING: f64 = 1e-6;
/// A step of an f32 near 1.
const STEP: f32 = f32::EPSILON;

impl Record {
    #[inline]
    pub fn new(middle: DVec2, free: f32, ball: u32) -> Self {
        let (x, z) = (middle.x as f32, middle.y as f32);
        Self {
            x,
            z,
            free: free * (1.0 + 4.0 * STEP) + STEP * (x.abs() + z.abs()),
            ball,
        }
    }

    /// How far a ball with this record gets from its middle on a leg that stays this near to this place, m.
    #[inline]
    pub fn wander(&self, middle: DVec2, extent: f64) -> f32 {
        let (dx, dz) = (middle.x - f64::from(self.x), middle.y - f64::from(self.z));
        let wander = roomy((dx * dx + dz * dz).sqrt() + extent);
        wander + 4.0 * STEP * (self.x.abs() + self.z.abs())
    }
}

/// Records sorted by cell, and in a row of cells by `x`.
#[derive(Debug, Default)]
pub(super) struct Sorted {
    /// Index of the first record of each cell, and the number of all.
    pub first: Vec<u32>,
    pub records: Vec<Record>,
    /// The slot of each ball.
    pub slots: Vec<u32>,
    /// For each ball its last link to a ball near it.
    heads: Vec<u32>,
}

impl Sorted {
    /// Makes room for so many records, without links.
    pub fn resize(&mut self, count: usize) {
        self.records.resize(count, Record::new(DVec2::ZERO, 0.0, 0));
        self.unlink();
    }

    /// Forgets all links.
    pub fn unlink(&mut self) {
        self.heads.clear();
        self.heads.resize(self.records.len(), END);
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
                row[at] = record;
            }
        }
    }

    /// Takes a record away: nothing is near it any more.
    pub fn clear(&mut self, at: usize) {
        self.records[at].z = f32::INFINITY;
        self.records[at].free = 0.0;
    }
}

/// A ball near another, and the next of these.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    pub place: u32,
    pub next: u32,
}

/// No more links.
pub(super) const END: u32 = u32::MAX;

impl Sorted {
    /// Links the ball at an index to one at a place.
    #[inline]
    pub fn link(&mut self, at: usize, place: u32, links: &mut Vec<Link>) {
        let next = std::mem::replace(&mut self.heads[at], links.len() as u32);
        links.push(Link { place, next });
    }

    /// The last link of a ball.
    #[inline]
    pub fn head(&self, at: usize) -> u32 {
        self.heads[at]
    }
}

/// Records compared at a time.
const LANES: usize = 4;

/// A row of records, each number in its own list, so that several are compared at once.
#[derive(Debug, Default)]
pub(super) struct Row {
    x: Vec<f32>,
    z: Vec<f32>,
    free: Vec<f32>,
    count: usize,
}

impl Row {
    /// Takes a row of records sorted by `x`.
    pub fn fill(&mut self, records: &[Record]) {
        self.count = records.len();
        for (list, end) in [
            (&mut self.x, f32::INFINITY),
            (&mut self.z, 0.0),
            (&mut self.free, 0.0),
        ] {
            list.clear();
            list.resize(records.len() + LANES, end);
        }
        let lists = self.x.iter_mut().zip(&mut self.z).zip(&mut self.free);
        for (((x, z), free), record) in lists.zip(records) {
            (*x, *z, *free) = (record.x, record.z, record.free);
        }
    }

    /// Takes, from index `from` on, every record that may come within `wide` m of this one; none that is further away
    /// along `x` than `edge` can.
    #[inline]
    fn near(
        &self,
        from: usize,
        record: &Record,
        wide: f32,
        edge: f32,
        mut take: impl FnMut(usize),
    ) {
        let (x, z, most) = (
            f32x4::splat(record.x),
            f32x4::splat(record.z),
            f32x4::splat(wide),
        );
        let last = record.x + edge;
        let four = |list: &[f32], at: usize| {
            let mut four = [0.0; LANES];
            four.copy_from_slice(&list[at..at + LANES]);
            f32x4::new(four)
        };
        let mut at = from;
        loop {
            let (dx, dz) = (four(&self.x, at) - x, four(&self.z, at) - z);
            let most = four(&self.free, at) + most;
            let mut bits = (dx * dx + dz * dz).simd_lt(most * most).to_bitmask();
            while bits != 0 {
                take(at + bits.trailing_zeros() as usize);
                bits &= bits - 1;
            }
            at += LANES;
            // Beyond the end is infinity.
            if self.x[at - 1] > last {
                return;
            }
        }
    }

    /// Takes the pairs of this row with itself that may come within `reach` m. No ball gets further than `most`.
    pub fn pairs(
        &self,
        records: &[Record],
        reach: f32,
        most: f32,
        mut take: impl FnMut(usize, usize),
    ) {
        for (i, record) in records.iter().enumerate() {
            let edge = edge(reach, most, record.x);
            self.near(i + 1, record, reach + record.free, edge, |k| take(i, k));
        }
    }

    /// Takes the pairs of a row of records with this row.
    pub fn pairs_with(
        &self,
        records: &[Record],
        reach: f32,
        most: f32,
        mut take: impl FnMut(usize, usize),
    ) {
        let mut low = 0;
        for (i, record) in records.iter().enumerate() {
            let edge = edge(reach, most, record.x);
            while self.x[low] < record.x - edge {
                low += 1;
            }
            if low >= self.count {
                return;
            }
            self.near(low, record, reach + record.free, edge, |k| take(i, k));
        }
    }
}

/// The largest distance along x of two linked balls, with room for rounding.
#[inline]
fn edge(reach: f32, most: f32, x: f32) -> f32 {
    (reach + 2.0 * most) * (1.0 + 1e-5) + 1e-6 * x.abs()
}

/// A length in f32 that is not shorter than this.
#[inline]
pub(super) fn roomy(length: f64) -> f32 {
    (length * (1.0 + ROUNDING)) as f32
}

/// How the table is cut. Cells at the edge reach to infinity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cells {
    pub least: DVec2,
    pub per_cell: DVec2,
    pub columns: usize,
    pub rows: usize,
}

/// Cells from a column to another and from a row to another, both included.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window {
    pub columns: [usize; 2],
    pub rows: [usize; 2],
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

    /// The cells around a place.
    #[inline]
    pub fn window(&self, center: DVec2, reach: f64) -> Window {
        let ([c0, r0], [c1, r1]) = (self.at(center - reach), self.at(center + reach));
        Window {
            columns: [c0, c1],
            rows: [r0, r1],
        }
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
    let at = (at - 0.5).max(0.0).min((count - 1) as f64);
    (at + COUNTED).to_bits() as u32 as usize
}
