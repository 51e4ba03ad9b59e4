//! A path as the search for contacts needs it.

use glam::DVec3;

use crate::physics::ball::Ball;
use crate::physics::contact::Track;
use crate::physics::record::PathPiece;

/// What the search for contacts needs of a ball, packed.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Flight {
    pub(super) track: Track,
    pub(super) since: f64,
    pub(super) until: f64,
    pub(super) radius: f64,
    pub(super) moves: bool,
    pub(super) in_play: bool,
}

impl Flight {
    pub(super) fn new(body: &Ball, path: &PathPiece) -> Self {
        let start = &path.piece.start;
        Self {
            track: Track {
                position: start.position,
                velocity: start.velocity,
                acceleration: path.piece.acceleration,
            },
            since: path.time,
            until: path.time + path.piece.duration,
            radius: body.radius,
            moves: start.motion.translates(),
            in_play: start.motion.in_play(),
        }
    }

    /// Where it is now.
    #[inline]
    pub(super) fn place(&self, now: f64) -> DVec3 {
        let age = now - self.since;
        let Track {
            position,
            velocity,
            acceleration,
        } = self.track;
        position + age * (velocity + (0.5 * age) * acceleration)
    }

    /// The path seen from now: the same numbers as [`Track::of`] the piece.
    #[inline]
    pub(super) fn seen(&self, now: f64) -> Track {
        if !self.moves {
            return self.track;
        }
        let age = now - self.since;
        let Track {
            position,
            velocity,
            acceleration,
        } = self.track;
        Track {
            position: position + age * (velocity + (0.5 * age) * acceleration),
            velocity: velocity + age * acceleration,
            acceleration,
        }
    }
}
