//! When a ball in flight meets the table: slate, noses in profile, rim and liner of a pocket.

use glam::{DVec2, DVec3};

use crate::physics::contact::{Track, circle, plan_circle};
use crate::physics::roots::{RootError, quadratic};
use crate::physics::table::{Cushion, Nose, Pocket, Table};

/// Two that are nearer than this in m touch.
const NEAR: f64 = 1e-13;

/// Steps of a search before it counts as failed.
const LIMIT: usize = 200_000;

/// Least closing speed in m/s at the rim of a pocket.
const CLOSING: f64 = 1e-3;

/// Least step in s of the search for the rim of a pocket.
const STEP: f64 = 4e-6;

/// When the centre comes down to this height in m.
///
/// # Errors
/// [`RootError`] if a number is not finite.
pub fn fall(track: &Track, height: f64, horizon: f64) -> Result<Option<f64>, RootError> {
    let gap = track.position.y - height;
    quadratic::first_closing(
        [gap, track.velocity.y, 0.5 * track.acceleration.y],
        0.0,
        horizon,
    )
}

/// When a ball of this radius meets a nose at this height, at whatever height the ball flies; the ends of lines count.
///
/// The distance f to a round nose, which is convex, falls no faster than f + f' s − |a| s²/2 from now on; so the time at
/// which that is 0 is never beyond a contact. The search goes from such time to time, and ends quadratically near a
/// contact, with an error below 1e-13 m.
///
/// # Errors
/// [`RootError`] if a number is not finite or the search does not end.
pub fn nose(
    track: &Track,
    (cushion, nose, height): (&Cushion, &Nose, f64),
    radius: f64,
    horizon: f64,
) -> Result<Option<f64>, RootError> {
    let Nose::Round { radius: rounding } = *nose else {
        return match cushion {
            Cushion::Line(line) => super::line(track, line, radius, horizon),
            Cushion::Arc(arc) => super::arc(track, arc, radius, horizon),
        };
    };
    let gap = |time: f64| round_gap(track, (cushion, rounding, height), radius, time);
    let bend = track.acceleration.length();
    let mut time = 0.0;
    for _ in 0..LIMIT {
        let (distance, speed) = gap(time);
        if !(distance + speed).is_finite() {
            return Err(failed(track, time));
        }
        if distance <= NEAR && speed < 0.0 {
            return Ok(Some(time));
        }
        let distance = distance.max(0.0);
        let root = (speed * speed + 2.0 * bend * distance).sqrt();
        // The falling root of f + f' s − |a| s²/2.
        let step = if speed < 0.0 {
            2.0 * distance / (root - speed)
        } else if bend > 0.0 {
            (speed + root) / bend
        } else {
            return Ok(None);
        };
        time += step.max(1e-12);
        if time > horizon {
            return Ok(None);
        }
    }
    Err(failed(track, time))
}

/// How far a ball of this radius is from a rounded nose after this time, and how fast that grows.
fn round_gap(
    track: &Track,
    (cushion, rounding, height): (&Cushion, f64, f64),
    radius: f64,
    time: f64,
) -> (f64, f64) {
    let position = track.at(time);
    let velocity = track.velocity + time * track.acceleration;
    let (distance, direction) = cushion.nearest(DVec2::new(position.x, position.z));
    // The circle in profile around which the nose is rounded lies behind the nose line.
    let (out, up) = (distance + rounding, position.y - height);
    let length = (out * out + up * up).sqrt();
    let speed = out * direction.dot(DVec2::new(velocity.x, velocity.z)) + up * velocity.y;
    (length - radius - rounding, speed / length.max(1e-12))
}

/// How deep in m a ball in flight overlaps a nose at this height after this time, and how fast in m/s it grows.
#[must_use]
pub fn overlap_of_nose(
    track: &Track,
    (cushion, nose, height): (&Cushion, &Nose, f64),
    radius: f64,
    time: f64,
) -> (f64, f64) {
    match *nose {
        Nose::Wall => track.overlap_of(cushion, radius, time),
        Nose::Round { radius: rounding } => {
            let (gap, opens) = round_gap(track, (cushion, rounding, height), radius, time);
            (-gap, -opens)
        }
    }
}

