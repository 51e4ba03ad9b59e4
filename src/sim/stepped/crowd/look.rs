//! Looking for what balls meet after they were turned.
#![expect(
    clippy::inline_always,
    reason = "the innermost loops of a tick: a call would cost as much as the work"
)]

use glam::DVec2;

use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::cells::Sorted;
use crate::sim::stepped::crowd::rows::Sought;
use crate::sim::stepped::crowd::search::Solver;
use crate::sim::stepped::crowd::stripe::place;

/// A ball that has just been put on a path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub ball: u32,
    /// When the path began.
    pub from: f64,
    /// The corners of the rectangle that the centre stays in from then on, m.
    pub bounds: [DVec2; 2],
    /// The path as others that look for it will see it.
    pub path: [f32; 4],
}

impl<B: Body, const WIDE: bool> Solver<'_, B, WIDE> {
    /// Lists the places of the balls that balls on new paths may meet, each with the index of the path; false if more may
    /// lie beyond these stripes.
    #[inline(always)]
    fn list_near<const N: usize>(&self, turns: &[Turn; N], list: &mut Vec<(usize, u32)>) -> bool {
        let (cells, start) = (&self.stretch.cells, self.stretch.start);
        let [mut least, mut most] = turns[0].bounds;
        for Turn { bounds, .. } in &turns[1..] {
            (least, most) = (least.min(bounds[0]), most.max(bounds[1]));
        }
        let reach = f64::from(self.near.wide) + self.wander.max(self.fastest);
        let (least, most) = (least - reach, most + reach);
        let ([left, top], [right, bottom]) = (cells.at(least), cells.at(most));
        let sought = Sought::new(
            turns.each_ref().map(|turn| turn.path),
            ((turns[0].from - start) * self.per_second) as f32,
            self.near.wide,
            most.x as f32,
        );
        let mut inside = true;
        for stripe in self.stripes.iter() {
            let (begin, end) = (stripe.rows.start, stripe.rows.end);
            if !WIDE {
                inside = begin <= top && bottom < end;
            }
            let rows = top.max(begin) - begin..(bottom + 1).min(end).max(begin) - begin;
            let columns = left..right + 1;
            let mine = place::of(stripe.index, 0);
            let mut list = |sorted: &Sorted, mark: u32| {
                let ranges = sorted.ranges(rows.clone(), cells.columns, &columns);
                let take = |path, k| list.push((path, mine | mark | k));
                sorted.lanes.meet(ranges, &sought, take);
            };
            list(&stripe.moving, 0);
            if !stripe.still.records.is_empty() {
                list(&stripe.still, place::STILL);
            }
        }
        inside
    }

    /// Looks for what balls on new paths, which begin at the same time, meet until the end.
    pub fn look<const N: usize>(&mut self, turns: &[Turn; N]) {
        for turn in turns {
            self.alone(turn.ball, turn.bounds);
        }
        let mut list = std::mem::take(&mut self.list);
        list.clear();
        if !self.list_near(turns, &mut list) {
            let balls = turns.iter().map(|turn| turn.ball);
            self.stripes[0].wide.extend(balls);
        }
        for &(path, other) in &list {
            let ball = turns[path].ball;
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
        let lanes = &self.stripe(ball).sorted(ball).lanes;
        Turn {
            ball,
            from: seen.from,
            bounds: self.stretch.bounds(seen.body, seen.from),
            path: lanes.path(place::index(ball)),
        }
    }
}
