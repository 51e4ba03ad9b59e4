//! One ball of a crowd, packed: only what its law of motion needs.

use glam::{DVec2, DVec3};

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::laws::motion::{MotionLaw, Piece};

/// A ball on a closed-form piece of path. All balls of a crowd are equal, so their constants are kept once.
pub(super) trait Body: Copy + PartialEq + Send + Sync + 'static {
    /// Whether paths can bend and the kind of motion can change.
    const BENDS: bool;

    /// A ball that starts in this state.
    fn start(law: &MotionLaw, ball: &Ball, state: &State) -> Self;

    /// The centre in plan after `age` seconds, m.
    fn position(&self, age: f64) -> DVec2;

    /// Velocity in plan after `age` seconds, m/s.
    fn velocity(&self, age: f64) -> DVec2;

    /// Acceleration in plan, m/s².
    fn acceleration(&self) -> DVec2;

    /// Seconds until the kind of motion changes.
    fn left(&self) -> f64;

    /// The whole state after `age` seconds.
    fn state(&self, ball: &Ball, age: f64) -> State;

    /// The state in which the piece ends.
    fn end(&self, ball: &Ball) -> State;

    /// The same ball on the same piece, `age` seconds further.
    fn moved(&self, ball: &Ball, age: f64) -> Self;

    /// Whether the centre moves.
    fn translates(&self) -> bool;

    /// Whether nothing at all moves.
    fn is_still(&self) -> bool;

    /// Kinetic energy of translation and rotation, J.
    fn energy(&self, ball: &Ball) -> f64;
}

/// A ball without spin on a table without cloth: 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Gliding {
    position: DVec2,
    velocity: DVec2,
}

fn plan(vector: DVec3) -> DVec2 {
    DVec2::new(vector.x, vector.z)
}

fn space(vector: DVec2, height: f64) -> DVec3 {
    DVec3::new(vector.x, height, vector.y)
}

impl Body for Gliding {
    const BENDS: bool = false;

    #[inline]
    fn start(_: &MotionLaw, _: &Ball, state: &State) -> Self {
        Self {
            position: plan(state.position),
            velocity: plan(state.velocity),
        }
    }

    #[inline]
    fn position(&self, age: f64) -> DVec2 {
        self.position + age * self.velocity
    }

    #[inline]
    fn velocity(&self, _: f64) -> DVec2 {
        self.velocity
    }

    #[inline]
    fn acceleration(&self) -> DVec2 {
        DVec2::ZERO
    }

    #[inline]
    fn left(&self) -> f64 {
        f64::INFINITY
    }

    #[inline]
    fn state(&self, ball: &Ball, age: f64) -> State {
        State {
            position: space(self.position(age), ball.radius),
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
    fn end(&self, ball: &Ball) -> State {
        self.state(ball, 0.0)
    }

    #[inline]
    fn moved(&self, _: &Ball, age: f64) -> Self {
        Self {
            position: self.position(age),
            velocity: self.velocity,
        }
    }

    #[inline]
    fn translates(&self) -> bool {
        self.velocity != DVec2::ZERO
    }

    #[inline]
    fn is_still(&self) -> bool {
        !self.translates()
    }

    #[inline]
    fn energy(&self, ball: &Ball) -> f64 {
        0.5 * ball.mass * self.velocity.length_squared()
    }
}

/// A ball that spins or rubs on cloth. The piece of path is kept from tick to tick: roots and divisions are paid once
/// a piece, not once a tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rubbed {
    position: DVec2,
    velocity: DVec2,
    acceleration: DVec2,
    spin: DVec3,
    /// Rate of change of the horizontal spin.
    twist: DVec2,
    spin_deceleration: f64,
    left: f64,
    motion: Motion,
    next: Motion,
}

impl Rubbed {
    fn piece(&self, ball: &Ball) -> Piece {
        Piece {
            start: State {
                position: space(self.position, ball.radius),
                velocity: space(self.velocity, 0.0),
                angular_velocity: self.spin,
                motion: self.motion,
            },
            acceleration: space(self.acceleration, 0.0),
            angular_acceleration: space(self.twist, 0.0),
            spin_deceleration: self.spin_deceleration,
            duration: self.left,
            next: self.next,
        }
    }
}

impl Body for Rubbed {
    const BENDS: bool = true;

    #[inline]
    fn start(law: &MotionLaw, ball: &Ball, state: &State) -> Self {
        let piece = law.piece(ball, state);
        Self {
            position: plan(state.position),
            velocity: plan(state.velocity),
            acceleration: plan(piece.acceleration),
            spin: state.angular_velocity,
            twist: plan(piece.angular_acceleration),
            spin_deceleration: piece.spin_deceleration,
            left: piece.duration,
            motion: state.motion,
            next: piece.next,
        }
    }

    #[inline]
    fn position(&self, age: f64) -> DVec2 {
        self.position + age * (self.velocity + (0.5 * age) * self.acceleration)
    }

    #[inline]
    fn velocity(&self, age: f64) -> DVec2 {
        self.velocity + age * self.acceleration
    }

    #[inline]
    fn acceleration(&self) -> DVec2 {
        self.acceleration
    }

    #[inline]
    fn left(&self) -> f64 {
        self.left
    }

    #[inline]
    fn state(&self, ball: &Ball, age: f64) -> State {
        self.piece(ball).at(age)
    }

    #[inline]
    fn end(&self, ball: &Ball) -> State {
        self.piece(ball).end(ball)
    }

    #[inline]
    fn moved(&self, ball: &Ball, age: f64) -> Self {
        Self {
            position: self.position(age),
            velocity: self.velocity(age),
            spin: self.piece(ball).angular_velocity(age),
            left: self.left - age,
            ..*self
        }
    }

    #[inline]
    fn translates(&self) -> bool {
        self.motion.translates()
    }

    #[inline]
    fn is_still(&self) -> bool {
        matches!(self.motion, Motion::Rest | Motion::Pocketed)
    }

    #[inline]
    fn energy(&self, ball: &Ball) -> f64 {
        0.5 * ball.mass * self.velocity.length_squared()
            + 0.5 * ball.inertia() * self.spin.length_squared()
    }
}
