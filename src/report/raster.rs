//! SVG pictures as PNG files.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb::Database};
use thiserror::Error;

/// Most pixels of a side.
const WIDEST: u32 = 16_384;

/// Why a picture cannot be made of pixels.
#[derive(Debug, Error)]
pub enum RasterError {
    /// The width asked for is no good.
    #[error("{width} pixels: a picture is 16 to {WIDEST} pixels wide and high")]
    Size {
        /// Pixels asked for.
        width: u32,
    },
    /// The text is no SVG.
    #[error("the picture cannot be read: {0}")]
    Svg(#[from] resvg::usvg::Error),
    /// The pixels cannot be packed.
    #[error("the picture cannot be written: {0}")]
    Png(String),
}

/// The PNG file of an SVG picture, so many pixels wide. Its words are set in Ubuntu Light, which comes with the program: the
/// same picture gives the same bytes on every machine.
///
/// # Errors
/// [`RasterError`] if the text is no SVG or the picture would be too large.
pub fn png(svg: &str, width: u32) -> Result<Vec<u8>, RasterError> {
    if !(16..=WIDEST).contains(&width) {
        return Err(RasterError::Size { width });
    }
    let mut fonts = Database::new();
    fonts.load_font_data(epaint_default_fonts::UBUNTU_LIGHT.to_vec());
    fonts.set_sans_serif_family("Ubuntu");
    let options = Options {
        font_family: "Ubuntu".to_owned(),
        fontdb: Arc::new(fonts),
        ..Options::default()
    };
    let tree = Tree::from_str(svg, &options)?;
    let size = tree.size();
    let scale = width as f32 / size.width();
    let height = (scale * size.height()).ceil();
    if !(1.0..=WIDEST as f32).contains(&height) {
        return Err(RasterError::Size { width });
    }
    let mut pixels = Pixmap::new(width, height as u32).ok_or(RasterError::Size { width })?;
    resvg::render(
        &tree,
        Transform::from_scale(scale, scale),
        &mut pixels.as_mut(),
    );
    pixels
        .encode_png()
        .map_err(|error| RasterError::Png(error.to_string()))
}
