//! Which contacts happen, in which order, how often.

use serde::{Deserialize, Serialize};

use crate::scenarios::expect::check::{Checked, Checker};
use crate::scenarios::expect::grade;
use crate::scenarios::expect::kinds::Kind;
use crate::scenarios::expect::moment::{Contact, Moment};
use crate::scenarios::expect::phrase::{Phrase, Word, say};
use crate::scenarios::expect::reading::{Ends, Play, Reading};
use crate::scenarios::expect::standing::Progress;
use crate::scenarios::expect::tell;

/// These contacts happen in this order; others may happen between them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Order(pub Vec<Contact>);

impl Kind for Order {
    fn check(&self, checker: &Checker) -> Checked {
        if self.0.is_empty() {
            return checker.refuse("Order", "[]", "an order has one contact at least");
        }
        let mut numbered = self.0.iter().enumerate();
        numbered.try_for_each(|(i, contact)| checker.contact(&format!("Order[{i}]"), contact))
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        Some(grade::order(play, &self.0))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        progress.met
    }

    fn wanted(&self) -> Phrase {
        let contacts = self.0.iter().map(tell::contact).collect();
        say!("expect-order", "{contacts}", contacts: Word::Then(contacts))
    }
}

/// This contact does not happen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Never(pub Contact);

impl Kind for Never {
    fn check(&self, checker: &Checker) -> Checked {
        checker.contact("Never", &self.0)
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        Some(grade::never(play, &self.0))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        !progress.met
    }

    fn wanted(&self) -> Phrase {
        say!("expect-never", "never: {contact}", contact: tell::contact(&self.0))
    }
}

/// How often a contact happens.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Count {
    /// The contact.
    pub of: Contact,
    /// Least number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least: Option<u32>,
    /// Greatest number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub most: Option<u32>,
    /// Only what comes before this moment counts.
    #[serde(default = "Moment::end", skip_serializing_if = "Moment::is_end")]
    pub until: Moment,
}

impl Count {
    fn ends(&self) -> Ends {
        Ends(self.least.map(f64::from), self.most.map(f64::from))
    }
}

impl Kind for Count {
    fn check(&self, checker: &Checker) -> Checked {
        checker.contact("of", &self.of)?;
        checker.moment("until", &self.until)?;
        checker.ends(self.ends())
    }

    fn read(&self, play: &Play) -> Option<Reading> {
        let Some(until) = play.came(&self.until) else {
            return Some(play.never(&self.until));
        };
        // What happens at the very end is before it.
        let to_the_end = self.until.is_end();
        let events = play.record.events.iter().filter(|event| {
            self.of.is(play.scene, event) && (to_the_end || event.time < until.time)
        });
        let number = events.count() as f64;
        Some(Reading::within(number, "times", self.ends(), 3.0))
    }

    fn is_settled(&self, progress: &Progress) -> bool {
        progress.came(&self.until) || progress.grows(self.ends())
    }

    fn wanted(&self) -> Phrase {
        say!(
            "expect-count", "{contact} {range}{span}",
            contact: tell::contact(&self.of),
            range: tell::ends(self.ends(), "times"),
            span: tell::between(&Moment::Start, &self.until),
        )
    }
}
