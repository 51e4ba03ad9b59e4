//! What can be wrong with a scene file.

use thiserror::Error;

use crate::kept::Unread;
use crate::physics::scene::SceneError;

/// Why a scene file cannot be used. Every variant names the file, the place in it and the value found there.
#[derive(Debug, Error)]
pub enum FileError {
    /// The file cannot be read, is too large or no text.
    #[error("{file}: {why}")]
    Read {
        /// The file.
        file: String,
        /// Why not.
        why: Unread,
    },
    /// The text is not a scene file: bad RON, an unknown or missing field, a value of the wrong kind.
    #[error("{file}:{line}:{column}: {message}\n  {excerpt}")]
    Syntax {
        /// The file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What is wrong.
        message: String,
        /// The line of the file, cut to the neighbourhood of the place.
        excerpt: String,
    },
    /// A field has a value that makes no sense.
    #[error("{file}: {problem}")]
    Field {
        /// The file.
        file: String,
        /// The field and its value.
        problem: FieldError,
    },
    /// The scene cannot be played.
    #[error("{file}: {problem}")]
    Scene {
        /// The file.
        file: String,
        /// The field and its value.
        problem: SceneError,
    },
    /// A scene cannot be spelled in RON.
    #[error("the scene cannot be written as text: {message}")]
    Write {
        /// What the writer says.
        message: String,
    },
}

impl FileError {
    /// Characters of a line shown on each side of a mistake.
    const AROUND: usize = 50;

    pub(in crate::scenarios) fn syntax(
        file: &str,
        text: &str,
        error: &ron::error::SpannedError,
    ) -> Self {
        // The end of the span is where the reader stopped: at the value it could not take.
        let place = error.span.end;
        let line = text.lines().nth(place.line.saturating_sub(1)).unwrap_or("");
        let skipped = place.col.saturating_sub(1 + Self::AROUND);
        let excerpt: String = line
            .chars()
            .skip(skipped)
            .take(2 * Self::AROUND)
            .map(|c| if c.is_control() { ' ' } else { c })
            .collect();
        let excerpt = excerpt.trim();
        Self::Syntax {
            file: file.to_owned(),
            line: place.line,
            column: place.col,
            message: error.code.to_string(),
            excerpt: if excerpt.is_empty() {
                "(the line is empty)".to_owned()
            } else {
                excerpt.to_owned()
            },
        }
    }
}

/// A field of a scene file whose value makes no sense.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FieldError {
    /// The file is of a version that is not known.
    #[error("version: {version} is not known, this program reads version 1")]
    Version {
        /// The version found.
        version: u32,
    },
    /// Exactly one of several fields is needed.
    #[error("{parent}: one of {choices} is needed, {count} are given")]
    OneOf {
        /// The struct.
        parent: String,
        /// The fields.
        choices: &'static str,
        /// How many are given.
        count: usize,
    },
    /// A ball is named that is not there.
    #[error("{field}: there is no ball `{name}`, there are {known}")]
    NoSuchBall {
        /// The field.
        field: &'static str,
        /// The name found.
        name: String,
        /// The names that could be used.
        known: String,
    },
    /// An expectation that can never be tested, or a camera that can see nothing.
    #[error("{field}: {value}: {problem}")]
    Untestable {
        /// The field.
        field: String,
        /// The value found.
        value: String,
        /// What is wrong with it.
        problem: String,
    },
    /// A ball aims at itself, or at a ball in the same place.
    #[error("shot.aim_at: `{name}` gives no direction")]
    NoDirection {
        /// The name found.
        name: String,
    },
    /// A preset or a cloth is named that is not there.
    #[error("{field}: there is no {what} and no file `{name}`; built in are {known}")]
    Unknown {
        /// The field.
        field: &'static str,
        /// What was looked for.
        what: &'static str,
        /// The name found.
        name: String,
        /// The names that are built in.
        known: String,
    },
    /// There is neither a table nor a preset that brings one.
    #[error("table: a `table` is needed, or a `preset` that has one")]
    NoTable,
    /// Presets that are made from each other.
    #[error("preset: `{name}` is made from itself, or from more than {most} others")]
    Circle {
        /// The name found.
        name: String,
        /// Longest chain of presets.
        most: usize,
    },
    /// A single number is set that is not there.
    #[error("set: there is no number `{path}`; `{parent}` has {known}")]
    NoSuchNumber {
        /// The path found.
        path: String,
        /// The part of the path that is known.
        parent: String,
        /// What could follow.
        known: String,
    },
    /// A tip whose restitution is not that of its kind.
    #[error(
        "cue.tip_restitution: {value} is not allowed, a {kind} tip has {least} to {most} (Alciatore, FAQ on cue tips)"
    )]
    Tip {
        /// The kind of tip.
        kind: &'static str,
        /// The value found.
        value: f64,
        /// Least value measured.
        least: f64,
        /// Greatest value measured.
        most: f64,
    },
    /// More balls than the table has room for, however they lie.
    #[error("fill.count: {count} balls cannot lie on the table, it must be at most {most}")]
    Crowded {
        /// Balls asked for.
        count: u32,
        /// Balls that would cover the table.
        most: u32,
    },
    /// More balls than there is memory for.
    #[error("fill.count: {count} balls need up to {need} bytes of memory, {available} are free")]
    NoMemory {
        /// Balls asked for.
        count: u32,
        /// Bytes needed.
        need: u64,
        /// Bytes free.
        available: u64,
    },
    /// There is not enough room for a fill.
    #[error("fill.count: {count} balls do not fit on the table, {placed} do")]
    NoRoom {
        /// Balls asked for.
        count: u32,
        /// Balls placed.
        placed: u32,
    },
    /// A range whose ends are the wrong way round.
    #[error("{field}: {least} is above {most}")]
    EmptyRange {
        /// The field.
        field: &'static str,
        /// The first end.
        least: f64,
        /// The second end.
        most: f64,
    },
}

/// A scene or a preset that cannot be made of a file, before the file is named.
#[derive(Debug)]
pub(in crate::scenarios) enum LayoutError {
    /// A field of the file.
    Field(FieldError),
    /// A field of the scene.
    Scene(SceneError),
    /// Another file that this one needs.
    File(Box<FileError>),
}

impl LayoutError {
    pub(in crate::scenarios) fn in_file(self, file: &str) -> FileError {
        let file = file.to_owned();
        match self {
            Self::Field(problem) => FileError::Field { file, problem },
            Self::Scene(problem) => FileError::Scene { file, problem },
            Self::File(error) => *error,
        }
    }
}

impl From<FieldError> for LayoutError {
    fn from(error: FieldError) -> Self {
        Self::Field(error)
    }
}

impl From<FileError> for LayoutError {
    fn from(error: FileError) -> Self {
        Self::File(Box::new(error))
    }
}

impl From<SceneError> for LayoutError {
    fn from(error: SceneError) -> Self {
        Self::Scene(error)
    }
}
