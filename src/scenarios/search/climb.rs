//! The (1+1)-CMA-ES: one point, one try at a time; the shape of the tries follows those that succeeded. After Igel, Suttorp &
//! Hansen, A computational efficient covariance matrix update and a (1+1)-CMA for evolution strategies, GECCO 2006, with
//! the parameters given there; the inverse of the factor is kept beside it.

use rand_chacha::ChaCha8Rng;

use crate::scenarios::search::spread::{mirrored, normal};

/// Share of successes that keeps the width of the tries.
const TARGET: f64 = 2.0 / 11.0;

/// Share of successes above which the shape is left alone: the width must grow first.
const THRESHOLD: f64 = 0.44;

/// Memory of the share of successes.
const MEMORY: f64 = 1.0 / 12.0;

/// A point that climbs down a function on the unit cube.
pub(super) struct Climber {
    pub(super) point: Vec<f64>,
    pub(super) value: f64,
    width: f64,
    success: f64,
    path: Vec<f64>,
    /// Row by row: a step is `factor` times normal numbers.
    factor: Vec<f64>,
    inverse: Vec<f64>,
}

impl Climber {
    pub(super) fn new(point: Vec<f64>, value: f64, width: f64) -> Self {
        let n = point.len();
        let mut unit = vec![0.0; n * n];
        for i in 0..n {
            unit[i * n + i] = 1.0;
        }
        Self {
            point,
            value,
            width,
            success: TARGET,
            path: vec![0.0; n],
            factor: unit.clone(),
            inverse: unit,
        }
    }

    /// Whether the tries have become too small to find anything.
    pub(super) fn stuck(&self) -> bool {
        self.width < 1e-9
    }

    /// Tries one step.
    pub(super) fn step(&mut self, rng: &mut ChaCha8Rng, mut value: impl FnMut(&[f64]) -> f64) {
        let n = self.point.len();
        let normals: Vec<f64> = (0..n).map(|_| normal(rng)).collect();
        let way = times(&self.factor, &normals);
        let tried: Vec<f64> = self
            .point
            .iter()
            .zip(&way)
            .map(|(at, way)| mirrored(at + self.width * way))
            .collect();
        let found = value(&tried);
        let succeeds = found <= self.value;
        self.success += MEMORY * (f64::from(u8::from(succeeds)) - self.success);
        let damping = 1.0 + n as f64 / 2.0;
        self.width *= libm::exp((self.success - TARGET) / (damping * (1.0 - TARGET)));
        self.width = self.width.min(0.5);
        if succeeds {
            self.point = tried;
            self.value = found;
            self.learn(&way);
        }
    }

    /// Stretches the shape of the tries along a way that succeeded.
    fn learn(&mut self, way: &[f64]) {
        let n = self.point.len() as f64;
        let fading = 2.0 / (n + 2.0);
        let learning = 2.0 / (n * n + 6.0);
        let fresh = self.success < THRESHOLD;
        for (path, way) in self.path.iter_mut().zip(way) {
            *path *= 1.0 - fading;
            if fresh {
                *path += (fading * (2.0 - fading)).sqrt() * way;
            }
        }
        let keep = if fresh {
            1.0 - learning
        } else {
            1.0 - learning + learning * fading * (2.0 - fading)
        };
        let along = times(&self.inverse, &self.path);
        let size: f64 = along.iter().map(|a| a * a).sum();
        if size < 1e-30 {
            return;
        }
        let a = keep.sqrt();
        let b = a / size * ((1.0 + learning / keep * size).sqrt() - 1.0);
        let n = self.path.len();
        let mut row = vec![0.0; n]; // alongᵀ times the inverse
        for (i, along) in along.iter().enumerate() {
            for (j, row) in row.iter_mut().enumerate() {
                *row += along * self.inverse[i * n + j];
            }
        }
        let shrink = b / (a * a + a * b * size);
        for i in 0..n {
            for j in 0..n {
                let at = i * n + j;
                self.factor[at] = a * self.factor[at] + b * self.path[i] * along[j];
                self.inverse[at] = self.inverse[at] / a - shrink * along[i] * row[j];
            }
        }
    }
}

fn times(matrix: &[f64], vector: &[f64]) -> Vec<f64> {
    let rows = matrix.chunks_exact(vector.len());
    rows.map(|row| row.iter().zip(vector).map(|(m, v)| m * v).sum())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenarios::search::spread::numbers;

    /// A narrow bent valley (Rosenbrock), scaled to the unit cube.
    fn valley(point: &[f64]) -> f64 {
        let (x, y) = (4.0 * point[0] - 2.0, 4.0 * point[1] - 1.0);
        let off = y - x * x;
        (1.0 - x) * (1.0 - x) + 100.0 * off * off
    }

    #[test]
    fn it_follows_a_bent_valley_to_its_end() {
        for task in 0..10 {
            let mut rng = numbers(1, 0, task);
            let mut climber = Climber::new(vec![0.1, 0.8], valley(&[0.1, 0.8]), 0.1);
            for _ in 0..3000 {
                climber.step(&mut rng, valley);
            }
            assert!(climber.value < 1e-8, "{task}: {}", climber.value);
        }
    }

    #[test]
    fn the_inverse_is_the_inverse() {
        let mut rng = numbers(2, 0, 0);
        let bowl = |point: &[f64]| -> f64 {
            let mut scaled = point.iter().zip([1.0, 30.0, 900.0]);
            scaled
                .by_ref()
                .map(|(x, k)| k * (x - 0.4) * (x - 0.4))
                .sum()
        };
        let mut climber = Climber::new(vec![0.9; 3], bowl(&[0.9; 3]), 0.2);
        for _ in 0..400 {
            climber.step(&mut rng, bowl);
        }
        for i in 0..3 {
            for j in 0..3 {
                let product: f64 = (0..3)
                    .map(|k| climber.factor[i * 3 + k] * climber.inverse[k * 3 + j])
                    .sum();
                let unit = if i == j { 1.0 } else { 0.0 };
                assert!((product - unit).abs() < 1e-6, "{i} {j}: {product}");
            }
        }
    }
}
