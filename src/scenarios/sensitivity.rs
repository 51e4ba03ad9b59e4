//! How much a stroke may vary before its shot no longer does what is expected.

use rayon::prelude::*;
use thiserror::Error;

use crate::physics::scene::{PlannedShot, Scene};
use crate::scenarios::dial::Dial;
use crate::scenarios::expect::miss;
use crate::scenarios::file::Scenario;
use crate::scenarios::search::Player;

/// The first step away from the stroke, in units of [`Dial::human_error`].
const FIRST: f64 = 1e-5;

/// Every step is so much longer than the one before.
const GROWTH: f64 = 1.2;

/// Halvings of the last step: the edge is then known to a millionth of it.
const HALVINGS: u32 = 20;

/// How far a heading is turned at most, degrees.
const HALF_TURN: f64 = 180.0;

/// Why a shot has no sensitivity.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum SensitivityError {
    /// There is no stroke.
    #[error("shot: the scene has no shot, so that nothing can be turned")]
    NoShot,
    /// Nothing is expected.
    #[error("expect: nothing is expected, so that nothing can fail")]
    NothingExpected,
    /// The laws have no closed form.
    #[error("laws.motion: sensitivity needs laws with a closed form, for the exact solver")]
    NotExact,
    /// The shot itself fails.
    #[error("expect[{expectation}]: the shot misses this as it is")]
    Misses {
        /// The first expectation that it misses.
        expectation: usize,
    },
}

/// How far a number may be turned one way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// The change at which an expectation begins to fail, in the unit of the dial; never below 0.
    pub by: f64,
    /// The expectation that fails first; none if the dial comes to its stop before.
    pub fails: Option<usize>,
}

/// How far a number may be turned both ways while the others stay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Room {
    /// The number.
    pub dial: Dial,
    /// Its value in the shot.
    pub value: f64,
    /// Downwards.
    pub below: Edge,
    /// Upwards.
    pub above: Edge,
}

/// A shot whose numbers can be turned.
struct Stroke<'s> {
    scenario: &'s Scenario,
    planned: PlannedShot,
    scene: Scene,
    player: Player,
}

impl<'s> Stroke<'s> {
    fn of(scenario: &'s Scenario) -> Result<Self, SensitivityError> {
        let planned = scenario.scene.shot.ok_or(SensitivityError::NoShot)?;
        if scenario.expect.is_empty() {
            return Err(SensitivityError::NothingExpected);
        }
        if !scenario.scene.laws.motion.is_closed_form() {
            return Err(SensitivityError::NotExact);
        }
        Ok(Self {
            scenario,
            planned,
            scene: scenario.scene.clone(),
            player: Player::default(),
        })
    }

    /// The shot with some numbers turned to other values.
    fn turn(&mut self, turned: &[(Dial, f64)]) {
        let mut shot = self.planned.shot;
        for (dial, value) in turned {
            dial.set(&mut shot, *value);
        }
        self.scene.shot = Some(PlannedShot {
            shot,
            ..self.planned
        });
    }

    fn miss(&mut self, turned: &[(Dial, f64)]) -> f64 {
        self.turn(turned);
        if let Ok(record) = self.player.play(&self.scene) {
            return miss(&self.scene, record, &self.scenario.expect);
        }
        self.player.forget();
        f64::INFINITY
    }

    /// The first expectation that fails; `None` if all are met.
    fn fails(&mut self, turned: &[(Dial, f64)]) -> Option<usize> {
        self.turn(turned);
        let expect = &self.scenario.expect;
        if let Ok(record) = self.player.play(&self.scene) {
            return expect
                .iter()
                .position(|one| one.miss(&self.scene, record) > 0.0);
        }
        self.player.forget();
        Some(0)
    }

    /// Looks for the edge in one direction: ever longer steps until one fails, then halves.
    fn edge(&mut self, dial: Dial, sign: f64) -> Edge {
        let value = dial.get(&self.planned.shot);
        let (least, most) = dial.limits(&self.planned.shot, self.scene.cue.miscue_offset);
        let stop = if sign > 0.0 {
            most - value
        } else {
            value - least
        };
        let stop = stop.clamp(0.0, HALF_TURN);
        let (mut good, mut step) = (0.0, FIRST * dial.human_error());
        loop {
            let tried = step.min(stop);
            if tried <= good {
                return Edge {
                    by: stop,
                    fails: None,
                };
            }
            if let Some(mut fails) = self.fails(&[(dial, value + sign * tried)]) {
                let mut bad = tried;
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (good + bad);
                    match self.fails(&[(dial, value + sign * middle)]) {
                        Some(first) => (bad, fails) = (middle, first),
                        None => good = middle,
                    }
                }
                return Edge {
                    by: good,
                    fails: Some(fails),
                };
            }
            good = tried;
            step *= GROWTH;
        }
    }
}

