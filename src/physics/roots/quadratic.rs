//! Smallest closing root of a quadratic.

use crate::physics::roots::RootError;

/// The smallest time in [`from`, `horizon`] at which c₀ + c₁ t + c₂ t² is not positive and falls.
///
/// # Errors
/// [`RootError`] if a coefficient is not finite.
pub fn first_closing(c: [f64; 3], from: f64, horizon: f64) -> Result<Option<f64>, RootError> {
    if !c.iter().all(|x| x.is_finite()) {
        return Err(RootError {
            coefficients: [c[0], c[1], c[2], 0.0, 0.0],
        });
    }
    let slope = |t: f64| c[1] + 2.0 * c[2] * t;
    let value = |t: f64| c[0] + t * (c[1] + t * c[2]);
    if value(from) <= 0.0 && slope(from) < 0.0 {
        return Ok(Some(from));
    }
    let discriminant = c[1] * c[1] - 4.0 * c[0] * c[2];
    let root = if c[2] == 0.0 {
        if c[1] < 0.0 {
            -c[0] / c[1]
        } else {
            return Ok(None);
        }
    } else if discriminant < 0.0 {
        return Ok(None);
    } else {
        // The falling root is the one at which the slope is −√discriminant.
        let root = discriminant.sqrt();
        if c[1] <= 0.0 {
            2.0 * c[0] / (-c[1] + root)
        } else {
            (-c[1] - root) / (2.0 * c[2])
        }
    };
    Ok((root >= from && root <= horizon && slope(root) <= 0.0).then_some(root))
}
