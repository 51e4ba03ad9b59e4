//! Where a law comes from.

use serde::Serialize;

/// Where a law comes from, and what it says, for whoever chooses between laws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Source {
    /// Authors, journal and year, and the place in it: equations, section or number of the technical proof.
    pub paper: &'static str,
    /// The law in a line.
    pub formula: &'static str,
    /// What it leaves out.
    pub leaves_out: &'static str,
}

/// The law of impacts that happen at one moment: [`cluster`](super::cluster).
pub const SIMULTANEOUS: Source = Source {
    paper: "Smith, Kaufman, Vouga, Tamstorf & Grinspun, ACM Trans. Graph. 31 (2012) 106",
    formula: "all contacts that close are reflected together, (1 + e) λ with A λ ≥ c, λ ≥ 0; in rounds",
    leaves_out: "elastic waves along a row; e below 1, friction and the end of rounds are our own",
};
