//! The file of the settings: RON, with the number of its form in it.
//!
//! Nothing that a person may have written is ever overwritten unread: a file that is no good, or newer than this program,
//! is renamed and stays.

use std::io;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use thiserror::Error;

use super::Settings;
use crate::game::volume::SoundKind;
use crate::kept::{self, Unread};

/// The form of the file that this program writes.
pub const VERSION: u32 = 1;

/// Longest file that is read, in bytes.
const LONGEST: u64 = 1 << 20;

/// What is wrong with a file of settings.
#[derive(Debug, Error)]
pub enum SettingsError {
    /// It cannot be read, or is no text.
    #[error(transparent)]
    Read(#[from] Unread),
    /// It is no RON, or has a field or a value that is unknown.
    #[error("{0}")]
    Syntax(ron::error::SpannedError),
    /// It was written by a later program.
    #[error("version: {0} is newer than {VERSION}, the newest that this program knows")]
    TooNew(u32),
    /// It has a number that no form has.
    #[error("version: {0} is no version of the settings")]
    NoVersion(u32),
    /// A number is out of range.
    #[error("{field}: {value} is not between {least} and {most}")]
    Range {
        /// Which number.
        field: &'static str,
        /// What it is.
        value: f32,
        /// The smallest it may be.
        least: f32,
        /// The largest it may be.
        most: f32,
    },
}

/// The settings that a text holds.
///
/// # Errors
/// [`SettingsError`] says what is wrong and where.
pub fn parse(text: &str) -> Result<Settings, SettingsError> {
    #[derive(Deserialize)]
    struct Versioned {
        version: u32,
    }
    let Versioned { version } = ron::from_str(text).map_err(SettingsError::Syntax)?;
    match version {
        VERSION => {}
        0 => return Err(SettingsError::NoVersion(version)),
        _ => return Err(SettingsError::TooNew(version)),
    }
    let settings: Settings = ron::from_str(text).map_err(SettingsError::Syntax)?;
    check(&settings)?;
    Ok(settings)
}

fn check(settings: &Settings) -> Result<(), SettingsError> {
    let within = |field, value: f32, least: f32, most: f32| {
        if (least..=most).contains(&value) {
            Ok(())
        } else {
            Err(SettingsError::Range {
                field,
                value,
                least,
                most,
            })
        }
    };
    let scales = Settings::SCALES;
    within("scale", settings.scale, *scales.start(), *scales.end())?;
    let mut volume = settings.volume;
    within("volume.level", volume.level, 0.0, 1.0)?;
    for kind in SoundKind::ALL {
        let field = match kind {
            SoundKind::Balls => "volume.balls",
            SoundKind::Cushions => "volume.cushions",
            SoundKind::Pockets => "volume.pockets",
            SoundKind::Cue => "volume.cue",
            SoundKind::Rolling => "volume.rolling",
            SoundKind::Interface => "volume.interface",
        };
        within(field, *volume.of(kind), 0.0, 1.0)?;
    }
    Ok(())
}

/// A file that was no good.
#[derive(Debug)]
pub struct Damage {
    /// What is wrong with it.
    pub error: SettingsError,
    /// Where it is kept now, or why it could not be moved out of the way: then it must not be written over.
    pub kept: io::Result<PathBuf>,
}

/// The settings of a file: defaults if there is none, and if it is no good, which then is put aside.
#[must_use]
pub fn load(path: &Path) -> (Settings, Option<Damage>) {
    match read(path) {
        Ok(settings) => (settings.unwrap_or_default(), None),
        Err(error) => {
            let kept = put_aside(path);
            (Settings::default(), Some(Damage { error, kept }))
        }
    }
}

fn read(path: &Path) -> Result<Option<Settings>, SettingsError> {
    match kept::read(path, LONGEST) {
        Ok(text) => parse(&text).map(Some),
        Err(Unread::System(error)) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(why) => Err(why.into()),
    }
}

/// Renames a file to a name that nothing has yet.
fn put_aside(path: &Path) -> io::Result<PathBuf> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    kept::put_aside(path, |number| format!("{name}.damaged-{number}"))
}

/// Writes the settings beside the file and puts them in its place.
///
/// # Errors
/// [`io::Error`] if the folder cannot be made or written to. The old file is then as it was.
pub fn save(path: &Path, settings: &Settings) -> io::Result<()> {
    let text = ron::ser::to_string_pretty(settings, ron::ser::PrettyConfig::default())
        .map_err(io::Error::other)?;
    kept::replace(path, format!("{text}\n"))
}

/// Where this platform keeps the settings of a program; none if it does not say.
#[must_use]
pub fn place() -> Option<PathBuf> {
    let folders = directories::ProjectDirs::from("", "", "masse")?;
    Some(folders.config_dir().join("settings.ron"))
}
