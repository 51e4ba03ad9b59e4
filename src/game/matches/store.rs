//! The folder of saved matches.
//!
//! A save is written beside, synced, and then renamed over the old one: whatever happens, there is a whole file under the
//! name, the old or the new. A file that is damaged, or that a newer program wrote, is never replaced: it is renamed aside
//! first.

use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::game::matches::Match;
use crate::game::matches::saved::{self, SavedError};

/// The name of the match that is saved by itself after every shot.
pub const AUTOSAVE: &str = "autosave";

/// What saved matches end on.
const EXTENSION: &str = "masse";

/// Largest file that is read, bytes.
const LARGEST: u64 = 1 << 28;

/// Most files that are put aside under one name.
const MOST_ASIDE: u32 = 10_000;

/// Why a match is not saved.
#[derive(Debug, Error)]
pub enum StoreError {
    /// The file cannot be written.
    #[error("{file}: cannot be written: {source}")]
    Write {
        /// The file or the folder.
        file: String,
        /// What the system says.
        source: io::Error,
    },
    /// A number of the match is not finite.
    #[error("{file}: the match cannot be written: {source}")]
    Numbers {
        /// The file.
        file: String,
        /// What cannot be written.
        source: serde_json::Error,
    },
    /// A name that cannot be that of a file everywhere.
    #[error(
        "name: `{name}` cannot name a saved match: use letters, digits, spaces, `-` and `_`, at most 100"
    )]
    Name {
        /// The name.
        name: String,
    },
}

/// A match that was saved.
#[derive(Debug)]
pub struct Saved {
    /// Where.
    pub path: PathBuf,
    /// The file that lay there and could not be replaced: where it is now, and why.
    pub put_aside: Option<(PathBuf, SavedError)>,
}

/// A folder of saved matches.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Store {
    folder: PathBuf,
}

impl Store {
    /// Where this platform keeps the data of programs; `None` if it has no such place.
    #[must_use]
    pub fn of_platform() -> Option<Self> {
        let folders = directories::ProjectDirs::from("", "", "masse")?;
        Some(Self::in_folder(folders.data_dir().join("matches")))
    }

    /// In this folder; it need not be there yet.
    #[must_use]
    pub fn in_folder(folder: impl Into<PathBuf>) -> Self {
        Self {
            folder: folder.into(),
        }
    }

    /// The folder.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The file of the match with this name.
    ///
    /// # Errors
    /// [`StoreError::Name`] if that cannot be the name of a file everywhere.
    pub fn path(&self, name: &str) -> Result<PathBuf, StoreError> {
        let allowed = |letter: char| letter.is_alphanumeric() || " -_".contains(letter);
        let short = (1..=100).contains(&name.chars().count());
        if !short || !name.chars().all(allowed) || name.trim() != name {
            let name = name.to_owned();
            return Err(StoreError::Name { name });
        }
        Ok(self.folder.join(format!("{name}.{EXTENSION}")))
    }

    /// Saves a match under a name.
    ///
    /// # Errors
    /// [`StoreError`]; what was saved under the name before is then still there.
    pub fn save(&self, name: &str, game: &Match) -> Result<Saved, StoreError> {
        let path = self.path(name)?;
        let file = path.display().to_string();
        let text = saved::text(game).map_err(|source| {
            let file = file.clone();
            StoreError::Numbers { file, source }
        })?;
        let write = |source| {
            let file = file.clone();
            StoreError::Write { file, source }
        };
        fs::create_dir_all(&self.folder).map_err(write)?;
        let put_aside = self.put_aside(name, &path)?;
        let mut beside = tempfile::NamedTempFile::new_in(&self.folder).map_err(write)?;
        beside.write_all(text.as_bytes()).map_err(write)?;
        beside.as_file().sync_all().map_err(write)?;
        beside.persist(&path).map_err(|error| write(error.error))?;
        sync_folder(&self.folder);
        Ok(Saved { path, put_aside })
    }

    /// Saves a match as the one to go on with.
    ///
    /// # Errors
    /// As [`Self::save`].
    pub fn autosave(&self, game: &Match) -> Result<Saved, StoreError> {
        self.save(AUTOSAVE, game)
    }

    /// Moves what lies under a name out of the way if it may not be replaced.
    fn put_aside(
        &self,
        name: &str,
        path: &Path,
    ) -> Result<Option<(PathBuf, SavedError)>, StoreError> {
        let file = path.display().to_string();
        if !path.exists() {
            return Ok(None);
        }
        let Err(why) = text_of(path).and_then(|text| saved::check_replaceable(&text, &file)) else {
            return Ok(None);
        };
        let kind = match why {
            SavedError::Newer { .. } => "newer",
            _ => "damaged",
        };
        let free = (1..MOST_ASIDE)
            .map(|number| {
                self.folder
                    .join(format!("{name} {kind} {number}.{EXTENSION}"))
            })
            .find(|aside| !aside.exists());
        let failed = |source| {
            let file = file.clone();
            StoreError::Write { file, source }
        };
        let aside = free.ok_or_else(|| failed(io::ErrorKind::AlreadyExists.into()))?;
        fs::rename(path, &aside).map_err(failed)?;
        Ok(Some((aside, why)))
    }

    /// Reads the match with this name.
    ///
    /// # Errors
    /// [`SavedError`] with the file, the field and the value. The file stays as it is.
    pub fn load(&self, name: &str) -> Result<Match, SavedError> {
        let path = self.folder.join(format!("{name}.{EXTENSION}"));
        load(&path)
    }

    /// The names of what is saved here, in order.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.folder).into_iter().flatten().flatten();
        let mut names: Vec<String> = entries
            .map(|entry| entry.path())
            .filter(|path| path.extension().is_some_and(|end| end == EXTENSION))
            .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
            .collect();
        names.sort();
        names
    }
}

/// Reads a saved match.
///
/// # Errors
/// [`SavedError`] with the file, the field and the value.
pub fn load(path: &Path) -> Result<Match, SavedError> {
    saved::parse(&text_of(path)?, &path.display().to_string())
}

fn text_of(path: &Path) -> Result<String, SavedError> {
    let file = path.display().to_string();
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|opened| opened.take(LARGEST + 1).read_to_end(&mut bytes))
        .map_err(|source| SavedError::Read {
            file: file.clone(),
            source,
        })?;
    if bytes.len() as u64 > LARGEST {
        let most = LARGEST;
        return Err(SavedError::TooLarge { file, most });
    }
    String::from_utf8(bytes).map_err(|error| SavedError::NotText {
        file,
        byte: error.utf8_error().valid_up_to(),
    })
}

/// Makes a rename last. Not every platform can sync a folder; the file itself is synced in any case.
fn sync_folder(folder: &Path) {
    if let Ok(opened) = File::open(folder) {
        let _ = opened.sync_all();
    }
}
