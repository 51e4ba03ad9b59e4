//! Rows of balls, several compared at once.
#![expect(
    clippy::inline_always,
    reason = "the innermost loops of a tick: a call would cost as much as the work"
)]

use wide::f32x4;

use crate::sim::stepped::crowd::cells::Record;

/// Balls compared at a time.
const LANES: usize = 4;

/// Some balls next to each other, each number of them side by side: where they begin the tick along x and z, and how far
/// they get in it, m. One line of a cache.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Block([[f32; LANES]; 4]);

impl Block {
    /// Nothing is near it.
    const NOBODY: Self = Self([[f32::NAN; LANES]; 4]);
}

/// Where balls begin the tick and how far they get in it, block by block, so that several are compared at once. In f32: it
/// only tells which pairs certainly do not meet. A ball that was turned has the place at which it would have begun, had it
/// always been on its new path.
#[derive(Debug, Default)]
pub(super) struct Lanes {
    blocks: Vec<Block>,
    /// The middles of the paths along `x`, by which each row is sorted.
    x: Vec<f32>,
}

/// What two balls must come near enough to meet in a tick, m, with room for rounding and for bent paths.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    /// Distance of the centres.
    pub wide: f32,
    /// Distance along `x` of the middles of their paths.
    pub edge: f32,
}

/// What is looked for: balls that meet one on any of these paths after this part of the tick, their middles not beyond
/// `last` along `x`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sought<const N: usize> {
    pub paths: [[f32; 4]; N],
    pub after: f32,
    pub wide: f32,
    pub last: f32,
}

impl Lanes {
    /// A path that nothing meets.
    pub const NOBODY: [f32; 4] = [f32::NAN; 4];

    /// Takes records that are sorted by cell, and in each row by `x`.
    pub fn fill(&mut self, records: &[Record]) {
        self.blocks.clear();
        self.x.clear();
        self.x.extend(records.iter().map(|record| record.x));
        let full = records.chunks_exact(LANES);
        let rest = full.remainder();
        self.blocks.extend(full.map(|four| {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| four[k].path());
            Block([0, 1, 2, 3].map(|k| [a[k], b[k], c[k], d[k]]))
        }));
        if !rest.is_empty() {
            self.blocks.push(Block::NOBODY);
            for (k, record) in rest.iter().enumerate() {
                self.set(records.len() - rest.len() + k, record.path());
            }
        }
    }

    /// The path of a ball.
    #[inline]
    pub fn path(&self, at: usize) -> [f32; 4] {
        let Block([x, z, dx, dz]) = &self.blocks[at / LANES];
        let lane = at % LANES;
        [x[lane], z[lane], dx[lane], dz[lane]]
    }

    /// Puts a ball on another path.
    #[inline]
    pub fn set(&mut self, at: usize, path: [f32; 4]) {
        let Block(block) = &mut self.blocks[at / LANES];
        for (list, number) in block.iter_mut().zip(path) {
            list[at % LANES] = number;
        }
    }

    /// Takes, out of a range of a row, every ball that may meet what is looked for, and perhaps some that do not, with the
    /// index of the path.
    #[inline(always)]
    pub fn meet<const N: usize, const LATER: bool>(
        &self,
        [from, to]: [u32; 2],
        sought: &Sought<N>,
        mut take: impl FnMut(usize, u32),
    ) {
        let mut paths = [[f32x4::splat(0.0); 4]; N];
        for (path, numbers) in paths.iter_mut().zip(&sought.paths) {
            for (four, number) in path.iter_mut().zip(numbers) {
                *four = f32x4::splat(*number);
            }
        }
        let (wide, zero) = (f32x4::splat(sought.wide * sought.wide), f32x4::splat(0.0));
        let (after, left) = (f32x4::splat(sought.after), f32x4::splat(1.0 - sought.after));
        let mut mask = u32::MAX << (from as usize % LANES);
        let mut at = from as usize / LANES * LANES;
        let blocks = &self.blocks[at / LANES..(to as usize).div_ceil(LANES).max(at / LANES)];
        for Block([xs, zs, dxs, dzs]) in blocks {
            let mut bits = [0; N];
            for (bits, [x, z, dx, dz]) in bits.iter_mut().zip(&paths) {
                // The square of the distance is gap + 2 slope t + square t², t from now on.
                let (mut x, mut z) = (f32x4::new(*xs) - *x, f32x4::new(*zs) - *z);
                let (mut dx, mut dz) = (f32x4::new(*dxs) - *dx, f32x4::new(*dzs) - *dz);
                if LATER {
                    (x, z) = (x + after * dx, z + after * dz);
                    (dx, dz) = (left * dx, left * dz);
                }
                let gap = x * x + z * z - wide;
                let slope = x * dx + z * dz;
                let square = dx * dx + dz * dz;
                let overlaps = gap.simd_le(zero);
                let closes = slope.simd_lt(zero);
                let ends = (gap + slope + slope + square).simd_le(zero);
                let turns = (slope * slope).simd_ge(gap * square) & (zero - slope).simd_lt(square);
                *bits = (overlaps | (closes & (ends | turns))).to_bitmask() & mask;
            }
            mask = u32::MAX;
            for (path, mut bits) in bits.into_iter().enumerate() {
                while bits != 0 {
                    take(path, at as u32 + bits.trailing_zeros());
                    bits &= bits - 1;
                }
            }
            at += LANES;
            if self.x.get(at - 1).is_none_or(|x| *x > sought.last) {
                return;
            }
        }
    }

    /// Takes the pairs of a row with itself that may meet.
    pub fn pairs(&self, [from, to]: [u32; 2], near: Near, mut take: impl FnMut(u32, u32)) {
        for i in from..to {
            let sought = self.sought(i, near);
            self.meet::<1, false>([i + 1, to], &sought, |_, k| take(i, k));
        }
    }

    /// Takes the pairs of a row with another row, here or elsewhere, that may meet.
    pub fn pairs_with(
        &self,
        [from, to]: [u32; 2],
        other: &Self,
        [mut low, end]: [u32; 2],
        near: Near,
        mut take: impl FnMut(u32, u32),
    ) {
        for i in from..to {
            let first = self.x[i as usize] - near.edge;
            while low < end && other.x[low as usize] < first {
                low += 1;
            }
            let sought = self.sought(i, near);
            other.meet::<1, false>([low, end], &sought, |_, k| take(i, k));
        }
    }

    #[inline(always)]
    fn sought(&self, at: u32, near: Near) -> Sought<1> {
        Sought {
            paths: [self.path(at as usize)],
            after: 0.0,
            wide: near.wide,
            last: self.x[at as usize] + near.edge,
        }
    }
}
