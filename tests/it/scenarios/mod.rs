//! Scenarios: what must happen in a shot, the library, searches.

mod command_line;
mod expectations;
mod films;
mod library;
mod pictures;
mod refusals;
mod searching;
mod sensitivities;
mod sharing;
mod standing;
mod sweeps;

use masse::physics::exact::{self, Limits};
use masse::physics::record::Record;
use masse::scenarios::file::{self, Scenario};

/// A scene file.
fn scenario(text: &str) -> Scenario {
    file::parse(text, "test.ron").unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// What happens in it, by the exact solver.
fn played(scenario: &Scenario) -> Record {
    exact::solve(&scenario.scene, Limits::default()).unwrap_or_else(|error| panic!("{error}"))
}
