//! A folder of files of one kind, each with a name that a player gave it.

use std::fs;
use std::path::{Path, PathBuf};

use thiserror::Error;

/// Most letters of a name.
pub const LONGEST_NAME: usize = 100;

/// A name that cannot be that of a file everywhere.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error(
    "`{0}` cannot be the name of a file: 1 to {LONGEST_NAME} letters, digits, spaces, `-` and `_`"
)]
pub struct BadName(pub String);

/// A folder of files that end alike.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shelf {
    folder: PathBuf,
    ending: &'static str,
}

impl Shelf {
    /// The folder of this name where the platform keeps the data of programs; `None` if it has no such place.
    #[must_use]
    pub fn of_platform(name: &str, ending: &'static str) -> Option<Self> {
        let folders = directories::ProjectDirs::from("", "", "masse")?;
        Some(Self::in_folder(folders.data_dir().join(name), ending))
    }

    /// This folder; it need not be there yet.
    #[must_use]
    pub fn in_folder(folder: impl Into<PathBuf>, ending: &'static str) -> Self {
        Self {
            folder: folder.into(),
            ending,
        }
    }

    /// The folder.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The name of the file of what has this name.
    #[must_use]
    pub fn file_name(&self, name: &str) -> String {
        format!("{name}.{}", self.ending)
    }

    /// The file of what has this name.
    ///
    /// # Errors
    /// [`BadName`] if that cannot be the name of a file everywhere.
    pub fn path(&self, name: &str) -> Result<PathBuf, BadName> {
        let allowed = |letter: char| letter.is_alphanumeric() || " -_".contains(letter);
        let short = (1..=LONGEST_NAME).contains(&name.chars().count());
        if !short || !name.chars().all(allowed) || name.trim() != name {
            return Err(BadName(name.to_owned()));
        }
        Ok(self.folder.join(self.file_name(name)))
    }

    /// The names of what is kept here, in order.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.folder).into_iter().flatten().flatten();
        let mut names: Vec<String> = entries
            .map(|entry| entry.path())
            .filter(|path| path.extension().is_some_and(|end| end == self.ending))
            .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
            .collect();
        names.sort();
        names
    }
}
