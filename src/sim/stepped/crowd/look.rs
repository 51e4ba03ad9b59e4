//! Looking for what balls meet after they were turned.

use glam::DVec2;

use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::cells::Sorted;
use crate::sim::stepped::crowd::rows::Sought;
use crate::sim::stepped::crowd::search::Solver;
use crate::sim::stepped::crowd::stripe::place;
use crate::sim::stepped::crowd::turned::{Kind, Leg};

/// A ball that has just been put on a path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn<B> {
    pub ball: u32,
    pub leg: Leg<B>,
    /// Where it is halfway to the end, and how far it gets from there, m.
    pub middle: DVec2,
    pub extent: f64,
    /// The path as others that look for it will see it.
    pub path: [f32; 4],
}

impl<B: Body, const WIDE: bool> Solver<'_, B, WIDE> {
    /// Lists the places of the balls that balls on new paths may meet, each with the index of the path; false if more may
    /// lie beyond these stripes.
    fn list_near<const N: usize>(
        &self,
        turns: &[Turn<B>; N],
        list: &mut Vec<(usize, u32)>,
    ) -> bool {
        let (cells, start) = (&self.stretch.cells, self.stretch.start);
        let reach = f64::from(self.near.wide) + self.wander.max(self.fastest);
        let (mut least, mut most) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for turn in turns {
            least = least.min(turn.middle - (reach + turn.extent));
            most = most.max(turn.middle + (reach + turn.extent));
        }
        let ([left, top], [right, bottom]) = (cells.at(least), cells.at(most));
        let sought = Sought {
            paths: turns.each_ref().map(|turn| turn.path),
            after: ((turns[0].leg.from - start) * self.per_second) as f32,
            wide: self.near.wide,
            last: most.x as f32,
        };
        let mut inside = true;
        for row in top..=bottom {
            let stripe = if WIDE {
                match self.stripe_of(row) {
                    Some(index) => &self.stripes[index],
                    None => continue,
                }
            } else if self.stripes[0].rows.contains(&row) {
                &self.stripes[0]
            } else {
                inside = false;
                continue;
            };
            let begin = (row - stripe.rows.start) * cells.columns;
            let mine = place::of(stripe.index, 0);
            let mut list = |sorted: &Sorted, mark: u32| {
                let range = [sorted.first[begin + left], sorted.first[begin + right + 1]];
                let take = |path, k| list.push((path, mine | mark | k));
                sorted.lanes.meet::<N, true>(range, &sought, take);
            };
            if !stripe.moving.records.is_empty() {
                list(&stripe.moving, 0);
            }
            if !stripe.still.records.is_empty() {
                list(&stripe.still, place::STILL);
            }
        }
        inside
    }

    /// Looks for what balls on new paths, which begin at the same time, meet until the end.
    pub fn look<const N: usize>(&mut self, turns: &[Turn<B>; N]) {
        for turn in turns {
            self.alone(turn.ball, &turn.leg);
        }
        let mut list = std::mem::take(&mut self.list);
        list.clear();
        if !self.list_near(turns, &mut list) {
            let balls = turns.iter().map(|turn| turn.ball);
            self.stripes[0].wide.extend(balls);
        }
        for &(path, other) in &list {
            let Turn { ball, leg, .. } = &turns[path];
            if other != *ball {
                self.look_at(*ball, leg, other);
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
            self.look_at(one.ball, &one.leg, other.ball);
        }
    }

    #[inline]
    fn look_at(&mut self, ball: u32, leg: &Leg<B>, other: u32) {
        let theirs = self.seen(other);
        if let Some(time) = self.meet(ball, &leg.seen(), &theirs) {
            let turns = [leg.turns, theirs.turns];
            self.wait(time, ball, Kind::Ball(other), turns);
        }
    }

    /// What is needed to look for what a ball meets from its last turn on.
    pub fn turn_of(&self, ball: u32) -> Turn<B> {
        let leg = self.leg(ball);
        Turn {
            ball,
            middle: leg.body.position(0.5 * (leg.from + self.stretch.end)),
            extent: self.stretch.extent(&leg.body, leg.from),
            path: self
                .stripe(ball)
                .sorted(ball)
                .lanes
                .path(place::index(ball)),
            leg,
        }
    }
}
