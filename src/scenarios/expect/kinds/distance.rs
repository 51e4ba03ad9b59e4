//! How near balls come to each other and how high they fly.

use serde::{Deserialize, Serialize};

use crate::scenarios::expect::check::{Checked, Checker};
use crate::scenarios::expect::grade;
use crate::scenarios::expect::kinds::Kind;
use crate::scenarios::expect::moment::Moment;
use crate::scenarios::expect::phrase::{Phrase, say};
use crate::scenarios::expect::reading::{Ends, Play, Reading, Shown};
use crate::scenarios::expect::standing::Progress;
use crate::scenarios::expect::tell;
use crate::scenarios::expect::trace::{self, place, plan};

/// A height in m that counts as much as a metre in plan.
const HIGH: f64 = 0.1;

/// The smallest distance in space between the surfaces of two balls, m.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gap {
    /// The ball.
    pub ball: String,
    /// The other ball.
    pub of: String,
    /// Least gap.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least: Option<f64>,
    /// Greatest gap.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub most: Option<f64>,
    /// Only what comes after this moment counts.
    #[serde(default, skip_serializing_if = "Moment::is_start")]
    pub from: Moment,
    /// Only what comes before this moment counts.
    #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
    pub until: Moment,
}

impl Kind for Gap {
    fn check(&self, checker: &Checker) -> Checked {
        checker.pair("ball", &self.ball, &self.of)?;
        checker.moment("from", &self.from)?;
        checker.moment("until", &self.until)?;
        checker.ends(Ends(self.least, self.most))
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let pair = [play.ball(&self.ball)?, play.ball(&self.of)?];
        let span = play.span(&self.from, &self.until)?;
        let gap = |time: f64| grade::gap(play, pair, time);
        let (_, gap) = trace::least(play.record, &pair, span, gap)?;
        Some(Reading::within(gap, "m", Ends(self.least, self.most), 1.0))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        if progress.came(&self.until) && progress.came(&self.from) {
            return true;
        }
        // The least gap only shrinks.
        match (progress.met, self.least) {
            (true, least) => least.is_none(),
            (false, Some(least)) => progress.found.is_some_and(|found| found < least),
            (false, None) => false,
        }
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-gap", "the smallest gap between {a} and {b}{span} is {range}",
            a: tell::ball(&self.ball), b: tell::ball(&self.of),
            span: tell::between(&self.from, &self.until),
            range: tell::ends(Ends(self.least, self.most), "m"),
        )
    }
}

/// The greatest height of the lowest point of the ball over the slate, m.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Height {
    /// The ball.
    pub ball: String,
    /// Least height.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least: Option<f64>,
    /// Greatest height.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub most: Option<f64>,
    /// Only what comes after this moment counts.
    #[serde(default, skip_serializing_if = "Moment::is_start")]
    pub from: Moment,
    /// Only what comes before this moment counts.
    #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
    pub until: Moment,
}

impl Kind for Height {
    fn check(&self, checker: &Checker) -> Checked {
        checker.ball("ball", &self.ball)?;
        checker.flies("ball", &self.ball)?;
        checker.moment("from", &self.from)?;
        checker.moment("until", &self.until)?;
        checker.ends(Ends(self.least, self.most))
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let ball = play.ball(&self.ball)?;
        let span = play.span(&self.from, &self.until)?;
        let radius = play.scene.balls[ball].ball.radius;
        let below = |time: f64| radius - place(play.record, ball, time).y;
        let (_, below) = trace::least(play.record, &[ball], span, below)?;
        Some(Reading::within(
            -below,
            "m",
            Ends(self.least, self.most),
            HIGH,
        ))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        let is_over = progress.came(&self.until) && progress.came(&self.from);
        is_over || progress.grows(Ends(self.least, self.most))
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-height", "{a} rises{span} {range} over the slate",
            a: tell::ball(&self.ball), span: tell::between(&self.from, &self.until),
            range: tell::ends(Ends(self.least, self.most), "m"),
        )
    }
}

/// The ball flies over another: the height in m of its lowest point over the top of the other where their centres are
/// nearest in plan, within a radius of each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Over {
    /// The ball.
    pub ball: String,
    /// The ball below.
    pub of: String,
    /// Least height.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least: Option<f64>,
    /// Greatest height.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub most: Option<f64>,
}

impl Kind for Over {
    fn check(&self, checker: &Checker) -> Checked {
        checker.pair("ball", &self.ball, &self.of)?;
        checker.flies("ball", &self.ball)?;
        checker.ends(Ends(self.least, self.most))
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let (ball, of) = (play.ball(&self.ball)?, play.ball(&self.of)?);
        let record = play.record;
        let places = |time: f64| (place(record, ball, time), place(record, of, time));
        let apart = |time: f64| {
            let (above, below) = places(time);
            plan(above).distance(plan(below))
        };
        let (time, distance) = trace::least(record, &[ball, of], play.whole(), apart)?;
        let radius = |ball: usize| play.scene.balls[ball].ball.radius;
        let (above, below) = places(time);
        let height = (above.y - radius(ball)) - (below.y + radius(of));
        let reading = Reading::within(height, "m", Ends(self.least, self.most), HIGH);
        let aside = (distance - radius(ball)).max(0.0);
        if aside > 0.0 {
            return Some(Reading::new(Shown::Beside(distance), aside + reading.miss));
        }
        Some(reading)
    }

    fn is_settled(&self, _: &Progress) -> bool {
        false
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-over", "{a} flies {range} over the top of {b}",
            a: tell::ball(&self.ball), b: tell::ball(&self.of),
            range: tell::ends(Ends(self.least, self.most), "m"),
        )
    }
}
