//! What a crowd did in its last tick, in numbers.

use std::time::{Duration, Instant};

use bevy::prelude::*;
use glam::DVec2;

use crate::physics::ball::{Ball, State};
use crate::physics::laws::motion::MotionLaw;

/// The passes of a tick, in their order. They carry the names of the systems of a tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// Balls are sorted by cell.
    Grid,
    /// Contacts between balls are found.
    Balls,
    /// Contacts with cushions are found.
    Cushions,
    /// Contacts are resolved in order of time.
    Resolve,
    /// Positions, velocities and spins at the end of the tick.
    Move,
    /// The components are written.
    Mirror,
}

impl Pass {
    /// Every pass in order.
    pub const ALL: [Self; 6] = [
        Self::Grid,
        Self::Balls,
        Self::Cushions,
        Self::Resolve,
        Self::Move,
        Self::Mirror,
    ];
}

/// What a crowd did in its last tick. Times are summed over threads.
#[derive(Resource, Clone, Debug, Default, PartialEq)]
pub struct Census {
    /// Balls in play.
    pub balls: usize,
    /// Balls that moved, or have moved lately; the others cost nothing.
    pub awake: usize,
    /// Contacts between balls in the tick.
    pub contacts: u64,
    /// Contacts with cushions in the tick.
    pub cushions: u64,
    /// Contacts between balls since the scene was laid out.
    pub contacts_in_all: u64,
    /// Deepest overlap of two balls at the end of the tick before, m. Where every contact is found it is rounding.
    pub overlap: f64,
    /// Kinetic energy of translation and rotation at the end of the tick, J.
    pub energy: f64,
    /// Potential energy on a tilted table at the end of the tick, J, from the middle of the table.
    pub potential: f64,
    /// Momentum along x and z, kg m/s.
    pub momentum: [f64; 2],
    /// Largest speed at the end of the tick, m/s.
    pub speed: f64,
    /// Parts the tick was cut into, so that no ball moves much further than a diameter or two at a time.
    pub parts: u32,
    /// Contacts since the scene was laid out that were not seen in time, because a ball was turned towards one whose next
    /// contact had been resolved already: the two balls were set apart where that showed.
    pub late: u64,
    /// Balls that met so many others in the tick that from then on they no longer bounced and met them in fixed short
    /// intervals: the scene is denser than the solver keeps apart, and [`Self::overlap`] says by how much.
    pub saturated: u64,
    /// Time of each pass, in the order of [`Pass::ALL`].
    pub times: [Duration; 6],
}

/// What was done in a stripe, or in all.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    /// Contacts of two balls.
    pub met: u64,
    pub cushions: u64,
    pub saturated: u64,
    pub overlap: f64,
    pub late: u64,
    /// Square of the largest speed, and sum of squares.
    pub speed: f64,
    pub squares: f64,
    /// Balls that should move and do not.
    pub stopped: u64,
    pub times: [Duration; 6],
}

impl Tally {
    /// Books the time since the last lap.
    pub fn time(&mut self, pass: Pass, lap: &mut Instant) {
        let now = Instant::now();
        self.times[pass as usize] += now - *lap;
        *lap = now;
    }

    /// Adds what has been done, wherever it was done.
    pub fn add(&mut self, other: &Self) {
        self.met += other.met;
        self.cushions += other.cushions;
        self.saturated += other.saturated;
        self.overlap = self.overlap.max(other.overlap);
        self.late += other.late;
        self.squares += other.squares;
        self.stopped += other.stopped;
        self.speed = self.speed.max(other.speed);
        for (mine, theirs) in self.times.iter_mut().zip(other.times) {
            *mine += theirs;
        }
    }
}

/// What is summed over balls at the end of a tick.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    pub energy: f64,
    pub potential: f64,
    pub momentum: [f64; 2],
    /// Square of the largest speed.
    pub speed: f64,
    pub moves: bool,
}

impl Sums {
    /// Counts a ball.
    #[inline]
    pub fn count(&mut self, law: &MotionLaw, ball: &Ball, state: &State) {
        let v = state.velocity;
        self.energy += ball.kinetic_energy(state);
        self.potential += law.potential(ball, state);
        self.momentum[0] += ball.mass * v.x;
        self.momentum[1] += ball.mass * v.z;
        self.speed = self.speed.max(v.length_squared());
        self.moves |= !state.motion.is_still();
    }

    /// Counts a ball without spin of which only the velocity in plan is known.
    #[inline]
    pub fn count_gliding(&mut self, ball: &Ball, velocity: DVec2) {
        let square = velocity.length_squared();
        self.energy += 0.5 * ball.mass * square;
        self.momentum[0] += ball.mass * velocity.x;
        self.momentum[1] += ball.mass * velocity.y;
        self.speed = if square > self.speed {
            square
        } else {
            self.speed
        };
        self.moves |= square > 0.0;
    }

    pub fn add(&mut self, other: &Self) {
        self.energy += other.energy;
        self.potential += other.potential;
        self.momentum[0] += other.momentum[0];
        self.momentum[1] += other.momentum[1];
        self.speed = self.speed.max(other.speed);
        self.moves |= other.moves;
    }
}
