//! Files that a player keeps: scenes, matches, settings.
//!
//! Whatever happens, there is a whole file under a name, the old or the new; and what cannot be read is moved aside, never
//! overwritten.

mod shelf;

pub use shelf::{BadName, LONGEST_NAME, Shelf};

use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use thiserror::Error;

/// Most files that are put aside under one name.
const MOST_ASIDE: u32 = 10_000;

/// Why a text cannot be read.
#[derive(Debug, Error)]
pub enum Unread {
    /// The system does not let us, or there is none.
    #[error("cannot be read: {0}")]
    System(#[from] io::Error),
    /// It is longer than anything that was written here.
    #[error("{size} bytes are more than the {most} that it may have")]
    TooLong {
        /// How long it is, bytes.
        size: u64,
        /// How long it may be, bytes.
        most: u64,
    },
    /// It is no text.
    #[error("byte {0} is not UTF-8 text")]
    NotText(usize),
}

/// Reads a text of at most so many bytes.
///
/// # Errors
/// [`Unread`] says why not.
pub fn read(path: &Path, longest: u64) -> Result<String, Unread> {
    let mut bytes = Vec::new();
    let file = File::open(path)?;
    let told = file.metadata()?.len();
    file.take(longest + 1).read_to_end(&mut bytes)?;
    let read = bytes.len() as u64;
    if read > longest {
        return Err(Unread::TooLong {
            // What is no plain file has no length to tell.
            size: told.max(read),
            most: longest,
        });
    }
    String::from_utf8(bytes).map_err(|error| Unread::NotText(error.utf8_error().valid_up_to()))
}

/// Writes a file as [`write()`] does. The folder is made if it is not there.
///
/// # Errors
/// [`io::Error`] if it cannot be written; the file is then as it was.
pub fn replace(path: &Path, content: impl AsRef<[u8]>) -> io::Result<()> {
    fs::create_dir_all(folder_of(path))?;
    write(path, content)
}

/// Writes beside a file, and puts that in the place of the file once it is safe on the disk. A link is followed, and what
/// is no file, as a terminal or a pipe, is written to as it is.
///
/// # Errors
/// [`io::Error`] if it cannot be written; the file is then as it was.
pub fn write(path: &Path, content: impl AsRef<[u8]>) -> io::Result<()> {
    let known = fs::metadata(path).ok();
    if known.as_ref().is_some_and(|known| !known.is_file()) {
        return fs::write(path, content);
    }
    let path = &fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let beside = beside(path)?;
    if let Some(known) = known {
        beside.as_file().set_permissions(known.permissions())?;
    }
    beside.as_file().write_all(content.as_ref())?;
    beside.as_file().sync_all()?;
    beside.persist(path).map_err(|error| error.error)?;
    sync(folder_of(path));
    Ok(())
}

/// Writes a file under the first of the numbered names, from this number on, that nothing has yet, and gives that. The
/// folder is made if it is not there.
///
/// # Errors
/// [`io::Error`] if it cannot be written, or every name is taken; nothing is left behind then.
pub fn add(
    folder: &Path,
    from: u32,
    name: impl Fn(u32) -> String,
    content: impl AsRef<[u8]>,
) -> io::Result<PathBuf> {
    fs::create_dir_all(folder)?;
    let mut aside = beside(&folder.join(name(from)))?;
    aside.as_file().write_all(content.as_ref())?;
    aside.as_file().sync_all()?;
    for number in from.. {
        let path = folder.join(name(number));
        match aside.persist_noclobber(&path) {
            Ok(_) => {
                sync(folder);
                return Ok(path);
            }
            Err(taken) if taken.error.kind() == io::ErrorKind::AlreadyExists => aside = taken.file,
            Err(error) => return Err(error.error),
        }
    }
    Err(io::Error::other("every number is taken"))
}

/// An empty file beside another, that others may read as far as the user lets them: temporary files by themselves are for
/// one alone.
fn beside(path: &Path) -> io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    // Whoever finds one after a crash sees whose it is.
    builder.prefix(".masse-").suffix(".part");
    #[cfg(unix)]
    let builder = builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder_of(path)).map_err(plain)
}

