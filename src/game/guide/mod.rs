//! The aim line: where the struck ball goes, what it meets first, and where both go from there.
//!
//! It asks the same laws as the solvers, so it accounts for squirt, for the bend of a sliding ball and for throw. It
//! follows one contact only; balls other than the struck one are taken to stand still. Under the coursework's motion law,
//! which has no closed form, the line is straight.

mod leg;

pub use leg::{Hit, Leg};

use self::leg::leg;

use thiserror::Error;

use crate::physics::ball::State;
use crate::physics::cue::Shot;
use crate::physics::laws::ball_ball::PairContact;
use crate::physics::roots::RootError;
use crate::physics::scene::{Scene, strike_with};

/// A shot as far as the guides show it.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    /// The struck ball up to its first contact. The last point is the ghost ball.
    pub first: Leg,
    /// The object ball after the contact, if a ball is hit.
    pub object: Option<Leg>,
    /// The struck ball after the contact, if it moves on.
    pub onward: Option<Leg>,
    /// Angle in rad by which the way turns from the heading of the cue: squirt, to the left.
    pub squirt: f64,
    /// Whether the tip slips off.
    pub miscue: bool,
}

/// Why there is no guide.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum GuideError {
    /// The ball is not there or lies in a pocket.
    #[error("ball {0} is not on the table")]
    NotOnTable(usize),
    /// Numbers without meaning.
    #[error(transparent)]
    Root(#[from] RootError),
}

/// Follows a shot to its first contact and a little further: the ways after it are cut after `reach` m.
///
/// # Errors
/// [`GuideError`] if the ball is not on the table or a number is not finite.
pub fn first_contact(
    scene: &Scene,
    ball: usize,
    shot: &Shot,
    reach: f64,
) -> Result<Guide, GuideError> {
    let struck = scene
        .balls
        .get(ball)
        .filter(|ball| ball.state.motion.in_play())
        .ok_or(GuideError::NotOnTable(ball))?;
    let outcome = strike_with(&scene.cue, &scene.laws, &struck.ball, &struck.state, shot);
    let first = leg(scene, ball, outcome.state, f64::INFINITY)?;
    let (onward, object) = after(scene, &first);
    let leg_from = |state: Option<(usize, State)>| match state {
        Some((ball, state)) if state.motion.translates() => {
            leg(scene, ball, state, reach).map(Some)
        }
        _ => Ok(None),
    };
    Ok(Guide {
        onward: leg_from(onward.map(|state| (ball, state)))?,
        object: leg_from(object)?,
        first,
        squirt: outcome.squirt,
        miscue: outcome.miscue,
    })
}

