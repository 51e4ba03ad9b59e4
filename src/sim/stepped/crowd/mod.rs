//! Crowds: thousands to a million equal balls, packed, on all threads.
//!
//! The systems of a tick are the same and so are the laws; what differs is where the data lie. The grid resource
//! [`Crowd`] holds the balls packed, near what they are near, and works on stripes of the table on all threads. Contacts
//! are located inside the tick and resolved in order of time but for a few in a thousand, which the census counts. The same bits on
//! any number of threads.
//!
//! On a tilted table balls come to lie on cushions and on each other, and would bounce ever more often. There a contact
//! that lasts loses nothing: what lies goes on trembling, by some centimetres a second under ten others.
//!
//! A crowd tells nothing ball by ball: no messages of contacts and no record, only the numbers of its [`Census`]. Its
//! balls are equal, stay on the slate and know no pockets. Everything else plays in the general solver.

mod begin;
mod body;
mod calendar;
mod cells;
mod census;
mod commit;
mod field;
mod frame;
mod lasting;
mod look;
mod meeting;
mod mirror;
mod order;
mod pairs;
mod queue;
mod rows;
mod rubbed;
mod search;
mod settle;
mod share;
mod single;
mod stretch;
mod stripe;
#[cfg(test)]
mod tests;
mod turned;
mod walls;

pub use census::{Census, Pass};
pub use mirror::Mirror;
pub(super) use mirror::{take_up, write};

use std::time::Instant;

use bevy::ecs::change_detection::Tick as ChangeTick;
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
use body::{Body, Gliding};
use cells::Cells;
use census::Tally;
use field::Field;
use rubbed::Rubbed;
use single::Single;
use stretch::Stretch;
use walls::Walls;

/// How far a ball may move in one part of a tick, in radii. A faster one cuts the tick into parts.
const REACH: f64 = 4.0;

/// The balls of a crowd.
#[derive(Resource)]
pub struct Crowd {
    field: Option<Kind>,
    walls: Walls,
    ball: Option<Ball>,
    /// Whether any ball moves.
    moves: bool,
    /// When the components were last taken up or written.
    seen: Option<ChangeTick>,
    /// Whether the balls have moved since.
    behind: bool,
    asked: bool,
    /// Processors there are: asking the system takes as long as a tick of a small crowd.
    cores: usize,
    /// Threads to use; absent is all that Bevy has for computing, and the one that waits for them.
    pub threads: Option<usize>,
    /// When the components are written.
    pub mirror: Mirror,
}

impl Default for Crowd {
    fn default() -> Self {
        Self {
            field: None,
            walls: Walls::default(),
            ball: None,
            moves: true,
            seen: None,
            behind: false,
            asked: false,
            cores: available_parallelism(),
            threads: None,
            mirror: Mirror::default(),
        }
    }
}

/// With and without bends and spin; those without also in single precision.
enum Kind {
    Gliding(Field<Gliding>),
    Single(Field<Single>),
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
            Kind::Gliding(field) => field.state(ball, number),
            Kind::Single(field) => field.state(ball, number),
            Kind::Rubbed(field) => field.state(ball, number),
        }
    }

    fn threads(&self) -> usize {
        let all = || {
            let pool = ComputeTaskPool::try_get().map_or(1, |pool| pool.thread_num() + 1);
            pool.min(self.cores)
        };
        self.threads.unwrap_or_else(all).max(1)
    }

    /// Lays the balls out anew, those in play.
    fn lay_out(&mut self, playfield: &Playfield, ball: Ball, balls: &[(u32, State)]) {
        let (table, law) = (&playfield.table, &playfield.laws.motion);
        self.walls = Walls::new(table, (1.0 + REACH) * ball.radius);
        self.ball = Some(ball);
        let smooth = *law == MotionLaw::Frictionless && !ball.spins;
        let single = matches!(
            playfield.solver,
            Solver::Stepped(Stepped { single: true, .. })
        );
        self.field = Some(match (smooth, single) {
            (true, true) => Kind::Single(Field::start(law, &ball, balls)),
            (true, false) => Kind::Gliding(Field::start(law, &ball, balls)),
            (false, _) => Kind::Rubbed(Field::start(law, &ball, balls)),
        });
        self.moves = true;
    }

    /// Advances all balls by one tick.
    fn advance(
        &mut self,
        playfield: &Playfield,
        stepped: &Stepped,
        census: &mut Census,
    ) -> Result<(), (u32, RootError)> {
        let threads = self.threads();
        let (Some(field), Some(ball)) = (&mut self.field, self.ball) else {
            return Ok(());
        };
        let size = DVec2::new(playfield.table.length, playfield.table.width);
        let tick = Tick {
            length: stepped.tick,
            cell: stepped
                .grid
                .map(|(columns, rows)| size / DVec2::new(f64::from(columns), f64::from(rows))),
            threads,
        };
        let stretch = Stretch {
            laws: &playfield.laws,
            table: &playfield.table,
            ball,
            walls: &self.walls,
            cells: Cells::new(DVec2::ONE, DVec2::ONE),
            start: 0.0,
            end: 0.0,
            cut: 0.0,
            fast: 0.0,
            clear: DVec2::ZERO,
            bend: bend(&playfield.laws),
            pull: playfield.laws.motion.pull().length(),
        };
        census.times = Default::default();
        let tally = match field {
            Kind::Gliding(field) => run(field, &stretch, &tick, census)?,
            Kind::Single(field) => run(field, &stretch, &tick, census)?,
            Kind::Rubbed(field) => run(field, &stretch, &tick, census)?,
        };
        self.behind = true;
        census.contacts = tally.met;
        census.contacts_in_all += tally.met;
        census.cushions = tally.cushions;
        census.overlap = tally.overlap;
        census.late += tally.late;
        census.saturated = tally.saturated;
        census.times = tally.times;
        Ok(())
    }
}

/// The largest acceleration without a contact, m/s².
fn bend(laws: &Laws) -> f64 {
    match &laws.motion {
        MotionLaw::Coulomb(cloth) => cloth.sliding.max(cloth.rolling) * cloth.gravity,
        MotionLaw::Inclined(incline) => incline.pull().length(),
        MotionLaw::Frictionless | MotionLaw::Coursework(_) => 0.0,
    }
}

/// A tick as it is asked for.
struct Tick {
    length: f64,
    /// Size of a cell in m; fitted to balls and speeds where absent.
    cell: Option<DVec2>,
    threads: usize,
}

/// Runs a tick, in parts where balls are fast.
fn run<B: Body>(
    field: &mut Field<B>,
    stretch: &Stretch,
    tick: &Tick,
    census: &mut Census,
) -> Result<Tally, (u32, RootError)> {
    let reach = REACH * stretch.ball.radius;
    let (mut sum, mut parts) = (Tally::default(), 0);
    let mut left = tick.length;
    while left > 0.0 {
        let most = field.speed + stretch.bend * left;
        let count = (most * left / reach).ceil().max(1.0);
        let end = if count > 1.0 { left / count } else { left };
        let part = Stretch { end, ..*stretch };
        let tally = field.advance(&part, tick.cell, tick.threads);
        if let Some(failure) = field.failure() {
            return Err(failure);
        }
        sum.add(&tally);
        parts += 1;
        left = if count > 1.0 { left - end } else { 0.0 };
    }
    census.parts = parts;
    census.awake = field.awake();
    Ok(sum)
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