/// When a falling ball of this radius meets the rounded edge of a pocket from inside. The edge is rounded with `edge` m,
/// and its flat ends at the radius of the pocket. A ball that has just passed the end of the flat touches the edge without
/// closing; if it then sinks into it, it meets it when it closes at a millimetre a second, 0.1 µm deep.
///
/// In the plane through the axis of the hole the distance f to the edge is convex, and the distance d from the axis bends
/// by L²/d³, L the moment of the velocity in plan about the axis; so f falls no faster than f + f' s − (|a| + 8 L²/d³) s²/2
/// while d is not halved. Nor can it fall faster than the ball moves. The search goes on by what is longer.
///
/// # Errors
/// [`RootError`] if a number is not finite or the search does not end.
pub fn rim(
    track: &Track,
    pocket: &Pocket,
    edge: f64,
    radius: f64,
    horizon: f64,
) -> Result<Option<f64>, RootError> {
    let plan = |v: DVec3| DVec2::new(v.x, v.z);
    let bend = track.acceleration.length();
    let moment = (plan(track.position) - pocket.center).perp_dot(plan(track.velocity));
    // Distance to the edge, its rate, distance from the axis.
    let gap = |time: f64| {
        let at = pocket.at_edge(edge, track.at(time));
        let velocity = track.velocity + time * track.acceleration;
        (at.length - radius - edge, at.speed(velocity), at.from_axis)
    };
    let mut time = 0.0;
    for _ in 0..LIMIT {
        // Below the rim there is the wall.
        if time > horizon || track.at(time).y < -edge {
            return Ok(None);
        }
        let velocity = track.velocity + time * track.acceleration;
        let (distance, speed, from_axis) = gap(time);
        if !(distance + speed).is_finite() {
            return Err(failed(track, time));
        }
        if distance <= 1e-9 && speed < -CLOSING {
            // A step may have gone a little too far; the rest of the way is shorter than rounding. But one that passes by
            // so fast that it did not close there yet would meet the edge there for ever.
            let met = (time + (distance / -speed).max(-STEP)).max(0.0);
            return Ok(Some(if gap(met).1 < 0.0 { met } else { time }));
        }
        let reach = distance.max(0.0);
        let fastest = velocity.length();
        let straight = 2.0 * reach / (fastest + (fastest * fastest + 2.0 * bend * reach).sqrt());
        let turn = bend + 8.0 * moment * moment / (from_axis * from_axis * from_axis).max(1e-12);
        let root = (speed * speed + 2.0 * turn * reach).sqrt();
        let bent = if speed < 0.0 {
            2.0 * reach / (root - speed)
        } else {
            (speed + root) / turn
        };
        let unhalved = 0.5 * from_axis / plan(velocity).length().max(1e-12);
        time += straight.max(bent.min(unhalved)).max(STEP);
    }
    Err(failed(track, time))
}

/// When a falling ball of this radius meets the wall of a hole, or above the slate its liner, from inside; see
/// [`Table::has_wall`].
///
/// # Errors
/// [`RootError`] if a number is not finite.
pub fn wall(
    track: &Track,
    (table, pocket): (&Table, &Pocket),
    edge: f64,
    radius: f64,
    horizon: f64,
) -> Result<Option<f64>, RootError> {
    // From inside the room is left when room² − d² falls through 0.
    let room = pocket.room(edge, radius);
    let inside = plan_circle(track, pocket.center, room).map(|c| -c);
    let time = circle(inside, horizon)?;
    Ok(time.filter(|time| table.has_wall(pocket, edge, radius, track.at(*time))))
}

/// How far in m a ball has left the room inside the wall of a hole after this time, and how fast in m/s that grows.
#[must_use]
pub fn overlap_of_wall(
    track: &Track,
    pocket: &Pocket,
    edge: f64,
    radius: f64,
    time: f64,
) -> (f64, f64) {
    let (position, velocity) = (track.at(time), track.velocity + time * track.acceleration);
    let offset = DVec2::new(position.x, position.z) - pocket.center;
    let out = offset.normalize_or_zero();
    let speed = out.dot(DVec2::new(velocity.x, velocity.z));
    (offset.length() - pocket.room(edge, radius), speed)
}

fn failed(track: &Track, from: f64) -> RootError {
    let (p, v) = (track.position, track.velocity);
    RootError {
        coefficients: [p.x, p.y, p.z, v.length(), track.acceleration.y],
        from,
    }
}
