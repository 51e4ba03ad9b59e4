//! One tick of a crowd.
//!
//! The balls stay where they are in memory; every tick only their records, 16 bytes each, are sorted by cell. Now and
//! then the balls themselves are sorted, so that those that are near each other on the table are near each other in
//! memory ([`Field::sort`]). The table is cut into stripes of rows of cells, one or more for each thread. Each finds and
//! follows its clusters of contacts by itself; those that reach beyond it are followed afterwards, one after the other.

use std::time::Instant;

use glam::DVec2;

use crate::physics::ball::{Ball, State};
use crate::physics::laws::motion::MotionLaw;
use crate::physics::roots::RootError;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::cells::Cells;
use crate::sim::stepped::crowd::census::{Pass, Sums, Tally};
use crate::sim::stepped::crowd::search::{Scratch, Solver};
use crate::sim::stepped::crowd::share::{light, share};
use crate::sim::stepped::crowd::stretch::Stretch;
use crate::sim::stepped::crowd::stripe::Stripe;

/// All balls of one kind.
pub(super) struct Field<B> {
    /// In an order that keeps near what is near; those that rested when they were last sorted come last.
    pub bodies: Vec<B>,
    /// Index in the scene of each.
    pub numbers: Vec<u32>,
    /// Where the ball of each index is; a slot that does not exist for one out of play.
    pub slots: Vec<u32>,
    /// How many of the balls moved when they were last sorted.
    pub moving: usize,
    /// Those of the others that have begun to move since, and for each of the others whether it has.
    pub woken: Vec<u32>,
    pub stirred: Vec<bool>,
    /// Whether the states have been told since.
    pub told: bool,
    pub stripes: Vec<Stripe<B>>,
    scratch: Vec<Scratch>,
    pub cells: Cells,
    /// Seconds since the clock of the bodies was set to zero.
    pub now: f64,
    /// Ticks since then, and work since the balls were last sorted, in balls.
    pub ticks: u32,
    pub work: usize,
    /// Mean square speed, and the largest, m²/s².
    pub mean_square: f64,
    pub speed: f64,
    /// Moving balls that had no speed in the last tick.
    stopped: usize,
}

/// Balls summed up at a time.
const BLOCK: usize = 4096;
/// Each ball is sorted anew after so many ticks in which all moved.
const SORT_AFTER: usize = 32;
/// The clock of the bodies is set to zero after so many ticks.
const REBASE_AFTER: u32 = 256;
/// Balls that get further than this many times the root of the mean square are looked after one by one: with the speeds
/// of a gas one in a hundred and fifty.
const CUT: f64 = 2.2;
/// Least room in a cell beyond a diameter, in radii.
const ROOM: f64 = 0.3;

impl<B: Body> Field<B> {
    fn new(bodies: Vec<B>, numbers: Vec<u32>) -> Self {
        let count = numbers.iter().max().map_or(0, |most| *most as usize + 1);
        let mut slots = vec![u32::MAX; count];
        for (slot, number) in (0..).zip(&numbers) {
            slots[*number as usize] = slot;
        }
        Self {
            moving: bodies.len(),
            bodies,
            numbers,
            slots,
            woken: Vec::new(),
            stirred: Vec::new(),
            told: false,
            stripes: Vec::new(),
            scratch: Vec::new(),
            cells: Cells::new(DVec2::ONE, DVec2::ONE),
            now: 0.0,
            ticks: 0,
            work: 0,
            mean_square: 0.0,
            speed: 0.0,
            stopped: 0,
        }
    }

    /// Balls of these numbers in these states.
    pub fn start(law: &MotionLaw, ball: &Ball, balls: &[(u32, State)]) -> Self {
        let bodies: Vec<B> = balls
            .iter()
            .map(|(_, state)| B::start(law, ball, state, 0.0))
            .collect();
        let mut field = Self::new(bodies, balls.iter().map(|(number, _)| *number).collect());
        let squares = || {
            field
                .bodies
                .iter()
                .map(|body| body.velocity(0.0).length_squared())
        };
        field.mean_square = squares().sum::<f64>() / balls.len().max(1) as f64;
        field.speed = squares().fold(0.0, f64::max).sqrt();
        field
    }

    /// The state of the ball of this number of the scene, if it is in play.
    #[inline]
    pub fn state(&self, ball: &Ball, number: usize) -> Option<State> {
        Some(self.body(number)?.state(ball, self.now))
    }

    #[inline]
    pub fn body(&self, number: usize) -> Option<&B> {
        self.bodies.get(*self.slots.get(number)? as usize)
    }

    /// Whether the ball of this number rests since its state was told.
    #[inline]
    pub fn is_as_told(&self, number: usize) -> bool {
        let slot = self.slots.get(number).map_or(0, |slot| *slot as usize);
        let still = slot.checked_sub(self.moving);
        self.told && still.is_some_and(|still| self.stirred.get(still) == Some(&false))
    }

    /// What is summed over balls. The blocks do not depend on threads.
    pub fn sums(&self, law: &MotionLaw, ball: &Ball, threads: usize) -> Sums {
        let mut sums = vec![Sums::default(); self.moving.div_ceil(BLOCK) + 1];
        let woken = |sums: &mut Sums| {
            for slot in &self.woken {
                self.bodies[*slot as usize].count(law, ball, self.now, sums);
            }
        };
        let blocks = self.bodies[..self.moving].chunks(BLOCK).zip(&mut sums[1..]);
        share(light(threads, self.moving), blocks, |(bodies, sums)| {
            for body in bodies {
                body.count(law, ball, self.now, sums);
            }
        });
        woken(&mut sums[0]);
        let mut all = Sums::default();
        for sum in &sums {
            all.add(sum);
        }
        all
    }

