//! Speed against error: what each way to advance a table costs, and how far it is off.
//!
//! A ladder of scenes, from one ball to thousands, is played by every [`Method`]. The exact solver is the truth that the
//! others are measured by, up to the horizon of each scene, beyond which no solver can tell a single shot; from there
//! on the statistics of many shots are compared. For the model of the coursework report the error is its distance from
//! real physics as the laws of the house have it.
//!
//! Costs are processor time of the whole process while the work runs on one thread; short runs are repeated and the
//! cheapest counts, since whatever else the machine does only adds.

mod beyond;
mod comparison;
mod crowds;
mod ensemble;
mod error;
mod fit;
mod horizon;
mod ladder;
mod many;
mod measure;
mod method;
mod pictures;
mod play;
mod sheets;
mod tables;

pub use comparison::{Comparison, Measured};
pub use crowds::{CrowdCost, Drift, GridCost};
pub use ensemble::Ensemble;
pub use error::Errors;
pub use fit::{Convergence, convergence, mean_and_spread, pareto};
pub use horizon::{NUDGE, Truth, truth};
pub use ladder::Rung;
pub use many::{enskog_rate, gas};
pub use measure::{names, run};
pub use method::Method;
pub use pictures::pictures;
pub use sheets::csv;
pub use tables::markdown;

use std::time::Duration;

/// The scenes of the library that belong to the ladder.
pub const LIBRARY: [&str; 7] = [
    BREAK,
    "coursework-1-collisions",
    "coursework-3-backspin",
    "coursework-3-side-curve",
    "coursework-3-draw-english",
    BOARD,
    DAM,
];

/// The scene of which many shots are played.
const BREAK: &str = "break-nine";

/// A Galton board, down which balls run one by one.
const BOARD: &str = "galton";

/// A heap of balls that nothing holds.
const DAM: &str = "dam-break";

/// A scene of the library.
#[derive(Clone, Debug)]
pub struct Named {
    /// What the library calls it.
    pub name: String,
    /// Its title.
    pub title: String,
    /// The scene.
    pub scene: crate::physics::scene::Scene,
}

/// How much to do.
#[derive(Clone, Debug, PartialEq)]
pub struct Effort {
    /// Whether it is the short report.
    pub quick: bool,
    /// Ticks a second of the stepped methods, multiples of 60.
    pub rates: Vec<u32>,
    /// Places from which each scene begins.
    pub starts: u32,
    /// Shots of a break, and balls on a Galton board, whose statistics are compared.
    pub shots: usize,
    /// Runs of a gas and of a dam break whose statistics are compared.
    pub runs: usize,
    /// The largest crowd.
    pub most_balls: u32,
    /// How long a short run is repeated.
    pub budget: Duration,
}

impl Effort {
    /// Everything, in some minutes.
    #[must_use]
    pub fn whole() -> Self {
        Self {
            quick: false,
            rates: vec![60, 120, 240, 480, 960, 1920, 3840, 7680],
            starts: 8,
            shots: 200,
            runs: 12,
            most_balls: 1_000_000,
            budget: Duration::from_millis(200),
        }
    }

    /// A short report, within a minute.
    #[must_use]
    pub fn quick() -> Self {
        Self {
            quick: true,
            rates: vec![60, 120, 240, 480, 960],
            starts: 3,
            shots: 24,
            runs: 3,
            most_balls: 100_000,
            budget: Duration::from_millis(25),
        }
    }
}

/// Hears how far the report is.
pub trait Progress {
    /// So many steps there will be.
    fn begin(&self, steps: usize);
    /// The next step begins, and this is what it does.
    fn step(&self, what: &str);
}

/// Everything measured.
#[derive(Clone, Debug)]
pub struct Report {
    /// How much was done.
    pub effort: Effort,
    /// Scene by scene.
    pub scenes: Vec<Comparison>,
    /// Many shots, of the scenes that were played.
    pub ensembles: Vec<Ensemble>,
    /// What a ball costs.
    pub crowds: Vec<CrowdCost>,
    /// What the grid is worth.
    pub grids: Vec<GridCost>,
    /// Balls of the experiment with grids.
    pub grid_balls: u32,
    /// Whether the energy stays.
    pub drifts: Vec<Drift>,
}

impl Report {
    /// The scenes in which a located method converges slower than is demanded of it: second order, or exact to rounding.
    #[must_use]
    pub fn missed(&self) -> Vec<&str> {
        let gentle = self.scenes.iter().filter(|scene| scene.rung.gentle);
        gentle
            .filter(|scene| !scene.keeps_order())
            .map(|scene| scene.rung.name.as_str())
            .collect()
    }
}
