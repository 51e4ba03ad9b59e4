//! A tile and what surrounds it, copied together and sorted by cell: small enough for the cache of one core.

use std::time::Instant;

use glam::DVec2;

use crate::physics::ball::Ball;
use crate::physics::laws::Laws;
use crate::physics::laws::motion::MotionLaw;
use crate::physics::roots::RootError;
use crate::physics::table::Table;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::census::{Pass, Tally};
use crate::sim::stepped::crowd::queue::Calendar;
use crate::sim::stepped::crowd::walls::Walls;

/// What holds for all balls during one stretch of time: the tick, or a part of it.
#[derive(Clone, Copy)]
pub(super) struct Stretch<'a> {
    pub laws: &'a Laws,
    pub table: &'a Table,
    /// The constants of every ball.
    pub ball: Ball,
    /// Length of the stretch, s.
    pub length: f64,
    /// Size of a cell in m; fitted to balls and speeds where absent.
    pub cell: Option<DVec2>,
    pub walls: &'a Walls,
}

/// What a ball of a patch is there for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// The patch says what becomes of it.
    Own,
    /// It can meet an own ball; its own tile must find the same path for it.
    Near,
    /// It can meet a near ball.
    Far,
}

/// Where a ball of a patch comes from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Origin {
    /// Index in the scene.
    pub number: u32,
    pub tile: u32,
    pub slot: u32,
    pub role: Role,
}

/// Where a ball of a patch is listed.
pub(super) const STATIC: u32 = u32::MAX;
pub(super) const FAST: u32 = u32::MAX - 1;
pub(super) const END: u32 = u32::MAX;

/// Balls that move further than this many radii from the middle of their path are listed apart, if they are few: they
/// would make the cells too large for all others.
const SLACK: f64 = 1.2;
/// What is added to distances before they are compared, for rounding; a share.
pub(super) const MARGIN: f64 = 1e-9;
/// One ball in so many may be listed apart.
const FEW: usize = 32;

/// The scratch memory of one thread.
pub(super) struct Patch<B> {
    staged: Vec<(B, Origin)>,
    cell_of: Vec<u32>,
    /// Sorted by cell.
    pub(super) bodies: Vec<B>,
    pub(super) origins: Vec<Origin>,
    /// The middle of each path of the stretch; infinite once the ball is listed elsewhere.
    pub(super) x: Vec<f64>,
    pub(super) z: Vec<f64>,
    /// The middle of the new path of a ball that is listed in a chain.
    pub(super) middles: Vec<DVec2>,
    /// Index of the first ball of each cell.
    pub(super) first: Vec<u32>,
    /// Balls whose path has changed, chained by cell.
    pub(super) heads: Vec<u32>,
    pub(super) next: Vec<u32>,
    pub(super) listed: Vec<u32>,
    pub(super) fast: Vec<u32>,
    pub(super) since: Vec<f64>,
    pub(super) versions: Vec<u32>,
    pub(super) impacts: Vec<u32>,
    pub(super) calendar: Calendar,
    /// Pairs close enough to be looked at.
    pub(super) close: Vec<[u32; 2]>,
    /// Balls close enough to one to be looked at.
    pub(super) near: Vec<u32>,
    pub(super) least: DVec2,
    pub(super) per_cell: DVec2,
    pub(super) columns: usize,
    pub(super) rows: usize,
    /// How many cells away a ball can be met, along x and z.
    pub(super) span: [usize; 2],
    /// No listed ball leaves the circle of this radius round the middle of its path, m.
    pub(super) slack: f64,
    /// Largest acceleration, m/s².
    pub(super) bend: f64,
    pub(super) tally: Tally,
    pub(super) failure: Option<(u32, RootError)>,
}

impl<B: Body> Patch<B> {
    pub fn new() -> Self {
        Self {
            staged: Vec::new(),
            cell_of: Vec::new(),
            bodies: Vec::new(),
            origins: Vec::new(),
            x: Vec::new(),
            z: Vec::new(),
            middles: Vec::new(),
            first: Vec::new(),
            heads: Vec::new(),
            next: Vec::new(),
            listed: Vec::new(),
            fast: Vec::new(),
            since: Vec::new(),
            versions: Vec::new(),
            impacts: Vec::new(),
            calendar: Calendar::default(),
            close: Vec::new(),
            near: Vec::new(),
            least: DVec2::ZERO,
            per_cell: DVec2::ONE,
            columns: 0,
            rows: 0,
            span: [1, 1],
            slack: 0.0,
            bend: 0.0,
            tally: Tally::default(),
            failure: None,
        }
    }

    /// Begins a new patch.
    pub fn clear(&mut self) {
        self.staged.clear();
        self.tally = Tally::default();
        self.failure = None;
    }

    /// Adds a ball.
    #[inline]
    pub fn add(&mut self, body: &B, origin: Origin) {
        self.staged.push((*body, origin));
    }

    /// Follows all balls through the stretch.
    pub fn solve(&mut self, stretch: &Stretch) {
        let mut lap = Instant::now();
        self.sort(stretch);
        self.tally.time(Pass::Grid, &mut lap);
        self.collide_balls(stretch);
        self.tally.time(Pass::Balls, &mut lap);
        self.collide_cushions(stretch);
        self.tally.time(Pass::Cushions, &mut lap);
        self.resolve(stretch);
        self.tally.time(Pass::Resolve, &mut lap);
    }

