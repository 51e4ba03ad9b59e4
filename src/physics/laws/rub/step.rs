//! Steps along the normal impulse.

use glam::DVec2;

use super::{Accuracy, MOST_STEPS, Point, Rate, Rub};

/// Dormand & Prince (1980), J. Comput. Appl. Math. 6, 19: stages, and the difference of the two orders.
const A: [[f64; 6]; 6] = [
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [
        19372.0 / 6561.0,
        -25360.0 / 2187.0,
        64448.0 / 6561.0,
        -212.0 / 729.0,
        0.0,
        0.0,
    ],
    [
        9017.0 / 3168.0,
        -355.0 / 33.0,
        46732.0 / 5247.0,
        49.0 / 176.0,
        -5103.0 / 18656.0,
        0.0,
    ],
    [
        35.0 / 384.0,
        0.0,
        500.0 / 1113.0,
        125.0 / 192.0,
        -2187.0 / 6784.0,
        11.0 / 84.0,
    ],
];
const C: [f64; 6] = [0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0];
const E: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// Longest step times the rate at which a slip turns into its direction: the pair is stable up to 3.3.
const STABLE: f64 = 2.0;

/// An impact under way.
pub(super) struct Walk<'a, const N: usize> {
    rub: &'a Rub<N>,
    accuracy: &'a Accuracy,
    pub(super) at: Point<N>,
    rate: Rate<N>,
    held: [bool; N],
    /// The step that the error of the last one asks for.
    stride: f64,
    steps: usize,
    stored: f64,
    goal: Option<f64>,
}

/// A step that was tried.
struct Trial<const N: usize> {
    at: Point<N>,
    rate: Rate<N>,
    error: f64,
}

impl<'a, const N: usize> Walk<'a, N> {
    pub(super) fn new(rub: &'a Rub<N>, accuracy: &'a Accuracy) -> Self {
        let at = Point {
            impulse: 0.0,
            friction: [DVec2::ZERO; N],
            heat: 0.0,
        };
        let vanished = accuracy.vanished.max(rub.noise);
        let held = std::array::from_fn(|c| rub.slip[c].length_squared() <= vanished * vanished);
        Self {
            rub,
            accuracy,
            at,
            rate: rub.rate(&at, &held),
            held,
            stride: 0.5 / rub.normal,
            steps: 0,
            stored: 0.0,
            goal: None,
        }
    }

    /// Until the closing speed is zero.
    pub(super) fn compress(&mut self) {
        while self.steps < MOST_STEPS {
            let (closing, slope) = self.closing();
            if slope < 0.0 && closing.abs() <= 1e-3 {
                break;
            }
            // A step that was too long ends beyond: go back.
            let zero = -closing / slope;
            let length = if slope < 0.0 && zero < 1.25 * self.stride {
                zero
            } else {
                self.stride
            };
            self.advance(length);
        }
        let (closing, slope) = self.closing();
        self.stored = self.rub.work(&self.at);
        if slope < 0.0 {
            // Work is greatest where the closing speed is zero, so that a little off matters in second order only.
            self.stored -= 0.5 * closing * closing / slope;
            if self.rub.restitution == 0.0 {
                self.drift(-closing / slope);
            }
        }
    }

    /// Until e² of the work is given back.
    pub(super) fn restore(&mut self) {
        let e = self.rub.restitution;
        let goal = (1.0 - e * e) * self.stored;
        self.goal = Some(goal);
        if e == 0.0 {
            return;
        }
        while self.steps < MOST_STEPS {
            let (closing, slope) = self.closing();
            if closing > 2e-3 || slope >= 0.0 {
                return;
            }
            let left = self.rub.work(&self.at) - goal;
            // Closing speed at the goal, if the forces stay as they are.
            let square = closing * closing - 2.0 * slope * left;
            let length = (closing + square.max(0.0).sqrt()) / -slope;
            if length.abs() <= 3e-4 / self.rub.normal {
                self.finish(goal);
                return;
            }
            self.advance(if length < 1.25 * self.stride {
                length
            } else {
                self.stride
            });
        }
    }

