//! `masse share`.

use crate::cli::{CommandError, to_stdout};
use crate::scenarios::{library, share};

/// Prints a scene as a text that can be pasted.
pub(super) fn share(name: &str) -> Result<(), CommandError> {
    let text = share::write(&library::open(name)?)?;
    to_stdout(|out| writeln!(out, "{text}"))
}
