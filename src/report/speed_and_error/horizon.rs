//! How far ahead a scene can be told, and where two accounts of it part.

use glam::DVec3;

use crate::physics::exact::{Limits, solve};
use crate::physics::record::Record;
use crate::physics::scene::Scene;
use crate::report::speed_and_error::play::{Played, SAMPLES, Touch, sampled};
use crate::sim::play::Stopped;

/// The turn in rad that stands for what nobody can know: a thousand roundings of a direction.
pub const NUDGE: f64 = 1e-13;

/// Contacts within this time in s are at one time, and have no order.
const AT_ONCE: f64 = 1e-9;

/// The scene as the exact solver plays it, up to where that means something.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The whole run.
    pub record: Record,
    /// States at the common times before the horizon, and the contacts of the whole run.
    pub played: Played,
    /// Up to which time in s the same contacts come in the same order after a turn of [`NUDGE`]: the horizon, or the end.
    pub until: f64,
    /// Whether the scene ended before its horizon.
    pub whole: bool,
    /// Contacts up to then.
    pub contacts: usize,
    /// How far in m the turn has carried any ball at any common time up to then: no comparison says less than this.
    pub floor: f64,
}

/// Finds the horizon of a scene.
///
/// # Errors
/// [`Stopped`] if the exact solver cannot play it.
pub fn truth(scene: &Scene) -> Result<Truth, Stopped> {
    let record = solve(scene, Limits::default())?;
    let other = solve(&turned(scene, NUDGE), Limits::default())?;
    let [mine, theirs] = [&record, &other].map(|record| Touch::all(&record.events));
    let agreed = agreement(&mine, &theirs, mine.len().max(theirs.len()));
    let first = |touches: &[Touch]| {
        touches
            .get(agreed)
            .map_or(f64::INFINITY, |touch| touch.time)
    };
    let horizon = first(&mine).min(first(&theirs));
    let whole = horizon.is_infinite();
    let until = horizon.min(record.end_time).min(other.end_time);
    // The common times before it, but one at least.
    let samples = (until * f64::from(SAMPLES)).ceil().max(2.0) as usize - 1;
    let played = sampled(&record, samples);
    let nudged = sampled(&other, samples);
    let floor = apart(&played, &nudged).fold(0.0, f64::max);
    Ok(Truth {
        played,
        until: until.max(1.0 / f64::from(SAMPLES)),
        whole,
        contacts: agreed,
        floor,
        record,
    })
}

/// The distance in m of every ball at every sample in two accounts.
pub(super) fn apart<'a>(one: &'a Played, two: &'a Played) -> impl Iterator<Item = f64> + 'a {
    let pairs = one.states.iter().zip(&two.states);
    pairs.flat_map(|(one, two)| {
        one.iter()
            .zip(two)
            .map(|(one, two)| one.position.distance(two.position))
    })
}

/// A scene whose motion at the start is turned about the vertical by this angle in rad.
#[must_use]
pub fn turned(scene: &Scene, angle: f64) -> Scene {
    let mut scene = scene.clone();
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    let turn = |v: &mut DVec3| *v = DVec3::new(cos * v.x + sin * v.z, v.y, cos * v.z - sin * v.x);
    for ball in &mut scene.balls {
        turn(&mut ball.state.velocity);
        turn(&mut ball.state.angular_velocity);
    }
    if let Some(planned) = &mut scene.shot {
        planned.shot.heading += angle;
    }
    scene
}

/// How many contacts come in the same order in both lists, looking at the first `most` of them. Contacts at one time may
/// stand in any order.
#[must_use]
pub fn agreement(one: &[Touch], two: &[Touch], most: usize) -> usize {
    let mut agreed = 0;
    while agreed < most && agreed < one.len().min(two.len()) {
        let mut end = agreed + 1;
        loop {
            let further = at_once(one, end).max(at_once(two, end));
            if further == end {
                break;
            }
            end = further;
        }
        let keys = |list: &[Touch]| {
            let mut keys: Vec<_> = list[agreed.min(list.len())..end.min(list.len())]
                .iter()
                .map(|touch| touch.key)
                .collect();
            keys.sort_unstable();
            keys
        };
        if keys(one) != keys(two) {
            let same = |at: &usize| {
                one.get(*at)
                    .zip(two.get(*at))
                    .is_some_and(|(one, two)| one.key == two.key)
            };
            return (agreed..end)
                .take_while(same)
                .last()
                .map_or(agreed, |last| last + 1)
                .min(most);
        }
        agreed = end;
    }
    agreed.min(most)
}

/// Where the group ends that holds the contact before `end`.
fn at_once(list: &[Touch], end: usize) -> usize {
    let pairs = list.windows(2).skip(end - 1);
    end + pairs
        .take_while(|pair| pair[1].time - pair[0].time <= AT_ONCE)
        .count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::ball::Ball;
    use crate::physics::laws::Laws;
    use crate::physics::table::Preset;

    fn list(touches: &[(f64, usize)]) -> Vec<Touch> {
        let touch = |&(time, ball)| Touch {
            time,
            key: (1, ball, 0),
        };
        touches.iter().map(touch).collect()
    }

    #[test]
    fn lists_agree_up_to_the_first_contact_that_differs() {
        let one = list(&[(0.1, 0), (0.2, 1), (0.3, 2)]);
        assert_eq!(agreement(&one, &one, 3), 3);
        assert_eq!(agreement(&one, &one, 2), 2);
        assert_eq!(
            agreement(&one, &list(&[(0.1, 0), (0.2, 2), (0.3, 1)]), 3),
            1
        );
        assert_eq!(agreement(&one, &list(&[(0.1, 0), (0.2, 1)]), 3), 2);
        assert_eq!(agreement(&one, &[], 3), 0);
        assert_eq!(agreement(&[], &[], 0), 0);
    }

    #[test]
    fn contacts_at_one_time_have_no_order() {
        let one = list(&[(0.1, 0), (0.2, 1), (0.2, 2), (0.3, 3)]);
        let two = list(&[(0.1, 0), (0.2, 2), (0.2, 1), (0.3, 3)]);
        assert_eq!(agreement(&one, &two, 4), 4);
        // They are there, at whatever time the other has them.
        let late = list(&[(0.11, 0), (0.21, 2), (0.22, 1), (0.31, 3)]);
        assert_eq!(agreement(&one, &late, 4), 4);
        let missing = list(&[(0.1, 0), (0.2, 1), (0.25, 3)]);
        assert_eq!(agreement(&one, &missing, 4), 2);
    }

    #[test]
    fn a_lone_ball_has_no_horizon_and_a_gas_has_one() {
        let mut lone = Scene::new(Preset::NineFoot.table(), Laws::default());
        lone.place("cue", Ball::POOL, 0.0, 0.0);
        lone.balls[0].state.velocity = DVec3::X;
        let known = truth(&lone).expect("a sound scene");
        assert!(
            known.whole && known.until == known.record.end_time,
            "{known:?}"
        );
        assert!(
            known.floor > 0.0 && known.floor < 1e-12,
            "{:e}",
            known.floor
        );

        let mut gas = crate::report::speed_and_error::many::gas(100, false, 0);
        gas.solver = crate::physics::scene::Solver::Exact;
        gas.time_limit = 3.0;
        let known = truth(&gas).expect("a sound scene");
        assert!(
            !known.whole && known.until > 0.1 && known.until < 2.5,
            "{}",
            known.until
        );
        assert!(known.contacts > 100, "{}", known.contacts);
    }
}
