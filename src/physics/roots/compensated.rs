//! Sums and products with their rounding errors, without fused multiply-add.
//!
//! Sources: Dekker, "A floating-point technique for extending the available precision", Numer. Math. 18 (1971) 224;
//! Langlois & Louvet, "How to ensure a faithful polynomial evaluation with the compensated Horner algorithm" (2007).

/// 2²⁷ + 1: splits a number into two halves of 26 bits.
const SPLITTER: f64 = 134_217_729.0;

/// a + b and its rounding error.
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// a b and its rounding error; not a number where a factor exceeds about 10³⁰⁰.
pub(super) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let split = |x: f64| {
        let scaled = SPLITTER * x;
        let high = scaled - (scaled - x);
        (high, x - high)
    };
    let product = a * b;
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    (
        product,
        a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low),
    )
}

/// The polynomial at t, as if computed with 106 bits and rounded once.
pub(super) fn value(c: &[f64; 5], t: f64) -> f64 {
    let (mut sum, mut error) = (c[4], 0.0);
    for x in [c[3], c[2], c[1], c[0]] {
        let (product, product_error) = two_product(sum, t);
        let (next, sum_error) = two_sum(product, x);
        sum = next;
        error = error * t + (product_error + sum_error);
    }
    sum + error
}

/// b² − 4 a c, as if computed with 106 bits and rounded once.
pub(super) fn discriminant(a: f64, b: f64, c: f64) -> f64 {
    let (square, square_error) = two_product(b, b);
    let (product, product_error) = two_product(4.0 * a, c);
    let (difference, error) = two_sum(square, -product);
    difference + (error + (square_error - product_error))
}
