//! `masse picture`.

use std::path::PathBuf;

use clap::Args;

use crate::cli::{CommandError, to_file};
use crate::report::picture::{self, Style};
use crate::report::{raster, record_file};
use crate::scenarios::{library, share};
use crate::sim::play::play;

/// What to draw, and how.
#[derive(Args, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "flags of the command line")]
pub(super) struct PictureOptions {
    /// Record file, or a scene: built in, a scene file, or a shared text. A scene is played for its picture
    what: String,
    /// The file to write: SVG, or PNG if its name ends so
    #[arg(value_name = "FILE.svg|FILE.png")]
    file: PathBuf,
    /// Draw the scene before its shot, with the cue
    #[arg(long, conflicts_with_all = ["motion", "ghosts", "numbers", "diagram"])]
    before: bool,
    /// Colour the paths by motion: sliding, rolling, flying
    #[arg(long)]
    motion: bool,
    /// Outline the balls where they met others
    #[arg(long)]
    ghosts: bool,
    /// Number the events and list them
    #[arg(long)]
    numbers: bool,
    /// All three
    #[arg(long)]
    diagram: bool,
    /// Pixels of the width of a PNG
    #[arg(long, default_value_t = 1600)]
    width: u32,
}

impl PictureOptions {
    fn style(&self) -> Style {
        Style {
            by_motion: self.motion || self.diagram,
            ghosts: self.ghosts || self.diagram,
            numbers: self.numbers || self.diagram,
        }
    }
}

/// Whether a name is that of a scene; anything else is a record file.
fn is_scene(name: &str) -> bool {
    let built_in = library::BUILT_IN.iter().any(|scene| scene.name == name);
    let path = std::path::Path::new(name);
    let ron = path
        .extension()
        .is_some_and(|end| end.eq_ignore_ascii_case("ron"));
    built_in || ron || share::is_shared(name)
}

/// Draws a scene or a run that was written to a file.
pub(super) fn draw(options: &PictureOptions) -> Result<(), CommandError> {
    let svg = if is_scene(&options.what) {
        let scenario = library::open(&options.what)?;
        let (title, scene) = (&scenario.title, &scenario.scene);
        if options.before {
            picture::draw_set_up(title, scene)
        } else {
            picture::draw_as(title, scene, &play(scene)?, options.style())
        }
    } else {
        let run = record_file::read(std::path::Path::new(&options.what))?;
        if options.before {
            picture::draw_set_up(&run.title, &run.scene)
        } else {
            picture::draw_as(&run.title, &run.scene, &run.record, options.style())
        }
    };
    let png = options
        .file
        .extension()
        .is_some_and(|end| end.eq_ignore_ascii_case("png"));
    if !png {
        return to_file(&options.file, svg.as_bytes());
    }
    let file = options.file.display();
    let pixels = raster::png(&svg, options.width)
        .map_err(|error| CommandError::Usage(format!("{file}: {error}")))?;
    to_file(&options.file, &pixels)
}