    /// Balls that may move.
    pub fn awake(&self) -> usize {
        self.moving + self.woken.len()
    }

    /// Advances all balls by a stretch of time.
    pub fn advance(&mut self, stretch: &Stretch, cell: Option<DVec2>, threads: usize) -> Tally {
        let mut lap = Instant::now();
        let mut tally = Tally::default();
        let length = stretch.end - stretch.start;
        let (start, end) = (self.now, self.now + length);
        let cut = self.cut(stretch, length);
        let overdue = self.work >= SORT_AFTER * self.bodies.len()
            || self.woken.len() > 64 + self.moving / 8
            || self.ticks > 8 && self.stopped > 64 + self.moving / 8 && self.work > 8 * self.moving
            || (cell.is_none()
                && Self::reach(stretch, cut) * self.cells.per_cell.max_element() > 1.0 + 1e-6);
        if self.stripes.is_empty() || overdue {
            self.sort(stretch, cell, cut);
        } else if self.ticks >= REBASE_AFTER {
            self.rebase(stretch);
        }
        let (start, end) = (
            start.min(self.now),
            if start == self.now {
                end
            } else {
                self.now + length
            },
        );
        let stretch = stretch.within([start, end], self.cells, cut);
        self.lay_records(&stretch, threads);
        tally.time(Pass::Grid, &mut lap);
        self.follow(&stretch, threads);
        let mut lap = Instant::now();
        self.commit(threads);
        for stripe in &self.stripes {
            tally.add(&stripe.tally);
        }
        if let MotionLaw::Coursework(_) = stretch.laws.motion {
            self.rub(&stretch);
        }
        self.now = end;
        self.ticks += 1;
        self.work += self.awake();
        self.mean_square = tally.squares / (self.awake().max(1) as f64);
        self.speed = tally.speed.sqrt();
        self.stopped = tally.stopped as usize;
        tally.time(Pass::Move, &mut lap);
        tally
    }

    fn cut(&self, stretch: &Stretch, length: f64) -> f64 {
        let bend = if B::BENDS { length * stretch.bend } else { 0.0 };
        let usual = 0.5 * length * (CUT * self.mean_square.sqrt() + bend);
        // A few fast balls among many slow ones must not be all in all.
        usual.max(0.5 * ROOM * stretch.ball.radius)
    }

    /// How far the centres of two balls can be from each other in the middle of their paths, and meet.
    pub fn reach(stretch: &Stretch, cut: f64) -> f64 {
        (stretch.reach() + 2.0 * cut) * (1.0 + 1e-4)
    }

    /// Sorts the records of all moving balls by cell.
    fn lay_records(&mut self, stretch: &Stretch, threads: usize) {
        let bodies = &self.bodies;
        let threads = light(threads, self.moving);
        share(threads, self.stripes.iter_mut(), |stripe| {
            stripe.stage(stretch, bodies);
        });
        let columns = stretch.cells.columns;
        let mut leaving = Vec::new();
        for stripe in &mut self.stripes {
            leaving.append(&mut stripe.leaving);
        }
        for &slot in &self.woken {
            let first = &mut self.stripes[0];
            leaving.push(stretch.record(&bodies[slot as usize], slot, &mut first.tally));
        }
        for (record, key) in leaving {
            let row = Stripe::<B>::row_of(key, columns);
            let home = self
                .stripes
                .iter_mut()
                .find(|stripe| stripe.rows.contains(&row));
            if let Some(home) = home {
                home.coming.push((record, key));
            }
        }
    }

    /// Finds and follows all clusters.
    fn follow(&mut self, stretch: &Stretch, threads: usize) {
        let fastest = self.stripes.iter().map(|stripe| stripe.tally.speed);
        let fastest = stretch.freedom(fastest.fold(0.0, f64::max));
        let all = self.stripes.len();
        self.scratch.resize_with(all, Scratch::default);
        let truth = (&self.bodies[..], &self.numbers[..]);
        let span = stretch.cells.span(Self::reach(stretch, stretch.cut));
        let work = self.stripes.iter_mut().zip(&mut self.scratch);
        share(threads, work, |(stripe, scratch)| {
            let mut lap = Instant::now();
            stripe.scatter(stretch);
            stripe.tally.time(Pass::Grid, &mut lap);
            let index = stripe.index;
            let stripes = std::slice::from_mut(stripe);
            let mut solver =
                Solver::<B, false>::new(stretch, (stripes, index, all), truth, fastest, scratch);
            solver.work_through(span, scratch);
            solver.finish(scratch);
        });
        let mut lap = Instant::now();
        let scratch = &mut self.scratch[0];
        let mut solver = Solver::<B, true>::new(
            stretch,
            (&mut self.stripes, 0, all),
            truth,
            fastest,
            scratch,
        );
        if all > 1 {
            solver.begin_across(span, scratch);
            solver.gather();
            solver.look_beyond();
            solver.resolve(None);
        }
        solver.finish(scratch);
        self.stripes[0].tally.time(Pass::Resolve, &mut lap);
    }

    /// The failure of the ball with the lowest number, if any.
    pub fn failure(&self) -> Option<(u32, RootError)> {
        let failures = self.stripes.iter().filter_map(|stripe| stripe.failure);
        failures.min_by_key(|(number, _)| *number)
    }
}
