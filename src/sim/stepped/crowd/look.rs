//! Looking for what balls meet after they were turned.
#![expect(
    clippy::inline_always,
    reason = "the innermost loops of a tick: a call would cost as much as the work"
)]

use std::ops::Range;

use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::rows::Sought;
use crate::sim::stepped::crowd::search::Solver;
use crate::sim::stepped::crowd::stripe::{Stripe, place};

/// A ball that has just been put on a path. In f32: it only tells what it certainly does not meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub ball: u32,
    /// Which part of the tick was over when the path began.
    pub after: f32,
    /// The corners of the rectangle that the centre stays in from then on, m.
    pub bounds: [f32; 4],
    /// The path as others that look for it will see it.
    pub path: [f32; 4],
}

/// Rows that nearly all that a ball may meet lies in.
const FEW: usize = 4;

impl<B: Body, const WIDE: bool> Solver<'_, B, WIDE> {
    /// Lists the places of the balls that a ball on a new path may meet; false if more may lie beyond these stripes.
    #[inline(always)]
    fn list_near(&self, turn: &Turn, list: &mut Vec<[u32; 2]>) -> bool {
        let (corners, last) = self.frame.around(turn.bounds, self.near.wide, self.wander);
        let [left, top, right, bottom] = corners;
        let sought = Sought::new(turn.path, turn.after, self.near.wide, last);
        let stripe = if WIDE {
            self.stripe_of(top).unwrap_or(0)
        } else {
            0
        };
        let Stripe {
            index,
            moving,
            still,
            rows,
            ..
        } = &self.stripes[stripe];
        let is_far = bottom >= top + FEW || rows.len() < FEW || WIDE && bottom >= rows.end;
        if is_far || !still.records.is_empty() {
            return self.list_all(turn.ball, [top, bottom], left..right + 1, &sought, list);
        }
        // At an edge of the stripe some rows more are looked at.
        let begin = top.max(rows.start).min(rows.end - FEW);
        let columns = self.stretch.cells.columns;
        let first = &moving.first[(begin - rows.start) * columns..];
        let row = |k| [first[k * columns + left], first[k * columns + right + 1]];
        let mine = place::of(*index, 0);
        let take = |k| list.push([turn.ball, mine | k]);
        // Most that a ball may meet lies in three rows.
        if bottom.min(rows.end - 1) + 1 < begin + FEW {
            moving
                .lanes
                .meet_few(&[row(0), row(1), row(2)], &sought, take);
        } else {
            let ranges = [row(0), row(1), row(2), row(3)];
            moving.lanes.meet_few(&ranges, &sought, take);
        }
        WIDE || rows.start <= top && bottom < rows.end
    }

    /// The same for any rows of all these stripes, and balls at rest.
    #[inline(never)]
    fn list_all(
        &self,
        ball: u32,
        [top, bottom]: [usize; 2],
        columns: Range<usize>,
        sought: &Sought,
        list: &mut Vec<[u32; 2]>,
    ) -> bool {
        let mut inside = true;
        for stripe in self.stripes.iter() {
            let (begin, end) = (stripe.rows.start, stripe.rows.end);
            inside = WIDE || begin <= top && bottom < end;
            let rows = top.max(begin) - begin..(bottom + 1).min(end).max(begin) - begin;
            let mine = place::of(stripe.index, 0);
            for (sorted, mark) in [(&stripe.moving, 0), (&stripe.still, place::STILL)] {
                if !sorted.records.is_empty() {
                    let ranges =
                        sorted.ranges(rows.clone(), self.stretch.cells.columns, columns.clone());
                    let take = |k| list.push([ball, mine | mark | k]);
                    sorted.lanes.meet(ranges, sought, take);
                }
            }
        }
        inside
    }

    /// Looks for what balls on new paths, which begin at the same time, meet until the end.
    pub fn look<const N: usize>(&mut self, turns: &[Turn; N]) {
        let mut list = std::mem::take(&mut self.list);
        list.clear();
        for turn in turns {
            self.alone(turn.ball, turn.bounds);
            if !self.list_near(turn, &mut list) {
                self.stripes[0].wide.push(turn.ball);
            }
        }
        for &[ball, other] in &list {
            if other != ball {
                self.begin(ball, other);
            }
        }
        self.list = list;
        for turn in turns {
            let sorted = self.stripe_mut(turn.ball).sorted_mut(turn.ball);
            sorted.lanes.set(place::index(turn.ball), turn.path);
        }
        if let [one, other] = turns.as_slice()
            && B::BENDS
        {
            // Two balls on straight lines have nothing more to do with each other.
            self.begin(one.ball, other.ball);
        }
    }

    /// What is needed to look for what a ball meets from its last turn on.
    pub fn turn_of(&self, ball: u32) -> Turn {
        let seen = self.seen(ball);
        self.stretch.turn(ball, seen.body, seen.from)
    }
}
