//! One tick of a crowd: every tile with its surroundings by itself, on all threads, and then the proof that all tiles
//! agree.
//!
//! A tile computes what becomes of its own balls. To know what comes in from outside it follows its surroundings too,
//! several diameters wide, and throws that part away. Then each tile's idea of the balls that its own could meet is
//! compared, bit for bit, with what became of them in their own tile. Where both agree for all tiles, the tiles
//! together are one solution of the whole tick, and since contacts are resolved in order of time there is only one:
//! the result does not depend on tiles, cells or threads. Where a chain of contacts has run through, the two tiles are
//! solved again as one, until all agree.

use std::sync::{Mutex, PoisonError};

use bevy::tasks::ComputeTaskPool;
use glam::DVec2;

use crate::physics::roots::RootError;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::census::{Pass, Tally};
use crate::sim::stepped::crowd::patch::{Patch, Role, Stretch};
use crate::sim::stepped::crowd::tiles::{Outcome, Tiles};

/// Layers of balls that a tile follows beyond the balls that its own can meet, in radii.
const DEPTH: f64 = 5.0;

/// All balls of one kind.
pub(super) struct Field<B> {
    pub tiles: Tiles<B>,
    outcomes: Vec<Outcome<B>>,
    /// Scratch memory, one for each thread.
    patches: Vec<Patch<B>>,
    strays: Vec<u32>,
    /// Group of each tile where tiles are solved together.
    group: Vec<u32>,
    /// Threads to use at most.
    pub threads: usize,
    /// Tiles solved again.
    pub repeated: u64,
    pub awake: usize,
}

impl<B: Body> Field<B> {
    pub fn new(size: DVec2, side: f64, balls: usize, threads: usize) -> Self {
        let tiles = Tiles::new(size, side, balls);
        let count = tiles.all.len();
        Self {
            tiles,
            outcomes: (0..count).map(|_| Outcome::default()).collect(),
            patches: (0..threads.max(1)).map(|_| Patch::new()).collect(),
            strays: Vec::new(),
            group: vec![0; count],
            threads: threads.max(1),
            repeated: 0,
            awake: 0,
        }
    }

    /// Largest speed now, m/s.
    pub fn speed(&self) -> f64 {
        self.tiles
            .all
            .iter()
            .filter(|tile| tile.moves)
            .flat_map(|tile| &tile.bodies)
            .fold(0.0_f64, |most, body| {
                most.max(body.velocity(0.0).length_squared())
            })
            .sqrt()
    }

    /// Runs a stretch in which no ball gets further than `reach` m, and says what was done. `None` if one did: nothing has
    /// changed then.
    pub fn advance(&mut self, stretch: &Stretch, reach: f64) -> Option<Tally> {
        let started = std::time::Instant::now();
        let radius = stretch.ball.radius;
        let near = 2.0 * (radius + reach);
        let far = near + DEPTH * radius;
        if self.tiles.all.len() > 1 {
            let tiles = self.tiles.all.iter_mut();
            let tiles: Vec<_> = tiles.filter(|tile| !tile.is_listed(far)).collect();
            share(self.threads, tiles, &mut self.patches, |_, tile| {
                tile.list_sides(far);
            });
        }
        let mut tally = Tally::default();
        tally.times[Pass::Grid as usize] += started.elapsed();
        self.solve(stretch, near, far);
        self.agree(stretch, near, far);
        for outcome in &self.outcomes {
            tally.add(&outcome.tally);
        }
        if tally.speed.sqrt() * stretch.length > reach {
            return None;
        }
        self.commit();
        Some(tally)
    }

    /// Solves every tile that is awake, each by itself.
    fn solve(&mut self, stretch: &Stretch, near: f64, far: f64) {
        let tiles = &self.tiles;
        let mut awake = Vec::with_capacity(tiles.all.len());
        for (tile, outcome) in self.outcomes.iter_mut().enumerate() {
            if tiles.is_awake(tile) {
                awake.push((tile, outcome));
            } else {
                outcome.sleep();
            }
        }
        self.awake = awake
            .iter()
            .map(|(tile, _)| tiles.all[*tile].bodies.len())
            .sum();
        share(
            self.threads,
            awake,
            &mut self.patches,
            |patch, (tile, outcome)| {
                let started = std::time::Instant::now();
                patch.clear();
                for (body, origin) in tiles.own(tile) {
                    patch.add(body, origin);
                }
                for other in tiles.around(tile) {
                    for (body, origin) in tiles.halo(tile, other, near, far) {
                        patch.add(body, origin);
                    }
                }
                patch.tally.times[Pass::Grid as usize] += started.elapsed();
                patch.solve(stretch);
                let mut lap = std::time::Instant::now();
                outcome.take(stretch, patch, tile as u32, &tiles.all[tile]);
                outcome.tally.time(Pass::Move, &mut lap);
            },
        );
    }

