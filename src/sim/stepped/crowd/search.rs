//! Finding what meets: the memory of a solver, and its questions.

use std::collections::BinaryHeap;

use glam::DVec2;

use crate::physics::contact;
use crate::physics::roots::RootError;
use crate::physics::table::Cushion;
use crate::sim::stepped::crowd::body::{Body, track};
use crate::sim::stepped::crowd::caught::{Contact, Kind, Leg, NONE};
use crate::sim::stepped::crowd::cells::{CAUGHT, Row, roomy};
use crate::sim::stepped::crowd::census::Tally;
use crate::sim::stepped::crowd::stripe::{Stretch, Stripe, place};
use crate::sim::stepped::resolve::{BOUNCES, IMPACTS};

/// What is added to distances before they are compared, for rounding; a share.
pub(super) const MARGIN: f64 = 1e-9;
/// A ball that has met so many others in a part of a tick that it no longer bounces meets them at most this often in a
/// part: balls pressed together would meet without end. Until then they may overlap a little.
const RATTLES: f64 = 16.0;

/// Memory that is kept from tick to tick.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    queue: BinaryHeap<Contact>,
    near: Vec<u32>,
    pub close: Vec<[u32; 2]>,
    pub likely: Vec<[u32; 2]>,
    pub lanes: Vec<Row>,
    /// The rows before this one are in `lanes`.
    pub filled: usize,
}

/// Follows the clusters of some stripes, one next to the other.
pub(super) struct Solver<'a, B> {
    pub stretch: &'a Stretch<'a>,
    pub stripes: &'a mut [Stripe<B>],
    /// Index of the first of these stripes.
    pub base: usize,
    /// How many stripes there are in all.
    pub all: usize,
    pub bodies: &'a [B],
    pub numbers: &'a [u32],
    /// How far fast balls get, m.
    pub fastest: f64,
    pub wander: f64,
    pub queue: BinaryHeap<Contact>,
    /// Places near one that is looked at.
    pub near: Vec<u32>,
    /// The pairs of all rows before this one are linked.
    pub begun: usize,
    /// Whether a cluster reaches beyond these stripes.
    pub outside: bool,
    /// Contacts with balls, with cushions, and balls that no longer bounce, of the cluster that is followed.
    pub count: [u32; 3],
}

