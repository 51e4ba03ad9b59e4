//! Roots of the polynomials that say when two things touch.
//!
//! Both solvers ask for one number: the smallest time in [`from`, `horizon`] at which a polynomial **is not positive
//! and falls**. That is the falling root where there is one; a polynomial that is already at or below zero and falls
//! answers `from`; one that is below zero, rises and turns round below zero answers the turning point (two things
//! that overlap by rounding and begin to approach). A polynomial that is zero everywhere never falls.
//!
//! Accuracy: the answer is a root of the polynomial with exactly the given coefficients. Signs are decided with
//! compensated sums (as if in 106 bits) wherever plain arithmetic cannot be trusted, so near-double roots are not
//! lost; the root itself is within a few units in the last place while its condition number in 106 bits allows, and
//! within about (10⁻³² c)^(1/m) relative for a cluster of m roots of condition c.

mod compensated;
pub mod quadratic;
pub mod quartic;
#[cfg(test)]
mod tests;

use thiserror::Error;

/// A polynomial that cannot be solved: a number is not finite, or grew beyond the range of the arithmetic.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error(
    "the polynomial with coefficients {coefficients:?} (constant first) cannot be solved from time {from} on"
)]
pub struct RootError {
    /// The coefficients, constant first.
    pub coefficients: [f64; 5],
    /// Time from which a root was asked for.
    pub from: f64,
}
