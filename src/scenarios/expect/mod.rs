//! What must happen in a shot, said in a scene file, and whether it did.
//!
//! ```ron
//! expect: [
//!     Potted(ball: "1", pocket: "foot right"),
//!     Stays(ball: "cue"),
//!     Order([Hit("cue", "1"), Rail("cue"), Falls("1")]),
//!     Near(ball: "cue", at: Diamonds(2, 4), within: 0.1),
//!     Advances(ball: "cue", from: Hit("cue", "1"), most: -0.5),     // it comes back half a metre at least
//! ]
//! ```
//!
//! The kinds there are: [`kinds`]. Everything here is pure: a scene and its record go in, [`Outcome`]s come out. Each has a `miss`, 0 where the expectation
//! is met and growing with the distance from it, so that a search can climb.

mod check;
mod grade;
pub mod kinds;
mod moment;
mod phrase;
mod reading;
mod standing;
mod tell;
mod trace;

pub(in crate::scenarios) use check::check;

pub use moment::{Contact, Moment, Rail, Spot};
pub use phrase::{Phrase, Word};
pub use standing::{Standing, standings};

use serde::{Deserialize, Serialize};

use crate::physics::record::Record;
use crate::physics::scene::Scene;
use kinds::Kind;
use reading::{Play, Reading, Shown};

macro_rules! kinds {
    ($($name:ident),+ $(,)?) => {
        /// One thing that must happen. Balls and pockets have the names of the scene; lengths in m, speeds in m/s, times in s.
        /// Of `least` and `most` at least one is given; both ends are allowed.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        pub enum Expectation {
            $(#[doc = concat!("See [`kinds::", stringify!($name), "`].")] $name(kinds::$name)),+
        }

        impl Expectation {
            fn kind(&self) -> &dyn Kind {
                match self {
                    $(Self::$name(kind) => kind),+
                }
            }
        }
    };
}

kinds! {
    Potted,
    Stays,
    Order,
    Never,
    Count,
    Near,
    Inside,
    Passes,
    Gap,
    Height,
    Over,
    Speed,
    Heading,
    Turns,
    Travels,
    Advances,
    Time,
}

/// What became of an expectation.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// Whether it is met.
    pub met: bool,
    /// 0 if it is met, else how far from it the shot was: about 1 for a metre, 30 degrees, 1 m/s.
    pub miss: f64,
    /// The value found, if the expectation speaks of one and its moments came.
    pub found: Option<f64>,
    /// The unit of the value.
    pub unit: &'static str,
    /// What was expected, in words.
    pub wanted: Phrase,
    /// What happened, in words.
    pub seen: Phrase,
}

impl Outcome {
    /// Both in one sentence.
    #[must_use]
    pub fn sentence(&self) -> String {
        let verdict = if self.met { "met" } else { "MISSED" };
        format!("{verdict}: {}: {}", self.wanted, self.seen)
    }
}

impl Expectation {
    /// What is expected, in words.
    #[must_use]
    pub fn wanted(&self) -> Phrase {
        self.kind().wanted()
    }

    /// Whether this came true in a record of the scene, and the value found.
    #[must_use]
    pub fn outcome(&self, scene: &Scene, record: &Record) -> Outcome {
        let reading = self.read(scene, record);
        let shown = reading.shown;
        Outcome {
            met: reading.miss == 0.0,
            miss: reading.miss,
            found: match shown {
                Shown::Value(value, _) => Some(value),
                _ => None,
            },
            unit: match shown {
                Shown::Value(_, unit) => unit,
                _ => "",
            },
            wanted: self.wanted(),
            seen: tell::seen(&shown, scene),
        }
    }

    /// What a record shows of it.
    fn read(&self, scene: &Scene, record: &Record) -> Reading {
        let play = Play::of(scene, record);
        let reading = play.and_then(|play| self.kind().read(&play));
        reading.unwrap_or(Reading::NOTHING)
    }

    /// How far a record is from meeting this: 0 if it does. Allocates nothing.
    #[must_use]
    pub fn miss(&self, scene: &Scene, record: &Record) -> f64 {
        self.read(scene, record).miss
    }
}

/// What became of every expectation, in their order.
#[must_use]
pub fn judge(scene: &Scene, record: &Record, expect: &[Expectation]) -> Vec<Outcome> {
    let outcomes = expect.iter().map(|one| one.outcome(scene, record));
    outcomes.collect()
}

/// How far a record is from meeting all of these: 0 if it does. Allocates nothing.
#[must_use]
pub fn miss(scene: &Scene, record: &Record, expect: &[Expectation]) -> f64 {
    expect.iter().map(|one| one.miss(scene, record)).sum()
}

/// How near a shot came, from 0 to 100: the mean over its expectations of 1 / (1 + 4 miss), so that a quarter of a metre
/// counts half. 100 means that all are met, and only that.
#[must_use]
pub fn score(outcomes: &[Outcome]) -> u32 {
    if outcomes.iter().all(|outcome| outcome.met) {
        return 100;
    }
    let near = |outcome: &Outcome| 1.0 / (1.0 + 4.0 * outcome.miss.max(0.0));
    let mean = outcomes.iter().map(near).sum::<f64>() / outcomes.len() as f64;
    // Between 0 and 99.
    (100.0 * mean).clamp(0.0, 99.0) as u32
}
