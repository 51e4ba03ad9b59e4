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

/// A ball and a part of its way.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Way {
    /// The ball.
    pub ball: String,
    /// Least distance, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least: Option<f64>,
    /// Greatest distance, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub most: Option<f64>,
    /// Where the way begins.
    #[serde(default, skip_serializing_if = "Moment::is_start")]
    pub from: Moment,
    /// Where it ends.
    #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
    pub to: Moment,
}

impl Way {
    fn ends(&self) -> Ends {
        Ends(self.least, self.most)
    }

    fn check(&self, checker: &Checker) -> Checked {
        checker.ball("ball", &self.ball)?;
        checker.moment("from", &self.from)?;
        checker.moment("to", &self.to)?;
        checker.ends(self.ends())
    }
}

/// The length of the way of the ball, m.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Travels(pub Way);

impl Kind for Travels {
    fn check(&self, checker: &Checker) -> Checked {
        self.0.check(checker)
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let ball = play.ball(&self.0.ball)?;
        let Some(begin) = play.came(&self.0.from) else {
            return Some(play.never(&self.0.from));
        };
        let Some(end) = play.came(&self.0.to) else {
            return Some(play.never(&self.0.to));
        };
        let span = Span {
            from: begin.time,
            until: end.time,
        };
        let length = trace::length(play.record, ball, span);
        Some(Reading::within(length, "m", self.0.ends(), 1.0))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        let grows = || self.0.to.is_end() && progress.grows(self.0.ends());
        progress.came(&self.0.from) && (progress.came(&self.0.to) || grows())
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-travels", "{a} travels {range}{span}",
            a: tell::ball(&self.0.ball), range: tell::ends(self.0.ends(), "m"),
            span: tell::between(&self.0.from, &self.0.to),
        )
    }
}

/// How far the ball gets in the direction in which it moves at the first moment, m; below zero it comes back.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Advances(pub Way);

impl Kind for Advances {
    fn check(&self, checker: &Checker) -> Checked {
        self.0.check(checker)
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let ball = play.ball(&self.0.ball)?;
        let Some(begin) = play.state(ball, &self.0.from) else {
            return Some(play.never(&self.0.from));
        };
        let Some(end) = play.state(ball, &self.0.to) else {
            return Some(play.never(&self.0.to));
        };
        let way = plan(begin.velocity);
        if way.length() < STILL {
            return Some(Reading::no_direction());
        }
        let gone = plan(end.position - begin.position).dot(way.normalize());
        Some(Reading::within(gone, "m", self.0.ends(), 1.0))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        progress.came(&self.0.from) && progress.came(&self.0.to)
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-advances", "{a} gets {range} ahead{span}",
            a: tell::ball(&self.0.ball), range: tell::ends(self.0.ends(), "m"),
            span: tell::between(&self.0.from, &self.0.to),
        )
    }
}
