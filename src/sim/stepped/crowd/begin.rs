//! Contacts of the paths that balls began a stretch on.

use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::cells::Row;
use crate::sim::stepped::crowd::cluster::{Contact, Kind, Leg, NONE};
use crate::sim::stepped::crowd::search::{MARGIN, Scratch, Solver};
use crate::sim::stepped::crowd::stripe::place;

impl<B: Body> Solver<'_, B> {
    /// Finds all pairs of a stripe that meet on the paths they began on.
    pub fn begin_stripe(&mut self, span: [usize; 2], scratch: &mut Scratch) {
        let mut close = std::mem::take(&mut scratch.close);
        let mut likely = std::mem::take(&mut scratch.likely);
        likely.clear();
        let rows = self.stripes[0].rows.clone();
        let rests = !self.stripes[0].still.records.is_empty();
        let columns = self.stretch.cells.columns;
        let ring = span[1] + 1;
        scratch
            .lanes
            .resize_with(scratch.lanes.len().max(ring + 1), Row::default);
        let (lanes, still) = scratch.lanes.split_at_mut(ring);
        let mut filled = rows.start;
        for row in rows.clone() {
            close.clear();
            let stripe = &self.stripes[0];
            let last = (row + ring).min(rows.end);
            while filled < last {
                lanes[filled % ring].fill(stripe.row(&stripe.moving, filled, columns).1);
                filled += 1;
            }
            for other in row..last {
                let lanes = &lanes[other % ring];
                stripe.find_close(self.stretch, row, (stripe, other, false), lanes, &mut close);
            }
            if rests {
                for other in row.saturating_sub(span[1]).max(rows.start)..last {
                    still[0].fill(stripe.row(&stripe.still, other, columns).1);
                    stripe.find_close(
                        self.stretch,
                        row,
                        (stripe, other, true),
                        &still[0],
                        &mut close,
                    );
                }
            }
            self.sieve(&close, &mut likely, |at| {
                stripe.sorted(at).records[place::index(at)].ball as usize
            });
            self.link(&close);
        }
        scratch.close = close;
        for k in 0..self.stripes[0].fast.len() {
            let at = place::of(self.base, self.stripes[0].fast[k] as usize);
            if !self.find_fast(at, &mut likely) {
                self.stripes[0].wide_fast.push(at);
            }
        }
        // Whoever is caught is no longer found by cells.
        for pair in &likely {
            self.begin(*pair);
        }
        scratch.likely = likely;
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
        self.sieve(&close, &mut likely, |at| self.slot(at));
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
                self.sieve(&[[at, other]], likely, |at| self.slot(at));
                self.link(&[[at, other]]);
            }
        }
        self.near = list;
        inside
    }

    /// Finds what the balls of a stripe that may do more than move on meet besides balls.
    pub fn begin_marked(&mut self, stripe: usize) {
        for k in 0..self.stripes[stripe].marked.len() {
            let marked = self.stripes[stripe].marked[k] as usize;
            self.begin_alone(place::of(self.base + stripe, marked));
        }
    }

    /// Of pairs that are near each other lists those that may meet on the paths they began the stretch on.
    fn sieve(&self, close: &[[u32; 2]], likely: &mut Vec<[u32; 2]>, slot: impl Fn(u32) -> usize) {
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
            let (a, b) = (&self.bodies[slot(one)], &self.bodies[slot(other)]);
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
