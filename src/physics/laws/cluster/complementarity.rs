//! The impulses that just stop a set of contacts from closing.
//!
//! Find λ ≥ 0 with A λ ≥ c, and equality wherever λ > 0: the linear complementarity problem of an inelastic impact. A is
//! symmetric and positive semidefinite, so the velocities that follow are unique, even where a rack has more contacts
//! than its balls have freedoms and λ is not.

/// Steps of the iterative method.
const LIMIT: usize = 20_000;

/// Room for solving, kept between calls.
#[derive(Clone, Debug, Default)]
pub(super) struct Complementarity {
    /// A, row by row.
    pub(super) matrix: Vec<f64>,
    /// c on input.
    pub(super) closing: Vec<f64>,
    /// λ on output.
    pub(super) impulse: Vec<f64>,
    factor: Vec<f64>,
    last: Vec<f64>,
    ahead: Vec<f64>,
}

impl Complementarity {
    /// Makes room for `size` contacts, all entries zero.
    pub(super) fn clear(&mut self, size: usize) {
        for (list, length) in [
            (&mut self.matrix, size * size),
            (&mut self.closing, size),
            (&mut self.impulse, size),
        ] {
            list.clear();
            list.resize(length, 0.0);
        }
    }

    /// Solves for λ: directly where all contacts push, else by accelerated projected gradients (Nesterov 1983, with the
    /// restart of O'Donoghue & Candès 2015), which treats all contacts alike and so keeps mirror images mirrored.
    pub(super) fn solve(&mut self) {
        if !(self.direct() && self.impulse.iter().all(|x| *x >= 0.0)) {
            self.iterate();
        }
    }

    /// Cholesky; false if A is singular to rounding.
    fn direct(&mut self) -> bool {
        let n = self.closing.len();
        self.factor.clear();
        self.factor.extend_from_slice(&self.matrix);
        self.impulse.clear();
        self.impulse.extend_from_slice(&self.closing);
        let (l, x) = (&mut self.factor, &mut self.impulse);
        for i in 0..n {
            for j in 0..=i {
                let mut sum = l[i * n + j];
                for k in 0..j {
                    sum -= l[i * n + k] * l[j * n + k];
                }
                if i > j {
                    l[i * n + j] = sum / l[j * n + j];
                } else if sum > 1e-9 * self.matrix[i * n + i] {
                    l[i * n + i] = sum.sqrt();
                } else {
                    return false;
                }
            }
        }
        for i in 0..n {
            for k in 0..i {
                x[i] -= l[i * n + k] * x[k];
            }
            x[i] /= l[i * n + i];
        }
        for i in (0..n).rev() {
            for k in i + 1..n {
                x[i] -= l[k * n + i] * x[k];
            }
            x[i] /= l[i * n + i];
        }
        true
    }

    fn iterate(&mut self) {
        let n = self.closing.len();
        let a = &self.matrix;
        let steepest = (0..n)
            .map(|i| a[i * n..(i + 1) * n].iter().map(|x| x.abs()).sum::<f64>())
            .fold(0.0, f64::max);
        let scale = self.closing.iter().fold(0.0, |m: f64, x| m.max(x.abs())) / steepest;
        self.impulse.fill(0.0);
        self.last.clear();
        self.last.resize(n, 0.0);
        self.ahead.clear();
        self.ahead.resize(n, 0.0);
        let mut momentum = 1.0_f64;
        for _ in 0..LIMIT {
            let mut change = 0.0_f64;
            let mut uphill = 0.0;
            for i in 0..n {
                let row = &a[i * n..(i + 1) * n];
                let reached: f64 = row.iter().zip(&self.ahead).map(|(a, y)| a * y).sum();
                let next = (self.ahead[i] + (self.closing[i] - reached) / steepest).max(0.0);
                uphill += (self.ahead[i] - next) * (next - self.last[i]);
                change = change
                    .max((next - self.last[i]).abs())
                    .max((next - self.ahead[i]).abs());
                self.impulse[i] = next;
            }
            if change <= 1e-16 * scale {
                break;
            }
            let grown = 0.5 * (1.0 + (1.0 + 4.0 * momentum * momentum).sqrt());
            let push = if uphill > 0.0 {
                0.0
            } else {
                (momentum - 1.0) / grown
            };
            momentum = if uphill > 0.0 { 1.0 } else { grown };
            for i in 0..n {
                self.ahead[i] = self.impulse[i] + push * (self.impulse[i] - self.last[i]);
                self.last[i] = self.impulse[i];
            }
        }
    }
}
