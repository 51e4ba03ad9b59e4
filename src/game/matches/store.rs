//! The folder of saved matches.
//!
//! A file that is damaged, or that a newer program wrote, is never replaced: it is put aside first.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::game::matches::Match;
use crate::game::matches::saved::{self, SavedError};
use crate::kept::{self, BadName, Shelf};

/// The name of the match that is saved by itself after every shot.
pub const AUTOSAVE: &str = "autosave";

/// What saved matches end on.
const EXTENSION: &str = "masse";

/// Largest file that is read, bytes.
const LARGEST: u64 = 1 << 28;

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
    #[error("name: {0}")]
    Name(#[from] BadName),
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
pub struct Store(Shelf);

impl Store {
    /// Where this platform keeps the data of programs; `None` if it has no such place.
    #[must_use]
    pub fn of_platform() -> Option<Self> {
        Shelf::of_platform("matches", EXTENSION).map(Self)
    }

    /// In this folder; it need not be there yet.
    #[must_use]
    pub fn in_folder(folder: impl Into<PathBuf>) -> Self {
        Self(Shelf::in_folder(folder, EXTENSION))
    }

    /// The folder.
    #[must_use]
    pub fn folder(&self) -> &Path {
        self.0.folder()
    }

    /// The file of the match with this name.
    ///
    /// # Errors
    /// [`StoreError::Name`] if that cannot be the name of a file everywhere.
    pub fn path(&self, name: &str) -> Result<PathBuf, StoreError> {
        Ok(self.0.path(name)?)
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
        let put_aside = self.put_aside(name, &path)?;
        kept::replace(&path, &text).map_err(|source| StoreError::Write { file, source })?;
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
        let named = |number| self.0.file_name(&format!("{name} {kind} {number}"));
        let aside =
            kept::put_aside(path, named).map_err(|source| StoreError::Write { file, source })?;
        Ok(Some((aside, why)))
    }

    /// Reads the match with this name.
    ///
    /// # Errors
    /// [`SavedError`] with the file, the field and the value. The file stays as it is.
    pub fn load(&self, name: &str) -> Result<Match, SavedError> {
        load(&self.folder().join(self.0.file_name(name)))
    }

    /// The names of what is saved here, in order.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        self.0.names()
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
    kept::read(path, LARGEST).map_err(|why| SavedError::Read {
        file: path.display().to_string(),
        why,
    })
}
