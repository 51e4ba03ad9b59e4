//! Rows of balls, several compared at once.
#![expect(
    clippy::inline_always,
    reason = "the innermost loops of a tick: a call would cost as much as the work"
)]

use wide::f32x4;

use crate::sim::stepped::crowd::cells::Record;

/// Balls compared at a time.
pub(super) const LANES: usize = 4;

/// Where balls begin the tick and how far they get in it, each number in a list of its own, so that several balls are
/// compared at once. In f32: it only tells which pairs certainly do not meet. A ball that was turned has the place at which
/// it would have begun, had it always been on its new path. Behind the last come some that nothing meets.
#[derive(Debug, Default)]
pub(super) struct Lanes {
    /// The middles of the paths along `x`, by which each row is sorted.
    middle: Vec<f32>,
    x: Vec<f32>,
    z: Vec<f32>,
    dx: Vec<f32>,
    dz: Vec<f32>,
}

/// Lanes of equal length, so that one comparison tells that all of them go so far.
#[derive(Clone, Copy)]
pub(super) struct View<'a> {
    pub middle: &'a [f32],
    x: &'a [f32],
    z: &'a [f32],
    pub dx: &'a [f32],
    dz: &'a [f32],
}

/// Some numbers of a list, from `at` on.
#[inline(always)]
fn some(list: &[f32], at: usize) -> f32x4 {
    match list[at..at + LANES].first_chunk() {
        Some(numbers) => f32x4::new(*numbers),
        None => f32x4::new([f32::NAN; LANES]),
    }
}

impl View<'_> {
    /// Which of the balls from `at` on may meet one on a path: one bit for each. With `LATER` in the part of the tick that
    /// is left.
    #[inline(always)]
    pub fn meet<const LATER: bool>(&self, at: usize, path: &[f32x4; 4], part: &Part) -> u32 {
        // The square of the distance is gap + 2 slope t + square t², t from now on.
        let (mut x, mut z) = (some(self.x, at) - path[0], some(self.z, at) - path[1]);
        let (mut dx, mut dz) = (some(self.dx, at) - path[2], some(self.dz, at) - path[3]);
        if LATER {
            (x, z) = (x + part.after * dx, z + part.after * dz);
            (dx, dz) = (part.left * dx, part.left * dz);
        }
        let gap = x * x + z * z - part.square;
        let slope = x * dx + z * dz;
        let square = dx * dx + dz * dz;
        let rising = slope + square;
        let zero = f32x4::splat(0.0);
        let ends = (gap + slope + rising).simd_le(zero);
        let turns = (slope * slope).simd_ge(gap * square) & zero.simd_lt(rising);
        (gap.simd_le(zero) | (slope.simd_lt(zero) & (ends | turns))).to_bitmask()
    }

    #[inline(always)]
    pub fn path(&self, at: usize) -> [f32x4; 4] {
        let splat = |list: &[f32]| f32x4::splat(list[at]);
        [splat(self.x), splat(self.z), splat(self.dx), splat(self.dz)]
    }
}

/// The part of the tick that is left, and the square of the distance that counts as near, each several times.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    after: f32x4,
    left: f32x4,
    square: f32x4,
}

impl Part {
    #[inline(always)]
    pub fn new(after: f32, wide: f32) -> Self {
        Self {
            after: f32x4::splat(after),
            left: f32x4::splat(1.0 - after),
            square: f32x4::splat(wide * wide),
        }
    }
}

/// What two balls must come near enough to meet in a tick, m, with room for rounding and for bent paths.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    /// Distance of the centres.
    pub wide: f32,
    /// Distance along `x` of a path from the middle of the other.
    pub side: f32,
    /// Distance along `x` of the middles of their paths.
    pub edge: f32,
}

/// What is looked for: balls that meet one on this path after this part of the tick, their middles not beyond `last` along
/// `x`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sought {
    path: [f32x4; 4],
    part: Part,
    last: f32,
}

impl Sought {
    /// Balls that come as near as `wide` to a path.
    #[inline(always)]
    pub fn new([x, z, dx, dz]: [f32; 4], after: f32, wide: f32, last: f32) -> Self {
        let splat = f32x4::splat;
        Self {
            path: [splat(x), splat(z), splat(dx), splat(dz)],
            part: Part::new(after, wide),
            last,
        }
    }
}

