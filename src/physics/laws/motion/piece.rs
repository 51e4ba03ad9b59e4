//! One closed-form piece of a path.

use glam::DVec3;

use crate::physics::ball::{Ball, Motion, State};

/// A stretch of a path with constant acceleration, from `start` for `duration` seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// The state at local time 0.
    pub start: State,
    /// Acceleration of the centre in m/s².
    pub acceleration: DVec3,
    /// Rate of change of the horizontal part of the spin in rad/s².
    pub angular_acceleration: DVec3,
    /// Deceleration of the vertical part of the spin in rad/s²; it stops at zero spin.
    pub spin_deceleration: f64,
    /// Seconds until the kind of motion changes; infinite if it never does.
    pub duration: f64,
    /// The kind of motion that follows.
    pub next: Motion,
}

impl Piece {
    /// A piece on which nothing ever changes.
    #[must_use]
    pub fn uniform(start: State) -> Self {
        Self {
            start,
            acceleration: DVec3::ZERO,
            angular_acceleration: DVec3::ZERO,
            spin_deceleration: 0.0,
            duration: f64::INFINITY,
            next: start.motion,
        }
    }

    /// Position in m after `time` seconds.
    #[must_use]
    pub fn position(&self, time: f64) -> DVec3 {
        self.start.position + time * (self.start.velocity + (0.5 * time) * self.acceleration)
    }

    /// Velocity in m/s after `time` seconds.
    #[must_use]
    pub fn velocity(&self, time: f64) -> DVec3 {
        self.start.velocity + time * self.acceleration
    }

    /// Angular velocity in rad/s after `time` seconds.
    #[must_use]
    pub fn angular_velocity(&self, time: f64) -> DVec3 {
        let mut spin = self.start.angular_velocity + time * self.angular_acceleration;
        let vertical = self.start.angular_velocity.y;
        spin.y = (vertical.abs() - time * self.spin_deceleration)
            .max(0.0)
            .copysign(vertical);
        if spin.y == 0.0 {
            spin.y = 0.0; // no negative zero: equal states have equal bits
        }
        spin
    }

    /// The whole state after `time` seconds, which must not exceed `duration`.
    #[must_use]
    pub fn at(&self, time: f64) -> State {
        State {
            position: self.position(time),
            velocity: self.velocity(time),
            angular_velocity: self.angular_velocity(time),
            motion: self.start.motion,
        }
    }

    /// The state at the end of the piece, with the next kind of motion, freed of rounding: a ball that
    /// begins to roll rolls exactly, a ball that stops has exactly no velocity.
    #[must_use]
    pub fn end(&self, ball: &Ball) -> State {
        let mut state = self.at(self.duration);
        state.motion = self.next;
        match self.next {
            Motion::Rolling => {
                let vertical = state.angular_velocity.y;
                state.angular_velocity = ball.rolling_spin(state.velocity);
                state.angular_velocity.y = vertical;
            }
            Motion::Spinning => {
                state.velocity = DVec3::ZERO;
                state.angular_velocity = DVec3::Y * state.angular_velocity.y;
            }
            Motion::Rest => {
                state.velocity = DVec3::ZERO;
                state.angular_velocity = DVec3::ZERO;
            }
            Motion::Sliding
            | Motion::Gliding
            | Motion::Airborne
            | Motion::Tipping
            | Motion::Wedged
            | Motion::Pocketed
            | Motion::OffTable => {}
        }
        state
    }
}
