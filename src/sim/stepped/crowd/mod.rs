//! Crowds: thousands to a million equal balls, packed, on all threads.
//!
//! The systems of a tick are the same and so are the laws; what differs is where the data lie. The grid resource
//! [`Crowd`] holds the balls in tiles; a tile is worked through pass by pass (grid, balls, cushions, resolve, move)
//! while it is in the cache of one core, instead of the whole table system by system. Contacts are located inside the
//! tick and resolved in order of time, exactly as for few balls: a frictionless crowd ends in the same bits as the same
//! scene without [`Stepped::crowd`], with any cells and any number of threads.
//!
//! A crowd tells nothing ball by ball: no messages of contacts and no record, only the numbers of its [`Census`]. Its
//! balls are equal, stay on the slate and know no pockets. Everything else plays in the general solver.

mod body;
mod census;
mod collide;
mod field;
mod mirror;
mod patch;
mod queue;
mod settle;
mod tiles;
mod walls;

pub use census::{Census, Pass};
pub use mirror::Mirror;
pub(super) use mirror::{take_up, write};

use std::time::Instant;

use bevy::ecs::change_detection::Tick;
use bevy::prelude::*;
use bevy::tasks::{ComputeTaskPool, available_parallelism};
use glam::DVec2;

use crate::physics::ball::{Ball, State};
use crate::physics::laws::Laws;
use crate::physics::laws::motion::MotionLaw;
use crate::physics::roots::RootError;
use crate::physics::scene::{Solver, Stepped};
use crate::sim::clock::Clock;
use crate::sim::messages::Failed;
use crate::sim::playfield::Playfield;
use body::{Body, Gliding, Rubbed};
use census::Tally;
use field::Field;
use patch::Stretch;
use walls::Walls;

/// How far a ball may move in one part of a tick, in radii. A faster one cuts the tick into parts.
const REACH: f64 = 4.0;
/// Speeds may grow by this factor in one part of a tick; if one grows more, the part is computed again.
const GROWTH: f64 = 1.25;
/// Least side of a tile, in radii.
const LEAST_SIDE: f64 = 64.0;

/// The balls of a crowd. Every ball of the crowd belongs to one tile of the table.
#[derive(Resource)]
pub struct Crowd {
    field: Option<Kind>,
    walls: Walls,
    ball: Option<Ball>,
    /// Largest speed, m/s.
    speed: f64,
    /// When the components were last written.
    written: Option<Tick>,
    /// Whether the balls have moved since.
    behind: bool,
    asked: bool,
    /// Threads to use; absent is all that Bevy has for computing, and the one that waits for them.
    pub threads: Option<usize>,
    /// Balls in a tile, if it is filled evenly; taken up when the balls are laid out. Large tiles leave the cache, small
    /// ones have much around them. The result does not depend on it.
    pub in_tile: usize,
    /// When the components are written.
    pub mirror: Mirror,
}

impl Default for Crowd {
    fn default() -> Self {
        Self {
            field: None,
            walls: Walls::default(),
            ball: None,
            speed: 0.0,
            written: None,
            behind: false,
            asked: false,
            threads: None,
            in_tile: 4000,
            mirror: Mirror::default(),
        }
    }
}

/// With and without bends and spin.
enum Kind {
    Gliding(Field<Gliding>),
    Rubbed(Field<Rubbed>),
}

impl Crowd {
    /// Has the components written at the end of the next tick, whatever [`Self::mirror`] says.
    pub fn ask(&mut self) {
        self.asked = true;
    }

    /// The state of the ball of this number of the scene, if it is in play.
    #[must_use]
    pub fn state(&self, number: usize) -> Option<State> {
        let ball = self.ball.as_ref()?;
        match self.field.as_ref()? {
            Kind::Gliding(field) => Some(field.tiles.body(number as u32)?.state(ball, 0.0)),
            Kind::Rubbed(field) => Some(field.tiles.body(number as u32)?.state(ball, 0.0)),
        }
    }

    fn is_moving(&self) -> bool {
        match &self.field {
            Some(Kind::Gliding(field)) => field.tiles.all.iter().any(|tile| tile.moves),
            Some(Kind::Rubbed(field)) => field.tiles.all.iter().any(|tile| tile.moves),
            None => false,
        }
    }

    fn threads(&self) -> usize {
        let pool = ComputeTaskPool::try_get().map_or(1, |pool| pool.thread_num() + 1);
        self.threads
            .unwrap_or(pool.min(available_parallelism()))
            .max(1)
    }