    fn closing(&self) -> (f64, f64) {
        (
            self.rub.closing(&self.at),
            self.rub.closing_rate(&self.rate),
        )
    }

    /// A piece so short that the forces stay as they are.
    fn drift(&mut self, length: f64) {
        self.at.impulse += length;
        for c in 0..N {
            self.at.friction[c] += length * self.rate.friction[c];
        }
        self.at.heat += length * self.rate.heat;
    }

    /// The last piece: to the goal to rounding.
    fn finish(&mut self, goal: f64) {
        for _ in 0..3 {
            let (closing, slope) = self.closing();
            let left = self.rub.work(&self.at) - goal;
            let square = closing * closing - 2.0 * slope * left;
            self.drift((closing + square.max(0.0).sqrt()) / -slope);
        }
    }

    /// One step of at most this length; negative lengths go back.
    fn advance(&mut self, length: f64) {
        let mut length = self.before_slips_change(length);
        let mut rejected = false;
        loop {
            self.steps += 1;
            let trial = self.trial(length);
            let ratio = trial.error / self.accuracy.tolerance;
            let factor = 0.9 * libm::pow(ratio.max(1e-4), -0.2);
            let far = self.begun_too_far(&trial.at);
            let last = self.steps >= MOST_STEPS || length.abs() < 1e-9;
            if (ratio <= 1.0 && far >= 1.0) || last {
                let next = length.abs() * factor.clamp(0.3, 5.0);
                self.stride = if rejected {
                    next
                } else {
                    self.stride.max(next)
                };
                self.at = trial.at;
                self.rate = trial.rate;
                break;
            }
            rejected = true;
            length *= factor.min(far).clamp(0.1, 0.8);
        }
        self.change_modes();
    }

    /// Shortens a step at whose end a slip would be reversed, or a slip that begins would have gone far.
    fn before_slips_change(&self, length: f64) -> f64 {
        let slips = self.rub.slips(&self.at);
        let rates = self.rub.slip_rates(&self.rate);
        let mut length = length;
        for c in 0..N {
            let rate = rates[c].length();
            if self.held[c] {
                if rate > 1e-9 {
                    length = length.min(1.5 * self.accuracy.release / rate);
                }
                continue;
            }
            // A small slip turns quickly: longer steps would be unstable.
            let force = self.rate.friction[c].length() * self.rub.mobility_x[c][c];
            let size = slips[c].length();
            length = length.min(STABLE * size / force.max(1e-100));
            let approach = -slips[c].dot(rates[c]);
            if approach > 0.0 && slips[c].perp_dot(rates[c]).abs() < 0.3 * slips[c].length() * rate
            {
                length = length.min(0.95 * approach / (rate * rate));
            }
        }
        length
    }

