//! Finding what meets: the memory of a solver, and its questions.
#![expect(
    clippy::inline_always,
    reason = "the innermost loops of a tick: a call would cost as much as the work"
)]

use std::cell::Cell;

use crate::physics::contact;
use crate::physics::roots::RootError;
use crate::physics::table::Cushion;
use crate::sim::stepped::crowd::body::{Body, track};
use crate::sim::stepped::crowd::calendar::Calendar;
use crate::sim::stepped::crowd::cells::TURNED;
use crate::sim::stepped::crowd::census::Tally;
use crate::sim::stepped::crowd::frame::{Frame, Wander};
use crate::sim::stepped::crowd::pairs::Close;
use crate::sim::stepped::crowd::rows::Near;
use crate::sim::stepped::crowd::stretch::Stretch;
use crate::sim::stepped::crowd::stripe::{Stripe, place};
use crate::sim::stepped::crowd::turned::{Contact, Kind, Leg, Seen};
use crate::sim::stepped::resolve::IMPACTS;

/// Memory that is kept from tick to tick.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    pub close: Close,
    list: Vec<[u32; 2]>,
    queue: Calendar,
    held: Vec<Contact>,
}

/// Finds and resolves the contacts of all stripes, or, if it is not `WIDE`, of one.
pub(super) struct Solver<'a, B, const WIDE: bool> {
    pub stretch: &'a Stretch<'a>,
    pub stripes: &'a mut [Stripe<B>],
    /// Index of the first of these stripes.
    pub base: usize,
    /// How many stripes there are in all.
    pub all: usize,
    pub bodies: &'a [B],
    pub numbers: &'a [u32],
    /// How far balls get from the middle of the path they began on, along x or z, m.
    pub wander: Wander,
    /// What is near balls that are looked at.
    pub list: Vec<[u32; 2]>,
    pub near: Near,
    /// Half the sides of the rectangle in which a ball touches no cushion, m.
    pub free: [f32; 2],
    pub frame: Frame,
    /// Contacts that wait for their turn, and those that wait for something beyond what is known.
    pub queue: Calendar,
    pub held: Vec<Contact>,
    /// Square of the least distance of two balls at the start, m².
    pub nearest: Cell<f64>,
    failure: Cell<Option<(u32, RootError)>>,
}

impl<'a, B: Body, const WIDE: bool> Solver<'a, B, WIDE> {
    pub fn new(
        stretch: &'a Stretch,
        (stripes, base, all): (&'a mut [Stripe<B>], usize, usize),
        (bodies, numbers): (&'a [B], &'a [u32]),
        fastest: f64,
        scratch: &mut Scratch,
    ) -> Self {
        scratch.queue.open(stretch.start, stretch.end);
        let mut wander = Wander::new(stretch.cut.max(fastest) as f32);
        for stripe in stripes.iter() {
            wander.add(stripe.wander);
        }
        Self {
            stretch,
            base,
            all,
            bodies,
            numbers,
            wander,
            list: std::mem::take(&mut scratch.list),
            near: stretch.near(),
            free: stretch.free(),
            frame: Frame::new(&stretch.cells),
            queue: std::mem::take(&mut scratch.queue),
            held: std::mem::take(&mut scratch.held),
            nearest: Cell::new(f64::INFINITY),
            failure: Cell::new(stripes[0].failure),
            stripes,
        }
    }

    /// Gives the memory back.
    pub fn finish(mut self, scratch: &mut Scratch) {
        self.stripes[0].wander = self.wander;
        self.stripes[0].failure = self.failure.get();
        let overlap = self.stretch.reach() - self.nearest.get().sqrt();
        let tally = self.tally();
        tally.overlap = tally.overlap.max(overlap);
        scratch.list = self.list;
        scratch.queue = self.queue;
        scratch.held = self.held;
    }

    pub fn tally(&mut self) -> &mut Tally {
        &mut self.stripes[0].tally
    }

    #[inline(always)]
    pub fn stripe(&self, at: u32) -> &Stripe<B> {
        if WIDE {
            &self.stripes[place::stripe(at)]
        } else {
            &self.stripes[0]
        }
    }

    #[inline(always)]
    pub fn stripe_mut(&mut self, at: u32) -> &mut Stripe<B> {
        if WIDE {
            &mut self.stripes[place::stripe(at)]
        } else {
            &mut self.stripes[0]
        }
    }

    /// The path that the ball at a place is on.
    #[inline(always)]
    pub fn leg(&self, at: u32) -> Leg<B> {
        let Seen {
            body,
            from,
            impacts,
            turns,
        } = self.seen(at);
        Leg {
            body: *body,
            from,
            impacts,
            turns,
        }
    }

    /// The same without a copy of the body.
    #[inline(always)]
    pub fn seen(&self, at: u32) -> Seen<'_, B> {
        let stripe = self.stripe(at);
        let ball = stripe.sorted(at).balls[place::index(at)];
        stripe.turned.seen(ball, self.bodies)
    }

