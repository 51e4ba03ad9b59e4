//! Record files: a run as JSON lines, complete, so that it can be read back bit for bit without a solver.
//!
//! | line | what it holds |
//! |---|---|
//! | first | `format`, `version`, the name and the title of the scene, and the scene as it was |
//! | one for each event | time in s, kind, who, impulse in N s, the states of these balls before and after |
//! | one for each path | only where the events do not tell it: its ball and the states with which its pieces begin |
//! | one for each expectation | only if the scene has any: whether it was met, the value found, in words |
//! | last | the summary: why and when the run ended, counts, what fell, where every ball ended; how many paths have lines |
//!
//! A path follows from the first state of its ball and the states after its events, through the motion law of the scene.
//! Numbers have all their digits. A reader finds everything that is missing, unknown or at odds with the other lines: what
//! was read is put into words again and compared with the file.

mod body;
mod error;
mod fields;
mod lines;
mod paths;
mod reading;
mod summary;

pub use error::RecordFileError;
pub use reading::{parse, read};
pub use summary::Summary;

use std::io::{self, Write};

use serde::{Deserialize, Serialize};

use crate::physics::record::Record;
use crate::physics::scene::Scene;

/// What the first line calls the format.
const FORMAT: &str = "masse record";

/// The version that is written, and the only one that is read. It grows with every change to a line.
pub const VERSION: u64 = 1;

/// A run with the scene from which it came.
#[derive(Clone, Debug, PartialEq)]
pub struct Recorded {
    /// What `masse run` calls the scene: the name of a built-in one or a file.
    pub name: String,
    /// One line for a person.
    pub title: String,
    /// The scene as it was at the start.
    pub scene: Scene,
    /// What happened.
    pub record: Record,
    /// What became of its expectations.
    pub expected: Vec<Expected>,
}

/// What became of an expectation, as a line tells it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expected {
    /// What was expected, in words.
    pub expected: String,
    /// Whether it was met.
    pub met: bool,
    /// The value found, if there is one.
    pub found: Option<f64>,
    /// Its unit.
    pub unit: String,
    /// What happened, in words.
    pub seen: String,
}

/// Writes a run of a scene.
///
/// # Errors
/// What the stream says, or [`io::ErrorKind::InvalidInput`] if the record is not one of this scene.
pub fn write(
    out: &mut dyn Write,
    name: &str,
    title: &str,
    scene: &Scene,
    record: &Record,
) -> io::Result<()> {
    write_judged(out, name, title, scene, record, &[])
}

/// Writes a run of a scene, and what became of its expectations.
///
/// # Errors
/// As [`write()`].
pub fn write_judged(
    out: &mut dyn Write,
    name: &str,
    title: &str,
    scene: &Scene,
    record: &Record,
    expected: &[Expected],
) -> io::Result<()> {
    let other = |what: &str| io::Error::new(io::ErrorKind::InvalidInput, what.to_owned());
    if !lines::belongs(scene, record) {
        return Err(other("the record names balls that its scene does not have"));
    }
    line(out, &lines::Header::of(name, title, scene))?;
    for event in &record.events {
        line(out, &lines::EventLine::of(scene, event))?;
    }
    let told = paths::of_events(scene, &record.events);
    let mut lines_of_paths = 0;
    for (ball, (path, told)) in record.paths.iter().zip(&told).enumerate() {
        if !paths::follow_from_starts(scene, ball, path) {
            return Err(other("a path does not follow the motion law of its scene"));
        }
        if !paths::same(path, told) {
            line(out, &lines::PathLine::of(scene, ball, path))?;
            lines_of_paths += 1;
        }
    }
    for one in expected {
        line(out, one)?;
    }
    line(
        out,
        &lines::Last {
            summary: &Summary::of(name, title, scene, record),
            paths: lines_of_paths,
        },
    )
}

fn line(out: &mut dyn Write, value: &impl serde::Serialize) -> io::Result<()> {
    serde_json::to_writer(&mut *out, value)?;
    out.write_all(b"\n")
}
