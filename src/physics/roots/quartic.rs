//! Smallest closing root of a quartic.

use crate::physics::roots::RootError;

/// The smallest time in [`from`, `horizon`] at which Σ cᵢ tⁱ is not positive and falls.
///
/// # Errors
/// [`RootError`] if a coefficient is not finite.
pub fn first_closing(c: [f64; 5], from: f64, horizon: f64) -> Result<Option<f64>, RootError> {
    if !c.iter().all(|x| x.is_finite()) {
        return Err(RootError { coefficients: c });
    }
    if c[3] == 0.0 && c[4] == 0.0 {
        return super::quadratic::first_closing([c[0], c[1], c[2]], from, horizon);
    }
    let slope = [c[1], 2.0 * c[2], 3.0 * c[3], 4.0 * c[4]];
    if value(&c, from) <= 0.0 && value(&slope, from) < 0.0 {
        return Ok(Some(from));
    }
    let horizon = horizon.min(bound(&c));
    if horizon <= from {
        return Ok(None);
    }
    let curve = [slope[1], 2.0 * slope[2], 3.0 * slope[3]];
    let mut turns = [0.0; 4];
    let turns = crossings(
        &curve,
        &[2.0 * c[3] * 3.0, 24.0 * c[4]],
        from,
        horizon,
        &mut turns,
    );
    let (turns, count) = turns;
    let mut knots = [0.0; 4];
    let mut bends = 0;
    let mut a = from;
    for &b in turns[..count].iter().chain(std::iter::once(&horizon)) {
        if let Some(root) = bracketed(&slope, a, b) {
            knots[bends] = root;
            bends += 1;
        }
        a = b;
    }
    let mut a = from;
    for &b in knots[..bends].iter().chain(std::iter::once(&horizon)) {
        if value(&c, a) > 0.0 && value(&c, b) <= 0.0 {
            return Ok(bracketed(&c, a, b));
        }
        a = b;
    }
    Ok(None)
}

fn crossings(
    p: &[f64; 3],
    _d: &[f64; 2],
    from: f64,
    to: f64,
    out: &mut [f64; 4],
) -> ([f64; 4], usize) {
    let mut count = 0;
    let turn = if p[2] == 0.0 {
        f64::NAN
    } else {
        -p[1] / (2.0 * p[2])
    };
    let mut a = from;
    for b in [turn, to] {
        if b > a && b <= to {
            if let Some(root) = bracketed(p, a, b) {
                out[count] = root;
                count += 1;
            }
            a = b;
        }
    }
    (*out, count)
}

/// All real roots lie within this distance of zero (Cauchy).
fn bound(c: &[f64; 5]) -> f64 {
    let lead = c.iter().rposition(|x| *x != 0.0).unwrap_or(0);
    let most = c[..lead].iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    1.0 + most / c[lead].abs()
}

fn value(c: &[f64], t: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, x| sum * t + x)
}

/// The root in [a, b] where the polynomial changes sign once.
fn bracketed(c: &[f64], mut a: f64, mut b: f64) -> Option<f64> {
    let (fa, fb) = (value(c, a), value(c, b));
    if fa == 0.0 {
        return Some(a);
    }
    if (fa > 0.0) == (fb > 0.0) {
        return None;
    }
    for _ in 0..200 {
        let m = 0.5 * (a + b);
        if m <= a || m >= b {
            break;
        }
        if (value(c, m) > 0.0) == (fa > 0.0) {
            a = m;
        } else {
            b = m;
        }
    }
    Some(b)
}
