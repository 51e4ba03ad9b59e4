//! The pairs of rows that may meet.
#![expect(
    clippy::inline_always,
    reason = "the innermost loops of a tick: a call would cost as much as the work"
)]

use crate::sim::stepped::crowd::rows::{LANES, Lanes, Near, Part, Sought};

/// What was found for a ball: the first balls looked at in the other row, a bit for each that may meet it, those of its own
/// row first, and two bits for whether there may be more in the other row and in its own.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Found {
    i: u32,
    first: u32,
    bits: u32,
}

/// Pairs that may meet, and the memory of the search for them.
#[derive(Debug, Default)]
pub(super) struct Close {
    pub pairs: Vec<[u32; 2]>,
    pub found: Vec<Found>,
}

impl Lanes {
    /// Takes the pairs of a row that may meet: of the row with itself, if it is `OWN`, and with a row of `other`, of
    /// which `start` tells the first ball not before a place along `x`. It may take more, but none twice of one row.
    #[inline(always)]
    pub fn pairs<const OWN: bool>(
        &self,
        [from, to]: [u32; 2],
        (other, end, start): (&Self, u32, impl Fn(f32) -> u32),
        near: Near,
        found: &mut Vec<Found>,
        mut take: impl FnMut(u32, u32),
    ) {
        let (view, others) = (self.view(), other.view());
        let part = Part::new(0.0, near.wide);
        let last_of = |at: usize| view.middle[at] + near.side + 0.5 * view.dx[at].abs();
        // Whether anything is found is as good as chance, so it is written down in any case, and counted if it is.
        let mut count = 0;
        found.resize((to - from) as usize + 1, Found::default());
        for i in from..to {
            let (at, path) = (i as usize, view.path(i as usize));
            let last = last_of(at);
            let first = start(view.middle[at] - near.edge);
            // Nearly always the first few are all.
            let next = first as usize + LANES;
            let mut bits = 0;
            if first < end {
                bits = others.meet::<false>(first as usize, &path, &part) << LANES;
                let ends = (next >= end as usize, others.middle[next - 1] > last);
                bits |= (1 - (u32::from(ends.0) | u32::from(ends.1))) << (2 * LANES);
            }
            if OWN {
                bits |= view.meet::<false>(at + 1, &path, &part);
                let ends = (
                    at + 1 + LANES >= to as usize,
                    view.middle[at + LANES] > last,
                );
                bits |= (1 - (u32::from(ends.0) | u32::from(ends.1))) << (2 * LANES + 1);
            }
            found[count] = Found { i, first, bits };
            count += usize::from(bits != 0);
        }
        for &Found { i, first, mut bits } in &found[..count] {
            let few = LANES as u32;
            let rests = bits >> (2 * LANES);
            bits &= (1 << (2 * LANES)) - 1;
            while bits != 0 {
                let bit = bits.trailing_zeros();
                let lane = bit % few;
                take(i, lane + if bit == lane { i + 1 } else { first });
                bits &= bits - 1;
            }
            if rests & 1 != 0 {
                let range = [first + few, end];
                self.rest(i, (other, range), last_of(i as usize), near, &mut take);
            }
            if rests & 2 != 0 {
                let range = [i + 1 + few, to];
                self.rest(i, (self, range), last_of(i as usize), near, &mut take);
            }
        }
    }

    /// Takes the pairs of a ball with a range of a row.
    #[inline(never)]
    fn rest(
        &self,
        i: u32,
        (other, range): (&Self, [u32; 2]),
        last: f32,
        near: Near,
        take: &mut impl FnMut(u32, u32),
    ) {
        let sought = Sought::new(self.path(i as usize), 0.0, near.wide, last);
        other.meet(std::iter::once(range), &sought, |k| take(i, k));
    }
}
