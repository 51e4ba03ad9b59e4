//! Whether the cue ball jumped over a ball (WPBSA, section 2, rule 19).
//!
//! It did if in flight any part of it passes over any part of another ball, touching it or not. It did not if it met another
//! ball before; if it met that ball in flight but did not come down on the far side of it; or if it had struck that ball
//! lawfully and went over it after a cushion or another ball.

use glam::{DVec2, DVec3};

use crate::game::rules::facts::Facts;
use crate::physics::ball::Motion;
use crate::physics::record::{EventKind, PathPiece};
use crate::physics::roots::quadratic;

/// Discs in plan that overlap by less than this in m pass each other.
const BRUSH: f64 = 1e-6;

/// The ball that the cue ball jumped over against the rules, if any.
#[must_use]
pub fn jumped_over(facts: &Facts) -> Option<usize> {
    let first = facts.first_time.unwrap_or(f64::INFINITY);
    let mut others = (0..facts.scene.balls.len())
        .filter(|&ball| ball != facts.cue && facts.scene.balls[ball].state.motion.in_play());
    others.find(|&ball| {
        let met = facts.met_by(facts.cue).find(|(_, other)| *other == ball);
        match met {
            // A ball that is not met, or met after another: what counts is whether it was passed before the first contact.
            None => passes_over(facts, ball, 0.0, first).is_some(),
            Some((time, _)) if time > first => passes_over(facts, ball, 0.0, first).is_some(),
            // The ball met first: it must not be passed on the way to nothing else.
            Some((time, _)) => lands_beyond(facts, ball, time),
        }
    })
}

/// The direction in plan in which the cue ball passes over a ball between two times.
fn passes_over(facts: &Facts, ball: usize, from: f64, until: f64) -> Option<DVec2> {
    let reach = facts.scene.balls[facts.cue].ball.radius + facts.scene.balls[ball].ball.radius;
    let path = &facts.record.paths[facts.cue];
    path.iter().enumerate().find_map(|(index, piece)| {
        let end = path
            .get(index + 1)
            .map_or(until, |next| next.time.min(until));
        if piece.piece.start.motion != Motion::Airborne || end <= from {
            return None;
        }
        let mut others = pieces_between(&facts.record.paths[ball], piece.time.max(from), end);
        others.find_map(|(begin, finish, other)| {
            over_during(piece, &other, reach - BRUSH, begin, finish)
        })
    })
}

/// The pieces of a path between two times, each with the times it is followed.
fn pieces_between(
    path: &[PathPiece],
    from: f64,
    until: f64,
) -> impl Iterator<Item = (f64, f64, PathPiece)> {
    path.iter().enumerate().filter_map(move |(index, piece)| {
        let begin = piece.time.max(from);
        let end = path
            .get(index + 1)
            .map_or(until, |next| next.time.min(until));
        (begin < end).then_some((begin, end, *piece))
    })
}

/// In flight the plan of the path is a straight line at constant speed; the ball below is at rest or rolls slowly, so its
/// path is taken as straight within a piece of flight too.
fn over_during(
    flight: &PathPiece,
    other: &PathPiece,
    reach: f64,
    begin: f64,
    end: f64,
) -> Option<DVec2> {
    let at = |time: f64| {
        let cue = flight.piece.position(time - flight.time);
        let below = other.piece.position(time - other.time);
        plan(cue - below)
    };
    let way = (at(end) - at(begin)) / (end - begin);
    let offset = at(begin);
    let gap = offset.length_squared() - reach * reach;
    if gap < 0.0 {
        return Some(way);
    }
    let coefficients = [gap, 2.0 * offset.dot(way), way.length_squared()];
    let meets = quadratic::first_closing(coefficients, 0.0, end - begin);
    meets.ok().flatten().map(|_| way)
}

/// Whether the cue ball, having met this ball first, goes over it without a cushion or another ball between: it was in
/// flight at the contact or soon after, and is beyond it when it comes down.
fn lands_beyond(facts: &Facts, ball: usize, met: f64) -> bool {
    let between = facts
        .events_of(facts.cue)
        .filter(|event| event.time > met)
        .find(|event| match event.kind {
            EventKind::Cushion { .. } | EventKind::Slate => true,
            EventKind::BallBall => !event.participants().any(|who| who.ball == ball),
            _ => false,
        });
    let Some(event) = between.filter(|event| event.kind == EventKind::Slate) else {
        return false;
    };
    let Some(before) = passes_over(facts, ball, 0.0, event.time) else {
        return false;
    };
    let come = facts.record.state_at(facts.cue, event.time).position;
    let there = facts.record.state_at(ball, met).position;
    before.dot(plan(come - there)) > 0.0
}

fn plan(vector: DVec3) -> DVec2 {
    DVec2::new(vector.x, vector.z)
}
