//! A match as a file: one line that says what it is, one line with the match.
//!
//! ```text
//! {"format":"masse match","version":1,"bytes":48213,"crc32":"9a1c03f7"}
//! {"setup":{...},"base":{...},"rack":2,"state":{...},"lie":[...],"call":"Nothing","shots":[...],"ends":[...]}
//! ```
//!
//! Both lines are JSON. Numbers have all their digits, so a match that is resumed has the bits of the match that was saved.
//! The checksum tells a file that was cut off or lost a bit from one that is whole; a damaged file is reported with the
//! field that cannot be read where there is one.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::game::matches::Match;
use crate::kept::Unread;

/// What the first line calls the format.
const FORMAT: &str = "masse match";

/// The version that this program writes, and the newest that it reads.
pub const VERSION: u32 = 1;

/// Why a saved match cannot be used. Every variant names the file.
#[derive(Debug, Error)]
pub enum SavedError {
    /// The file cannot be read, is too large or no text.
    #[error("{file}: {why}")]
    Read {
        /// The file.
        file: String,
        /// Why not.
        why: Unread,
    },
    /// The first line does not say that this is a saved match.
    #[error("{file}:1: {field}: {what}; this is no saved match, or its first line is damaged")]
    Header {
        /// The file.
        file: String,
        /// The field.
        field: String,
        /// What is wrong.
        what: String,
    },
    /// A newer program wrote the file.
    #[error(
        "{file}:1: version: {version} is newer than {VERSION}, the newest that this program reads; a newer Massé reads it"
    )]
    Newer {
        /// The file.
        file: String,
        /// The version found.
        version: u32,
    },
    /// A field cannot be read, or has a value that cannot be.
    #[error("{file}:2: {field}: {what}")]
    Field {
        /// The file.
        file: String,
        /// Path of the field.
        field: String,
        /// Its value and what is wrong.
        what: String,
    },
    /// The file is not as it was written.
    #[error("{file}:1: {field}: {written} was written, the match that follows has {found}")]
    Damaged {
        /// The file.
        file: String,
        /// Field of the first line.
        field: &'static str,
        /// What the first line says.
        written: String,
        /// What the rest of the file has.
        found: String,
    },
}

/// The first line.
#[derive(Debug, Serialize, Deserialize)]
struct Header {
    format: String,
    version: u32,
    bytes: usize,
    crc32: String,
}

fn checksum(body: &str) -> String {
    format!("{:08x}", crc32fast::hash(body.as_bytes()))
}

/// The text of a saved match.
///
/// # Errors
/// A [`serde_json::Error`] if a number of the match is not finite.
pub fn text(game: &Match) -> Result<String, serde_json::Error> {
    let body = serde_json::to_string(game)?;
    let header = Header {
        format: FORMAT.to_owned(),
        version: VERSION,
        bytes: body.len(),
        crc32: checksum(&body),
    };
    Ok(format!("{}\n{body}\n", serde_json::to_string(&header)?))
}

/// The first line and the rest.
fn header<'t>(text: &'t str, file: &str) -> Result<(Header, &'t str), SavedError> {
    let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
    let mut reader = serde_json::Deserializer::from_str(first);
    let header: Header =
        serde_path_to_error::deserialize(&mut reader).map_err(|error| SavedError::Header {
            file: file.to_owned(),
            field: error.path().to_string(),
            what: error.into_inner().to_string(),
        })?;
    if header.format != FORMAT {
        return Err(SavedError::Header {
            file: file.to_owned(),
            field: "format".to_owned(),
            what: format!("`{}` is not `{FORMAT}`", header.format),
        });
    }
    if header.version > VERSION {
        return Err(SavedError::Newer {
            file: file.to_owned(),
            version: header.version,
        });
    }
    if header.version == 0 {
        return Err(SavedError::Header {
            file: file.to_owned(),
            field: "version".to_owned(),
            what: "0 is no version".to_owned(),
        });
    }
    Ok((header, rest.strip_suffix('\n').unwrap_or(rest)))
}

fn check_whole(header: &Header, body: &str, file: &str) -> Result<(), SavedError> {
    let damaged = |field, written: &str, found: String| SavedError::Damaged {
        file: file.to_owned(),
        field,
        written: written.to_owned(),
        found,
    };
    if header.bytes != body.len() {
        let found = body.len().to_string();
        return Err(damaged("bytes", &header.bytes.to_string(), found));
    }
    let found = checksum(body);
    if header.crc32 != found {
        return Err(damaged("crc32", &header.crc32, found));
    }
    Ok(())
}

/// Whether the text is whole and of a version that this program may write over: what a file must be before it is replaced.
///
/// # Errors
/// [`SavedError`] with what is wrong; `file` is what it calls the file.
pub fn check_replaceable(text: &str, file: &str) -> Result<(), SavedError> {
    let (header, body) = header(text, file)?;
    check_whole(&header, body, file)
}

/// Reads the text of a saved match; `file` is what errors call it.
///
/// # Errors
/// [`SavedError`] with the file, the field and the value.
pub fn parse(text: &str, file: &str) -> Result<Match, SavedError> {
    let (header, body) = header(text, file)?;
    let mut reader = serde_json::Deserializer::from_str(body);
    let field = |field: String, what: String| SavedError::Field {
        file: file.to_owned(),
        field,
        what,
    };
    let game: Match = serde_path_to_error::deserialize(&mut reader)
        .map_err(|error| field(error.path().to_string(), error.inner().to_string()))?;
    reader
        .end()
        .map_err(|error| field("the end of the match".to_owned(), error.to_string()))?;
    check_whole(&header, body, file)?;
    game.check()
        .map_err(|problem| field(problem.field, problem.what))?;
    Ok(game)
}