    /// Has the body of the ball at a place, as it began the tick, brought to the cache.
    #[inline(always)]
    pub fn touch(&self, at: u32) -> u64 {
        let ball = self.stripe(at).sorted(at).balls[place::index(at)];
        let body = self.bodies.get((ball & !TURNED) as usize);
        body.map_or(0, B::touch)
    }

    /// How often the ball at a place has been turned.
    #[inline(always)]
    pub fn turns(&self, at: u32) -> u16 {
        let stripe = self.stripe(at);
        stripe
            .turned
            .turns(stripe.sorted(at).balls[place::index(at)])
    }

    /// Slot of the ball at a place.
    #[inline]
    pub fn slot(&self, at: u32) -> u32 {
        let stripe = self.stripe(at);
        stripe
            .turned
            .slot(stripe.sorted(at).balls[place::index(at)])
    }

    /// Index in the scene of the ball at a place.
    #[inline]
    pub fn number(&self, at: u32) -> u32 {
        self.numbers[self.slot(at) as usize]
    }

    /// The stripe of a row, as an index of `stripes`; `None` if it is not among them.
    #[inline]
    pub fn stripe_of(&self, row: usize) -> Option<usize> {
        self.stripes
            .iter()
            .position(|stripe| stripe.rows.contains(&row))
    }

    /// Has the changes of motion and the cushions that the path of a ball leads to wait. Its centre stays in a rectangle
    /// with these corners.
    #[inline(always)]
    pub fn alone(&mut self, ball: u32, [left, top, right, bottom]: [f32; 4]) {
        if B::BENDS {
            let Seen {
                body, from, turns, ..
            } = self.seen(ball);
            let change = body.change();
            if change <= self.stretch.end {
                self.wait(change.max(from), ball, Kind::Change, [turns, 0]);
            }
        }
        let [x, z] = self.free;
        if left < -x || top < -z || right > x || bottom > z {
            self.cushions(ball);
        }
    }

    /// Has the cushions that the path of a ball leads to wait.
    #[inline(never)]
    fn cushions(&mut self, ball: u32) {
        let Leg {
            body,
            from,
            impacts,
            turns,
        } = self.leg(ball);
        if !body.translates() || u32::from(impacts) > IMPACTS {
            return;
        }
        let (end, walls) = (self.stretch.end, self.stretch.walls);
        let left = (end.min(body.change()) - from).max(0.0);
        let path = track(&body, from);
        let reach = self.stretch.table.reach(self.stretch.ball.radius);
        for listed in walls.near(body.position(0.5 * (from + end))) {
            let index = walls.cushion(listed);
            let met = match &self.stretch.table.cushions[index as usize] {
                Cushion::Line(line) => contact::line(&path, line, reach, left),
                Cushion::Arc(arc) => contact::arc(&path, arc, reach, left),
            };
            if let Some(met) = self.found(ball, met) {
                // Only a slope drives a ball back to a cushion by itself.
                let pause = if self.stretch.pull > 0.0 {
                    self.stretch.pause(u32::from(impacts))
                } else {
                    0.0
                };
                if pause <= end - from {
                    let time = from + met.max(pause);
                    self.wait(time, ball, Kind::Cushion(index), [turns, 0]);
                }
            }
        }
    }

    /// The time found; the failure of the ball with the lowest number is kept.
    #[inline]
    pub fn found(&self, place: u32, result: Result<Option<f64>, RootError>) -> Option<f64> {
        result.unwrap_or_else(|error| {
            let number = self.number(place);
            if self.failure.get().is_none_or(|(other, _)| number < other) {
                self.failure.set(Some((number, error)));
            }
            None
        })
    }
}
