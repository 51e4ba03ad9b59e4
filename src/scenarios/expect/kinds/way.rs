//! How far a ball gets.

use serde::{Deserialize, Serialize};

use crate::scenarios::expect::check::{Checked, Checker};
use crate::scenarios::expect::kinds::Kind;
use crate::scenarios::expect::moment::Moment;
use crate::scenarios::expect::phrase::{Phrase, say};
use crate::scenarios::expect::reading::{Ends, Play, Reading, STILL};
use crate::scenarios::expect::standing::Progress;
use crate::scenarios::expect::tell;
use crate::scenarios::expect::trace::{self, Span, plan};

/// The length of the way of the ball, m.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Travels {
    /// The ball.
    pub ball: String,
    /// Least length.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least: Option<f64>,
    /// Greatest length.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub most: Option<f64>,
    /// Where the way begins.
    #[serde(default, skip_serializing_if = "Moment::is_start")]
    pub from: Moment,
    /// Where it ends.
    #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
    pub to: Moment,
}

impl Kind for Travels {
    fn check(&self, checker: &Checker) -> Checked {
        checker.ball("ball", &self.ball)?;
        checker.moment("from", &self.from)?;
        checker.moment("to", &self.to)?;
        checker.ends(Ends(self.least, self.most))
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let ball = play.ball(&self.ball)?;
        let Some(begin) = play.came(&self.from) else {
            return Some(play.never(&self.from));
        };
        let Some(end) = play.came(&self.to) else {
            return Some(play.never(&self.to));
        };
        let span = Span {
            from: begin.time,
            until: end.time,
        };
        let length = trace::length(play.record, ball, span);
        Some(Reading::within(
            length,
            "m",
            Ends(self.least, self.most),
            1.0,
        ))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        let grows = || self.to.is_end() && progress.grows(Ends(self.least, self.most));
        progress.came(&self.from) && (progress.came(&self.to) || grows())
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-travels", "{a} travels {range}{span}",
            a: tell::ball(&self.ball), range: tell::ends(Ends(self.least, self.most), "m"),
            span: tell::between(&self.from, &self.to),
        )
    }
}

/// How far the ball gets in the direction in which it moves at the first moment, m; below zero it comes back.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Advances {
    /// The ball.
    pub ball: String,
    /// Least distance.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least: Option<f64>,
    /// Greatest distance.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub most: Option<f64>,
    /// The first moment.
    #[serde(default, skip_serializing_if = "Moment::is_start")]
    pub from: Moment,
    /// The second moment.
    #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
    pub to: Moment,
}

impl Kind for Advances {
    fn check(&self, checker: &Checker) -> Checked {
        checker.ball("ball", &self.ball)?;
        checker.moment("from", &self.from)?;
        checker.moment("to", &self.to)?;
        checker.ends(Ends(self.least, self.most))
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let ball = play.ball(&self.ball)?;
        let Some(begin) = play.state(ball, &self.from) else {
            return Some(play.never(&self.from));
        };
        let Some(end) = play.state(ball, &self.to) else {
            return Some(play.never(&self.to));
        };
        let way = plan(begin.velocity);
        if way.length() < STILL {
            return Some(Reading::no_direction());
        }
        let gone = plan(end.position - begin.position).dot(way.normalize());
        Some(Reading::within(gone, "m", Ends(self.least, self.most), 1.0))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        progress.came(&self.from) && progress.came(&self.to)
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-advances", "{a} gets {range} ahead{span}",
            a: tell::ball(&self.ball), range: tell::ends(Ends(self.least, self.most), "m"),
            span: tell::between(&self.from, &self.to),
        )
    }
}
