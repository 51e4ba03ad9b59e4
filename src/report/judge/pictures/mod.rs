//! The pictures that an expert knows: our laws as curves, what was measured as black dots, the coursework model dashed.
//! One file a picture.

mod deflection;
mod rebound;
mod squirt;
mod throw;
mod travel;

use crate::report::chart::{Chart, Ink};
use crate::report::judge::Work;

/// A file name and the chart that it holds.
pub type Picture = (&'static str, Work<Chart>);

/// Every picture.
pub const ALL: &[Picture] = &[
    ("throw.svg", Work::Laws(throw::chart)),
    ("rebound.svg", Work::Laws(rebound::chart)),
    ("deflection.svg", Work::Shots(deflection::chart)),
    ("draw-and-follow.svg", Work::Shots(travel::chart)),
    ("squirt.svg", Work::Laws(squirt::chart)),
];

/// What was measured.
const MEASURED: Ink = Ink::dots(0);

/// The coursework model.
const COURSEWORK: Ink = Ink::dashed(1);

/// The ink of the law with this place in its list: the colours that neither of the above has, and strokes of which a
/// later kind leaves an earlier one visible below it, because laws that share a root can lie on each other.
fn law_ink(place: usize) -> Ink {
    let colour = 2 + place % 5;
    match place % 5 {
        2 => Ink::dotted(colour),
        4 => Ink::dashed(colour),
        _ => Ink::line(colour),
    }
}

/// The ink of one of several curves that never lie on each other.
fn curve_ink(place: usize) -> Ink {
    Ink::line(2 + place % 5)
}
