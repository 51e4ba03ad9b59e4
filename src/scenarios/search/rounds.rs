//! The search itself.

use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use crate::scenarios::expect::miss;
use crate::scenarios::file::Scenario;
use crate::scenarios::search::climb::Climber;
use crate::scenarios::search::spread::{latin, numbers};
use crate::scenarios::search::{Free, Player, SearchError, robustness};

/// Points of the hypercube of a round.
const POINTS: usize = 4096;

/// How many of them are climbed from.
const CLIMBS: usize = 32;

/// Tries of a climb for each free number.
const TRIES: usize = 150;

/// Rounds stop when so many starts have led to a shot that meets everything.
const ENOUGH: usize = 6;

/// Tries to make a shot more robust, for each free number.
const TOUCHES: usize = 30;

/// What a layout counts that cannot be played; overlaps add to it.
const UNPLAYABLE: f64 = 1e3;

/// How to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plan {
    /// Where the random numbers begin; the same seed gives the same result on any number of threads.
    pub seed: u64,
    /// Shots after which no new round begins.
    pub shots: u64,
}

impl Default for Plan {
    fn default() -> Self {
        Self {
            seed: 1,
            shots: 500_000,
        }
    }
}

/// Hears from a search, from any thread: shots so far, and the best miss of a finished round.
pub trait Watch: Sync {
    /// So many shots have been played.
    fn played(&self, _shots: u64) {}

    /// A round has ended with this miss, 0 if a shot is found.
    fn round(&self, _best: f64) {}
}

impl Watch for () {}

/// The best that a search has found.
#[derive(Clone, Debug)]
pub struct Found {
    /// The scene with the values found; nothing in it is free any more.
    pub scenario: Scenario,
    /// 0 if all expectations are met.
    pub miss: f64,
    /// Share of strokes with errors that still meet them, see [`robustness`].
    pub robustness: f64,
    /// The value of each free number, in the order of the file.
    pub values: Vec<f64>,
    /// Shots that were played.
    pub shots: u64,
}

/// What is searched for, and how many shots it has taken.
struct Search<'s> {
    scenario: &'s Scenario,
    moves_balls: bool,
    shots: AtomicU64,
    watch: &'s dyn Watch,
}

/// A scene and the solver that plays it.
struct Board {
    scene: crate::physics::scene::Scene,
    player: Player,
}

impl Search<'_> {
    fn board(&self) -> Board {
        Board {
            scene: self.scenario.scene.clone(),
            player: Player::default(),
        }
    }

    fn value(free: &Free, share: f64) -> f64 {
        let (least, most) = free.range();
        least + share * (most - least)
    }

    fn values(&self, point: &[f64]) -> Vec<f64> {
        let pairs = self.scenario.free.iter().zip(point);
        pairs
            .map(|(free, share)| Self::value(free, *share))
            .collect()
    }

    /// Gives the free numbers their values.
    fn set(&self, board: &mut Board, values: impl Iterator<Item = f64>) {
        for (free, value) in self.scenario.free.iter().zip(values) {
            free.set(&mut board.scene, value);
        }
        for tie in &self.scenario.ties {
            tie.hold(&mut board.scene);
        }
    }

    /// What stands in the way of playing: 0 if nothing does.
    fn unplayable(&self, board: &Board) -> f64 {
        let scene = &board.scene;
        if let Some(planned) = &scene.shot {
            let over = planned.shot.offset() - scene.cue.miscue_offset;
            if over > 1e-12 {
                return UNPLAYABLE + over;
            }
        }
        if !self.moves_balls {
            return 0.0;
        }
        let mut overlap = 0.0;
        for (i, a) in scene.balls.iter().enumerate() {
            for b in &scene.balls[i + 1..] {
                let apart = (a.state.position - b.state.position).length();
                overlap += (a.ball.radius + b.ball.radius - apart - 1e-10).max(0.0);
            }
        }
        if overlap > 0.0 {
            UNPLAYABLE + overlap
        } else if scene.check().is_err() {
            UNPLAYABLE
        } else {
            0.0
        }
    }

    /// Plays the values that are set; how far they are from meeting everything.
    fn miss(&self, board: &mut Board) -> f64 {
        let unplayable = self.unplayable(board);
        if unplayable > 0.0 {
            return unplayable;
        }
        if let Ok(record) = board.player.play(&board.scene) {
            return miss(&board.scene, record, &self.scenario.expect);
        }
        board.player.forget();
        UNPLAYABLE
    }

    fn count(&self, shots: u64) {
        let before = self.shots.fetch_add(shots, Ordering::Relaxed);
        self.watch.played(before + shots);
    }

    fn miss_at(&self, board: &mut Board, point: &[f64]) -> f64 {
        let values = self.scenario.free.iter().zip(point);
        self.set(board, values.map(|(free, share)| Self::value(free, *share)));
        self.miss(board)
    }

    /// One round: the hypercube, then the climbs from its best points. In the order of the points, whatever thread did them.
    fn round(&self, seed: u64, round: u64) -> Vec<(f64, Vec<f64>)> {
        let sides = self.scenario.free.len();
        let points = latin(&mut numbers(seed, round, u64::MAX), POINTS, sides);
        let mut starts: Vec<(f64, Vec<f64>)> = points
            .par_chunks(256)
            .map_init(
                || self.board(),
                |board, points| {
                    let found: Vec<(f64, Vec<f64>)> = points
                        .iter()
                        .map(|point| (self.miss_at(board, point), point.clone()))
                        .collect();
                    self.count(found.len() as u64);
                    found
                },
            )
            .flatten()
            .collect();
        starts.sort_by(|a, b| a.0.total_cmp(&b.0));
        starts.truncate(CLIMBS);
        let climbs = starts.into_par_iter().enumerate();
        climbs
            .map_init(
                || self.board(),
                |board, (task, (value, point))| {
                    let mut rng = numbers(seed, round, task as u64);
                    let mut climber = Climber::new(point, value, 0.05);
                    let mut tries = 0;
                    while tries < TRIES * sides && climber.value > 0.0 && !climber.stuck() {
                        climber.step(&mut rng, |point| self.miss_at(board, point));
                        tries += 1;
                    }
                    self.count(tries as u64);
                    (climber.value, climber.point)
                },
            )
            .collect()
    }

    /// Climbs from a shot that meets everything to one that forgives more.
    fn touched_up(&self, seed: u64, task: u64, point: Vec<f64>) -> (f64, Vec<f64>) {
        let mut board = self.board();
        let mut rng = numbers(seed, u64::MAX, task);
        let mut delicate = |point: &[f64]| {
            if self.miss_at(&mut board, point) > 0.0 {
                return 2.0;
            }
            let Board { scene, player } = &mut board;
            self.count(100);
            1.0 - robustness(player, scene, &self.scenario.expect)
        };
        let start = delicate(&point);
        let mut climber = Climber::new(point, start, 0.01);
        for _ in 0..TOUCHES * self.scenario.free.len() {
            if climber.value == 0.0 || climber.stuck() {
                break;
            }
            climber.step(&mut rng, &mut delicate);
        }
        (1.0 - climber.value, climber.point)
    }

    /// Values with as few decimals as the shot forgives.
    fn rounded(&self, board: &mut Board, values: &[f64]) -> Vec<f64> {
        for decimals in 2..12 {
            let scale = libm::pow(10.0, f64::from(decimals));
            let short: Vec<f64> = values.iter().map(|v| (v * scale).round() / scale).collect();
            self.set(board, short.iter().copied());
            if self.miss(board) == 0.0 && self.forgives(board) {
                return short;
            }
        }
        values.to_vec()
    }

    /// Whether the shot that is set forgives anything: where rounding lands on the edge of success it does not.
    fn forgives(&self, board: &mut Board) -> bool {
        let Board { scene, player } = board;
        scene.shot.is_none() || robustness(player, scene, &self.scenario.expect) > 0.2
    }
}