/// Makes a renaming last. Not every platform can sync a folder; the file itself is safe in any case.
fn sync(folder: &Path) {
    if let Ok(opened) = File::open(folder) {
        let _ = opened.sync_all();
    }
}

/// What the system says, without the name of the file beside, which nobody knows.
fn plain(error: io::Error) -> io::Error {
    use io::ErrorKind::{
        NotADirectory, PermissionDenied, QuotaExceeded, ReadOnlyFilesystem, StorageFull,
    };
    match error.kind() {
        kind @ (NotADirectory | PermissionDenied | QuotaExceeded | ReadOnlyFilesystem
        | StorageFull) => kind.into(),
        _ => error,
    }
}

/// Renames a file to the first of the numbered names that nothing has yet, and gives that.
///
/// # Errors
/// [`io::Error`] if it cannot be renamed, or every name is taken.
pub fn put_aside(path: &Path, name: impl Fn(u32) -> String) -> io::Result<PathBuf> {
    let free = (1..MOST_ASIDE)
        .map(|number| folder_of(path).join(name(number)))
        .find(|aside| fs::symlink_metadata(aside).is_err());
    let aside = free.ok_or_else(|| io::Error::other("too many files lie there already"))?;
    fs::rename(path, &aside)?;
    Ok(aside)
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_as_a_whole_and_read_again_up_to_a_length() {
        let folder = tempfile::tempdir().expect("a folder for a test");
        let path = folder.path().join("new folder").join("file");
        for text in ["first", "zweite Fassung", ""] {
            replace(&path, text).expect("it is writable");
            assert_eq!(read(&path, 15).expect("it is there"), text);
        }
        replace(&path, "0123456789").expect("it is writable");
        let long = read(&path, 7).expect_err("it is too long");
        assert!(matches!(long, Unread::TooLong { size: 10, most: 7 }));
        assert!(long.to_string().contains("10 bytes are more than the 7"));
        fs::write(&path, [b'a', 0xff]).expect("it is writable");
        assert!(matches!(read(&path, 9), Err(Unread::NotText(1))));
        fs::remove_file(&path).expect("it is there");
        assert!(matches!(read(&path, 9), Err(Unread::System(_))));
        // Nothing else is left behind.
        let left = fs::read_dir(folder_of(&path)).expect("it is there").count();
        assert_eq!(left, 0);
    }

    #[test]
    fn a_file_that_is_replaced_keeps_its_link_and_who_may_read_it() {
        let folder = tempfile::tempdir().expect("a folder for a test");
        let path = folder.path().join("file");
        fs::write(&path, "old").expect("it is writable");
        #[cfg(unix)]
        {
            use std::os::unix::fs::{PermissionsExt, symlink};
            let link = folder.path().join("link");
            symlink(&path, &link).expect("links can be made");
            let mode = |mode| fs::Permissions::from_mode(mode);
            fs::set_permissions(&path, mode(0o640)).expect("it is ours");
            write(&link, "new").expect("it is writable");
            let link = fs::symlink_metadata(&link).expect("it is there");
            assert!(link.is_symlink(), "it is a link still");
            let known = fs::metadata(&path).expect("it is there");
            assert_eq!(known.permissions().mode() & 0o777, 0o640);
        }
        write(&path, "new").expect("it is writable");
        assert_eq!(fs::read_to_string(&path).expect("it is there"), "new");
        // A folder is no file: nothing is put in its place.
        assert!(write(folder.path(), "new").is_err());
        assert!(folder.path().is_dir());
        // Without a folder there is no file either.
        assert!(write(&folder.path().join("none/file"), "new").is_err());
    }

    #[test]
    fn what_is_put_aside_takes_a_name_that_is_free() {
        let folder = tempfile::tempdir().expect("a folder for a test");
        let path = folder.path().join("file");
        let mut seen = Vec::new();
        for text in ["one", "two"] {
            fs::write(&path, text).expect("it is writable");
            let aside = put_aside(&path, |number| format!("aside {number}")).expect("a name");
            assert_eq!(fs::read_to_string(&aside).expect("it is there"), text);
            assert!(!path.exists() && !seen.contains(&aside));
            seen.push(aside);
        }
    }
}
