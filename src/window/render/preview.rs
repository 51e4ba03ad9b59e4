//! The paths of the shot that is being aimed, and where every ball will stop.

use bevy::prelude::*;

use crate::game::aim::Aim;
use crate::game::preview::Cached;
use crate::game::replay::Replay;
use crate::game::view::View;
use crate::physics::ball::Motion;
use crate::physics::record::Record;
use crate::sim::clock::Clock;
use crate::sim::playfield::{BallQuery, Playfield, snapshot};
use crate::window::render::Drawing;
use crate::window::render::lines::{Strokes, colour, strip};

/// Length in s of the chords that stand for a sliding curve.
const CHORD: f64 = 0.02;
/// Height of the lines above the cloth, m.
const HEIGHT: f32 = 0.0015;

pub(super) fn plugin(app: &mut App) {
    // Gizmos belong to the schedule they are drawn in; those of the fixed loop would not be seen every frame.
    app.add_systems(Update, draw.in_set(Drawing::Preview));
}

/// Draws the preview of the present aim while nothing moves.
#[expect(
    clippy::too_many_arguments,
    reason = "everything the preview depends on"
)]
fn draw(
    mut lines: Gizmos<Strokes>,
    mut cached: Local<Cached>,
    view: Res<View>,
    aim: Res<Aim>,
    clock: Res<Clock>,
    replay: Res<Replay>,
    playfield: Res<Playfield>,
    balls: BallQuery,
) {
    if !view.preview || clock.moving || replay.is_active() || balls.is_empty() {
        return;
    }
    if playfield.solver.is_crowd() {
        return;
    }
    let table = snapshot(&playfield, &balls);
    if aim.ball >= table.balls.len() {
        return;
    }
    let radii: Vec<f32> = table
        .balls
        .iter()
        .map(|ball| ball.ball.radius as f32)
        .collect();
    let Some(record) = cached.of(table, aim.ball, &aim.shot) else {
        return;
    };
    for (ball, radius) in radii.into_iter().enumerate() {
        path(&mut lines, record, ball, radius);
    }
}

/// Draws one path, and a ring where the ball stops.
fn path(lines: &mut Gizmos<Strokes>, record: &Record, ball: usize, radius: f32) {
    let pieces = &record.paths[ball];
    let moves = pieces.iter().any(|p| p.piece.start.motion.translates());
    if !moves {
        return;
    }
    let mut points = Vec::new();
    for (i, piece) in pieces.iter().enumerate() {
        let motion = piece.piece.start.motion;
        if !motion.in_play() {
            break;
        }
        let until = pieces.get(i + 1).map_or(record.end_time, |next| next.time);
        let length = (until - piece.time).max(0.0);
        // Slides and flights bend; everything else is a straight line.
        let chords = if motion == Motion::Sliding || motion.flies() {
            (length / CHORD).ceil().clamp(1.0, 64.0) as u32
        } else {
            1
        };
        for chord in 0..=chords {
            let time = length * f64::from(chord) / f64::from(chords);
            let at = lowest(piece.piece.position(time).as_vec3(), radius);
            points.push((at, faint(colour(motion))));
        }
    }
    strip(lines, points);
    let end = &record.end[ball];
    if end.motion.in_play() {
        let at = end.position.as_vec3().with_y(HEIGHT);
        let flat = Quat::from_rotation_x(std::f32::consts::FRAC_PI_2);
        lines.circle(
            Isometry3d::new(at, flat),
            radius,
            faint(LinearRgba::new(0.9, 0.9, 0.9, 0.9)),
        );
    }
}

/// The lowest point of a ball, just above the cloth: a flight is drawn as high as it goes.
fn lowest(center: Vec3, radius: f32) -> Vec3 {
    center.with_y(HEIGHT + (center.y - radius).max(0.0))
}

/// What is only planned is fainter than what has happened.
fn faint(colour: LinearRgba) -> LinearRgba {
    LinearRgba {
        alpha: 0.45 * colour.alpha,
        ..colour
    }
}
