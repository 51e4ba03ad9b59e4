//! How far a value may be from what it should be.

use glam::DVec3;

/// Fails unless `value` is within `tolerance` of `expected`, relative where `expected` is above 1, absolute below.
#[track_caller]
pub fn assert_close(what: &str, value: f64, expected: f64, tolerance: f64, unit: &str) {
    let error = (value - expected).abs();
    assert!(
        error <= tolerance * expected.abs().max(1.0),
        "{what}: {value:e} {unit}, expected {expected:e} {unit}, error {error:e} {unit}, allowed {tolerance:e}"
    );
}

/// Fails unless `value` is within `tolerance` of `expected`, relative to `expected` however small it is.
#[track_caller]
pub fn assert_relative(what: &str, value: f64, expected: f64, tolerance: f64, unit: &str) {
    let error = (value - expected).abs();
    assert!(
        error <= tolerance * expected.abs(),
        "{what}: {value:e} {unit}, expected {expected:e} {unit}, error {error:e} {unit}, allowed {tolerance:e} of it"
    );
}

/// Fails unless `value` agrees with a number printed with this many decimals: half a unit of the last one, and a
/// hundredth of it for a tie.
#[track_caller]
pub fn assert_printed(what: &str, value: f64, printed: f64, decimals: i32, unit: &str) {
    let last = libm::pow(10.0, f64::from(-decimals));
    let error = (value - printed).abs();
    assert!(
        error <= 0.51 * last,
        "{what}: {value} {unit}, printed {printed} {unit}, error {error:e} {unit}, last decimal {last:e}"
    );
}

/// Fails unless two vectors differ by at most `tolerance` in length, relative to the larger of 1 and the expected one.
#[track_caller]
pub fn assert_vectors(what: &str, value: DVec3, expected: DVec3, tolerance: f64, unit: &str) {
    let error = (value - expected).length();
    assert!(
        error <= tolerance * expected.length().max(1.0),
        "{what}: {value:?} {unit}, expected {expected:?} {unit}, error {error:e} {unit}, allowed {tolerance:e}"
    );
}