    /// By how much a step has to be shortened because a slip began in it; 1 or more if it has not.
    #[expect(
        clippy::needless_range_loop,
        reason = "one index runs through several lists"
    )]
    fn begun_too_far(&self, at: &Point<N>) -> f64 {
        let slips = self.rub.slips(at);
        let mut size = 0.0_f64;
        for c in 0..N {
            if self.held[c] {
                size = size.max(slips[c].length());
            }
        }
        2.0 * self.accuracy.release.max(2.0 * self.rub.noise) / size.max(1e-100)
    }

    /// Holds slips that vanish and frees those that begin.
    fn change_modes(&mut self) {
        let slips = self.rub.slips(&self.at);
        let rates = self.rub.slip_rates(&self.rate);
        let mut changed = false;
        for c in 0..N {
            let size = slips[c].length();
            if self.held[c] {
                let free = size > self.accuracy.release.max(4.0 * self.rub.noise);
                self.held[c] = !free;
                changed |= free;
            } else if size <= self.accuracy.vanished {
                self.held[c] = true;
                changed = true;
            } else if size <= self.accuracy.capture * self.least_other(c, &slips)
                && slips[c].dot(rates[c]) < 0.0
            {
                let stop = size / rates[c].length();
                changed |= stop < 0.5 * self.remaining() && self.capture(c);
            }
        }
        if changed {
            self.rate = self.rub.rate(&self.at, &self.held);
        }
    }

    /// The least free slip at another contact, at most 1: while that one turns quickly, what friction can hold changes.
    #[expect(
        clippy::needless_range_loop,
        reason = "one index runs through several lists"
    )]
    fn least_other(&self, contact: usize, slips: &[DVec2; N]) -> f64 {
        let mut least = 1.0_f64;
        for c in 0..N {
            if c != contact && !self.held[c] && self.rub.limits[c].friction > 0.0 {
                least = least.min(slips[c].length());
            }
        }
        least
    }

    /// How much normal impulse is still to come, at least.
    fn remaining(&self) -> f64 {
        let (closing, slope) = self.closing();
        if slope >= 0.0 {
            return 0.0;
        }
        let e = self.rub.restitution;
        let Some(goal) = self.goal else {
            return (1.0 + e) * closing / -slope;
        };
        let left = self.rub.work(&self.at) - goal;
        let square = closing * closing - 2.0 * slope * left;
        (closing + square.max(0.0).sqrt()) / -slope
    }

    /// Stops a small slip that friction can hold: later impulses do not depend on when it stopped.
    #[expect(
        clippy::needless_range_loop,
        reason = "one index runs through several lists"
    )]
    fn capture(&mut self, contact: usize) -> bool {
        let mut held = self.held;
        held[contact] = true;
        let mut at = self.at;
        let impulses = self.rub.stop(contact, &self.held, &at);
        for c in 0..N {
            at.friction[c] += impulses[c];
        }
        at.heat += self.rub.work(&at) - self.rub.work(&self.at);
        let rate = self.rub.rate(&at, &held);
        if self.rub.slip_rates(&rate)[contact].length() > 1e-9 {
            return false;
        }
        self.at = at;
        self.held = held;
        true
    }

    fn trial(&self, length: f64) -> Trial<N> {
        let k0 = self.rate;
        let k1 = self.rub.rate(&self.stage(length, 0, [&k0]), &self.held);
        let k2 = self
            .rub
            .rate(&self.stage(length, 1, [&k0, &k1]), &self.held);
        let k3 = self
            .rub
            .rate(&self.stage(length, 2, [&k0, &k1, &k2]), &self.held);
        let k4 = self
            .rub
            .rate(&self.stage(length, 3, [&k0, &k1, &k2, &k3]), &self.held);
        let k5 = self.rub.rate(
            &self.stage(length, 4, [&k0, &k1, &k2, &k3, &k4]),
            &self.held,
        );
        // The second stage has no part in the sum.
        let at = self.stage(length, 5, [&k0, &k1, &k2, &k3, &k4, &k5]);
        let k6 = self.rub.rate(&at, &self.held);
        let mut error = 0.0_f64;
        for c in 0..N {
            let mut off = E[0] * k0.friction[c];
            for (part, rate) in [
                (E[2], &k2),
                (E[3], &k3),
                (E[4], &k4),
                (E[5], &k5),
                (E[6], &k6),
            ] {
                off += part * rate.friction[c];
            }
            error = error.max(off.x.abs()).max(off.y.abs());
        }
        Trial {
            at,
            rate: k6,
            error: error * length.abs(),
        }
    }

    /// The point at which the next stage looks.
    #[inline]
    fn stage<const S: usize>(&self, length: f64, row: usize, rates: [&Rate<N>; S]) -> Point<N> {
        let mut at = self.at;
        at.impulse += C[row] * length;
        for s in 0..S {
            let part = A[row][s] * length;
            for c in 0..N {
                at.friction[c] += part * rates[s].friction[c];
            }
            at.heat += part * rates[s].heat;
        }
        at
    }
}
