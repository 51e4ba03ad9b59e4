//! A scene as a short text that can be pasted anywhere.
//!
//! `masse1:` and then, in the letters of base64 for addresses, four bytes with the length of what follows, four with its
//! CRC-32, and the scene file without spaces, deflated. So a text that was cut off, mistyped or written by a newer program
//! is told apart, and says so.

use std::io::{Read, Write};

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use flate2::Compression;
use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;
use thiserror::Error;

use crate::scenarios::file::{self, FileError, Scenario};

/// What every shared text begins with, before its version.
const MARK: &str = "masse";

/// The version that is written, and the only one that is read.
const VERSION: u32 = 1;

/// Bytes before the deflated text: its length and its CRC-32.
const HEAD: usize = 8;

/// Longest scene file in bytes that is unpacked: a text that fits a paste does not hold more.
const LARGEST: u64 = 1 << 24;

/// Why a shared text cannot be used.
#[derive(Debug, Error)]
pub enum ShareError {
    /// It comes from a newer program.
    #[error(
        "the shared text is of version {version}, this program reads version {VERSION}; a newer one may read it"
    )]
    Newer {
        /// The version found.
        version: u32,
    },
    /// It ends too soon.
    #[error("the shared text was cut off: {found} of {needed} bytes are there")]
    CutOff {
        /// Bytes found.
        found: usize,
        /// Bytes needed.
        needed: usize,
    },
    /// It is not what was written.
    #[error("the shared text is damaged: {what}")]
    Damaged {
        /// What is wrong.
        what: String,
    },
    /// It is whole, but its scene is no good, or cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
}

/// The version of a text that looks like a shared scene.
fn version(text: &str) -> Option<(&str, &str)> {
    let (version, body) = text.trim_start().strip_prefix(MARK)?.split_once(':')?;
    let number = !version.is_empty() && version.bytes().all(|byte| byte.is_ascii_digit());
    number.then_some((version, body))
}

/// Whether a text is meant to be a shared scene, whole or not.
#[must_use]
pub fn is_shared(text: &str) -> bool {
    version(text).is_some()
}

/// The text of a scene.
///
/// # Errors
/// [`ShareError::File`] if the scene cannot be spelled.
pub fn write(scenario: &Scenario) -> Result<String, ShareError> {
    seal(&file::write_short(scenario)?)
}

/// The text of the text of a scene file, whatever that says.
///
/// # Errors
/// [`ShareError::Damaged`] if it is too long.
pub fn seal(text: &str) -> Result<String, ShareError> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    let packed = encoder
        .write_all(text.as_bytes())
        .and_then(|()| encoder.finish())
        .map_err(|error| damaged(error.to_string()))?;
    let length = u32::try_from(packed.len()).map_err(|error| damaged(error.to_string()))?;
    let mut bytes = length.to_le_bytes().to_vec();
    bytes.extend(crc32fast::hash(&packed).to_le_bytes());
    bytes.extend(packed);
    Ok(format!("{MARK}{VERSION}:{}", URL_SAFE_NO_PAD.encode(bytes)))
}

fn damaged(what: impl Into<String>) -> ShareError {
    ShareError::Damaged { what: what.into() }
}

/// The scene of a text. Spaces and line breaks, as mails put them in, are passed over.
///
/// # Errors
/// [`ShareError`] with what is wrong.
pub fn read(text: &str) -> Result<Scenario, ShareError> {
    let Some((number, body)) = version(text) else {
        return Err(damaged(format!(
            "it does not begin with `{MARK}{VERSION}:`"
        )));
    };
    let number: u32 = number.parse().unwrap_or(u32::MAX);
    if number > VERSION {
        return Err(ShareError::Newer { version: number });
    }
    if number < VERSION {
        return Err(damaged(format!("there is no version {number}")));
    }
    let letters: String = body
        .chars()
        .filter(|letter| !letter.is_whitespace())
        .collect();
    let bytes = decoded(&letters)?;
    let Some((head, packed)) = bytes.split_at_checked(HEAD) else {
        return Err(ShareError::CutOff {
            found: bytes.len(),
            needed: HEAD,
        });
    };
    let four = |at: usize| u32::from_le_bytes([head[at], head[at + 1], head[at + 2], head[at + 3]]);
    let (length, sum) = (four(0) as usize, four(4));
    if packed.len() < length {
        return Err(ShareError::CutOff {
            found: packed.len(),
            needed: length,
        });
    }
    if packed.len() > length {
        return Err(damaged(format!(
            "{} bytes follow its end",
            packed.len() - length
        )));
    }
    if crc32fast::hash(packed) != sum {
        return Err(damaged("its sum does not match"));
    }
    let mut unpacked = Vec::new();
    DeflateDecoder::new(packed)
        .take(LARGEST + 1)
        .read_to_end(&mut unpacked)
        .map_err(|error| damaged(error.to_string()))?;
    if unpacked.len() as u64 > LARGEST {
        return Err(damaged(format!("it unpacks to more than {LARGEST} bytes")));
    }
    let text = String::from_utf8(unpacked).map_err(|error| damaged(error.to_string()))?;
    Ok(file::parse(&text, "shared text")?)
}

/// The bytes of the letters. A cut may leave one letter too many, which says nothing.
fn decoded(letters: &str) -> Result<Vec<u8>, ShareError> {
    if let Some(letter) = letters
        .chars()
        .find(|letter| !letter.is_ascii_alphanumeric() && !"-_".contains(*letter))
    {
        return Err(damaged(format!("`{letter}` is none of its letters")));
    }
    let whole = letters.len() - usize::from(letters.len() % 4 == 1);
    if let Ok(bytes) = URL_SAFE_NO_PAD.decode(&letters[..whole]) {
        return Ok(bytes);
    }
    // The last letter holds bits of a byte that is missing, or is mistyped; the length at the front tells which.
    let bytes = URL_SAFE_NO_PAD
        .decode(&letters[..whole - whole % 4])
        .unwrap_or_default();
    let length = bytes.get(..4).map_or(usize::MAX, |head| {
        u32::from_le_bytes([head[0], head[1], head[2], head[3]]) as usize
    });
    if bytes.len() < length.saturating_add(HEAD).saturating_sub(2) {
        Ok(bytes)
    } else {
        Err(damaged("its last letter is none that could end it"))
    }
}
