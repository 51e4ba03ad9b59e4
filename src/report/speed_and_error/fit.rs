//! What the numbers say: orders of convergence, and who is best at what price.

/// How an error falls with the tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Convergence {
    /// There is nothing to fall: the error is rounding at every tick.
    Rounding,
    /// As this power of the tick.
    Order {
        /// The power.
        order: f64,
        /// Root of the mean square of the distances from the fit, in powers of ten.
        scatter: f64,
    },
    /// There are less than three ticks, or no error can be measured.
    Unknown,
}

/// Fits log error against log tick by least squares. Errors up to `rounding` in the unit of the errors are no more than
/// rounding: if all are, there is nothing to fit, else they are left out.
#[must_use]
pub fn convergence(points: &[(f64, f64)], rounding: f64) -> Convergence {
    if !points.is_empty() && points.iter().all(|(_, error)| *error <= rounding) {
        return Convergence::Rounding;
    }
    let points: Vec<(f64, f64)> = points
        .iter()
        .filter(|(tick, error)| *tick > 0.0 && *error > rounding && error.is_finite())
        .map(|(tick, error)| (libm::log10(*tick), libm::log10(*error)))
        .collect();
    if points.len() < 3 {
        return Convergence::Unknown;
    }
    let count = points.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(&|point| point.0), mean(&|point| point.1));
    let order =
        mean(&|point| (point.0 - x) * (point.1 - y)) / mean(&|point| (point.0 - x) * (point.0 - x));
    let off = |point: &(f64, f64)| point.1 - y - order * (point.0 - x);
    let scatter = mean(&|point| off(point) * off(point)).sqrt();
    Convergence::Order { order, scatter }
}

/// Which of these (cost, error) no other beats in both, cheapest first. Of equals the first counts.
#[must_use]
pub fn pareto(points: &[(f64, f64)]) -> Vec<usize> {
    let mut sorted: Vec<usize> = (0..points.len()).collect();
    sorted.sort_by(|&a, &b| {
        let (a, b) = (points[a], points[b]);
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    let mut least = f64::INFINITY;
    sorted.retain(|&point| {
        let better = points[point].1 < least;
        least = least.min(points[point].1);
        better
    });
    sorted
}

/// Mean and standard deviation.
#[must_use]
pub fn mean_and_spread(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let square = values
        .iter()
        .map(|value| (value - mean) * (value - mean))
        .sum::<f64>();
    (mean, (square / (count - 1.0).max(1.0)).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_found() {
        for power in [1.0, 2.0, 4.0] {
            let points = [60.0, 120.0, 240.0, 480.0]
                .map(|rate: f64| (1.0 / rate, 3.0 * libm::pow(rate, -power)));
            let Convergence::Order { order, scatter } = convergence(&points, 1e-12) else {
                panic!("no order");
            };
            assert!(
                (order - power).abs() < 1e-9 && scatter < 1e-9,
                "{order} {scatter}"
            );
        }
    }

    #[test]
    fn rounding_has_no_order_and_is_left_out_of_one() {
        let points = [(0.1, 1e-15), (0.05, 3e-15), (0.025, 0.0)];
        assert_eq!(convergence(&points, 1e-12), Convergence::Rounding);
        assert_eq!(convergence(&points[..2], 2e-15), Convergence::Unknown);
        assert_eq!(convergence(&[], 1.0), Convergence::Unknown);
        // Second order until rounding is reached.
        let points = [(0.1, 1e-2), (0.01, 1e-4), (0.001, 1e-6), (0.0001, 3e-15)];
        let Convergence::Order { order, .. } = convergence(&points, 1e-12) else {
            panic!("no order");
        };
        assert!((order - 2.0).abs() < 1e-9, "{order}");
    }

    #[test]
    fn the_front_holds_what_nobody_beats() {
        let points = [
            (3.0, 1.0),
            (1.0, 5.0),
            (2.0, 6.0),
            (2.0, 2.0),
            (4.0, 1.0),
            (5.0, 0.0),
        ];
        assert_eq!(pareto(&points), [1, 3, 0, 5]);
        assert_eq!(pareto(&[]), [0_usize; 0]);
        assert_eq!(pareto(&[(1.0, 0.0), (1.0, 0.0)]), [0]);
    }

    #[test]
    fn spread_is_that_of_a_sample() {
        assert_eq!(mean_and_spread(&[1.0, 3.0]), (2.0, 2.0_f64.sqrt()));
        assert_eq!(mean_and_spread(&[2.0]), (2.0, 0.0));
    }
}