    /// Lays the balls out anew.
    fn lay_out(&mut self, playfield: &Playfield, ball: Ball, count: usize, balls: &[(u32, State)]) {
        let (table, law) = (&playfield.table, &playfield.laws.motion);
        let size = DVec2::new(table.length, table.width);
        let share = self.in_tile.max(1) as f64 / balls.len().max(1) as f64;
        let side = (size.x * size.y * share)
            .sqrt()
            .max(LEAST_SIDE * ball.radius);
        let threads = self.threads();
        self.walls = Walls::new(table, (1.0 + REACH) * ball.radius);
        self.ball = Some(ball);
        self.field = Some(if *law == MotionLaw::Frictionless && !ball.spins {
            let mut field = Field::new(size, side, count, threads);
            for (number, state) in balls {
                field.tiles.add(Gliding::start(law, &ball, state), *number);
            }
            self.speed = field.speed();
            Kind::Gliding(field)
        } else {
            let mut field = Field::new(size, side, count, threads);
            for (number, state) in balls {
                field.tiles.add(Rubbed::start(law, &ball, state), *number);
            }
            self.speed = field.speed();
            Kind::Rubbed(field)
        });
    }

    /// Advances all balls by one tick.
    fn advance(
        &mut self,
        playfield: &Playfield,
        stepped: &Stepped,
        census: &mut Census,
    ) -> Result<(), (u32, RootError)> {
        let (Some(field), Some(ball)) = (&mut self.field, self.ball) else {
            return Ok(());
        };
        let size = DVec2::new(playfield.table.length, playfield.table.width);
        let stretch = Stretch {
            laws: &playfield.laws,
            table: &playfield.table,
            ball,
            length: stepped.tick,
            cell: stepped
                .grid
                .map(|(columns, rows)| size / DVec2::new(f64::from(columns), f64::from(rows))),
            walls: &self.walls,
        };
        let (tally, parts) = match field {
            Kind::Gliding(field) => run(field, &stretch, self.speed, census)?,
            Kind::Rubbed(field) => run(field, &stretch, self.speed, census)?,
        };
        self.speed = tally.speed.sqrt();
        self.behind = true;
        census.parts = parts;
        census.contacts = tally.met / 2;
        census.contacts_in_all += tally.met / 2;
        census.cushions = tally.cushions;
        census.overlap = tally.overlap;
        census.energy = tally.energy;
        census.momentum = tally.momentum.map(|sum| sum * ball.mass);
        census.speed = self.speed;
        census.saturated = tally.saturated;
        census.times = tally.times;
        Ok(())
    }
}

/// The largest gain of speed in so many seconds without a contact, m/s.
fn gain(laws: &Laws, seconds: f64) -> f64 {
    match &laws.motion {
        MotionLaw::Coulomb(cloth) => cloth.sliding * cloth.gravity * seconds,
        MotionLaw::Frictionless | MotionLaw::Coursework(_) => 0.0,
    }
}

/// Runs a tick, in parts where balls are fast.
fn run<B: Body>(
    field: &mut Field<B>,
    tick: &Stretch,
    mut speed: f64,
    census: &mut Census,
) -> Result<(Tally, u32), (u32, RootError)> {
    let reach = REACH * tick.ball.radius;
    let before = field.repeated;
    let (mut sum, mut parts) = (Tally::default(), 0);
    let mut left = tick.length;
    while left > 0.0 {
        let most = GROWTH * speed + gain(tick.laws, left);
        let count = (most * left / reach).ceil().max(1.0);
        let length = if count > 1.0 { left / count } else { left };
        let stretch = Stretch { length, ..*tick };
        let done = field.advance(&stretch, most * length);
        if let Some(failure) = field.failure() {
            return Err(failure);
        }
        let Some(tally) = done else {
            speed = 2.0 * most;
            continue;
        };
        speed = tally.speed.sqrt();
        sum.follow(&tally);
        parts += 1;
        left = if count > 1.0 { left - length } else { 0.0 };
    }
    census.repeated += field.repeated - before;
    census.awake = field.awake;
    Ok((sum, parts))
}

fn crowd(playfield: &Playfield) -> Option<&Stepped> {
    match &playfield.solver {
        Solver::Stepped(stepped) if stepped.crowd => Some(stepped),
        _ => None,
    }
}

/// Whether the scene on the table is a crowd.
#[must_use]
pub fn is_crowd(playfield: Res<Playfield>) -> bool {
    playfield.solver.is_crowd()
}

/// Advances the crowd.
pub(super) fn advance(
    mut crowd: ResMut<Crowd>,
    mut census: ResMut<Census>,
    playfield: Res<Playfield>,
    clock: Res<Clock>,
    mut failed: MessageWriter<Failed>,
) {
    let Some(stepped) = self::crowd(&playfield) else {
        return;
    };
    if let Err((ball, error)) = crowd.advance(&playfield, stepped, &mut census) {
        failed.write(Failed {
            time: clock.time(),
            reason: format!("ball {ball}: {error}"),
        });
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Crowd>().init_resource::<Census>();
}

/// Books the time since the lap in a pass.
fn book(census: &mut Census, pass: Pass, lap: Instant) {
    census.times[pass as usize] += lap.elapsed();
}
