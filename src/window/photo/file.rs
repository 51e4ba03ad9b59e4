//! Where photos are kept: as PNG files in the folder that the platform has for pictures, one number after the other.

use std::fs;
use std::io::{self, Cursor};
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::kept;

/// Why a photo was not kept.
#[derive(Debug, Error)]
pub(super) enum PhotoError {
    /// The platform names no folder, nor a home.
    #[error("this system names no folder for pictures")]
    NoFolder,
    /// The folder cannot be made or written to.
    #[error("{}: {error}", folder.display())]
    Write {
        /// Where.
        folder: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// The picture cannot be packed.
    #[error("{0}")]
    Pack(#[from] image::ImageError),
}

/// The folder for pictures.
pub(super) fn folder() -> Result<PathBuf, PhotoError> {
    let user = directories::UserDirs::new().ok_or(PhotoError::NoFolder)?;
    let folder = user
        .picture_dir()
        .map_or_else(|| user.home_dir().join("Pictures"), Path::to_path_buf);
    Ok(folder.join("masse"))
}

/// Writes a picture under a name that nothing has yet, and says which. `rgba` is four bytes a pixel, row by row.
pub(super) fn keep(
    folder: &Path,
    (width, height): (u32, u32),
    rgba: &[u8],
) -> Result<PathBuf, PhotoError> {
    let failed = |error| PhotoError::Write {
        folder: folder.to_path_buf(),
        error,
    };
    let mut packed = Cursor::new(Vec::new());
    let rgb: Vec<u8> = rgba
        .chunks_exact(4)
        .flat_map(|pixel| [pixel[0], pixel[1], pixel[2]])
        .collect();
    image::write_buffer_with_format(
        &mut packed,
        &rgb,
        width,
        height,
        image::ExtendedColorType::Rgb8,
        image::ImageFormat::Png,
    )?;
    let name = |number| format!("masse-{number:04}.png");
    kept::add(folder, next(folder), name, packed.get_ref()).map_err(failed)
}

/// The number after the largest that is there.
fn next(folder: &Path) -> u32 {
    let number = |entry: fs::DirEntry| {
        let name = entry.file_name();
        let digits = name
            .to_str()?
            .strip_prefix("masse-")?
            .strip_suffix(".png")?;
        digits.parse::<u32>().ok()
    };
    fs::read_dir(folder)
        .into_iter()
        .flatten()
        .filter_map(|entry| number(entry.ok()?))
        .max()
        .map_or(1, |last| last.saturating_add(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_photo_overwrites_another() {
        let folder = tempfile::tempdir().expect("a folder for a test");
        let pixels = |shade: u8| vec![shade; 4 * 6];
        let first = keep(folder.path(), (3, 2), &pixels(10)).expect("it is writable");
        let old = fs::read(&first).expect("it is there");
        let second = keep(folder.path(), (3, 2), &pixels(200)).expect("it is writable");
        assert_ne!(first, second);
        assert_eq!(fs::read(&first).expect("it is there"), old);
        assert_ne!(fs::read(&second).expect("it is there"), old);
        // A name that somebody else has taken is left alone, whatever it holds.
        let third = folder.path().join("masse-0003.png");
        fs::write(&third, "mine").expect("it is writable");
        let fourth = keep(folder.path(), (3, 2), &pixels(3)).expect("it is writable");
        assert_eq!(fs::read(&third).expect("it is there"), b"mine");
        assert!(fourth.ends_with("masse-0004.png"), "{}", fourth.display());
    }

    #[test]
    fn a_folder_that_cannot_be_made_is_named() {
        let folder = tempfile::tempdir().expect("a folder for a test");
        let blocked = folder.path().join("file");
        fs::write(&blocked, "in the way").expect("it is writable");
        let error = keep(&blocked.join("masse"), (1, 1), &[0; 4]).expect_err("a file is no folder");
        assert!(error.to_string().contains("file"), "{error}");
    }
}
