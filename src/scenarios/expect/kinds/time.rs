//! When something happens.

use serde::{Deserialize, Serialize};

use crate::scenarios::expect::check::{Checked, Checker};
use crate::scenarios::expect::kinds::Kind;
use crate::scenarios::expect::moment::Moment;
use crate::scenarios::expect::phrase::{Phrase, say};
use crate::scenarios::expect::reading::{Ends, Play, Reading};
use crate::scenarios::expect::standing::Progress;
use crate::scenarios::expect::tell;

/// When something happens, s.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Time {
    /// What.
    pub of: Moment,
    /// Earliest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least: Option<f64>,
    /// Latest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub most: Option<f64>,
}

impl Kind for Time {
    fn check(&self, checker: &Checker) -> Checked {
        checker.moment("of", &self.of)?;
        checker.ends(Ends(self.least, self.most))
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let Some(came) = play.came(&self.of) else {
            return Some(play.never(&self.of));
        };
        Some(Reading::within(
            came.time,
            "s",
            Ends(self.least, self.most),
            1.0,
        ))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        progress.came(&self.of)
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-time", "{moment} comes at {range}",
            moment: tell::moment(&self.of), range: tell::ends(Ends(self.least, self.most), "s"),
        )
    }
}
