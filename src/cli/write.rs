//! `masse write`.

use std::path::Path;

use crate::cli::{CommandError, to_file};
use crate::scenarios::{file, library};

/// Writes a scene out in full.
pub(super) fn write(scene: &str, to: &Path) -> Result<(), CommandError> {
    let text = file::write(&library::open(scene)?)?;
    to_file(to, text.as_bytes())
}
