//! A path as the search for contacts needs it.

use glam::DVec3;

use crate::physics::ball::Ball;
use crate::physics::contact::Track;
use crate::physics::record::PathPiece;

/// What the search for contacts needs of a ball, packed. All that it takes to rule out two balls on straight level paths
/// is in the first of its two cache lines.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Flight {
    /// Place in plan at `since`, m.
    x: f64,
    z: f64,
    /// Velocity in plan at `since`, m/s.
    x_speed: f64,
    z_speed: f64,
    pub(super) since: f64,
    pub(super) until: f64,
    pub(super) radius: f64,
    /// Without acceleration, on the slate: its height is its radius.
    pub(super) level: bool,
    pub(super) moves: bool,
    pub(super) in_play: bool,
    height: f64,
    climb: f64,
    acceleration: DVec3,
}

/// A straight level path seen from now.
#[derive(Clone, Copy, Debug)]
pub(super) struct Glide {
    x: f64,
    z: f64,
    x_speed: f64,
    z_speed: f64,
    radius: f64,
}

impl Flight {
    pub(super) fn new(body: &Ball, path: &PathPiece) -> Self {
        let start = &path.piece.start;
        let level = path.piece.acceleration == DVec3::ZERO
            && start.position.y == body.radius
            && start.velocity.y == 0.0;
        Self {
            x: start.position.x,
            z: start.position.z,
            x_speed: start.velocity.x,
            z_speed: start.velocity.z,
            since: path.time,
            until: path.time + path.piece.duration,
            radius: body.radius,
            level: level && start.motion.in_play(),
            moves: start.motion.translates(),
            in_play: start.motion.in_play(),
            height: start.position.y,
            climb: start.velocity.y,
            acceleration: path.piece.acceleration,
        }
    }

    fn track(&self) -> Track {
        Track {
            position: DVec3::new(self.x, self.height, self.z),
            velocity: DVec3::new(self.x_speed, self.climb, self.z_speed),
            acceleration: self.acceleration,
        }
    }

    /// Where it is now.
    #[inline]
    pub(super) fn place(&self, now: f64) -> DVec3 {
        let age = now - self.since;
        if self.level {
            return DVec3::new(
                self.x + age * self.x_speed,
                self.radius,
                self.z + age * self.z_speed,
            );
        }
        let Track {
            position,
            velocity,
            acceleration,
        } = self.track();
        position + age * (velocity + (0.5 * age) * acceleration)
    }

    /// The path seen from now: the same numbers as [`Track::of`] the piece.
    #[inline]
    pub(super) fn seen(&self, now: f64) -> Track {
        let track = self.track();
        if !self.moves {
            return track;
        }
        let age = now - self.since;
        let Track {
            position,
            velocity,
            acceleration,
        } = track;
        Track {
            position: position + age * (velocity + (0.5 * age) * acceleration),
            velocity: velocity + age * acceleration,
            acceleration,
        }
    }

    /// The same of a level path.
    #[inline]
    pub(super) fn glide(&self, now: f64) -> Glide {
        let age = now - self.since;
        Glide {
            x: self.x + age * self.x_speed,
            z: self.z + age * self.z_speed,
            x_speed: self.x_speed,
            z_speed: self.z_speed,
            radius: self.radius,
        }
    }
}

impl Glide {
    /// The distance of two as a polynomial in time: the square of the gap, constant first. The same numbers as
    /// [`contact::pair`](crate::physics::contact::pair) finds.
    #[inline]
    pub(super) fn gap(&self, other: &Self) -> [f64; 3] {
        let (x, y, z) = (
            other.x - self.x,
            other.radius - self.radius,
            other.z - self.z,
        );
        let (x_speed, z_speed) = (other.x_speed - self.x_speed, other.z_speed - self.z_speed);
        let reach = self.radius + other.radius;
        [
            x * x + y * y + z * z - reach * reach,
            2.0 * (x * x_speed + z * z_speed),
            x_speed * x_speed + z_speed * z_speed,
        ]
    }
}
