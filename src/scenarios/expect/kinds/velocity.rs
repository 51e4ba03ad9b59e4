//! How fast a ball is, where it goes, and how it turns.

use serde::{Deserialize, Serialize};

use crate::physics::ball::State;
use crate::scenarios::expect::check::{Checked, Checker};
use crate::scenarios::expect::kinds::Kind;
use crate::scenarios::expect::moment::Moment;
use crate::scenarios::expect::phrase::{Phrase, Word, say};
use crate::scenarios::expect::reading::{Ends, Play, Reading, STILL, Shown};
use crate::scenarios::expect::standing::Progress;
use crate::scenarios::expect::tell;
use crate::scenarios::expect::trace::plan;

/// Degrees that count as much as a metre.
const DEGREES: f64 = 30.0;

/// The speed of the ball, m/s.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Speed {
    /// The ball.
    pub ball: String,
    /// Least speed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least: Option<f64>,
    /// Greatest speed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub most: Option<f64>,
    /// When.
    pub when: Moment,
}

impl Kind for Speed {
    fn check(&self, checker: &Checker) -> Checked {
        checker.ball("ball", &self.ball)?;
        checker.moment("when", &self.when)?;
        checker.ends(Ends(self.least, self.most))
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let ball = play.ball(&self.ball)?;
        let Some(state) = play.state(ball, &self.when) else {
            return Some(play.never(&self.when));
        };
        let speed = state.velocity.length();
        Some(Reading::within(
            speed,
            "m/s",
            Ends(self.least, self.most),
            1.0,
        ))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        progress.came(&self.when)
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-speed", "the speed of {a} at {when} is {range}",
            a: tell::ball(&self.ball), when: tell::moment(&self.when),
            range: tell::ends(Ends(self.least, self.most), "m/s"),
        )
    }
}

/// The direction in which the ball moves: degrees counter-clockwise seen from above from the x axis, as for a shot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Heading {
    /// The ball.
    pub ball: String,
    /// The direction, degrees.
    pub deg: f64,
    /// Greatest difference, degrees.
    pub within_deg: f64,
    /// When.
    pub when: Moment,
}

impl Kind for Heading {
    fn check(&self, checker: &Checker) -> Checked {
        checker.ball("ball", &self.ball)?;
        checker.finite("deg", self.deg)?;
        checker.positive("within_deg", self.within_deg)?;
        checker.moment("when", &self.when)
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let ball = play.ball(&self.ball)?;
        let Some(state) = play.state(ball, &self.when) else {
            return Some(play.never(&self.when));
        };
        let Some(found) = heading(&state) else {
            return Some(Reading::no_direction());
        };
        let off = turn(self.deg, found).abs();
        let miss = Reading::within(off, "", Ends(None, Some(self.within_deg)), DEGREES).miss;
        Some(Reading::new(Shown::Value(found, "degrees"), miss))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        progress.came(&self.when)
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-heading", "{a} moves along {deg} degrees, within {within}, at {when}",
            a: tell::ball(&self.ball), deg: Word::Number(self.deg),
            within: Word::Number(self.within_deg), when: tell::moment(&self.when),
        )
    }
}

/// By how many degrees the direction of the ball turns between two moments, counter-clockwise seen from above, -180 to 180.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Turns {
    /// The ball.
    pub ball: String,
    /// Least turn, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least: Option<f64>,
    /// Greatest turn, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub most: Option<f64>,
    /// The first moment.
    pub from: Moment,
    /// The second moment.
    pub to: Moment,
}

impl Kind for Turns {
    fn check(&self, checker: &Checker) -> Checked {
        checker.ball("ball", &self.ball)?;
        checker.moment("from", &self.from)?;
        checker.moment("to", &self.to)?;
        checker.ends(Ends(self.least, self.most))
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let ball = play.ball(&self.ball)?;
        let Some(before) = play.state(ball, &self.from) else {
            return Some(play.never(&self.from));
        };
        let Some(after) = play.state(ball, &self.to) else {
            return Some(play.never(&self.to));
        };
        let (Some(before), Some(after)) = (heading(&before), heading(&after)) else {
            return Some(Reading::no_direction());
        };
        let ends = Ends(self.least, self.most);
        Some(Reading::within(
            turn(before, after),
            "degrees",
            ends,
            DEGREES,
        ))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        progress.came(&self.from) && progress.came(&self.to)
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-turns", "{a} turns by {range} between {from} and {to}",
            a: tell::ball(&self.ball), range: tell::ends(Ends(self.least, self.most), "degrees"),
            from: tell::moment(&self.from), to: tell::moment(&self.to),
        )
    }
}

/// The direction in which a ball moves, degrees.
fn heading(state: &State) -> Option<f64> {
    let way = plan(state.velocity);
    (way.length() >= STILL).then(|| libm::atan2(-way.y, way.x).to_degrees())
}

/// The turn in degrees from one direction to another, -180 to 180.
fn turn(from: f64, to: f64) -> f64 {
    let turn = (to - from).rem_euclid(360.0);
    if turn > 180.0 { turn - 360.0 } else { turn }
}
