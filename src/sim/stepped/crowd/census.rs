//! What a crowd did in its last tick, in numbers.

use std::time::{Duration, Instant};

use bevy::prelude::*;

/// The passes over a tile, in their order. They carry the names of the systems of a tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// Balls are taken to their tiles and sorted by cell.
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
    /// Balls in tiles in which something moved, the others cost nothing.
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
    /// Momentum along x and z, kg m/s.
    pub momentum: [f64; 2],
    /// Largest speed at the end of the tick, m/s.
    pub speed: f64,
    /// Parts the tick was cut into, so that no ball moves much further than a diameter or two at a time.
    pub parts: u32,
    /// Tiles that had to be solved again together with a neighbour, because a chain of contacts ran through both.
    pub repeated: u64,
    /// Balls that met so many others in the tick that from then on they no longer bounced and met them in fixed short
    /// intervals: the scene is denser than the solver keeps apart, and [`Self::overlap`] says by how much.
    pub saturated: u64,
    /// Time of each pass, in the order of [`Pass::ALL`].
    pub times: [Duration; 6],
}

/// The sums over one patch.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    /// Own balls that met a ball, counted once a contact: twice the number of contacts.
    pub met: u64,
    pub cushions: u64,
    pub saturated: u64,
    pub overlap: f64,
    pub energy: f64,
    pub momentum: [f64; 2],
    /// Square of the largest speed.
    pub speed: f64,
    pub times: [Duration; 6],
}

impl Tally {
    /// Books the time since the last lap.
    pub fn time(&mut self, pass: Pass, lap: &mut Instant) {
        let now = Instant::now();
        self.times[pass as usize] += now - *lap;
        *lap = now;
    }

    /// Only what is summed over the balls of one tile at the end.
    pub fn of_tile(&self) -> Self {
        Self {
            energy: self.energy,
            momentum: self.momentum,
            speed: self.speed,
            ..Self::default()
        }
    }

    /// Adds the next part of the tick: counts add up, what is summed over balls is that of the later part.
    pub fn follow(&mut self, next: &Self) {
        *self = Self {
            energy: 0.0,
            momentum: [0.0; 2],
            speed: 0.0,
            ..*self
        };
        self.add(next);
    }

    /// Adds what has been done, wherever it was done.
    pub fn add(&mut self, other: &Self) {
        self.met += other.met;
        self.cushions += other.cushions;
        self.saturated += other.saturated;
        self.overlap = self.overlap.max(other.overlap);
        self.energy += other.energy;
        self.momentum[0] += other.momentum[0];
        self.momentum[1] += other.momentum[1];
        self.speed = self.speed.max(other.speed);
        for (mine, theirs) in self.times.iter_mut().zip(other.times) {
            *mine += theirs;
        }
    }
}
