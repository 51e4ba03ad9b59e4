//! What can be wrong with a record file.

use thiserror::Error;

use crate::kept::Unread;
use crate::physics::scene::SceneError;
use crate::report::record_file::VERSION;

/// Why a record file cannot be used. Every variant names the file, most the line (from 1) and the field.
#[derive(Debug, Error)]
pub enum RecordFileError {
    /// The file cannot be read, is too large or no text.
    #[error("{file}: {why}")]
    Read {
        /// The file.
        file: String,
        /// Why not.
        why: Unread,
    },
    /// The first line does not say that this is a record.
    #[error(
        "{file}:1: not a record file: its first line has no field `format` with value `masse record`"
    )]
    NotARecord {
        /// The file.
        file: String,
    },
    /// The file is of a version that this program does not know.
    #[error(
        "{file}:1: version: {version} is not known, this program reads version {VERSION}; a newer one may read it"
    )]
    Version {
        /// The file.
        file: String,
        /// The version found.
        version: u64,
    },
    /// A line is not JSON.
    #[error("{file}:{line}:{column}: {message}")]
    Syntax {
        /// The file.
        file: String,
        /// The line.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// What is wrong.
        message: String,
    },
    /// A field is missing, unknown, of the wrong kind, or at odds with the other lines.
    #[error("{file}:{line}: {field}: {problem}")]
    Field {
        /// The file.
        file: String,
        /// The line.
        line: usize,
        /// Path of the field, such as `before[0].position`.
        field: String,
        /// What is wrong.
        problem: String,
    },
    /// The scene could not have been played.
    #[error("{file}:1: scene: {problem}")]
    Scene {
        /// The file.
        file: String,
        /// The field and its value.
        problem: SceneError,
    },
    /// The file ends too soon.
    #[error("{file}:{line}: the file ends here without its summary: it was cut off")]
    CutOff {
        /// The file.
        file: String,
        /// The last line.
        line: usize,
    },
    /// Something follows the summary.
    #[error("{file}:{line}: the summary is the last line, nothing may follow it")]
    AfterTheEnd {
        /// The file.
        file: String,
        /// The line.
        line: usize,
    },
}
