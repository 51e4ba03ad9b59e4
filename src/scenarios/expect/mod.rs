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
//! Everything here is pure: a scene and its record go in, [`Outcome`]s come out. Each has a `miss`, 0 where the expectation
//! is met and growing with the distance from it, so that a search can climb.

mod check;
mod grade;
mod measure;
mod moment;
mod phrase;
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
use measure::Shown;

/// One thing that must happen. Balls and pockets have the names of the scene; lengths in m, speeds in m/s, times in s. Of
/// `least` and `most` at least one is given; both ends are allowed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Expectation {
    /// A pocket takes the ball: this one, or any.
    Potted {
        /// The ball.
        ball: String,
        /// The pocket; without it any.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        pocket: Option<String>,
    },
    /// The ball is neither potted nor leaves the table.
    Stays {
        /// The ball.
        ball: String,
    },
    /// These contacts happen in this order; others may happen between them.
    Order(Vec<Contact>),
    /// This contact does not happen.
    Never(Contact),
    /// How often a contact happens.
    Count {
        /// The contact.
        of: Contact,
        /// Least number.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        least: Option<u32>,
        /// Greatest number.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        most: Option<u32>,
        /// Only what comes before this moment counts.
        #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
        until: Moment,
    },
    /// The centre of the ball is near to a place.
    Near {
        /// The ball.
        ball: String,
        /// The place.
        at: Spot,
        /// Greatest distance in plan, m.
        within: f64,
        /// When; the end, if nothing is said.
        #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
        when: Moment,
    },
    /// The centre of the ball is in a rectangle, x and z in m.
    Inside {
        /// The ball.
        ball: String,
        /// The corner with the least x and z.
        least: (f64, f64),
        /// The corner with the greatest.
        most: (f64, f64),
        /// When; the end, if nothing is said.
        #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
        when: Moment,
    },
    /// The centre of the ball passes a mark.
    Passes {
        /// The ball.
        ball: String,
        /// The mark.
        at: Spot,
        /// Greatest distance in plan, m.
        within: f64,
        /// Only what comes after this moment counts.
        #[serde(default, skip_serializing_if = "Moment::is_start")]
        from: Moment,
        /// Only what comes before this moment counts.
        #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
        until: Moment,
    },
    /// The smallest distance in space between the surfaces of two balls, m.
    Gap {
        /// The ball.
        ball: String,
        /// The other ball.
        of: String,
        /// Least gap.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        least: Option<f64>,
        /// Greatest gap.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        most: Option<f64>,
        /// Only what comes after this moment counts.
        #[serde(default, skip_serializing_if = "Moment::is_start")]
        from: Moment,
        /// Only what comes before this moment counts.
        #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
        until: Moment,
    },
    /// The greatest height of the lowest point of the ball over the slate, m.
    Height {
        /// The ball.
        ball: String,
        /// Least height.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        least: Option<f64>,
        /// Greatest height.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        most: Option<f64>,
        /// Only what comes after this moment counts.
        #[serde(default, skip_serializing_if = "Moment::is_start")]
        from: Moment,
        /// Only what comes before this moment counts.
        #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
        until: Moment,
    },
    /// The ball flies over another: the height in m of its lowest point over the top of the other where their centres are
    /// nearest in plan, within a radius of each other.
    Over {
        /// The ball.
        ball: String,
        /// The ball below.
        of: String,
        /// Least height.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        least: Option<f64>,
        /// Greatest height.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        most: Option<f64>,
    },
    /// The speed of the ball, m/s.
    Speed {
        /// The ball.
        ball: String,
        /// Least speed.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        least: Option<f64>,
        /// Greatest speed.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        most: Option<f64>,
        /// When.
        when: Moment,
    },
    /// The direction in which the ball moves: degrees counter-clockwise seen from above from the x axis, as for a shot.
    Heading {
        /// The ball.
        ball: String,
        /// The direction, degrees.
        deg: f64,
        /// Greatest difference, degrees.
        within_deg: f64,
        /// When.
        when: Moment,
    },
    /// By how many degrees the direction of the ball turns between two moments, counter-clockwise seen from above, -180 to
    /// 180.
    Turns {
        /// The ball.
        ball: String,
        /// Least turn, degrees.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        least: Option<f64>,
        /// Greatest turn, degrees.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        most: Option<f64>,
        /// The first moment.
        from: Moment,
        /// The second moment.
        to: Moment,
    },
    /// The length of the way of the ball, m.
    Travels {
        /// The ball.
        ball: String,
        /// Least length.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        least: Option<f64>,
        /// Greatest length.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        most: Option<f64>,
        /// Where the way begins.
        #[serde(default, skip_serializing_if = "Moment::is_start")]
        from: Moment,
        /// Where it ends.
        #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
        to: Moment,
    },
    /// How far the ball gets in the direction in which it moves at the first moment, m; below zero it comes back.
    Advances {
        /// The ball.
        ball: String,
        /// Least distance.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        least: Option<f64>,
        /// Greatest distance.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        most: Option<f64>,
        /// The first moment.
        #[serde(default, skip_serializing_if = "Moment::is_start")]
        from: Moment,
        /// The second moment.
        #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
        to: Moment,
    },
    /// When something happens, s.
    Time {
        /// What.
        of: Moment,
        /// Earliest.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        least: Option<f64>,
        /// Latest.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        most: Option<f64>,
    },
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
        tell::wanted(self)
    }

    /// Whether this came true in a record of the scene, and the value found.
    #[must_use]
    pub fn outcome(&self, scene: &Scene, record: &Record) -> Outcome {
        let reading = measure::read(self, scene, record);
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
            wanted: tell::wanted(self),
            seen: tell::seen(&shown, scene),
        }
    }

    /// How far a record is from meeting this: 0 if it does. Allocates nothing.
    #[must_use]
    pub fn miss(&self, scene: &Scene, record: &Record) -> f64 {
        measure::read(self, scene, record).miss
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