    /// Every ball at the end of the stretch, with the changes of its path and its origin.
    pub fn ends<'a>(&'a self, stretch: &'a Stretch) -> impl Iterator<Item = (B, u32, Origin)> + 'a {
        self.bodies
            .iter()
            .zip(&self.since)
            .zip(self.versions.iter().zip(&self.origins))
            .map(|((body, since), (changes, origin))| {
                let age = stretch.length - since;
                let end = match &stretch.laws.motion {
                    law @ MotionLaw::Coursework(coursework) => {
                        let state = body.state(&stretch.ball, age);
                        let state = coursework.rub(&stretch.ball, &state, stretch.length);
                        B::start(law, &stretch.ball, &law.classify(&stretch.ball, state))
                    }
                    MotionLaw::Frictionless | MotionLaw::Coulomb(_) => {
                        body.moved(&stretch.ball, age)
                    }
                };
                (end, *changes, *origin)
            })
    }

    /// How far a ball can get from the middle of its path, m.
    #[inline]
    pub(super) fn extent(body: &B, age: f64, length: f64) -> f64 {
        let speed = body.velocity(age).length();
        if B::BENDS {
            0.5 * length * (speed + length * body.acceleration().length())
        } else {
            0.5 * length * speed
        }
    }

    #[inline]
    pub(super) fn cell(&self, place: DVec2) -> usize {
        let at = (place - self.least) * self.per_cell;
        // The casts saturate.
        let column = (at.x as usize).min(self.columns - 1);
        let row = (at.y as usize).min(self.rows - 1);
        row * self.columns + column
    }

    /// Sorts the balls by the cell of the middle of their path.
    fn sort(&mut self, stretch: &Stretch) {
        let half = 0.5 * stretch.length;
        let (mut least, mut most) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (mut speed, mut bend) = (0.0_f64, 0.0_f64);
        for (body, _) in &self.staged {
            let middle = body.position(half);
            least = least.min(middle);
            most = most.max(middle);
            speed = speed.max(body.velocity(0.0).length_squared());
            if B::BENDS {
                bend = bend.max(body.acceleration().length_squared());
            }
        }
        self.bend = bend.sqrt();
        self.set_slack(stretch, half * (speed.sqrt() + stretch.length * self.bend));
        self.set_cells(stretch, least, most);
        let cells = self.columns * self.rows;
        self.first.clear();
        self.first.resize(cells + 1, 0);
        self.cell_of.clear();
        for k in 0..self.staged.len() {
            let cell = self.cell(self.staged[k].0.position(half));
            self.cell_of.push(cell as u32);
            self.first[cell] += 1;
        }
        let mut sum = 0;
        for first in &mut self.first {
            sum += *first;
            *first = sum;
        }
        let count = self.staged.len();
        if let Some(&(body, origin)) = self.staged.first() {
            self.bodies.resize(count, body);
            self.origins.resize(count, origin);
        } else {
            self.bodies.clear();
            self.origins.clear();
        }
        self.x.resize(count, 0.0);
        self.z.resize(count, 0.0);
        for ((body, origin), &cell) in self.staged.iter().zip(&self.cell_of) {
            let place = &mut self.first[cell as usize];
            *place -= 1;
            let place = *place as usize;
            self.bodies[place] = *body;
            self.origins[place] = *origin;
            let middle = body.position(half);
            self.x[place] = middle.x;
            self.z[place] = middle.y;
        }
        refill(&mut self.since, count, 0.0);
        refill(&mut self.versions, count, 0);
        refill(&mut self.impacts, count, 0);
        refill(&mut self.listed, count, STATIC);
        refill(&mut self.heads, cells, END);
        self.next.resize(count, END);
        self.middles.resize(count, DVec2::ZERO);
        self.list_fast(stretch);
        self.calendar.reset(stretch.length, count / 2);
    }

    fn set_slack(&mut self, stretch: &Stretch, most: f64) {
        self.slack = most;
        let enough = SLACK * stretch.ball.radius;
        if most > enough {
            let fast = self
                .staged
                .iter()
                .filter(|(body, _)| Self::extent(body, 0.0, stretch.length) > enough)
                .count();
            if fast * FEW <= self.staged.len() {
                self.slack = enough;
            }
        }
    }

    fn set_cells(&mut self, stretch: &Stretch, least: DVec2, most: DVec2) {
        let reach = 2.0 * (stretch.ball.radius + self.slack) * (1.0 + 2.0 * MARGIN);
        let size = stretch.cell.unwrap_or(DVec2::splat(reach));
        self.least = least;
        self.per_cell = size.recip();
        let extent = (most - least).max(DVec2::ZERO);
        self.columns = (extent.x * self.per_cell.x) as usize + 1;
        self.rows = (extent.y * self.per_cell.y) as usize + 1;
        // A ball is met at most this many cells away; rounding is in the margin of `reach`.
        self.span = match stretch.cell {
            None => [1, 1],
            Some(_) => [
                (reach * self.per_cell.x).ceil() as usize,
                (reach * self.per_cell.y).ceil() as usize,
            ],
        };
    }

    fn list_fast(&mut self, stretch: &Stretch) {
        self.fast.clear();
        if self.slack < SLACK * stretch.ball.radius {
            return;
        }
        for ball in 0..self.bodies.len() {
            if Self::extent(&self.bodies[ball], 0.0, stretch.length) > self.slack {
                self.fast.push(ball as u32);
                self.listed[ball] = FAST;
                self.x[ball] = f64::INFINITY;
            }
        }
    }
}

fn refill<T: Copy>(list: &mut Vec<T>, count: usize, value: T) {
    list.clear();
    list.resize(count, value);
}
