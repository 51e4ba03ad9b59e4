//! Smallest closing time of a quartic, made for the one root that a contact needs.
//!
//! 1. Two bounds: if the constant outweighs the sum of all that pulls down until the horizon, or if a parabola that lies
//!    below the curve until then has no root, nothing is solved. Most pairs of balls end here.
//! 2. The second derivative, a quadratic, cuts the interval into at most three stretches on which the quartic is
//!    convex or concave. On a convex stretch that starts above zero, Newton's tangents lie below the curve, so Newton
//!    walks monotonically towards the first root and can never jump over it; it ends at the root, at the bottom of
//!    the curve, or at the end of the stretch. On a concave stretch there is one falling root or none, told by the
//!    sign at its end, and Newton walks towards it from the right.
//!
//! Nothing is divided by a leading coefficient: cubics, quadratics and lines need no case of their own.
//!
//! Iterations: quadratic convergence, 3 to 6 in practice; a cluster of m roots costs a factor 1 − 1/m of the distance
//! each, so 53 / log₂(4/3) = 128 at most for each of three stretches. Beyond `LIMIT` the answer is an error.

use crate::physics::roots::{RootError, compensated, quadratic};

/// Most Newton steps on one stretch.
const LIMIT: usize = 400;

/// The smallest time in [`from`, `horizon`] at which Σ cᵢ tⁱ is not positive and falls; see [`crate::physics::roots`].
///
/// # Errors
/// [`RootError`] if a coefficient is not finite or a value overflows: never a silent "no root".
pub fn first_closing(c: [f64; 5], from: f64, horizon: f64) -> Result<Option<f64>, RootError> {
    if c[3] == 0.0 && c[4] == 0.0 {
        return quadratic::first_closing([c[0], c[1], c[2]], from, horizon);
    }
    let polynomial = Polynomial { c };
    if !(c.iter().sum::<f64>().is_finite() && from.is_finite()) {
        return Err(polynomial.error(from));
    }
    // Two lower bounds.
    if c[0] > 0.0 && from == 0.0 {
        let fall = c[3].min(0.0) + horizon * c[4].min(0.0);
        let pull = c[1].min(0.0) + horizon * (c[2].min(0.0) + horizon * fall);
        if c[0] + horizon * pull > 1e-14 * c[0] {
            return Ok(None);
        }
        // The parabola below the curve may pass zero above.
        let bend = c[2] + horizon * fall;
        if bend > 0.0 && c[1] * c[1] < (4.0 - 1e-12) * c[0] * bend {
            return Ok(None);
        }
    }
    polynomial
        .first(from, horizon)
        .or_else(|error| polynomial.in_other_units(from, horizon).ok_or(error)?)
}

struct Polynomial {
    c: [f64; 5],
}

impl Polynomial {
    fn error(&self, from: f64) -> RootError {
        RootError {
            coefficients: self.c,
            from,
        }
    }

    /// The same with time counted in units of about `from`, for powers beyond the range of the arithmetic; `None` where
    /// that changes nothing.
    fn in_other_units(&self, from: f64, horizon: f64) -> Option<Result<Option<f64>, RootError>> {
        let unit = if from == 0.0 { 0 } else { libm::ilogb(from) };
        if unit.abs() < 100 {
            return None;
        }
        let powers: [i32; 5] = [0, unit, 2 * unit, 3 * unit, 4 * unit];
        let most = (0..5)
            .filter(|&i| self.c[i] != 0.0)
            .map(|i| libm::ilogb(self.c[i]) + powers[i])
            .max()?;
        let mut c = [0.0; 5];
        for i in 0..5 {
            c[i] = libm::scalbn(self.c[i], powers[i] - most);
        }
        let found = Self { c }.first(libm::scalbn(from, -unit), libm::scalbn(horizon, -unit));
        Some(
            found
                .map(|root| root.map(|time| libm::scalbn(time, unit)))
                .map_err(|_| self.error(from)),
        )
    }

