//! `masse write`.

use std::path::Path;

use crate::cli::{CommandError, to_file};
use crate::scenarios::{file, library, preset};

/// Writes out what has this name, to be changed: a scene in full, a preset or a cloth as it is, with the sources of its
/// numbers.
pub(super) fn write(name: &str, to: &Path) -> Result<(), CommandError> {
    let built_in = preset::BUILT_IN.iter().chain(preset::CLOTHS);
    if let Some(asset) = built_in.into_iter().find(|asset| asset.name == name) {
        return to_file(to, asset.text.as_bytes());
    }
    let text = file::write(&library::open(name)?)?;
    to_file(to, text.as_bytes())
}
