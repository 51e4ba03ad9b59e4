//! Points spread over the unit cube, and normal numbers.

use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The numbers of one task of a search: the same for the same seed, round and task.
pub(in crate::scenarios) fn numbers(seed: u64, round: u64, task: u64) -> ChaCha8Rng {
    let mut rng = ChaCha8Rng::seed_from_u64(seed ^ round.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    rng.set_stream(task);
    rng
}

/// Points of which no two share a slice of any side (`McKay`, Beckman & Conover, Technometrics 21 (1979) 239).
pub(super) fn latin(rng: &mut ChaCha8Rng, count: usize, sides: usize) -> Vec<Vec<f64>> {
    let mut points = vec![vec![0.0; sides]; count];
    let mut slices: Vec<usize> = (0..count).collect();
    for side in 0..sides {
        slices.shuffle(rng);
        for (point, slice) in points.iter_mut().zip(&slices) {
            point[side] = (*slice as f64 + rng.random::<f64>()) / count as f64;
        }
    }
    points
}

/// A number from the standard normal distribution (Box & Muller 1958).
pub(in crate::scenarios) fn normal(rng: &mut ChaCha8Rng) -> f64 {
    let radius = (-2.0 * libm::log(1.0 - rng.random::<f64>())).sqrt();
    radius * libm::cos(std::f64::consts::TAU * rng.random::<f64>())
}

/// A number brought back into the unit interval as by mirrors at its ends.
pub(super) fn mirrored(value: f64) -> f64 {
    let value = value.rem_euclid(2.0);
    if value > 1.0 { 2.0 - value } else { value }
}
