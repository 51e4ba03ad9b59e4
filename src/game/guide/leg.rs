//! One leg of the guide: a ball up to what it meets next.

use glam::DVec3;

use crate::physics::airborne;
use crate::physics::ball::State;
use crate::physics::contact::{self, Track};
use crate::physics::laws::motion::Piece;
use crate::physics::roots::RootError;
use crate::physics::scene::Scene;
use crate::physics::table::Cushion;

/// Points along a bent piece of path.
pub(super) const BEND_POINTS: u32 = 16;

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

/// Follows one ball from a state until it meets something, comes to rest or has gone `reach` m.
pub(super) fn leg(
    scene: &Scene,
    ball: usize,
    mut state: State,
    reach: f64,
) -> Result<Leg, RootError> {
    let constants = &scene.balls[ball].ball;
    let mut points = vec![state.position];
    let mut left = reach;
    let mut hit = Hit::Nothing;
    while state.motion.translates() && left > 0.0 {
        let piece = scene.laws.piece(&scene.table, constants, &state);
        let size = scene.table.length + scene.table.width;
        let across = 2.0 * size / state.velocity.length().max(1e-6);
        let horizon = piece.duration.min(across);
        let track = Track::of(&piece, 0.0);
        let landing = if state.motion.flies() {
            let (table, laws) = (&scene.table, &scene.laws);
            airborne::ground(table, laws, constants.radius, &track, horizon)?
        } else {
            None
        };
        let horizon = landing.map_or(horizon, |(time, _)| time);
        let found = first_hit(scene, ball, &track, horizon)?;
        let end = found.map_or(horizon, |(time, _)| time);
        let (walked, is_cut) = walk(&piece, end, left, &mut points);
        left -= walked;
        if let (Some((time, what)), false) = (found, is_cut) {
            hit = what;
            state = piece.at(time);
            break;
        }
        state = if let (Some((time, landing)), false) = (landing, is_cut) {
            let state = piece.at(time);
            airborne::land(&scene.table, &scene.laws, constants, &state, landing).1
        } else if is_cut || horizon < piece.duration {
            state = piece.at(end);
            break;
        } else {
            scene.laws.end(&scene.table, constants, &piece)
        };
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
            _ if track.acceleration.y != 0.0 => {
                let nose = (cushion, &scene.table.nose, scene.table.nose_height);
                contact::flight::nose(track, nose, radius, horizon)?
            }
            Cushion::Line(line) => contact::line(track, line, reach, horizon)?,
            Cushion::Arc(arc) => contact::arc(track, arc, reach, horizon)?,
        };
        note(time, Hit::Cushion(index));
    }
    for (index, pocket) in scene.table.pockets.iter().enumerate() {
        // A ball in flight is caught when it has come down.
        if track.acceleration.y != 0.0 {
            break;
        }
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
