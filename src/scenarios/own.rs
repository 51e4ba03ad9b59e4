//! The scenes that a player has saved: a folder of scene files.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::kept::{self, BadName, Shelf};
use crate::scenarios::file::{self, FileError, Scenario};

/// Why a scene cannot be saved.
#[derive(Debug, Error)]
pub enum OwnError {
    /// The name cannot be that of a file everywhere.
    #[error(transparent)]
    Name(#[from] BadName),
    /// What should be saved is no good.
    #[error(transparent)]
    File(#[from] FileError),
    /// The file cannot be written.
    #[error("{file}: {source}")]
    Write {
        /// The file.
        file: String,
        /// Why.
        source: io::Error,
    },
}

/// A folder of saved scenes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Own(Shelf);

impl Own {
    /// Where this platform keeps the data of programs; `None` if it has no such place.
    #[must_use]
    pub fn of_platform() -> Option<Self> {
        Shelf::of_platform("scenes", "ron").map(Self)
    }

    /// In this folder; it need not be there yet.
    #[must_use]
    pub fn in_folder(folder: impl Into<PathBuf>) -> Self {
        Self(Shelf::in_folder(folder, "ron"))
    }

    /// The folder.
    #[must_use]
    pub fn folder(&self) -> &Path {
        self.0.folder()
    }

    /// The file of the scene with this name.
    ///
    /// # Errors
    /// [`OwnError::Name`] if that cannot be the name of a file everywhere.
    pub fn path(&self, name: &str) -> Result<PathBuf, OwnError> {
        Ok(self.0.path(name)?)
    }

    /// Saves a scene under a name, in place of what was saved under it. What cannot be read again is not written.
    ///
    /// # Errors
    /// [`OwnError`]; what was saved under the name before is then still there.
    pub fn save(&self, name: &str, scenario: &Scenario) -> Result<PathBuf, OwnError> {
        let path = self.path(name)?;
        let file = path.display().to_string();
        let text = file::write(scenario)?;
        file::parse(&text, &file)?;
        kept::replace(&path, &text).map_err(|source| OwnError::Write { file, source })?;
        Ok(path)
    }

    /// The names of what is saved here, in order.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        self.0.names()
    }
}
