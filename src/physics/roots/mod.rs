//! Roots of the polynomials that say when two things touch.

pub mod quadratic;
pub mod quartic;

use thiserror::Error;

/// A polynomial that cannot be solved.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("the polynomial with coefficients {coefficients:?} (constant first) has no meaning")]
pub struct RootError {
    /// The coefficients, constant first.
    pub coefficients: [f64; 5],
}