/// How far each number of the stroke may be turned alone. Between two tries a shot is taken to do what both do.
///
/// # Errors
/// [`SensitivityError`] if there is nothing to turn, or the shot misses as it is.
pub fn sensitivity(scenario: &Scenario) -> Result<Vec<Room>, SensitivityError> {
    let mut stroke = Stroke::of(scenario)?;
    if let Some(expectation) = stroke.fails(&[]) {
        return Err(SensitivityError::Misses { expectation });
    }
    Dial::ALL
        .into_par_iter()
        .map(|dial| {
            let mut stroke = Stroke::of(scenario)?;
            Ok(Room {
                dial,
                value: dial.get(&stroke.planned.shot),
                below: stroke.edge(dial, -1.0),
                above: stroke.edge(dial, 1.0),
            })
        })
        .collect()
}

/// How far a shot is from its expectations while two numbers are turned together.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// The number that changes along a row.
    pub across: Dial,
    /// The number that changes from row to row.
    pub along: Dial,
    /// Values of the first, ascending.
    pub columns: Vec<f64>,
    /// Values of the second, ascending.
    pub rows: Vec<f64>,
    /// Row by row; 0 where everything is met.
    pub misses: Vec<f64>,
}

impl Map {
    /// The share of the map where everything is met.
    #[must_use]
    pub fn met(&self) -> f64 {
        let met = self.misses.iter().filter(|miss| **miss == 0.0).count();
        met as f64 / self.misses.len().max(1) as f64
    }
}

/// A map of so many values each way, wide enough to show where the shot fails on all sides.
///
/// # Errors
/// [`SensitivityError`] as [`sensitivity`].
pub fn map(
    scenario: &Scenario,
    (across, along): (Dial, Dial),
    count: usize,
) -> Result<Map, SensitivityError> {
    map_around(scenario, &sensitivity(scenario)?, (across, along), count)
}

/// The same where it is known already how far each number may be turned alone.
///
/// # Errors
/// [`SensitivityError`] if there is nothing to turn.
pub fn map_around(
    scenario: &Scenario,
    rooms: &[Room],
    (across, along): (Dial, Dial),
    count: usize,
) -> Result<Map, SensitivityError> {
    let stroke = Stroke::of(scenario)?;
    let values = |dial: Dial| -> Vec<f64> {
        let room = rooms.iter().find(|room| room.dial == dial);
        let reach = room.map_or(0.0, |room| room.below.by.max(room.above.by));
        // Twice as far as it goes alone; a dial that never fails is shown as far as a good player errs.
        let never =
            room.is_some_and(|room| room.below.fails.is_none() && room.above.fails.is_none());
        let reach = if never {
            reach.min(5.0 * dial.human_error())
        } else {
            2.0 * reach
        };
        let reach = reach.max(1e-6 * dial.human_error());
        let value = dial.get(&stroke.planned.shot);
        let (least, most) = dial.limits(&stroke.planned.shot, stroke.scene.cue.miscue_offset);
        let (least, most) = ((value - reach).max(least), (value + reach).min(most));
        let step = (most - least) / (count.max(2) - 1) as f64;
        (0..count).map(|i| least + i as f64 * step).collect()
    };
    let (columns, rows) = (values(across), values(along));
    let misses = rows
        .par_iter()
        .map(|row| {
            let mut stroke = Stroke::of(scenario)?;
            let misses = columns
                .iter()
                .map(|column| stroke.miss(&[(across, *column), (along, *row)]));
            Ok(misses.collect::<Vec<f64>>())
        })
        .collect::<Result<Vec<Vec<f64>>, SensitivityError>>()?;
    Ok(Map {
        across,
        along,
        columns,
        rows,
        misses: misses.concat(),
    })
}

/// A number in four digits, as far as it has any.
#[must_use]
pub fn in_four_digits(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || size >= 1000.0 {
        return format!("{value:.0}");
    }
    let decimals = (3.0 - libm::floor(libm::log10(size))).clamp(0.0, 12.0) as usize;
    format!("{value:.decimals$}")
}