/// Searches for values of the free numbers with which all expectations are met.
///
/// # Errors
/// [`SearchError`] if there is nothing to search.
pub fn solve(scenario: &Scenario, plan: Plan, watch: &dyn Watch) -> Result<Found, SearchError> {
    if scenario.free.is_empty() {
        return Err(SearchError::NothingFree);
    }
    if scenario.expect.is_empty() {
        return Err(SearchError::NothingExpected);
    }
    if !scenario.scene.laws.motion.is_closed_form() {
        return Err(SearchError::NotExact);
    }
    let search = Search {
        scenario,
        moves_balls: scenario.free.iter().any(Free::moves_a_ball) || !scenario.ties.is_empty(),
        shots: AtomicU64::new(0),
        watch,
    };
    let mut best: Option<(f64, Vec<f64>)> = None;
    let mut solutions = Vec::new();
    for round in 0.. {
        for (value, point) in search.round(plan.seed, round) {
            if value == 0.0 {
                solutions.push(point.clone());
            }
            if best.as_ref().is_none_or(|best| value < best.0) {
                best = Some((value, point));
            }
        }
        watch.round(best.as_ref().map_or(f64::INFINITY, |best| best.0));
        let played = search.shots.load(Ordering::Relaxed);
        if solutions.len() >= ENOUGH || played >= plan.shots {
            break;
        }
    }
    let (mut value, mut point) = best.unwrap_or((UNPLAYABLE, Vec::new()));
    if value >= UNPLAYABLE {
        let tried = search.shots.load(Ordering::Relaxed);
        return Err(SearchError::NoLayout { tried });
    }
    solutions.truncate(2 * ENOUGH);
    let touched: Vec<(f64, Vec<f64>)> = solutions
        .into_par_iter()
        .enumerate()
        .map(|(task, point)| search.touched_up(plan.seed, task as u64, point))
        .collect();
    let mut best_of = f64::NEG_INFINITY;
    for (robust, touched) in touched {
        if robust > best_of {
            (best_of, value, point) = (robust, 0.0, touched);
        }
    }
    let mut board = search.board();
    let mut values = search.values(&point);
    if value == 0.0 {
        values = search.rounded(&mut board, &values);
    }
    search.set(&mut board, values.iter().copied());
    let Board { scene, player } = &mut board;
    let robustness = robustness(player, scene, &scenario.expect);
    Ok(Found {
        scenario: Scenario {
            free: Vec::new(),
            ties: Vec::new(),
            scene: board.scene,
            ..scenario.clone()
        },
        miss: value,
        robustness,
        values,
        shots: search.shots.load(Ordering::Relaxed),
    })
}
