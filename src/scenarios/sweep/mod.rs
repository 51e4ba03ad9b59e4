//! A scene played many times with other numbers, on all threads: a table with a row a shot.
//!
//! ```
//! use masse::scenarios::library;
//! use masse::scenarios::sweep::{Axis, Sweep};
//!
//! let scenario = library::open("stun-shot")?;
//! let axes = ["speed=1:3:5", "laws.ball_ball.restitution=0.9,0.95"];
//! let axes = axes.iter().map(|text| Axis::parse(text, &scenario.scene));
//! let sweep = Sweep::grid(&scenario, axes.collect::<Result<_, _>>()?)?;
//! let rows = sweep.play(0..sweep.shots());
//! assert_eq!(rows.len(), 10);
//! // The first axis varies slowest.
//! assert_eq!(rows[1].values, [1.0, 0.95]);
//! let end = &rows[1].played.as_ref().expect("it can be played").end[0];
//! println!("the cue ball ends at {:.3} m", end.position.x);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Every shot has its own numbers at random, so that a row is the same for any number of threads and of shots.

mod axis;
mod row;

pub use axis::{Axis, AxisError, BallNumber, Values, Varied};
pub use row::{Played, Row};

use std::io;
use std::ops::Range;
use std::sync::Arc;

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

use crate::physics::scene::{Scene, Solver};
use crate::scenarios::file::Scenario;
use crate::scenarios::search::{Player, numbers};
use crate::sim::play::play;

/// Shots that one thread plays with one solver, and that are written at a time for each thread.
const TASK: u64 = 64;

/// Rows that wait to be written.
const WAITING: u64 = 64 * TASK;

/// A scene and what varies in it.
#[derive(Clone, Debug)]
pub struct Sweep<'s> {
    scenario: &'s Scenario,
    axes: Vec<Axis>,
    how: How,
    pool: Option<Arc<ThreadPool>>,
}

#[derive(Clone, Copy, Debug)]
enum How {
    /// Every value with every other.
    Grid { shots: u64 },
    /// Values at random.
    Random { shots: u64, seed: u64 },
}

impl<'s> Sweep<'s> {
    /// Every value of every axis with every value of the others; the last axis varies fastest.
    ///
    /// # Errors
    /// [`AxisError`] if a number is varied twice or has values at random.
    pub fn grid(scenario: &'s Scenario, axes: Vec<Axis>) -> Result<Self, AxisError> {
        let mut shots: u64 = 1;
        for axis in &axes {
            let count = axis.count().ok_or_else(|| AxisError::NoCount {
                name: axis.name.clone(),
            })?;
            shots = shots.saturating_mul(count as u64);
        }
        Self::new(scenario, axes, How::Grid { shots })
    }

    /// So many shots, each with a value of every axis at random.
    ///
    /// # Errors
    /// [`AxisError`] if a number is varied twice.
    pub fn random(
        scenario: &'s Scenario,
        axes: Vec<Axis>,
        shots: u64,
        seed: u64,
    ) -> Result<Self, AxisError> {
        Self::new(scenario, axes, How::Random { shots, seed })
    }

    fn new(scenario: &'s Scenario, axes: Vec<Axis>, how: How) -> Result<Self, AxisError> {
        let twice = axes.iter().enumerate().find(|(i, axis)| {
            let before = &axes[..*i];
            before.iter().any(|other| other.what == axis.what)
        });
        match twice {
            Some((_, axis)) => Err(AxisError::Twice {
                name: axis.name.clone(),
            }),
            None => Ok(Self {
                scenario,
                axes,
                how,
                pool: None,
            }),
        }
    }

    /// The same on so many threads, 0 for one a processor, instead of those that rayon has. They change nothing but the time.
    ///
    /// # Errors
    /// What rayon says if there can be no such threads.
    pub fn on_threads(mut self, threads: usize) -> Result<Self, ThreadPoolBuildError> {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
        self.pool = Some(Arc::new(pool));
        Ok(self)
    }

    /// How many shots there are.
    #[must_use]
    pub fn shots(&self) -> u64 {
        match self.how {
            How::Grid { shots } | How::Random { shots, .. } => shots,
        }
    }

