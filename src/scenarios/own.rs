//! The scenes that a player has saved: a folder of scene files.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::{fs, io};

use thiserror::Error;

use crate::scenarios::file::{self, FileError, Scenario};

/// How the files end.
const EXTENSION: &str = "ron";

/// Most letters of a name.
const LONGEST: usize = 100;

/// Why a scene cannot be saved.
#[derive(Debug, Error)]
pub enum OwnError {
    /// The name cannot be that of a file everywhere.
    #[error(
        "`{name}` cannot be the name of a scene: 1 to {LONGEST} letters, digits, spaces, `-` and `_`"
    )]
    Name {
        /// The name given.
        name: String,
    },
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
pub struct Own {
    folder: PathBuf,
}

impl Own {
    /// Where this platform keeps the data of programs; `None` if it has no such place.
    #[must_use]
    pub fn of_platform() -> Option<Self> {
        let folders = directories::ProjectDirs::from("", "", "masse")?;
        Some(Self::in_folder(folders.data_dir().join("scenes")))
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

    /// The file of the scene with this name.
    ///
    /// # Errors
    /// [`OwnError::Name`] if that cannot be the name of a file everywhere.
    pub fn path(&self, name: &str) -> Result<PathBuf, OwnError> {
        let allowed = |letter: char| letter.is_alphanumeric() || " -_".contains(letter);
        let short = (1..=LONGEST).contains(&name.chars().count());
        if !short || !name.chars().all(allowed) || name.trim() != name {
            let name = name.to_owned();
            return Err(OwnError::Name { name });
        }
        Ok(self.folder.join(format!("{name}.{EXTENSION}")))
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
        let failed = |source| {
            let file = file.clone();
            OwnError::Write { file, source }
        };
        fs::create_dir_all(&self.folder).map_err(failed)?;
        let mut beside = tempfile::NamedTempFile::new_in(&self.folder).map_err(failed)?;
        beside.write_all(text.as_bytes()).map_err(failed)?;
        beside.as_file().sync_all().map_err(failed)?;
        beside.persist(&path).map_err(|error| failed(error.error))?;
        Ok(path)
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
