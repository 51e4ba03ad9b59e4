//! What becomes of a ball.

use serde::{Deserialize, Serialize};

use crate::scenarios::expect::check::{Checked, Checker};
use crate::scenarios::expect::grade;
use crate::scenarios::expect::kinds::Kind;
use crate::scenarios::expect::phrase::{Phrase, say};
use crate::scenarios::expect::reading::{Play, Reading};
use crate::scenarios::expect::standing::Progress;
use crate::scenarios::expect::tell;

/// A pocket takes the ball: this one, or any.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Potted {
    /// The ball.
    pub ball: String,
    /// The pocket; without it any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pocket: Option<String>,
}

impl Kind for Potted {
    fn check(&self, checker: &Checker) -> Checked {
        checker.ball("ball", &self.ball)?;
        checker.pocket("pocket", self.pocket.as_deref())
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let ball = play.ball(&self.ball)?;
        Some(grade::potted(play, ball, self.pocket.as_deref()))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        progress.met || progress.play.is_gone(&self.ball)
    }

    fn wanted(&self) -> Phrase {
        let ball = tell::ball(&self.ball);
        match &self.pocket {
            Some(into) => say!(
                "expect-potted-into", "{a} falls into {pocket}", a: ball, pocket: tell::pocket(into)
            ),
            None => say!("expect-potted", "{a} is potted", a: ball),
        }
    }
}

/// The ball is neither potted nor leaves the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stays {
    /// The ball.
    pub ball: String,
}

impl Kind for Stays {
    fn check(&self, checker: &Checker) -> Checked {
        checker.ball("ball", &self.ball)
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        Some(grade::stays(play, play.ball(&self.ball)?))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        !progress.met
    }

    fn wanted(&self) -> Phrase {
        say!("expect-stays", "{a} stays on the table", a: tell::ball(&self.ball))
    }
}
