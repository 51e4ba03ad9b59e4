//! The unsteady hand: a stroke comes out near to what was planned.
//!
//! Gaussian errors of tip, cue and speed, with the standard deviations of `FastFiz`, the simulator of the Computational Pool
//! Tournaments: 0.5 mm on both offsets of the tip, 0.1° on the elevation, 0.125° on the heading, 0.075 m/s on the speed,
//! all times one factor for the skill of the hand.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::physics::ball::Ball;
use crate::physics::cue::{Cue, Shot};
use crate::physics::laws::cue_ball::squirt_angle;

/// Farthest contact in R that an error leads to: beyond it the cue would miss the ball.
const RIM: f64 = 0.95;

/// Steepest cue in rad that an error leads to.
const STEEPEST: f64 = 1.5;

/// Slowest stroke in m/s that an error leads to.
const SLOWEST: f64 = 0.02;

/// Standard deviations of a hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// Of either offset of the contact, m.
    pub tip: f64,
    /// Of the elevation, rad.
    pub elevation: f64,
    /// Of the heading, rad.
    pub heading: f64,
    /// Of the speed, m/s.
    pub speed: f64,
}

/// How far one stroke is off, in standard deviations: side, height, elevation, heading, speed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviation(pub [f64; 5]);

impl Deviation {
    /// Five independent normal numbers.
    #[must_use]
    pub fn draw(rng: &mut ChaCha8Rng) -> Self {
        let ((a, b), (c, d), (e, _)) = (normals(rng), normals(rng), normals(rng));
        Self([a, b, c, d, e])
    }
}

/// Two independent normal numbers (Box & Muller 1958).
fn normals(rng: &mut ChaCha8Rng) -> (f64, f64) {
    let length = (-2.0 * libm::log(1.0 - rng.random::<f64>())).sqrt();
    let angle = std::f64::consts::TAU * rng.random::<f64>();
    (length * libm::cos(angle), length * libm::sin(angle))
}

impl Noise {
    /// The hand of `FastFiz` times this factor; 0 never errs.
    #[must_use]
    pub fn times(factor: f64) -> Self {
        Self {
            tip: 0.000_5 * factor,
            elevation: 0.1_f64.to_radians() * factor,
            heading: 0.125_f64.to_radians() * factor,
            speed: 0.075 * factor,
        }
    }

    /// What becomes of a planned stroke at a ball of this radius in m.
    #[must_use]
    pub fn apply(&self, deviation: &Deviation, shot: &Shot, radius: f64) -> Shot {
        let [side, height, elevation, heading, speed] = deviation.0;
        let mut out = Shot {
            heading: shot.heading + self.heading * heading,
            elevation: (shot.elevation + self.elevation * elevation).clamp(0.0, STEEPEST),
            side: shot.side + self.tip / radius * side,
            height: shot.height + self.tip / radius * height,
            speed: (shot.speed + self.speed * speed).max(SLOWEST),
        };
        let offset = out.offset();
        if offset > RIM {
            out.side *= RIM / offset;
            out.height *= RIM / offset;
        }
        out
    }

    /// Standard deviation in rad of the direction in which a ball leaves the cue: heading, and squirt of the error of the
    /// tip.
    #[must_use]
    pub fn direction(&self, cue: &Cue, ball: &Ball) -> f64 {
        let squirt = squirt_angle(cue, ball, (self.tip / ball.radius).min(RIM));
        (self.heading * self.heading + squirt * squirt).sqrt()
    }
}
