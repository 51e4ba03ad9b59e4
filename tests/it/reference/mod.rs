//! Tables computed by another program, pooltool (Apache-2.0): `tests/data/reference`, or the folder that the environment
//! variable `MASSE_REFERENCE` names.

mod single_laws;
mod stepped_by_hand;
mod tables;
mod whole_shots;

use std::path::PathBuf;

use glam::DVec3;

use masse::physics::ball::{Motion, State};

/// Reads a file of the reference folder.
pub fn text(file: &str) -> String {
    let folder = std::env::var_os("MASSE_REFERENCE").map_or_else(
        || PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/reference"),
        PathBuf::from,
    );
    let path = folder.join(file);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A vector of theirs in our axes.
pub fn vector(theirs: &[f64]) -> DVec3 {
    DVec3::new(theirs[1], theirs[2], theirs[0])
}

/// A state of theirs, nine numbers, in our axes. It has no label yet.
pub fn state(theirs: &[f64; 9]) -> State {
    State {
        position: vector(&theirs[..3]),
        velocity: vector(&theirs[3..6]),
        angular_velocity: vector(&theirs[6..]),
        motion: Motion::Rest,
    }
}

/// A label of theirs.
pub fn motion(theirs: u8) -> Motion {
    match theirs {
        0 => Motion::Rest,
        1 => Motion::Spinning,
        2 => Motion::Sliding,
        3 => Motion::Rolling,
        4 => Motion::Pocketed,
        5 => Motion::Airborne,
        other => panic!("there is no label {other}"),
    }
}
