//! `masse picture`.

use std::path::Path;

use crate::cli::{CommandError, to_file};
use crate::report::{picture, record_file};

/// Draws the picture of a run that was written to a file.
pub(super) fn draw(record: &Path, to: &Path) -> Result<(), CommandError> {
    let run = record_file::read(record)?;
    let text = picture::draw(&run.title, &run.scene, &run.record);
    to_file(to, text.as_bytes())
}