impl<'a, B: Body> Solver<'a, B> {
    pub fn new(
        stretch: &'a Stretch,
        (stripes, base, all): (&'a mut [Stripe<B>], usize, usize),
        (bodies, numbers): (&'a [B], &'a [u32]),
        fastest: f64,
        scratch: &mut Scratch,
    ) -> Self {
        let wander = stripes.iter().map(|stripe| stripe.wander);
        let wander = wander.fold(stretch.most, f64::max);
        Self {
            stretch,
            base,
            all,
            bodies,
            numbers,
            fastest: (fastest + stretch.spare).max(stretch.most),
            wander,
            queue: std::mem::take(&mut scratch.queue),
            near: std::mem::take(&mut scratch.near),
            begun: usize::MAX,
            outside: false,
            count: [0; 3],
            stripes,
        }
    }

    /// Gives the memory back.
    pub fn finish(self, scratch: &mut Scratch) {
        self.stripes[0].wander = self.wander;
        scratch.queue = self.queue;
        scratch.near = self.near;
    }

    pub fn is_whole(&self) -> bool {
        self.stripes.len() == self.all
    }

    pub fn tally(&mut self) -> &mut Tally {
        &mut self.stripes[0].tally
    }

    /// Slot of the ball at a place.
    #[inline]
    pub fn slot(&self, at: u32) -> usize {
        let stripe = &self.stripes[place::stripe(at) - self.base];
        stripe.sorted(at).slots[place::index(at)] as usize
    }

    /// Slot of the ball at a place, or, with true, its place among the caught.
    #[inline]
    pub fn held(&self, at: u32) -> (u32, bool) {
        let stripe = &self.stripes[place::stripe(at) - self.base];
        let ball = stripe.sorted(at).records[place::index(at)].ball;
        (ball & !CAUGHT, ball & CAUGHT != 0)
    }

    /// The stripe of a row, as an index of `stripes`; `None` if it is not among them.
    #[inline]
    pub fn stripe_of(&self, row: usize) -> Option<usize> {
        self.stripes
            .iter()
            .position(|stripe| stripe.rows.contains(&row))
    }

    /// Links the balls of pairs both ways.
    pub fn link(&mut self, close: &[[u32; 2]]) {
        for &[one, other] in close {
            for (one, other) in [(one, other), (other, one)] {
                let stripe = &mut self.stripes[place::stripe(one) - self.base];
                let sorted = if one & place::STILL == 0 {
                    &mut stripe.moving
                } else {
                    &mut stripe.still
                };
                sorted.link(place::index(one), other, &mut stripe.links);
            }
        }
    }

    /// The changes of motion and the cushions that a leg leads to.
    pub fn alone(&mut self, leg: &Leg<B>, number: u32, mut take: impl FnMut(Contact)) {
        let Leg { body, from, .. } = leg;
        let end = self.stretch.end;
        let contact = |time, kind, order| Contact {
            time,
            order,
            ball: NONE,
            kind,
            legs: [NONE; 2],
        };
        if B::BENDS && body.change() <= end {
            let time = body.change().max(*from);
            take(contact(time, Kind::Change, Contact::order(0, 0, number)));
        }
        let middle = body.position(0.5 * (from + end));
        let walls = self.stretch.walls;
        if walls.is_clear(middle) || !body.translates() {
            return;
        }
        let left = (end.min(body.change()) - from).max(0.0);
        let path = track(body, *from);
        let reach = self.stretch.table.reach(self.stretch.ball.radius);
        for listed in walls.near(middle) {
            let index = walls.cushion(listed);
            let met = match &self.stretch.table.cushions[index as usize] {
                Cushion::Line(line) => contact::line(&path, line, reach, left),
                Cushion::Arc(arc) => contact::arc(&path, arc, reach, left),
            };
            if let Some(met) = self.found(number, met) {
                let order = Contact::order(1, index, number);
                take(contact(from + met, Kind::Cushion(index), order));
            }
        }
    }

    /// When two legs meet before `end`. Seen from the moment at which the later of them begins, whoever asks and when.
    pub fn meet(
        &mut self,
        (one, m): (&Leg<B>, u32),
        (two, n): (&Leg<B>, u32),
        end: f64,
        impacts: u32,
    ) -> Option<f64> {
        let from = one.from.max(two.from);
        let (a, b) = if m < n { (one, two) } else { (two, one) };
        let mut left = end - from;
        if B::BENDS {
            if !(a.body.translates() || b.body.translates()) {
                return None;
            }
            let change = a.body.change().min(b.body.change());
            left = left.min(change - from);
        }
        if impacts > IMPACTS {
            return None;
        }
        let paths = [track(&a.body, from), track(&b.body, from)];
        let met = contact::pair(&paths[0], &paths[1], self.stretch.reach(), left.max(0.0));
        let met = self.found(m.min(n), met)?;
        if impacts < BOUNCES {
            return Some(from + met);
        }
        // A ball that rattles between others meets them at most so often.
        let least = (self.stretch.end - self.stretch.start) / RATTLES;
        Some(from + met.max(least)).filter(|time| *time <= end)
    }

    /// Whether a leg may meet another between `from` and `end`: most pass each other, which is told without a division
    /// and without a root.
    #[inline]
    pub fn may_meet(&self, leg: &Leg<B>, other: &B, from: f64, end: f64) -> bool {
        let left = end - from;
        let offset = other.position(from) - leg.body.position(from);
        let velocity = other.velocity(from) - leg.body.velocity(from);
        let margin = if B::BENDS {
            self.stretch.bend * left * left
        } else {
            0.0
        };
        let wide = (self.stretch.reach() + margin) * (1.0 + MARGIN);
        let gap = offset.length_squared() - wide * wide;
        let slope = offset.dot(velocity);
        let square = velocity.length_squared();
        let last = gap + left * (2.0 * slope + square * left);
        let passes = gap * square > slope * slope || -slope >= square * left;
        gap <= 0.0 || slope < 0.0 && (last <= 0.0 || !passes)
    }

    /// Lists the places of the balls that may come within `near` m of a place; false if more may lie beyond these stripes.
    pub fn list_near(&self, middle: DVec2, near: f64, list: &mut Vec<u32>) -> bool {
        let cells = &self.stretch.cells;
        let reach = (near + self.wander.max(self.fastest)) * (1.0 + MARGIN);
        let window = cells.window(middle, reach);
        let [left, right] = window.columns;
        let (x, z) = (middle.x as f32, middle.y as f32);
        let near = roomy(near) + f32::EPSILON * (x.abs() + z.abs());
        let mut inside = true;
        for row in window.rows[0]..=window.rows[1] {
            let Some(index) = self.stripe_of(row) else {
                inside = false;
                continue;
            };
            let stripe = &self.stripes[index];
            let begin = (row - stripe.rows.start) * cells.columns;
            let mine = place::of(stripe.index, 0);
            for (sorted, mark) in [(&stripe.moving, 0), (&stripe.still, place::STILL)] {
                if sorted.records.is_empty() {
                    continue;
                }
                let from = sorted.first[begin + left] as usize;
                let to = sorted.first[begin + right + 1] as usize;
                for (k, record) in (from as u32..).zip(&sorted.records[from..to]) {
                    let (dx, dz) = (record.x - x, record.z - z);
                    let most = near + record.free;
                    // A fast ball, of which this is not a number, may be anywhere in the window.
                    let is_far = dx * dx + dz * dz >= most * most;
                    if !is_far {
                        list.push(mine | mark | k);
                    }
                }
            }
        }
        inside
    }

    /// The time found; the failure of the ball with the lowest number is kept.
    #[inline]
    fn found(&mut self, number: u32, result: Result<Option<f64>, RootError>) -> Option<f64> {
        result.unwrap_or_else(|error| {
            let failure = &mut self.stripes[0].failure;
            if failure.is_none_or(|(other, _)| number < other) {
                *failure = Some((number, error));
            }
            None
        })
    }
}
