//! Smallest closing time of a quadratic, in closed form.

use crate::physics::roots::{RootError, compensated};

/// The smallest time in [`from`, `horizon`] at which c₀ + c₁ t + c₂ t² is not positive and falls; see
/// [`crate::physics::roots`] for what that means at `from`.
///
/// The falling root of a quadratic is the one at which the slope is −√D, D = c₁² − 4 c₀ c₂, so there is never a choice
/// and never a cancellation. D is computed with 106 bits where it nearly vanishes. Error: 4 units in the last place.
/// Works for c₂ = 0 and c₁ = 0.
///
/// # Errors
/// [`RootError`] if a coefficient is not finite or D overflows.
#[inline]
pub fn first_closing(c: [f64; 3], from: f64, horizon: f64) -> Result<Option<f64>, RootError> {
    let square = c[1] * c[1];
    let product = 4.0 * c[0] * c[2];
    let mut discriminant = square - product;
    if !(discriminant.is_finite() && from.is_finite()) {
        return Err(RootError {
            coefficients: [c[0], c[1], c[2], 0.0, 0.0],
            from,
        });
    }
    if discriminant.abs() < 1e-3 * square {
        let exact = compensated::discriminant(c[2], c[1], c[0]);
        if exact.is_finite() {
            discriminant = exact;
        }
    }
    let root = if discriminant < 0.0 || (c[2] >= 0.0 && c[1] >= 0.0) {
        f64::NEG_INFINITY
    } else if c[1] <= 0.0 {
        // −c₁ + √D is 0 only for −|c₂| t²: the root is 0.
        let sum = discriminant.sqrt() - c[1];
        if sum == 0.0 { 0.0 } else { 2.0 * c[0] / sum }
    } else {
        -(c[1] + discriminant.sqrt()) / (2.0 * c[2])
    };
    let time = if root >= from {
        root
    } else {
        // No falling root ahead: it is behind, or it never was.
        let value = c[0] + from * (c[1] + from * c[2]);
        let slope = c[1] + 2.0 * from * c[2];
        if value > 0.0 {
            return Ok(None);
        } else if slope < 0.0 || (slope == 0.0 && c[2] < 0.0) {
            from
        } else if c[2] < 0.0 {
            -c[1] / (2.0 * c[2])
        } else {
            return Ok(None);
        }
    };
    Ok((time <= horizon).then_some(time))
}
