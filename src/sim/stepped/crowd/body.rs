//! One ball of a crowd, packed: only what its law of motion needs.
//!
//! A body is a closed-form piece of path on the clock of the crowd. A ball that meets nothing is not written at all from
//! tick to tick.

use glam::{DVec2, DVec3};

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::contact::Track;
use crate::physics::laws::motion::MotionLaw;
use crate::sim::stepped::crowd::census::Sums;

/// A ball on a closed-form piece of path. All balls of a crowd are equal, so their constants are kept once. Times are
/// seconds on the clock of the crowd.
pub(super) trait Body: Copy + Send + Sync + 'static {
    /// Whether paths can bend and the kind of motion can change.
    const BENDS: bool;

    /// A ball that is in this state at time `at`.
    fn start(law: &MotionLaw, ball: &Ball, state: &State, at: f64) -> Self;

    /// Bits of numbers on all lines of the cache that the body lies on: whoever wants them has them brought there.
    fn touch(&self) -> u64;

    /// The centre in plan, m.
    fn position(&self, at: f64) -> DVec2;

    /// Velocity in plan, m/s.
    fn velocity(&self, at: f64) -> DVec2;

    /// Acceleration in plan, m/s².
    #[inline]
    fn acceleration(&self) -> DVec2 {
        DVec2::ZERO
    }

    /// When the piece began, where a body knows it: when it last met something, on a slope.
    fn since(&self) -> f64 {
        f64::NEG_INFINITY
    }

    /// When the kind of motion changes.
    #[inline]
    fn change(&self) -> f64 {
        f64::INFINITY
    }

    /// The whole state.
    fn state(&self, ball: &Ball, at: f64) -> State;

    /// Counts the ball among those that are summed up.
    #[inline]
    fn count(&self, law: &MotionLaw, ball: &Ball, at: f64, sums: &mut Sums) {
        sums.count(law, ball, &self.state(ball, at));
    }

    /// The state in which the piece ends.
    #[inline]
    fn end(&self, ball: &Ball) -> State {
        self.state(ball, 0.0)
    }

    /// The same ball on the same piece, on a clock that began at `at`.
    fn rebased(&self, ball: &Ball, at: f64) -> Self;

    /// Two smooth balls after they met, if that can be told without their whole states: the law
    /// [`Frictionless`](crate::physics::laws::ball_ball::Frictionless) for equal balls. A test holds that they agree.
    fn collide(_: [&Self; 2], _at: f64, _restitution: f64) -> Option<[Self; 2]> {
        None
    }

    /// Whether the centre moves.
    fn translates(&self) -> bool;

    /// Whether nothing at all moves.
    #[inline]
    fn is_still(&self) -> bool {
        !self.translates()
    }
}

/// The path of a ball seen from now. The heights of equal balls are equal.
#[inline]
pub(super) fn track<B: Body>(body: &B, at: f64) -> Track {
    Track {
        position: space(body.position(at), 0.0),
        velocity: space(body.velocity(at), 0.0),
        acceleration: space(body.acceleration(), 0.0),
    }
}

pub(super) fn plan(vector: DVec3) -> DVec2 {
    DVec2::new(vector.x, vector.z)
}

pub(super) fn space(vector: DVec2, height: f64) -> DVec3 {
    DVec3::new(vector.x, height, vector.y)
}

/// A ball without spin on a table without cloth: 32 bytes.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
pub(super) struct Gliding {
    /// Where it would have been when the clock began.
    origin: DVec2,
    velocity: DVec2,
}

impl Body for Gliding {
    const BENDS: bool = false;

    #[inline]
    fn start(_: &MotionLaw, _: &Ball, state: &State, at: f64) -> Self {
        let velocity = plan(state.velocity);
        Self {
            origin: plan(state.position) - at * velocity,
            velocity,
        }
    }

    #[inline]
    fn touch(&self) -> u64 {
        self.origin.x.to_bits()
    }

    #[inline]
    fn position(&self, at: f64) -> DVec2 {
        self.origin + at * self.velocity
    }

    #[inline]
    fn velocity(&self, _: f64) -> DVec2 {
        self.velocity
    }

    #[inline]
    fn state(&self, ball: &Ball, at: f64) -> State {
        State {
            position: space(self.position(at), ball.radius),
            velocity: space(self.velocity, 0.0),
            angular_velocity: DVec3::ZERO,
            motion: if self.translates() {
                Motion::Gliding
            } else {
                Motion::Rest
            },
        }
    }

    #[inline]
    fn count(&self, _: &MotionLaw, ball: &Ball, _: f64, sums: &mut Sums) {
        sums.count_gliding(ball, self.velocity);
    }

    #[inline]
    fn rebased(&self, _: &Ball, at: f64) -> Self {
        Self {
            origin: self.position(at),
            velocity: self.velocity,
        }
    }

    #[inline]
    fn collide([one, other]: [&Self; 2], at: f64, restitution: f64) -> Option<[Self; 2]> {
        let offset = other.position(at) - one.position(at);
        let closing = (one.velocity - other.velocity).dot(offset);
        // Half of what the pair loses along the line of centres, for each of two equal masses.
        let change = (0.5 * (1.0 + restitution) * closing / offset.length_squared()) * offset;
        let turn = |body: &Self, change: DVec2| Self {
            origin: body.origin - at * change,
            velocity: body.velocity + change,
        };
        Some([turn(one, -change), turn(other, change)])
    }

    #[inline]
    fn translates(&self) -> bool {
        self.velocity != DVec2::ZERO
    }
}