    /// The value at t, with a sign that can be trusted.
    fn value(&self, t: f64) -> f64 {
        let c = &self.c;
        let value = c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * c[4])));
        let s = t.abs();
        let size =
            c[0].abs() + s * (c[1].abs() + s * (c[2].abs() + s * (c[3].abs() + s * c[4].abs())));
        if value.abs() > 4e-15 * size {
            return value;
        }
        let exact = compensated::value(c, t);
        if exact.is_finite() { exact } else { value }
    }

    fn slope(&self, t: f64) -> f64 {
        let c = &self.c;
        c[1] + t * (2.0 * c[2] + t * (3.0 * c[3] + t * (4.0 * c[4])))
    }

    /// Whether a polynomial that is zero at t is negative right after t.
    fn falls(&self, t: f64) -> bool {
        let c = &self.c;
        let derivatives = [
            self.slope(t),
            c[2] + t * (3.0 * c[3] + t * (6.0 * c[4])),
            c[3] + t * (4.0 * c[4]),
            c[4],
        ];
        derivatives
            .iter()
            .find(|x| **x != 0.0)
            .is_some_and(|x| *x < 0.0)
    }

    /// Where the curvature changes its sign, in order, and whether the curve is convex before the first of them.
    fn bends(&self) -> ([f64; 2], bool) {
        let (a, b, c) = (6.0 * self.c[4], 3.0 * self.c[3], self.c[2]);
        let never = f64::INFINITY;
        if a == 0.0 {
            return ([-c / b, never], b < 0.0);
        }
        let discriminant = b * b - 4.0 * a * c;
        // Written so that a discriminant that is not a number ends in bends that are not numbers either.
        if discriminant <= 0.0 {
            return ([never, never], a > 0.0);
        }
        if discriminant == f64::INFINITY {
            return ([f64::NAN; 2], true);
        }
        let q = -0.5 * (b + discriminant.sqrt().copysign(b));
        let (one, two) = (q / a, c / q);
        ([one.min(two), one.max(two)], a > 0.0)
    }

    fn first(&self, from: f64, horizon: f64) -> Result<Option<f64>, RootError> {
        let (bends, mut convex) = self.bends();
        let mut a = from;
        let mut value = self.value(a);
        if !value.is_finite() || bends[0].is_nan() || bends[1].is_nan() {
            return Err(self.error(from));
        }
        for end in [bends[0], bends[1], f64::INFINITY] {
            let b = end.min(horizon);
            if b > a || (b == a && b == horizon) {
                if value <= 0.0 {
                    if self.falls(a) {
                        return Ok(Some(a));
                    }
                    if !convex && let Some(top) = self.top(a, b) {
                        a = top;
                        value = self.value(a);
                        if value <= 0.0 {
                            return Ok(Some(a));
                        }
                    }
                }
                if value > 0.0 {
                    let root = if convex {
                        self.descend(a, value, b)?
                    } else {
                        self.drop(a, value, b)?
                    };
                    if root.is_some() {
                        return Ok(root);
                    }
                }
                if b >= horizon {
                    return Ok(None);
                }
                a = b;
                value = self.value(a);
                if value.is_nan() {
                    return Err(self.error(from));
                }
            }
            convex = !convex;
        }
        Ok(None)
    }

    /// The falling root on the convex stretch [a, b] that starts with a positive value.
    fn descend(&self, a: f64, value: f64, b: f64) -> Result<Option<f64>, RootError> {
        let (mut t, mut f) = (a, value);
        // The parabola at a is often near enough to save the first half of the steps. A tangent to the right of the
        // root still meets zero to its left.
        let slope = self.slope(a);
        let half_bend = self.c[2] + a * (3.0 * self.c[3] + a * (6.0 * self.c[4]));
        let discriminant = slope * slope - 4.0 * f * half_bend;
        if slope < 0.0 && discriminant > 0.0 {
            let guess = a + 2.0 * f / (discriminant.sqrt() - slope);
            let slope = self.slope(guess);
            if guess < b && slope < 0.0 {
                let next = guess - self.value(guess) / slope;
                if next >= b {
                    return Ok(None);
                }
                if next > a {
                    let value = self.value(next);
                    if value <= 0.0 {
                        return Ok(Some(self.polished(next)));
                    }
                    (t, f) = (next, value);
                }
            }
        }
        for _ in 0..LIMIT {
            let slope = self.slope(t);
            if slope >= 0.0 {
                return Ok(None);
            }
            let next = t - f / slope;
            if next >= b {
                return Ok(None);
            }
            if next <= t {
                return Ok(Some(t));
            }
            t = next;
            f = self.value(t);
            if f <= 0.0 {
                return Ok(Some(self.polished(t)));
            }
        }
        Err(self.error(a))
    }

    /// The falling root on the concave stretch [a, b] that starts with a positive value.
    fn drop(&self, a: f64, value: f64, b: f64) -> Result<Option<f64>, RootError> {
        let slope = self.slope(a);
        let mut t = b;
        if slope < 0.0 {
            // The tangent lies above the curve.
            t = t.min((a - value / slope).next_up());
        }
        let mut f = self.value(t);
        if !f.is_finite() {
            // The end is too far away to be computed: look for a nearer one.
            let mut reach = a.abs().max(f64::MIN_POSITIVE);
            loop {
                t = a + reach;
                f = self.value(t);
                if !f.is_finite() {
                    return Err(self.error(a));
                }
                if f <= 0.0 {
                    break;
                }
                reach *= 2.0;
            }
        }
        if f > 0.0 {
            if t < b {
                // Rounding put the end of the tangent before the root: it is the root.
                return Ok(Some(self.polished(t)));
            }
            return Ok(None);
        }
        for _ in 0..LIMIT {
            let slope = self.slope(t);
            let next = t - f / slope;
            if !(slope < 0.0 && next < t && next > a) {
                return Ok(Some(t));
            }
            t = next;
            f = self.value(t);
            if f >= 0.0 {
                return Ok(Some(self.polished(t)));
            }
        }
        Err(self.error(a))
    }

    /// Where the concave stretch [a, b], which rises at a, turns round; `None` if it rises to its end.
    fn top(&self, mut a: f64, mut b: f64) -> Option<f64> {
        if b == f64::INFINITY {
            let mut reach = a.abs().max(f64::MIN_POSITIVE);
            while self.slope(a + reach) > 0.0 {
                a += reach;
                reach *= 2.0;
            }
            b = a + reach;
        }
        if !b.is_finite() || self.slope(b) >= 0.0 {
            return None;
        }
        loop {
            let middle = a + 0.5 * (b - a);
            if middle <= a || middle >= b {
                return Some(b);
            }
            if self.slope(middle) > 0.0 {
                a = middle;
            } else {
                b = middle;
            }
        }
    }

    /// One last Newton step with a residual of 106 bits.
    fn polished(&self, t: f64) -> f64 {
        let slope = self.slope(t);
        let step = compensated::value(&self.c, t) / slope;
        if slope < 0.0 && step.abs() <= 1e-8 * t.abs() {
            t - step
        } else {
            t
        }
    }
}
