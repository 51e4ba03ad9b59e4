//! Contacts of the paths that balls began a stretch on.

use std::time::Instant;

use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::caught::{Contact, Kind, Leg, NONE};
use crate::sim::stepped::crowd::cells::Row;
use crate::sim::stepped::crowd::census::Pass;
use crate::sim::stepped::crowd::search::{MARGIN, Scratch, Solver};
use crate::sim::stepped::crowd::stripe::place;

/// Cells of about so many balls are worked on at a time.
const BLOCK: usize = 2048;

impl<B: Body> Solver<'_, B> {
    /// Works through a stripe, block by block of rows: finds all pairs that meet on the paths they began on, and follows the
    /// clusters of the block before, while both are in the cache.
    pub fn work_through(&mut self, span: [usize; 2], scratch: &mut Scratch) {
        let mut lap = Instant::now();
        let mut likely = std::mem::take(&mut scratch.likely);
        likely.clear();
        for k in 0..self.stripes[0].fast.len() {
            let at = place::of(self.base, self.stripes[0].fast[k] as usize);
            if !self.find_fast(at, &mut likely) {
                self.stripes[0].wide_fast.push(at);
            }
        }
        let rows = self.stripes[0].rows.clone();
        let columns = self.stretch.cells.columns;
        let block =
            (BLOCK * rows.len() / self.stripes[0].moving.records.len().max(1)).clamp(1, rows.len());
        let (mut marked, mut solved, mut known) = (0, 0, 0);
        scratch.filled = rows.start;
        for begin in rows.clone().step_by(block) {
            let end = (begin + block).min(rows.end);
            for row in begin..end {
                self.begin_row(row, span, scratch, &mut likely);
            }
            for pair in likely.drain(..) {
                self.begin(pair);
            }
            self.begun = end;
            self.tally().time(Pass::Balls, &mut lap);
            let last = self.stripes[0].moving.first[(end - rows.start) * columns];
            while let Some(&at) = self.stripes[0].marked.get(marked).filter(|at| **at < last) {
                self.begin_alone(place::of(self.base, at as usize));
                marked += 1;
            }
            self.tally().time(Pass::Cushions, &mut lap);
            self.solve_all(self.base, solved..known);
            (solved, known) = (known, self.stripes[0].clusters.len());
            self.tally().time(Pass::Resolve, &mut lap);
        }
        scratch.likely = likely;
        self.begun = usize::MAX;
        self.solve_all(self.base, solved..usize::MAX);
        self.tally().time(Pass::Resolve, &mut lap);
    }

    /// Links the balls of a row with those near them, here and in rows after it, and lists the pairs that may meet.
    fn begin_row(
        &mut self,
        row: usize,
        span: [usize; 2],
        scratch: &mut Scratch,
        likely: &mut Vec<[u32; 2]>,
    ) {
        let stripe = &self.stripes[0];
        let (rows, columns) = (&stripe.rows, self.stretch.cells.columns);
        let ring = span[1] + 1;
        let Scratch {
            close,
            lanes,
            filled,
            ..
        } = scratch;
        close.clear();
        lanes.resize_with(lanes.len().max(ring + 1), Row::default);
        let (lanes, still) = lanes.split_at_mut(ring);
        let last = (row + ring).min(rows.end);
        while *filled < last {
            lanes[*filled % ring].fill(stripe.row(&stripe.moving, *filled, columns).1);
            *filled += 1;
        }
        for other in row..last {
            let lanes = &lanes[other % ring];
            stripe.find_close(self.stretch, row, (stripe, other, false), lanes, close);
        }
        if !stripe.still.records.is_empty() {
            for other in row.saturating_sub(span[1]).max(rows.start)..last {
                still[0].fill(stripe.row(&stripe.still, other, columns).1);
                let other = (stripe, other, true);
                stripe.find_close(self.stretch, row, other, &still[0], close);
            }
        }
        self.sieve(close, likely);
        self.link(close);
    }

    /// Finds the pairs that meet across the edges of stripes.
    pub fn begin_across(&mut self, span: [usize; 2], scratch: &mut Scratch) {
        let mut close = std::mem::take(&mut scratch.close);
        let mut lanes = Row::default();
        close.clear();
        let rows = self.stretch.cells.rows;
        for mine in 0..self.stripes.len() {
            let stripe = &self.stripes[mine];
            for row in stripe.rows.clone() {
                let (low, high) = (row.saturating_sub(span[1]), (row + span[1] + 1).min(rows));
                for other_row in (low..stripe.rows.start).chain(stripe.rows.end..high) {
                    let Some(other) = self.stripe_of(other_row) else {
                        continue;
                    };
                    let other = &self.stripes[other];
                    for (sorted, still) in [(&other.moving, false), (&other.still, true)] {
                        if still || other_row > row {
                            lanes.fill(other.row(sorted, other_row, self.stretch.cells.columns).1);
                            let other = (other, other_row, still);
                            stripe.find_close(self.stretch, row, other, &lanes, &mut close);
                        }
                    }
                }
            }
        }
        let mut likely = std::mem::take(&mut scratch.likely);
        likely.clear();
        self.sieve(&close, &mut likely);
        self.link(&close);
        scratch.close = close;
        for stripe in 0..self.stripes.len() {
            for at in std::mem::take(&mut self.stripes[stripe].wide_fast) {
                self.find_fast(at, &mut likely);
            }
        }
        for pair in &likely {
            self.begin(*pair);
        }
        scratch.likely = likely;
    }

    /// Finds the pairs of a fast ball that meet on the paths they began on; false if it gets beyond these stripes.
    fn find_fast(&mut self, at: u32, likely: &mut Vec<[u32; 2]>) -> bool {
        let slot = self.slot(at);
        let body = self.bodies[slot];
        let middle = body.position(0.5 * (self.stretch.start + self.stretch.end));
        let near = self.stretch.reach() + self.stretch.freedom(&body) + self.stretch.spare;
        let mut list = std::mem::take(&mut self.near);
        list.clear();
        let inside = self.list_near(middle, near, &mut list);
        for &other in &list {
            // Two fast balls find each other twice.
            let fast = other & place::STILL == 0 && {
                let body = &self.bodies[self.slot(other)];
                self.stretch.is_fast(body)
            };
            if other != at && (!fast || at < other) {
                self.sieve(&[[at, other]], likely);
                self.link(&[[at, other]]);
            }
        }
        self.near = list;
        inside
    }

    /// Of pairs that are near each other lists those that may meet on the paths they began the stretch on.
    fn sieve(&self, close: &[[u32; 2]], likely: &mut Vec<[u32; 2]>) {
        let (start, length) = (self.stretch.start, self.stretch.end - self.stretch.start);
        let reach = self.stretch.reach();
        let margin = if B::BENDS {
            self.stretch.bend * length * length
        } else {
            0.0
        };
        let wide = (reach + margin) * (1.0 + MARGIN);
        let wide = wide * wide;
        for &[one, other] in close {
            let (a, b) = (&self.bodies[self.slot(one)], &self.bodies[self.slot(other)]);
            let offset = b.position(start) - a.position(start);
            let velocity = b.velocity(start) - a.velocity(start);
            let gap = offset.length_squared() - wide;
            let slope = offset.dot(velocity);
            let square = velocity.length_squared();
            let end = gap + length * (2.0 * slope + square * length);
            let passes = gap * square > slope * slope || -slope >= square * length;
            let meets = gap <= 0.0 || slope < 0.0 && (end <= 0.0 || !passes);
            if meets {
                likely.push([one, other]);
            }
        }
    }

    /// Takes up two balls if they meet on the paths they began the stretch on.
    fn begin(&mut self, [one, other]: [u32; 2]) {
        let (i, j) = (self.slot(one), self.slot(other));
        let start = self.stretch.start;
        let (a, b) = (self.bodies[i], self.bodies[j]);
        let overlap = self.stretch.reach() - (b.position(start) - a.position(start)).length();
        let tally = self.tally();
        tally.overlap = tally.overlap.max(overlap);
        let (m, n) = (self.numbers[i], self.numbers[j]);
        let leg = |body| Leg {
            body,
            from: start,
            before: NONE,
        };
        let Some(time) = self.meet((&leg(a), m), (&leg(b), n), self.stretch.end, 0) else {
            return;
        };
        let (one, other) = (self.catch(one), self.catch(other));
        self.sow(Contact {
            time,
            order: Contact::order(2, m.max(n), m.min(n)),
            ball: one,
            kind: Kind::Ball(other),
            legs: [self.caught(one).first, self.caught(other).first],
        });
    }

    /// Takes up what a ball at this place meets besides balls, on the path it began the stretch on.
    pub fn begin_alone(&mut self, at: u32) {
        let slot = self.slot(at);
        let leg = Leg {
            body: self.bodies[slot],
            from: self.stretch.start,
            before: NONE,
        };
        let number = self.numbers[slot];
        let mut found = [None; 8];
        let mut count = 0;
        self.alone(&leg, number, |contact| {
            if count < found.len() {
                found[count] = Some(contact);
            }
            count += 1;
        });
        if count > found.len() {
            // More cushions at once than a corner has: keep the earliest, the others are found again after it.
            found = [None; 8];
            self.alone(&leg, number, |contact| {
                if found[0].is_none_or(|first| contact > first) {
                    found[0] = Some(contact);
                }
            });
        }
        for contact in found.into_iter().flatten() {
            let ball = self.catch(at);
            let last = self.caught(ball).first;
            self.sow(Contact {
                ball,
                legs: [last; 2],
                ..contact
            });
        }
    }
}
