//! Where an expectation stands while a shot is still being played.

use crate::physics::record::Record;
use crate::physics::scene::Scene;
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
            let settled = is_over || is_settled(expected, &outcome, scene, record);
            let standing = match (settled, outcome.met) {
                (false, _) => Standing::Open,
                (true, true) => Standing::Met,
                (true, false) => Standing::Missed,
            };
            (outcome, standing)
        })
        .collect()
}

/// Whether nothing that follows can change the outcome.
fn is_settled(expected: &Expectation, outcome: &Outcome, scene: &Scene, record: &Record) -> bool {
    let met = outcome.met;
    // Moments that come once. A ball that rests may be hit again, and the end is not there yet.
    let came = |moment: &Moment| {
        !matches!(moment, Moment::End | Moment::Rests(_)) && moment.came(scene, record).is_some()
    };
    let is_gone = |name: &str| {
        let ball = scene.ball_named(name).and_then(|ball| record.end.get(ball));
        ball.is_some_and(|state| !state.motion.in_play())
    };
    // Values that only grow: once over the most they are lost, once over the least alone they are won.
    let grows = |least: Option<f64>, most: Option<f64>| {
        if met {
            least.is_some() && most.is_none()
        } else {
            matches!((outcome.found, most), (Some(found), Some(most)) if found > most)
        }
    };
    match expected {
        Expectation::Potted { ball, .. } => met || is_gone(ball),
        Expectation::Stays { .. } | Expectation::Never(_) => !met,
        Expectation::Order(_) => met,
        Expectation::Count {
            least, most, until, ..
        } => came(until) || grows(least.map(f64::from), most.map(f64::from)),
        Expectation::Near { when, .. }
        | Expectation::Inside { when, .. }
        | Expectation::Speed { when, .. }
        | Expectation::Heading { when, .. } => came(when),
        Expectation::Passes { until, from, .. } => met || (came(until) && came(from)),
        Expectation::Gap {
            least,
            most,
            from,
            until,
            ..
        } => {
            if came(until) && came(from) {
                return true;
            }
            // The least gap only shrinks.
            match (met, least, most) {
                (true, least, _) => least.is_none(),
                (false, Some(least), _) => outcome.found.is_some_and(|found| found < *least),
                (false, None, _) => false,
            }
        }
        Expectation::Height {
            least,
            most,
            from,
            until,
            ..
        } => (came(until) && came(from)) || grows(*least, *most),
        Expectation::Over { .. } => false,
        Expectation::Turns { from, to, .. } | Expectation::Advances { from, to, .. } => {
            came(from) && came(to)
        }
        Expectation::Travels {
            least,
            most,
            from,
            to,
            ..
        } => came(from) && (came(to) || (to.is_end() && grows(*least, *most))),
        Expectation::Time { of, .. } => came(of),
    }
}
