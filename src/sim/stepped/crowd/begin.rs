//! Contacts of the paths that balls began a stretch on.
#![expect(
    clippy::inline_always,
    reason = "the innermost loops of a tick: a call would cost as much as the work"
)]

use std::hint::black_box;
use std::time::Instant;

use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::census::Pass;
use crate::sim::stepped::crowd::pairs::Close;
use crate::sim::stepped::crowd::search::{Scratch, Solver};
use crate::sim::stepped::crowd::stripe::place;
use crate::sim::stepped::crowd::turned::Kind;

/// Cells of about so many balls are worked on at a time, and at least so many rows.
const BLOCK: usize = 2048;
/// Pairs whose balls are asked for at a time.
const AHEAD: usize = 32;
const ROWS: usize = 6;

impl<B: Body, const WIDE: bool> Solver<'_, B, WIDE> {
    /// Works through a stripe, block by block of rows: finds all pairs that meet on the paths they began on, and resolves
    /// the contacts whose balls have been looked after, while both are in the cache.
    pub fn work_through(&mut self, span: [usize; 2], scratch: &mut Scratch) {
        let mut lap = Instant::now();
        let rows = self.stripes[0].rows.clone();
        let columns = self.stretch.cells.columns;
        let block = (BLOCK * rows.len() / self.stripes[0].moving.records.len().max(1)).max(ROWS);
        // What lies at the edge of another stripe waits for it.
        let (first, last) = (self.base == 0, self.base + 1 == self.all);
        let from = if first {
            rows.start
        } else {
            rows.start + span[1]
        };
        let to = if last {
            rows.end
        } else {
            rows.end.saturating_sub(span[1])
        };
        let mut marked = 0;
        for begin in rows.clone().step_by(block) {
            let end = (begin + block).min(rows.end);
            scratch.close.pairs.clear();
            for row in begin..end {
                self.find_close(row, span, &mut scratch.close);
            }
            self.begin_all(&scratch.close.pairs);
            self.tally().time(Pass::Balls, &mut lap);
            let index = |row: usize| self.stripes[0].moving.first[(row - rows.start) * columns];
            let (after, ready) = (
                index(end),
                [
                    index(from.min(rows.end)),
                    index(to.max(rows.start).min(end)),
                ],
            );
            marked = self.begin_marked(marked, after);
            self.tally().time(Pass::Cushions, &mut lap);
            self.resolve(Some(ready));
            self.tally().time(Pass::Resolve, &mut lap);
        }
    }

    /// Lists the pairs of a row with itself and the rows after it, and with balls at rest, that are near enough to meet.
    fn find_close(&self, row: usize, span: [usize; 2], close: &mut Close) {
        let stripe = &self.stripes[0];
        let rows = &stripe.rows;
        let last = (row + span[1] + 1).min(rows.end);
        stripe.find_close_here(self.stretch, row, close);
        for other in row + 2..last {
            stripe.find_close(self.stretch, row, (stripe, other, false), close);
        }
        if !stripe.still.records.is_empty() {
            for other in row.saturating_sub(span[1]).max(rows.start)..last {
                stripe.find_close(self.stretch, row, (stripe, other, true), close);
            }
        }
    }

    /// Finds the pairs that meet across the edges of stripes.
    pub fn begin_across(&mut self, span: [usize; 2], scratch: &mut Scratch) {
        let mut close = std::mem::take(&mut scratch.close);
        close.pairs.clear();
        let rows = self.stretch.cells.rows;
        for stripe in self.stripes.iter() {
            for row in stripe.rows.clone() {
                let (low, high) = (row.saturating_sub(span[1]), (row + span[1] + 1).min(rows));
                for other_row in (low..stripe.rows.start).chain(stripe.rows.end..high) {
                    let Some(other) = self.stripe_of(other_row) else {
                        continue;
                    };
                    let other = &self.stripes[other];
                    for still in [false, true] {
                        if still || other_row > row {
                            let other = (other, other_row, still);
                            stripe.find_close(self.stretch, row, other, &mut close);
                        }
                    }
                }
            }
        }
        self.begin_all(&close.pairs);
        scratch.close = close;
    }

    fn begin_all(&mut self, close: &[[u32; 2]]) {
        for some in close.chunks(AHEAD) {
            // They lie all over memory: asked for at once, they come at once.
            let mut touched = 0;
            for &[one, other] in some {
                touched ^= self.touch(one) ^ self.touch(other);
            }
            black_box(touched);
            for &[one, other] in some {
                self.begin(one, other);
            }
        }
    }

    /// Takes up two balls if they meet on the paths they are on.
    #[inline(always)]
    pub fn begin(&mut self, one: u32, other: u32) {
        let (a, b) = (self.seen(one), self.seen(other));
        if let Some(time) = self.meet(one, &a, &b) {
            let turns = [a.turns, b.turns];
            self.wait(time, one, Kind::Ball(other), turns);
        }
    }

    /// Takes up the marked balls from one of them on that lie before a place; the first that does not.
    fn begin_marked(&mut self, from: usize, before: u32) -> usize {
        let marked = std::mem::take(&mut self.stripes[0].marked);
        let lie = marked[from..].iter().take_while(|at| **at < before);
        let to = from + lie.count();
        let base = self.base;
        let at = |index: &u32| place::of(base, *index as usize);
        for some in marked[from..to].chunks(AHEAD) {
            let touched = some.iter().map(|index| self.touch(at(index)));
            black_box(touched.fold(0, |a, b| a ^ b));
            for index in some {
                self.begin_alone(at(index));
            }
        }
        self.stripes[0].marked = marked;
        to
    }

    /// Takes up what a marked ball at this place meets besides the balls near it, on the path it is on.
    fn begin_alone(&mut self, at: u32) {
        let (turn, start) = (self.turn_of(at), self.stretch.start);
        let square = self.seen(at).body.velocity(start).length_squared();
        if square > self.stretch.fast {
            // It may be near to what is not near to its cell.
            self.look(&[turn]);
        } else {
            self.alone(at, turn.bounds);
        }
    }
}
