//! The one description that a scene file, a test, a benchmark, the aim preview and a saved game share.

mod check;
mod error;
mod places;
mod rack;
mod range;

pub use error::SceneError;
pub use places::OVERLAP_TOLERANCE;
pub use rack::{COLOURS, Rack, colour_spot};
pub use range::{check_parameter, within};

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::cue::{Cue, Shot};
use crate::physics::laws::Laws;
use crate::physics::laws::cue_ball::{Struck, strike};
use crate::physics::table::Table;

/// A ball of a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SceneBall {
    /// What players call it: `cue`, `1` to `15`, or any other name.
    pub name: String,
    /// Its constants.
    pub ball: Ball,
    /// Where it is and how it moves at time 0.
    pub state: State,
}

/// A stroke planned in a scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlannedShot {
    /// Index of the struck ball.
    pub ball: usize,
    /// The stroke.
    pub shot: Shot,
}

/// How the stepped solver is set up.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Stepped {
    /// Length of a tick in s.
    pub tick: f64,
    /// Cells of the grid along x and z; `None` tests every pair and every ball against every cushion.
    pub grid: Option<(u32, u32)>,
    /// Whether a contact is located inside the tick. Without it balls meet where the tick leaves them, overlapped:
    /// the coursework's way.
    pub locate: bool,
    /// Whether the balls are worked on as a crowd: packed, on all threads, counted instead of recorded one by one. The
    /// balls are equal then, there are no pockets, and without a `grid` the cells are fitted to the balls.
    pub crowd: bool,
    /// Whether a crowd keeps its balls in single precision: half the memory, less exact. Smooth balls without spin on a
    /// level table without cloth only.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub single: bool,
}

impl Default for Stepped {
    fn default() -> Self {
        Self {
            tick: 1.0 / 120.0,
            grid: Some((20, 20)),
            locate: true,
            crowd: false,
            single: false,
        }
    }
}

/// Which solver advances a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Solver {
    /// Every event at its own time.
    #[default]
    Exact,
    /// A fixed tick.
    Stepped(Stepped),
}

impl Solver {
    /// Whether the balls are a crowd: see [`Stepped::crowd`].
    #[must_use]
    pub fn is_crowd(&self) -> bool {
        matches!(self, Self::Stepped(stepped) if stepped.crowd)
    }

    /// The solver that these laws get where none is named: exact where there is a closed form.
    #[must_use]
    pub fn suited_to(laws: &Laws) -> Self {
        if laws.motion.is_closed_form() {
            Self::Exact
        } else {
            Self::Stepped(Stepped::default())
        }
    }
}

/// A table, its laws, balls on it and perhaps a stroke.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// The table.
    pub table: Table,
    /// Which laws hold.
    pub laws: Laws,
    /// The cue.
    pub cue: Cue,
    /// The balls.
    pub balls: Vec<SceneBall>,
    /// A stroke at time 0.
    pub shot: Option<PlannedShot>,
    /// The solver.
    pub solver: Solver,
    /// Seconds after which a run of the scene ends even if balls still move.
    pub time_limit: f64,
}

impl Scene {
    /// Default limit of a run in s.
    pub const TIME_LIMIT: f64 = 60.0;

    /// An empty table with these laws.
    #[must_use]
    pub fn new(table: Table, laws: Laws) -> Self {
        Self {
            table,
            laws,
            cue: Cue::default(),
            balls: Vec::new(),
            shot: None,
            solver: Solver::suited_to(&laws),
            time_limit: Self::TIME_LIMIT,
        }
    }

    /// Adds a ball at rest on the slate at x, z and returns its index.
    pub fn place(&mut self, name: &str, ball: Ball, x: f64, z: f64) -> usize {
        self.balls.push(SceneBall {
            name: name.to_owned(),
            ball,
            state: State::at_rest(DVec3::new(x, ball.radius, z)),
        });
        self.balls.len() - 1
    }

    /// Index of the ball with this name.
    #[must_use]
    pub fn ball_named(&self, name: &str) -> Option<usize> {
        self.balls.iter().position(|ball| ball.name == name)
    }

    /// What this shot does to this ball as it stands in the scene.
    #[must_use]
    pub fn struck(&self, planned: &PlannedShot) -> Struck {
        let ball = &self.balls[planned.ball];
        strike_with(
            &self.cue,
            &self.laws,
            &ball.ball,
            &ball.state,
            &planned.shot,
        )
    }
}

/// The stroke as every part of the program plays it: the cue's impulse, the slate's answer, the motion label.
#[must_use]
pub fn strike_with(cue: &Cue, laws: &Laws, ball: &Ball, state: &State, shot: &Shot) -> Struck {
    let mut struck = strike(cue, &laws.slate, ball, state, shot);
    struck.state = laws.motion.classify(ball, struck.state);
    struck
}
