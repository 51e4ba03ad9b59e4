//! A search for a shot, or for a layout, that meets its expectations.
//!
//! A search file is a scene file that says what may change, and in which range:
//!
//! ```ron
//! free: [
//!     Stroke(Heading, -10, 10),             // degrees; Speed, Side, Height, Elevation
//!     X("1", 0.2, 0.6),                     // m; Z as well
//!     Around("2", "1", -180, 180),          // `2` touches `1`, in this direction in degrees
//! ],
//! ties: [MirrorZ("3", "1")],                // `3` lies where the mirror image of `1` would
//! ```
//!
//! Rounds of a Latin hypercube find starts; from the best of them an evolution strategy climbs (the (1+1)-CMA-ES of Igel,
//! Suttorp & Hansen, GECCO 2006). Of the shots that meet everything the most robust one is climbed further. Every task has
//! its own seed, so that the result does not depend on the number of threads.

mod climb;
mod free;
mod player;
mod robust;
mod rounds;
mod spread;

pub(in crate::scenarios) use free::check;
pub use free::{Free, Tie};
pub use player::Player;
pub use robust::robustness;
pub use rounds::{Found, Plan, Watch, solve};
pub(in crate::scenarios) use spread::{normal, numbers};

use thiserror::Error;

/// Why there is nothing to search.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SearchError {
    /// Nothing may change.
    #[error("free: nothing is free; say what may change, such as `free: [Stroke(Heading, -5, 5)]`")]
    NothingFree,
    /// Nothing is wanted.
    #[error("expect: nothing is expected, so that any shot would do")]
    NothingExpected,
    /// The laws have no closed form.
    #[error("laws.motion: a search needs laws with a closed form, for the exact solver")]
    NotExact,
    /// Nowhere in the ranges can the scene be played.
    #[error(
        "free: not one of {tried} layouts in these ranges can be played: balls overlap, or lie off the table"
    )]
    NoLayout {
        /// Layouts tried.
        tried: u64,
    },
}