    /// Solves again together the tiles that do not agree, until all do.
    fn agree(&mut self, stretch: &Stretch, near: f64, far: f64) {
        if self.tiles.all.len() < 2 {
            return;
        }
        for (tile, group) in (0..).zip(&mut self.group) {
            *group = tile;
        }
        loop {
            let mut joined = Vec::new();
            for (tile, outcome) in (0..).zip(&self.outcomes) {
                for (copy, changes, [other, slot]) in &outcome.copies {
                    let (one, two) = (root(&self.group, tile), root(&self.group, *other));
                    if one == two {
                        continue;
                    }
                    let (other, slot) = (*other as usize, *slot as usize);
                    let theirs = &self.outcomes[other];
                    let truth = if theirs.slept {
                        // At rest the end is the start.
                        (&self.tiles.all[other].bodies[slot], &0)
                    } else {
                        (&theirs.bodies[slot], &theirs.changes[slot])
                    };
                    if (copy, changes) != truth {
                        self.group[one.max(two) as usize] = one.min(two);
                        joined.push(one.min(two));
                    }
                }
            }
            if joined.is_empty() {
                return;
            }
            for root_tile in &mut joined {
                *root_tile = root(&self.group, *root_tile);
            }
            joined.sort_unstable();
            joined.dedup();
            for group in joined {
                self.solve_group(stretch, group, near, far);
            }
        }
    }

    /// Solves the tiles of a group as one.
    fn solve_group(&mut self, stretch: &Stretch, group: u32, near: f64, far: f64) {
        let tiles = &self.tiles;
        let members: Vec<usize> = (0..tiles.all.len())
            .filter(|&tile| root(&self.group, tile as u32) == group)
            .collect();
        self.repeated += members.len() as u64;
        let mut halo: Vec<_> = Vec::new();
        for &tile in &members {
            for other in tiles.around(tile) {
                if root(&self.group, other.0 as u32) != group {
                    halo.extend(tiles.halo(tile, other, near, far));
                }
            }
        }
        // A ball can be near two members.
        halo.sort_by_key(|(_, origin)| (origin.number, origin.role == Role::Far));
        halo.dedup_by_key(|(_, origin)| origin.number);
        let patch = &mut self.patches[0];
        patch.clear();
        for &tile in &members {
            for (body, origin) in tiles.own(tile) {
                patch.add(body, origin);
            }
        }
        for (body, origin) in halo {
            patch.add(body, origin);
        }
        patch.solve(stretch);
        for &tile in &members {
            let outcome = &mut self.outcomes[tile];
            outcome.take(stretch, patch, tile as u32, &tiles.all[tile]);
            // What is kept a patch at a time is counted once.
            outcome.copies.clear();
            outcome.failure = None;
            outcome.tally = outcome.tally.of_tile();
        }
        let first = &mut self.outcomes[members[0]];
        first.failure = patch.failure;
        first.tally.add(&patch.tally);
        first
            .copies
            .extend(patch.ends(stretch).filter_map(|(body, changes, origin)| {
                let place = [origin.tile, origin.slot];
                (origin.role == Role::Near).then_some((body, changes, place))
            }));
    }

    /// The failure of the ball with the lowest number, if any.
    pub fn failure(&self) -> Option<(u32, RootError)> {
        let failures = self.outcomes.iter().filter_map(|outcome| outcome.failure);
        failures.min_by_key(|(number, _)| *number)
    }

    /// Makes the outcomes the state.
    fn commit(&mut self) {
        self.strays.clear();
        for (tile, outcome) in self.tiles.all.iter_mut().zip(&mut self.outcomes) {
            if !outcome.slept {
                tile.commit(outcome);
                self.strays.extend(&outcome.strays);
            }
        }
        self.tiles.hand_over(&self.strays);
    }
}

/// The lowest tile of the group of a tile.
fn root(group: &[u32], mut tile: u32) -> u32 {
    while group[tile as usize] != tile {
        tile = group[tile as usize];
    }
    tile
}

/// Works on all items, each thread with its own scratch. Items are given out one by one, so that no thread waits for
/// another that drew the heavy ones; what is done to an item does not depend on who does it.
pub(super) fn share<T: Send, S: Send>(
    threads: usize,
    items: Vec<T>,
    scratch: &mut [S],
    work: impl Fn(&mut S, T) + Sync,
) {
    let threads = threads.min(items.len()).min(scratch.len());
    let pool = ComputeTaskPool::try_get().filter(|_| threads > 1);
    let Some(pool) = pool else {
        for item in items {
            work(&mut scratch[0], item);
        }
        return;
    };
    let (queue, work) = (Mutex::new(items.into_iter()), &work);
    pool.scope(|scope| {
        for scratch in &mut scratch[..threads] {
            let queue = &queue;
            scope.spawn(async move {
                loop {
                    let item = queue.lock().unwrap_or_else(PoisonError::into_inner).next();
                    let Some(item) = item else { break };
                    work(scratch, item);
                }
            });
        }
    });
}
