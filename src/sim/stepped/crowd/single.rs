//! A ball without spin on a table without cloth, in single precision.
//!
//! Place and velocity are kept, moved and changed at contacts in f32; only the time of a contact is found in f64, from
//! these. A place is off by up to 6e-8 of the table and grows by that at each contact, and so is a velocity: no contact is
//! missed, because each is looked for on the paths as they are kept, but where balls are is soon another story, and energy
//! is only kept but for the rounding of all contacts. `masse report` measures both, and what it saves.

use glam::{DVec2, DVec3, Vec2};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::motion::MotionLaw;
use crate::sim::stepped::crowd::body::{Body, plan};
use crate::sim::stepped::crowd::census::Sums;

/// 16 bytes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Single {
    /// Where it would have been when the clock began, m.
    origin: Vec2,
    /// m/s.
    velocity: Vec2,
}

impl Single {
    #[inline]
    fn place(&self, at: f64) -> Vec2 {
        self.origin + at as f32 * self.velocity
    }
}

impl Body for Single {
    const BENDS: bool = false;

    #[inline]
    fn start(_: &MotionLaw, _: &Ball, state: &State, at: f64) -> Self {
        let velocity = plan(state.velocity).as_vec2();
        Self {
            origin: plan(state.position).as_vec2() - at as f32 * velocity,
            velocity,
        }
    }

    #[inline]
    fn touch(&self) -> u64 {
        u64::from(self.origin.x.to_bits())
    }

    #[inline]
    fn position(&self, at: f64) -> DVec2 {
        self.place(at).as_dvec2()
    }

    #[inline]
    fn velocity(&self, _: f64) -> DVec2 {
        self.velocity.as_dvec2()
    }

    #[inline]
    fn state(&self, ball: &Ball, at: f64) -> State {
        let (place, velocity) = (self.position(at), self.velocity(at));
        let state = State {
            velocity: DVec3::new(velocity.x, 0.0, velocity.y),
            ..State::at_rest(DVec3::new(place.x, ball.radius, place.y))
        };
        MotionLaw::Frictionless.classify(ball, state)
    }

    #[inline]
    fn count(&self, _: &MotionLaw, ball: &Ball, _: f64, sums: &mut Sums) {
        sums.count_gliding(ball, self.velocity.as_dvec2());
    }

    #[inline]
    fn rebased(&self, _: &Ball, at: f64) -> Self {
        Self {
            origin: self.place(at),
            velocity: self.velocity,
        }
    }

    #[inline]
    fn collide([one, other]: [&Self; 2], at: f64, restitution: f64) -> Option<[Self; 2]> {
        let offset = other.place(at) - one.place(at);
        let closing = (one.velocity - other.velocity).dot(offset);
        // As in double precision: half of what the pair loses along the line of centres, for each of two equal masses.
        let share = 0.5 * (1.0 + restitution as f32) * closing / offset.length_squared();
        let turn = |body: &Self, change: Vec2| Self {
            origin: body.origin - at as f32 * change,
            velocity: body.velocity + change,
        };
        Some([turn(one, -share * offset), turn(other, share * offset)])
    }

    #[inline]
    fn translates(&self) -> bool {
        self.velocity != Vec2::ZERO
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sim::stepped::crowd::body::Gliding;

    /// Half of a cache line holds two of them, and one in double precision.
    #[test]
    fn it_is_half_as_large() {
        assert_eq!(2 * size_of::<Single>(), size_of::<Gliding>());
    }
}
