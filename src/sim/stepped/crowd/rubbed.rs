//! A ball of a crowd on cloth or on a slope.

use glam::{DVec2, DVec3};

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::laws::motion::{MotionLaw, Piece};
use crate::sim::stepped::crowd::body::{Body, plan, space};

/// A ball that spins or rubs on cloth. The piece of path is kept from tick to tick: roots and divisions are paid once
/// a piece, not once a tick. What is wanted in every tick lies on one line of the cache, the rest on the next.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Rubbed {
    position: DVec2,
    velocity: DVec2,
    acceleration: DVec2,
    /// When the piece began.
    since: f64,
    change: f64,
    spin: DVec3,
    spin_deceleration: f64,
    /// Rate of change of the horizontal spin: so many times the acceleration turned by a right angle.
    twist: f64,
    motion: Motion,
    next: Motion,
}

impl Rubbed {
    fn piece(&self, ball: &Ball) -> Piece {
        let acceleration = space(self.acceleration, 0.0);
        Piece {
            start: State {
                position: space(self.position, ball.radius),
                velocity: space(self.velocity, 0.0),
                angular_velocity: self.spin,
                motion: self.motion,
            },
            acceleration,
            angular_acceleration: self.twist * DVec3::Y.cross(acceleration),
            spin_deceleration: self.spin_deceleration,
            duration: self.change - self.since,
            next: self.next,
        }
    }
}

impl Body for Rubbed {
    const BENDS: bool = true;

    #[inline]
    fn start(law: &MotionLaw, ball: &Ball, state: &State, at: f64) -> Self {
        let piece = law.piece(ball, state);
        let turned = DVec3::Y.cross(piece.acceleration);
        let square = turned.length_squared();
        Self {
            position: plan(state.position),
            velocity: plan(state.velocity),
            acceleration: plan(piece.acceleration),
            since: at,
            change: at + piece.duration,
            spin: state.angular_velocity,
            spin_deceleration: piece.spin_deceleration,
            twist: if square > 0.0 {
                piece.angular_acceleration.dot(turned) / square
            } else {
                0.0
            },
            motion: state.motion,
            next: piece.next,
        }
    }

    #[inline]
    fn touch(&self) -> u64 {
        self.change.to_bits() ^ self.spin.x.to_bits()
    }

    #[inline]
    fn position(&self, at: f64) -> DVec2 {
        let age = at - self.since;
        self.position + age * (self.velocity + (0.5 * age) * self.acceleration)
    }

    #[inline]
    fn velocity(&self, at: f64) -> DVec2 {
        self.velocity + (at - self.since) * self.acceleration
    }

    #[inline]
    fn acceleration(&self) -> DVec2 {
        self.acceleration
    }

    #[inline]
    fn since(&self) -> f64 {
        self.since
    }

    #[inline]
    fn change(&self) -> f64 {
        self.change
    }

    #[inline]
    fn state(&self, ball: &Ball, at: f64) -> State {
        self.piece(ball).at(at - self.since)
    }

    #[inline]
    fn end(&self, ball: &Ball) -> State {
        self.piece(ball).end(ball)
    }

    #[inline]
    fn rebased(&self, _: &Ball, at: f64) -> Self {
        Self {
            since: self.since - at,
            change: self.change - at,
            ..*self
        }
    }

    #[inline]
    fn translates(&self) -> bool {
        self.motion.translates()
    }

    #[inline]
    fn is_still(&self) -> bool {
        self.motion.is_still()
    }
}
