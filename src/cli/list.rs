//! `masse list`.

use crate::cli::{CommandError, to_stdout};
use crate::scenarios::library::BUILT_IN;

/// Names the built-in scenes, one a line: the name, then the title.
pub(super) fn list() -> Result<(), CommandError> {
    let width = BUILT_IN
        .iter()
        .map(|scene| scene.name.len())
        .max()
        .unwrap_or(0);
    let mut lines = Vec::new();
    for scene in BUILT_IN {
        lines.push(format!("{:width$}  {}", scene.name, scene.title()?));
    }
    to_stdout(|out| lines.iter().try_for_each(|line| writeln!(out, "{line}")))
}
