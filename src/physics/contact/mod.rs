//! When two things on the table will touch: the one place where both solvers, the aim line and the tests ask.
//!
//! Every function takes paths whose local time 0 is *now* and answers with the smallest time at or after now, and not
//! after `horizon`, at which the two touch **while they approach**. A pair that already touches or overlaps and
//! approaches meets now (0); one that separates is not met. `reach` is the distance of the centres at contact.
//! Nothing is ever lost silently: numbers that are not finite are an error that carries them.

pub mod flight;

use glam::{DVec2, DVec3};

use crate::physics::laws::motion::Piece;
use crate::physics::roots::{self, RootError};
use crate::physics::table::{Arc, Cushion, Line, Pocket};

/// A path with constant acceleration seen from now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Track {
    /// Position now, m.
    pub position: DVec3,
    /// Velocity now, m/s.
    pub velocity: DVec3,
    /// Acceleration, m/s².
    pub acceleration: DVec3,
}

impl Track {
    /// The rest of a piece of path, `age` seconds after its start.
    #[must_use]
    pub fn of(piece: &Piece, age: f64) -> Self {
        Self {
            position: piece.position(age),
            velocity: piece.velocity(age),
            acceleration: piece.acceleration,
        }
    }

    /// Where it is after this time.
    #[must_use]
    pub fn at(&self, time: f64) -> DVec3 {
        self.position + time * (self.velocity + (0.5 * time) * self.acceleration)
    }

    /// How deep in m two balls overlap after this time, and how fast in m/s it grows.
    #[must_use]
    pub fn overlap(&self, other: &Self, reach: f64, time: f64) -> (f64, f64) {
        let offset = other.at(time) - self.at(time);
        let distance = offset.length();
        let speed = self.speed(time) - other.speed(time);
        (reach - distance, speed.dot(offset) / distance)
    }

    /// How deep in m a ball on the slate overlaps a cushion after this time, and how fast in m/s it grows.
    #[must_use]
    pub fn overlap_of(&self, cushion: &Cushion, reach: f64, time: f64) -> (f64, f64) {
        let (distance, away) = cushion.nearest(Self::plan(self.at(time)));
        let speed = Self::plan(self.speed(time));
        (reach - distance, -speed.dot(away))
    }

    fn speed(&self, time: f64) -> DVec3 {
        self.velocity + time * self.acceleration
    }

    fn plan(vector: DVec3) -> DVec2 {
        DVec2::new(vector.x, vector.z)
    }
}

/// When two balls meet whose radii add up to `reach`. On the slate the centres of balls of different size differ in
/// height, and so they meet at a distance 2 √(R₁ R₂) in plan: the distance of the centres is always taken in space.
///
/// # Errors
/// [`RootError`] if a number is not finite.
#[inline]
pub fn pair(
    first: &Track,
    second: &Track,
    reach: f64,
    horizon: f64,
) -> Result<Option<f64>, RootError> {
    let offset = second.position - first.position;
    let velocity = second.velocity - first.velocity;
    let half = 0.5 * (second.acceleration - first.acceleration);
    let gap = offset.length_squared() - reach * reach;
    let slope = 2.0 * offset.dot(velocity);
    let square = velocity.length_squared();
    if half == DVec3::ZERO {
        // Straight lines: most pairs open, or pass each other.
        if gap > 0.0 && slope >= 0.0 && (gap + slope + square).is_finite() {
            return Ok(None);
        }
        return roots::quadratic::first_closing([gap, slope, square], 0.0, horizon);
    }
    circle(
        [
            gap,
            slope,
            square + 2.0 * offset.dot(half),
            2.0 * velocity.dot(half),
            half.length_squared(),
        ],
        horizon,
    )
}

/// When a ball that touches at this distance in plan meets the straight part of a nose, from either side. A nose has no end caps: give it
/// arcs of radius 0 if its ends can be met.
///
/// # Errors
/// [`RootError`] if a number is not finite.
pub fn line(
    track: &Track,
    line: &Line,
    reach: f64,
    horizon: f64,
) -> Result<Option<f64>, RootError> {
    let along = line.to - line.from;
    let length = along.length();
    let along = along / length;
    let (p, v, half) = (
        Track::plan(track.position) - line.from,
        Track::plan(track.velocity),
        0.5 * Track::plan(track.acceleration),
    );
    let (normal, distance) = line.side_of(p);
    let (speed, bend) = (v.dot(normal), half.dot(normal));
    if speed >= 0.0 && bend >= 0.0 && (speed + bend).is_finite() {
        return Ok(None);
    }
    let meets = |time: f64| {
        let foot = p.dot(along) + time * (v.dot(along) + time * half.dot(along));
        (0.0..=length).contains(&foot)
    };
    // Each side is fallen upon once at most, because the distance is a parabola in time.
    let near = roots::quadratic::first_closing([distance - reach, speed, bend], 0.0, horizon)?;
    if let Some(time) = near.filter(|time| meets(*time)) {
        return Ok(Some(time));
    }
    // A path may pass beyond the end of the nose, turn behind it, and come back from there.
    if bend > 0.0 && speed * speed > 4.0 * bend * (distance + reach) {
        let far =
            roots::quadratic::first_closing([-distance - reach, -speed, -bend], 0.0, horizon)?;
        return Ok(far.filter(|time| meets(*time)));
    }
    Ok(None)
}

/// When a ball that touches at this distance in plan meets a round nose from outside.
///
/// # Errors
/// [`RootError`] if a number is not finite.
pub fn arc(track: &Track, arc: &Arc, reach: f64, horizon: f64) -> Result<Option<f64>, RootError> {
    circle(plan_circle(track, arc.center, reach + arc.radius), horizon)
}

/// When the centre of a ball passes the edge of a hole inwards.
///
/// # Errors
/// [`RootError`] if a number is not finite.
pub fn pocket(track: &Track, pocket: &Pocket, horizon: f64) -> Result<Option<f64>, RootError> {
    circle(plan_circle(track, pocket.center, pocket.radius), horizon)
}

/// Coefficients, constant first, of |p(t) − c|² − reach² in plan.
fn plan_circle(track: &Track, center: DVec2, reach: f64) -> [f64; 5] {
    let p = Track::plan(track.position) - center;
    let v = Track::plan(track.velocity);
    let half = 0.5 * Track::plan(track.acceleration);
    [
        p.length_squared() - reach * reach,
        2.0 * p.dot(v),
        v.length_squared() + 2.0 * p.dot(half),
        2.0 * v.dot(half),
        half.length_squared(),
    ]
}

fn circle(coefficients: [f64; 5], horizon: f64) -> Result<Option<f64>, RootError> {
    roots::quartic::first_closing(coefficients, 0.0, horizon)
}
