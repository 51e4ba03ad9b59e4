//! Presets: table, laws, balls and cue in one file, each number with its source, to play with as they are or to copy and
//! edit.
//!
//! ```ron
//! (
//!     title: "My table",
//!     base: "snooker",                        // another preset that this one changes; without it every default is pool
//!     table: NineFoot,                        // as in a scene file
//!     cloth: "fast",                          // medium, slow, or a cloth file
//!     laws: Custom(cushion: Mirror(restitution: 0.8)),
//!     ball: (mass: 0.17, radius: 0.028575),
//!     cue_ball: (mass: 0.19),                 // what is different about the ball named `cue`
//!     cue: (tip: Phenolic, mass: 0.54),
//!     set: {"laws.motion.rolling": 0.008},    // single numbers, over all that stands above
//! )
//! ```
//!
//! Everything may be left out. A number outside its physical range is refused with the file, the field, the value, the
//! range and the source of the range.

mod cue;
mod numbers;
mod outfit;

pub(in crate::scenarios) use cue::CueEntry;
pub(in crate::scenarios) use numbers::set_in_scene;
pub(in crate::scenarios) use outfit::{Outfit, located};

use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::physics::equipment::Equipment;
use crate::physics::laws::Check;
use crate::physics::laws::motion::Cloth;
use crate::physics::scene::check_parameter;
use crate::scenarios::file::{FieldError, FileError, LayoutError, spelled, text_of};

/// A preset.
#[derive(Clone, Debug, PartialEq)]
pub struct Preset {
    /// One line.
    pub title: String,
    /// What it is good for; may be empty.
    pub description: String,
    /// What is played with, checked.
    pub equipment: Equipment,
    /// Files that it is made of, its own first; none of a built-in preset that names no file. What to watch for changes.
    pub files: Vec<PathBuf>,
}

/// A preset or a cloth that is built in.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// What files and commands call it.
    pub name: &'static str,
    /// Its RON, with the sources of the numbers.
    pub text: &'static str,
}

/// A line of the lists below: the name of a file in `assets`.
macro_rules! asset {
    ($folder:literal, $name:literal) => {
        BuiltIn {
            name: $name,
            text: include_str!(concat!("../../../assets/", $folder, "/", $name, ".ron")),
        }
    };
}

/// Every built-in preset, in the order in which they are listed.
pub const BUILT_IN: &[BuiltIn] = &[
    asset!("presets", "pool"),
    asset!("presets", "bar_box"),
    asset!("presets", "snooker"),
    asset!("presets", "heated_carom"),
];

/// Every built-in cloth, from fast to slow.
pub const CLOTHS: &[BuiltIn] = &[
    asset!("cloths", "fast"),
    asset!("cloths", "medium"),
    asset!("cloths", "slow"),
];

/// Longest chain of presets made from each other.
const LONGEST_CHAIN: usize = 8;

impl BuiltIn {
    /// One line about it.
    ///
    /// # Errors
    /// [`FileError::Syntax`] if its text is no good; a test holds that none is.
    pub fn title(&self) -> Result<String, FileError> {
        #[derive(Deserialize)]
        struct Titled {
            title: String,
        }
        spelled(self.text, self.name).map(|Titled { title }| title)
    }

    /// The preset.
    ///
    /// # Errors
    /// [`FileError`] if its text is no good; a test holds that none is.
    pub fn preset(&self) -> Result<Preset, FileError> {
        parse(self.text, self.name)
    }
}

/// The preset that a person calls by this name: a built-in one, else a file.
///
/// # Errors
/// [`FileError`] with the names that are known, or with what is wrong in the file.
pub fn open(name: &str) -> Result<Preset, FileError> {
    outfit::find(name, Path::new(""), LONGEST_CHAIN).map_err(|error| error.in_file("command line"))
}

/// Reads and checks a preset file.
///
/// # Errors
/// [`FileError`] if it cannot be read, is not a preset file or has a number outside its range.
pub fn read(path: &Path) -> Result<Preset, FileError> {
    outfit::read(path, LONGEST_CHAIN)
}

/// Reads and checks the text of a preset file; `file` is what errors call it.
///
/// # Errors
/// [`FileError`] if the text is not a preset file or has a number outside its range.
pub fn parse(text: &str, file: &str) -> Result<Preset, FileError> {
    outfit::parse(text, file, LONGEST_CHAIN)
}

/// The cloth that a person calls by this name: a built-in one, else a file. Its gravity is the Earth's.
///
/// # Errors
/// [`FileError`] with the names that are known, or with what is wrong in the file.
pub fn cloth(name: &str) -> Result<Cloth, FileError> {
    cloth_in(name, Path::new(""))
        .map(|(cloth, _)| cloth)
        .map_err(|error| error.in_file("command line"))
}

/// The friction of a cloth as a file names it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename = "Cloth")]
struct ClothFile {
    #[serde(default)]
    #[expect(dead_code, reason = "read by the list of cloths")]
    title: String,
    sliding: f64,
    rolling: f64,
    spin_deceleration: f64,
}

/// A cloth and the file it is in.
fn cloth_in(name: &str, folder: &Path) -> Result<(Cloth, Option<PathBuf>), LayoutError> {
    let built_in = CLOTHS.iter().find(|cloth| cloth.name == name);
    let (text, file, path) = match (built_in, path_of(name, folder)) {
        (Some(cloth), _) => (cloth.text.to_owned(), name.to_owned(), None),
        (None, Some(path)) => (text_of(&path)?, path.display().to_string(), Some(path)),
        (None, None) => return Err(unknown("cloth", "cloth", name, CLOTHS).into()),
    };
    let read: ClothFile = spelled(&text, &file)?;
    let cloth = Cloth {
        sliding: read.sliding,
        rolling: read.rolling,
        spin_deceleration: read.spin_deceleration,
        ..Cloth::default()
    };
    for parameter in cloth.parameters() {
        check_parameter(&parameter).map_err(|error| LayoutError::from(error).in_file(&file))?;
    }
    Ok((cloth, path))
}

/// The file that a name means: what looks like a file is one, beside the file that names it if it is there.
fn path_of(name: &str, folder: &Path) -> Option<PathBuf> {
    let path = Path::new(name);
    let beside = folder.join(path);
    if beside.is_file() {
        return Some(beside);
    }
    let looks_like_a_file = path.components().count() > 1 || path.extension().is_some();
    (looks_like_a_file || path.is_file()).then(|| path.to_owned())
}

fn unknown(
    field: &'static str,
    what: &'static str,
    name: &str,
    built_in: &[BuiltIn],
) -> FieldError {
    let known: Vec<&str> = built_in.iter().map(|asset| asset.name).collect();
    FieldError::Unknown {
        field,
        what,
        name: name.to_owned(),
        known: known.join(", "),
    }
}