impl Lanes {
    /// A path that nothing meets.
    pub const NOBODY: [f32; 4] = [f32::NAN; 4];

    /// Takes records that are sorted by cell, and in each row by `x`.
    pub fn fill(&mut self, records: &[Record]) {
        let count = records.len() + 2 * LANES;
        let lists = [&mut self.x, &mut self.z, &mut self.dx, &mut self.dz];
        for list in lists {
            list.resize(count, f32::NAN);
            list[records.len()..].fill(f32::NAN);
        }
        self.middle.resize(count, f32::INFINITY);
        self.middle[records.len()..].fill(f32::INFINITY);
        let lists = self.middle.iter_mut().zip(&mut self.x).zip(&mut self.z);
        let lists = lists.zip(&mut self.dx).zip(&mut self.dz);
        for (record, ((((middle, x), z), dx), dz)) in records.iter().zip(lists) {
            let [mx, mz, wx, wz] = record.numbers;
            (*middle, *dx, *dz) = (mx, wx, wz);
            (*x, *z) = (mx - 0.5 * wx, mz - 0.5 * wz);
        }
    }

    #[inline(always)]
    pub fn view(&self) -> View<'_> {
        let count = self.middle.len();
        View {
            middle: &self.middle[..count],
            x: &self.x[..count],
            z: &self.z[..count],
            dx: &self.dx[..count],
            dz: &self.dz[..count],
        }
    }

    /// The path of a ball.
    #[inline(always)]
    pub fn path(&self, at: usize) -> [f32; 4] {
        [self.x[at], self.z[at], self.dx[at], self.dz[at]]
    }

    /// Puts a ball on another path.
    #[inline(always)]
    pub fn set(&mut self, at: usize, [x, z, dx, dz]: [f32; 4]) {
        (self.x[at], self.z[at]) = (x, z);
        (self.dx[at], self.dz[at]) = (dx, dz);
    }

    /// Hides a ball until it is put on another path.
    #[inline(always)]
    pub fn hide(&mut self, at: usize) {
        self.x[at] = f32::NAN;
    }

    /// Takes, out of ranges of rows, every ball that may meet what is looked for, and perhaps some that do not or lie
    /// behind a range.
    #[inline(always)]
    pub fn meet(
        &self,
        ranges: impl Iterator<Item = [u32; 2]>,
        sought: &Sought,
        mut take: impl FnMut(u32),
    ) {
        let view = self.view();
        for [from, to] in ranges {
            let (mut at, to) = (from as usize, to as usize);
            while at < to {
                let mut bits = view.meet::<true>(at, &sought.path, &sought.part);
                while bits != 0 {
                    take(at as u32 + bits.trailing_zeros());
                    bits &= bits - 1;
                }
                at += LANES;
                if view.middle[at - 1] > sought.last {
                    break;
                }
            }
        }
    }

    /// The same for some rows at once. Nearly always the first few of each are all, so that nothing has to be guessed.
    #[inline(always)]
    pub fn meet_few<const FEW: usize>(
        &self,
        ranges: &[[u32; 2]; FEW],
        sought: &Sought,
        mut take: impl FnMut(u32),
    ) {
        let view = self.view();
        let (mut bits, mut all) = (0_u32, 0_u32);
        for (k, [from, to]) in ranges.iter().enumerate() {
            let end = *from as usize + LANES;
            let found = view.meet::<true>(*from as usize, &sought.path, &sought.part);
            bits |= found << (k * LANES);
            let (ends, passes) = (end >= *to as usize, view.middle[end - 1] > sought.last);
            all |= (u32::from(ends) | u32::from(passes)) << k;
        }
        while bits != 0 {
            let bit = bits.trailing_zeros() as usize;
            take(ranges[bit / LANES][0] + (bit % LANES) as u32);
            bits &= bits - 1;
        }
        if all + 1 != 1 << FEW {
            let rest = (0..FEW).filter(|k| all >> k & 1 == 0);
            let rest = rest.map(|k| [ranges[k][0] + LANES as u32, ranges[k][1]]);
            self.meet(rest, sought, take);
        }
    }
}
