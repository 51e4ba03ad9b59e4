//! Every kind of expectation: what can be wrong with it, what it finds in a record, when it is settled, and its words.
//!
//! A new kind is a struct in one of these files with its `Kind`, a line in the list `kinds!` of
//! [`expect`](crate::scenarios::expect), and its sentence in every file of `assets/languages`.

mod contacts;
mod distance;
mod fate;
mod place;
mod time;
mod velocity;
mod way;

pub use contacts::{Count, Never, Order};
pub use distance::{Gap, Height, Over};
pub use fate::{Potted, Stays};
pub use place::{Inside, Near, Passes};
pub use time::Time;
pub use velocity::{Heading, Speed, Turns};
pub use way::{Advances, Travels, Way};

use crate::scenarios::expect::check::{Checked, Checker};
use crate::scenarios::expect::phrase::Phrase;
use crate::scenarios::expect::reading::{Play, Reading};
use crate::scenarios::expect::standing::Progress;

/// A kind of expectation.
pub(super) trait Kind {
    /// Refuses what names a thing that is not there, or could never be tested.
    fn check(&self, checker: &Checker) -> Checked;

    /// What a record shows of it, and how far off that is. None if it cannot be told at all: a ball is missing, or a span
    /// of time never came.
    fn read(&self, play: &Play) -> Option<Reading>;

    /// Whether nothing that follows in a shot can change what was read.
    fn is_settled(&self, progress: &Progress) -> bool;

    /// What is expected, in words.
    fn wanted(&self) -> Phrase;
}
