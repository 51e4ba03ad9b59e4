//! A captured ball falls into its pocket. The simulation is done with it; this is only to be seen.

use bevy::math::DVec3;

/// The fall of one ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fall {
    /// Centre of the ball, m.
    pub position: DVec3,
    velocity: DVec3,
    center: DVec3,
    room: f64,
    gravity: f64,
}

/// Depth below the slate at which a fallen ball is out of sight, m.
const BOTTOM: f64 = -0.15;

impl Fall {
    /// A ball at `start` with this velocity over a hole around `center`, whose wall lets its centre `room` m away, under
    /// this gravity in m/s².
    pub fn new(start: DVec3, center: DVec3, room: f64, velocity: DVec3, gravity: f64) -> Self {
        let to_center = (center - start).with_y(0.0).normalize_or_zero();
        Self {
            position: start,
            // Even a ball that creeps over the edge tips inwards.
            velocity: (velocity + 0.25 * to_center)
                .with_y(0.0)
                .clamp_length_max(2.5),
            center,
            room: room.max(0.005),
            gravity,
        }
    }

    /// Falls on for this many seconds; the far wall takes most of the speed.
    pub fn advance(&mut self, time: f64) {
        if self.is_over() {
            return;
        }
        self.velocity.y -= self.gravity * time;
        self.position += self.velocity * time;
        let offset = (self.position - self.center).with_y(0.0);
        let out = offset.normalize_or_zero();
        let outwards = self.velocity.dot(out);
        if offset.length() > self.room && outwards > 0.0 {
            self.velocity -= 1.3 * outwards * out;
        }
    }

    /// Whether the ball is out of sight.
    pub fn is_over(&self) -> bool {
        self.position.y < BOTTOM
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ball_falls_out_of_sight_within_the_hole() {
        let start = DVec3::new(-0.06, 0.0286, 0.0);
        let mut fall = Fall::new(start, DVec3::ZERO, 0.034, DVec3::new(2.0, 0.0, 0.3), 9.81);
        for _ in 0..120 {
            fall.advance(1.0 / 120.0);
            assert!(fall.position.x < 0.06, "{fall:?}");
        }
        assert!(fall.is_over());
    }
}