/// The struck ball and, if one is hit, the object ball just after the contact that ends a leg.
fn after(scene: &Scene, leg: &Leg) -> (Option<State>, Option<(usize, State)>) {
    let ball = &scene.balls[leg.ball].ball;
    let classify = |index: usize, state: State| {
        let (table, ball) = (&scene.table, &scene.balls[index].ball);
        scene.laws.settled(table, ball, &state)
    };
    match leg.hit {
        Hit::Nothing | Hit::Pocket(_) => (None, None),
        Hit::Ball(other) => {
            let object = &scene.balls[other];
            let contact = PairContact::between(&leg.end, &object.state);
            let outcome = scene.laws.ball_ball.collide(
                (ball, &leg.end),
                (&object.ball, &object.state),
                &contact,
            );
            (
                Some(classify(leg.ball, outcome.first)),
                Some((other, classify(other, outcome.second))),
            )
        }
        Hit::Cushion(index) => {
            let (table, law) = (&scene.table, &scene.laws.cushion);
            let cushion = &table.cushions[index];
            let rebound = law.meet(table, cushion, (ball, &leg.end), None);
            (Some(classify(leg.ball, rebound.state)), None)
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::leg::BEND_POINTS;
    use super::*;
    use crate::physics::ball::Ball;
    use crate::physics::laws::Laws;
    use crate::physics::table::Preset;

    fn scene(laws: Laws) -> Scene {
        let mut scene = Scene::new(Preset::NineFoot.table(), laws);
        scene.place("cue", Ball::POOL, -0.5, 0.0);
        scene
    }

    #[test]
    fn a_straight_shot_meets_the_ball_one_diameter_short() {
        let mut scene = scene(Laws::default());
        scene.place("1", Ball::POOL, 0.3, 0.0);
        let guide = first_contact(&scene, 0, &Shot::default(), 0.4).expect("a fine shot");
        assert_eq!(guide.first.hit, Hit::Ball(1));
        let ghost = guide.first.end.position;
        assert!(
            (ghost.x - (0.3 - 2.0 * Ball::POOL.radius)).abs() < 1e-9,
            "{ghost}"
        );
        let object = guide.object.expect("the object ball moves");
        let end = object.points.last().expect("a leg has points");
        assert!((end.x - 0.7).abs() < 1e-9 && end.z.abs() < 1e-12, "{end}");
    }

    #[test]
    fn a_cut_sends_the_object_ball_along_the_line_of_centres_without_friction() {
        let mut scene = scene(Laws::ideal());
        let object = scene.place("1", Ball::POOL, 0.3, 0.03);
        let guide = first_contact(&scene, 0, &Shot::default(), 0.2).expect("a fine shot");
        let line = scene.balls[object].state.position - guide.first.end.position;
        let leg = guide.object.expect("the object ball moves");
        let way = leg.points[1] - leg.points[0];
        assert!(way.cross(line).length() < 1e-12, "{way} {line}");
        let onward = guide.onward.expect("a cut leaves the cue ball its tangent");
        let tangent = onward.points[1] - onward.points[0];
        assert!(tangent.dot(line).abs() < 1e-12, "{tangent} {line}");
    }

    #[test]
    fn right_english_squirts_the_line_to_the_left() {
        let shot = Shot {
            side: 0.4,
            ..Shot::default()
        };
        let guide = first_contact(&scene(Laws::default()), 0, &shot, 0.2).expect("a fine shot");
        assert!(guide.squirt > 0.0);
        // Left of +x is −z.
        let way = guide.first.points[1] - guide.first.points[0];
        assert!(
            (Shot::heading_between(DVec3::ZERO, way) - guide.squirt).abs() < 1e-9,
            "{way}"
        );
    }

    #[test]
    fn an_elevated_shot_with_english_bends() {
        let shot = Shot {
            side: 0.4,
            elevation: 0.6,
            speed: 1.5,
            ..Shot::default()
        };
        let guide = first_contact(&scene(Laws::default()), 0, &shot, 0.2).expect("a fine shot");
        assert!(guide.first.points.len() > BEND_POINTS as usize);
    }

    #[test]
    fn a_ball_comes_back_from_a_cushion_and_falls_into_a_pocket() {
        let mut scene = scene(Laws::ideal());
        let shot = Shot {
            heading: 0.5 * std::f64::consts::PI,
            ..Shot::default()
        };
        let guide = first_contact(&scene, 0, &shot, 0.2).expect("a fine shot");
        assert!(matches!(guide.first.hit, Hit::Cushion(_)));
        let back = guide.onward.expect("it comes back");
        assert!((back.end.velocity.z - -guide.first.end.velocity.z).abs() < 1e-12);

        scene.balls[0].state.position.x = 0.0;
        let guide = first_contact(&scene, 0, &shot, 0.2).expect("a fine shot");
        assert!(
            matches!(guide.first.hit, Hit::Pocket(_)),
            "{:?}",
            guide.first.hit
        );
        assert_eq!(guide.onward, None);
    }

    #[test]
    fn a_pocketed_ball_has_no_guide() {
        let mut scene = scene(Laws::default());
        scene.balls[0].state.motion = crate::physics::ball::Motion::Pocketed;
        let guide = first_contact(&scene, 0, &Shot::default(), 0.2);
        assert_eq!(guide, Err(GuideError::NotOnTable(0)));
        let nobody = first_contact(&scene, 7, &Shot::default(), 0.2);
        assert_eq!(nobody, Err(GuideError::NotOnTable(7)));
    }
}
