//! The aim line: where the struck ball goes, what it meets first, and where both go from there.
//!
//! It asks the same laws as the solvers, so it accounts for squirt, for the bend of a sliding ball and for throw. It
//! follows one contact only; balls other than the struck one are taken to stand still. Under the coursework's motion law,
//! which has no closed form, the line is straight.

use glam::{DVec2, DVec3};
use thiserror::Error;

use crate::physics::ball::State;
use crate::physics::contact::{self, Track};
use crate::physics::cue::Shot;
use crate::physics::laws::ball_ball::PairContact;
use crate::physics::laws::cushion::CushionContact;
use crate::physics::laws::motion::Piece;
use crate::physics::roots::RootError;
use crate::physics::scene::{Scene, strike_with};
use crate::physics::table::Cushion;

/// What a ball meets at the end of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hit {
    /// Nothing: it comes to rest, or the path is cut there.
    Nothing,
    /// The ball with this index.
    Ball(usize),
    /// The cushion with this index.
    Cushion(usize),
    /// The pocket with this index.
    Pocket(usize),
}

/// The way of one ball up to its next contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Leg {
    /// Index of the ball.
    pub ball: usize,
    /// Centres along the way in m; at least one.
    pub points: Vec<DVec3>,
    /// The ball at the last point, before anything happens to it there.
    pub end: State,
    /// What it meets there.
    pub hit: Hit,
}

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

/// Points along a bent piece of path.
const BEND_POINTS: u32 = 16;

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
    let classify =
        |index: usize, state: State| scene.laws.motion.classify(&scene.balls[index].ball, state);
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
            let position = DVec2::new(leg.end.position.x, leg.end.position.z);
            let (_, normal) = scene.table.cushions[index].nearest(position);
            let contact = CushionContact {
                normal: DVec3::new(normal.x, 0.0, normal.y),
                nose_height: scene.table.nose_height,
                nose: scene.table.nose,
                restitution: None,
            };
            let rebound = scene.laws.cushion.rebound(ball, &leg.end, &contact);
            (Some(classify(leg.ball, rebound.state)), None)
        }
    }
}

/// Follows one ball from a state until it meets something, comes to rest or has gone `reach` m.
fn leg(scene: &Scene, ball: usize, mut state: State, reach: f64) -> Result<Leg, RootError> {
    let constants = &scene.balls[ball].ball;
    let mut points = vec![state.position];
    let mut left = reach;
    let mut hit = Hit::Nothing;
    while state.motion.translates() && left > 0.0 {
        let piece = scene.laws.motion.piece(constants, &state);
        let size = scene.table.length + scene.table.width;
        let across = 2.0 * size / state.velocity.length().max(1e-6);
        let horizon = piece.duration.min(across);
        let found = first_hit(scene, ball, &Track::of(&piece, 0.0), horizon)?;
        let end = found.map_or(horizon, |(time, _)| time);
        let (walked, is_cut) = walk(&piece, end, left, &mut points);
        left -= walked;
        if let (Some((time, what)), false) = (found, is_cut) {
            hit = what;
            state = piece.at(time);
            break;
        }
        if is_cut || horizon < piece.duration {
            state = piece.at(end);
            break;
        }
        state = piece.end(constants);
    }
    Ok(Leg {
        ball,
        points,
        end: state,
        hit,
    })
}

/// The first thing on a track within `horizon` seconds, and when.
fn first_hit(
    scene: &Scene,
    ball: usize,
    track: &Track,
    horizon: f64,
) -> Result<Option<(f64, Hit)>, RootError> {
    let radius = scene.balls[ball].ball.radius;
    let reach = scene.table.reach(radius);
    let mut first: Option<(f64, Hit)> = None;
    let mut note = |time: Option<f64>, hit: Hit| {
        if let Some(time) = time
            && first.is_none_or(|(earlier, _)| time < earlier)
        {
            first = Some((time, hit));
        }
    };
    for (index, other) in scene.balls.iter().enumerate() {
        if index == ball || !other.state.motion.in_play() {
            continue;
        }
        let still = Track {
            position: other.state.position,
            velocity: DVec3::ZERO,
            acceleration: DVec3::ZERO,
        };
        let reach = radius + other.ball.radius;
        note(
            contact::pair(track, &still, reach, horizon)?,
            Hit::Ball(index),
        );
    }
    for (index, cushion) in scene.table.cushions.iter().enumerate() {
        let time = match cushion {
            Cushion::Line(line) => contact::line(track, line, reach, horizon)?,
            Cushion::Arc(arc) => contact::arc(track, arc, reach, horizon)?,
        };
        note(time, Hit::Cushion(index));
    }
    for (index, pocket) in scene.table.pockets.iter().enumerate() {
        note(contact::pocket(track, pocket, horizon)?, Hit::Pocket(index));
    }
    Ok(first)
}

/// Adds the points of a piece up to `end` s or `reach` m; returns the metres walked and whether the reach cut it.
fn walk(piece: &Piece, end: f64, reach: f64, points: &mut Vec<DVec3>) -> (f64, bool) {
    let is_straight = piece
        .start
        .velocity
        .cross(piece.acceleration)
        .length_squared()
        == 0.0;
    let steps = if is_straight { 1 } else { BEND_POINTS };
    let mut walked = 0.0;
    let mut last = piece.start.position;
    for step in 1..=steps {
        let next = piece.position(end * f64::from(step) / f64::from(steps));
        let length = last.distance(next);
        if walked + length > reach {
            points.push(last + (next - last) * ((reach - walked) / length));
            return (reach, true);
        }
        walked += length;
        points.push(next);
        last = next;
    }
    (walked, false)
}

#[cfg(test)]
mod tests {
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
