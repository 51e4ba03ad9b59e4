//! `masse list`.

use crate::cli::{CommandError, to_stdout};
use crate::scenarios::library;
use crate::scenarios::preset;

/// Names what is built in, one thing a line: the name, what it is, the title.
pub(super) fn list() -> Result<(), CommandError> {
    let mut rows = Vec::new();
    for scene in library::all() {
        rows.push((scene.name, "scene", scene.title()?));
    }
    for (kind, assets) in [("preset", preset::BUILT_IN), ("cloth", preset::CLOTHS)] {
        for asset in assets {
            rows.push((asset.name, kind, asset.title()?));
        }
    }
    let width = rows.iter().map(|row| row.0.len()).max().unwrap_or(0);
    to_stdout(|out| {
        rows.iter()
            .try_for_each(|(name, kind, title)| writeln!(out, "{name:width$}  {kind:6}  {title}"))
    })
}