    /// The value of every axis in a shot, counted from 0.
    #[must_use]
    pub fn values(&self, shot: u64) -> Vec<f64> {
        if let How::Random { seed, .. } = self.how {
            let mut rng = numbers(seed, 0, shot);
            return self.axes.iter().map(|axis| axis.draw(&mut rng)).collect();
        }
        let mut left = shot;
        let mut values: Vec<f64> = self
            .axes
            .iter()
            .rev()
            .filter_map(|axis| match &axis.values {
                Values::Listed(listed) => {
                    let count = listed.len() as u64;
                    let value = listed[(left % count) as usize];
                    left /= count;
                    Some(value)
                }
                Values::Between(..) | Values::About(..) => None,
            })
            .collect();
        values.reverse();
        values
    }

    /// The scene of a shot.
    ///
    /// # Errors
    /// Why it cannot be played, in words: a number out of its range, or balls that overlap.
    pub fn scene(&self, shot: u64) -> Result<Scene, String> {
        self.scene_with(&self.values(shot))
    }

    fn scene_with(&self, values: &[f64]) -> Result<Scene, String> {
        let mut scene = self.scenario.scene.clone();
        let numbers = self.axes.iter().map(|axis| &axis.what);
        axis::set(&mut scene, numbers.zip(values.iter().copied()))
            .map_err(|error| error.in_file("sweep").to_string())?;
        scene.check().map_err(|error| error.to_string())?;
        Ok(scene)
    }

    /// Plays these shots on all threads; the rows are in the order of the shots.
    #[must_use]
    pub fn play(&self, shots: Range<u64>) -> Vec<Row> {
        match &self.pool {
            Some(pool) => pool.install(|| self.rows(shots)),
            None => self.rows(shots),
        }
    }

    fn rows(&self, shots: Range<u64>) -> Vec<Row> {
        let tasks: Vec<u64> = (shots.start..shots.end).step_by(TASK as usize).collect();
        let rows = tasks.into_par_iter().flat_map_iter(|first| {
            let mut player = Player::default();
            let last = (first + TASK).min(shots.end);
            let rows: Vec<Row> = (first..last)
                .map(|shot| self.row(shot, &mut player))
                .collect();
            rows
        });
        rows.collect()
    }

    fn row(&self, shot: u64, player: &mut Player) -> Row {
        let values = self.values(shot);
        let played = self.scene_with(&values).and_then(|scene| {
            let told = |record: &_| Played::of(&scene, record, &self.scenario.expect);
            if scene.solver != Solver::Exact {
                let record = play(&scene).map_err(|error| error.to_string())?;
                return Ok(told(&record));
            }
            match player.play(&scene) {
                Ok(record) => Ok(told(record)),
                Err(error) => {
                    player.forget();
                    Err(error.to_string())
                }
            }
        });
        Row {
            shot,
            values,
            played,
        }
    }

    /// Plays all shots and writes them as CSV as they come, a row a shot; `done` hears how many have been written. Returns how
    /// many could not be played.
    ///
    /// # Errors
    /// What the stream says.
    pub fn write(&self, out: &mut dyn io::Write, mut done: impl FnMut(u64)) -> io::Result<u64> {
        let mut csv = csv::Writer::from_writer(out);
        let columns = self.columns();
        csv.write_record(&columns)?;
        let (mut next, mut refused) = (0, 0);
        while next < self.shots() {
            let end = (next + WAITING).min(self.shots());
            for row in self.play(next..end) {
                refused += u64::from(row.played.is_err());
                let mut cells = row.cells(&self.scenario.scene);
                cells.resize(columns.len(), String::new());
                csv.write_record(&cells)?;
            }
            csv.flush()?;
            next = end;
            done(next);
        }
        Ok(refused)
    }

    /// The heads of the columns, in the order of [`Row::cells`].
    #[must_use]
    pub fn columns(&self) -> Vec<String> {
        let axes = self.axes.iter().map(|axis| axis.name.clone());
        let mut columns: Vec<String> = std::iter::once("shot".to_owned()).chain(axes).collect();
        columns.extend(row::columns(&self.scenario.scene, &self.scenario.expect));
        columns
    }
}
