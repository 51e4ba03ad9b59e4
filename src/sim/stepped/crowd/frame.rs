//! Where to look, in f32.
#![expect(
    clippy::inline_always,
    reason = "the innermost loops of a tick: a call would cost as much as the work"
)]

use wide::f32x4;

use crate::sim::stepped::crowd::cells::Cells;

/// The numbers from here on are whole: their last bits tell how far they are from here.
const WHOLE: f32 = 8_388_608.0;

/// The cells in f32. Cells at the edge reach to infinity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    least: f32x4,
    per_cell: f32x4,
    last: f32x4,
}

impl Frame {
    pub fn new(cells: &Cells) -> Self {
        let twice = |x: f64, z: f64| f32x4::new([x, z, x, z].map(|number| number as f32));
        Self {
            least: twice(cells.least.x, cells.least.y),
            per_cell: twice(cells.per_cell.x, cells.per_cell.y),
            last: twice((cells.columns - 1) as f64, (cells.rows - 1) as f64),
        }
    }

    /// Column and row of the corners of a rectangle that is this much larger on all sides and by what others [`Wander`],
    /// and where it ends along `x`.
    #[inline(always)]
    pub fn around(&self, corners: [f32; 4], wider: f32, wander: Wander) -> ([usize; 4], f32) {
        let away = f32x4::new([-wider, -wider, wider, wider]);
        let corners = f32x4::new(corners) + away + wander.0;
        // To the nearest, as everywhere.
        let at = (corners - self.least) * self.per_cell - f32x4::splat(0.5);
        let at = at.fast_max(f32x4::splat(0.0)).fast_min(self.last) + f32x4::splat(WHOLE);
        let [left, top, right, bottom] = at.to_array();
        let index = |number: f32| (number.to_bits() - WHOLE.to_bits()) as usize;
        let cells = [index(left), index(top), index(right), index(bottom)];
        let [_, _, last, _] = corners.to_array();
        (cells, last)
    }

    /// The column of a place along `x`.
    #[inline(always)]
    pub fn column(&self, x: f32) -> usize {
        let [least, ..] = self.least.to_array();
        let ([per_cell, ..], [last, ..]) = (self.per_cell.to_array(), self.last.to_array());
        let at = (x - least) * per_cell - 0.5;
        let at = if at > 0.0 { at } else { 0.0 };
        let at = if at < last { at } else { last };
        ((at + WHOLE).to_bits() - WHOLE.to_bits()) as usize
    }
}

/// How far balls get from the middle of the path they began the tick on, m: how far what is looked for may lie beyond the
/// left, the top, the right and the bottom of where they can be. To the left and to the top it is below zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wander(f32x4);

impl Wander {
    /// So far in all directions.
    pub fn new(far: f32) -> Self {
        Self(f32x4::new([-far, -far, far, far]))
    }

    /// Has it include a ball that stays between corners.
    #[inline(always)]
    pub fn include(&mut self, [x, z]: [f32; 2], [left, top, right, bottom]: [f32; 4]) {
        let least = self
            .0
            .fast_min(f32x4::new([x - right, z - bottom, f32::MAX, f32::MAX]));
        self.0 = least.fast_max(f32x4::new([f32::MIN, f32::MIN, x - left, z - top]));
    }

    /// Has it include all that another includes.
    pub fn add(&mut self, other: Self) {
        let [left, top, right, bottom] = other.0.to_array();
        self.include([0.0; 2], [-right, -bottom, -left, -top]);
    }
}
