//! Where an expectation stands while a shot is still being played.

use crate::physics::record::Record;
use crate::physics::scene::Scene;
use crate::scenarios::expect::reading::{Ends, Play};
use crate::scenarios::expect::{Expectation, Moment, Outcome, judge};

/// Where an expectation stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// What is still to come decides.
    Open,
    /// It is met, whatever follows.
    Met,
    /// It is missed, whatever follows.
    Missed,
}

/// The outcome and the standing of every expectation in a record that goes so far, or that is over. What is once met or
/// missed stays so.
#[must_use]
pub fn standings(
    scene: &Scene,
    record: &Record,
    expect: &[Expectation],
    is_over: bool,
) -> Vec<(Outcome, Standing)> {
    judge(scene, record, expect)
        .into_iter()
        .zip(expect)
        .map(|(outcome, expected)| {
            let progress = Progress {
                play: Play { scene, record },
                met: outcome.met,
                found: outcome.found,
            };
            let settled = is_over || expected.kind().is_settled(&progress);
            let standing = match (settled, outcome.met) {
                (false, _) => Standing::Open,
                (true, true) => Standing::Met,
                (true, false) => Standing::Missed,
            };
            (outcome, standing)
        })
        .collect()
}

/// A shot that may go on, and what has been read of an expectation so far.
pub(super) struct Progress<'a> {
    pub(super) play: Play<'a>,
    pub(super) met: bool,
    pub(super) found: Option<f64>,
}

impl Progress<'_> {
    /// Whether a moment that comes once has come. A ball that rests may be hit again, and the end is not there yet.
    pub(super) fn came(&self, moment: &Moment) -> bool {
        !matches!(moment, Moment::End | Moment::Rests(_)) && self.play.came(moment).is_some()
    }

    /// Whether a value that only grows is settled: once over the most it is lost, once over the least alone it is won.
    pub(super) fn grows(&self, Ends(least, most): Ends) -> bool {
        if self.met {
            least.is_some() && most.is_none()
        } else {
            matches!((self.found, most), (Some(found), Some(most)) if found > most)
        }
    }
}
