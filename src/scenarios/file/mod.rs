//! Scene files: RON text in which a person can say everything a [`Scene`] holds.
//!
//! A number goes in and comes out with every bit. What is left out has its default; a field that is not known is an
//! error. Lengths in m, masses in kg, times in s, angles in rad unless the name says `_deg`.
//!
//! ```ron
//! (
//!     title: "Stop shot",
//!     preset: "pool",                        // table, laws, balls and cue: see `crate::scenarios::preset`
//!     table: NineFoot,                       // EightFoot, SevenFoot, Snooker, Carom, Box(length: 2, width: 1),
//!                                            // Pocketed(...) by the measures of a maker, Full(...) line by line
//!     cloth: "fast",                         // medium, slow, or a cloth file
//!     laws: Pool,                            // Ideal, Coursework, Custom(base: Pool, cushion: Mirror())
//!     set: {"laws.cushion.restitution": 0.9}, // single numbers, over all that stands above
//!     balls: [
//!         (name: "cue", position: (-0.635, 0)),
//!         (name: "1", diamonds: (2, 4)),
//!     ],
//!     shot: (ball: "cue", aim_at: "1", speed: 2, height: -0.3),
//!     look_for: "the cue ball stays where it hits",
//!     expect: [Potted(ball: "1")],           // what must happen: see `crate::scenarios::expect`
//!     cameras: [Overhead, BehindCue],
//! )
//! ```
//!
//! A file needs a `preset` or a `table`; what both give, the file's own word decides.
//!
//! The text is read into structs of this module, which mirror the file and nothing else, and is then
//! converted into a [`Scene`] and checked. The parts that describe a law, a cue or a solver are the structs of the
//! physics itself, so that a new law can be named in a file without a change here.

pub(in crate::scenarios) mod balls;
mod error;
mod fill;
mod layout;
mod memory;
mod shot;
pub(in crate::scenarios) mod surroundings;
#[cfg(test)]
mod tests;

pub(in crate::scenarios) use error::LayoutError;
pub use error::{FieldError, FileError};

use std::path::Path;

use ron::extensions::Extensions;
use ron::ser::PrettyConfig;
use serde::de::DeserializeOwned;

use crate::kept;
use crate::physics::ball::State;
use crate::physics::record::Record;
use crate::physics::scene::Scene;
use crate::scenarios::camera::Camera;
use crate::scenarios::expect::{self, Expectation, Outcome};
use crate::scenarios::preset;
use crate::scenarios::search::{self, Free, Tie};
use layout::SceneFile;

/// A scene with what a person calls it.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// One line.
    pub title: String,
    /// What to look at; may be empty.
    pub description: String,
    /// The preset it is played with, if it names one: a built-in name, or the path of a file.
    pub preset: Option<String>,
    /// What to watch for while it is played; may be empty.
    pub look_for: String,
    /// What must happen, checked against the scene.
    pub expect: Vec<Expectation>,
    /// From where to see it.
    pub cameras: Vec<Camera>,
    /// What a search may change; empty in a scene that is done.
    pub free: Vec<Free>,
    /// What follows from what a search changes.
    pub ties: Vec<Tie>,
    /// The scene, checked.
    pub scene: Scene,
}

impl Scenario {
    /// A scene that is expected to do nothing in particular.
    #[must_use]
    pub fn plain(title: &str, description: &str, scene: Scene) -> Self {
        Self {
            title: title.to_owned(),
            description: description.to_owned(),
            preset: None,
            look_for: String::new(),
            expect: Vec::new(),
            cameras: Vec::new(),
            free: Vec::new(),
            ties: Vec::new(),
            scene,
        }
    }

    /// The scene before anything happens: every ball at rest, no stroke.
    #[must_use]
    pub fn laid_out(&self) -> Scene {
        let mut scene = self.scene.clone();
        scene.shot = None;
        for placed in &mut scene.balls {
            if placed.state.motion.in_play() {
                placed.state = State::at_rest(placed.state.position);
            }
        }
        scene
    }

    /// What became of the expectations in a record of the scene.
    #[must_use]
    pub fn judge(&self, record: &Record) -> Vec<Outcome> {
        expect::judge(&self.scene, record, &self.expect)
    }
}

/// Largest scene file that is read, in bytes: a million balls written in full fit.
const LARGEST: u64 = 1 << 28;

/// Reads and checks a scene file.
///
/// # Errors
/// [`FileError`] if it cannot be read, is not a scene file or describes a scene that cannot be played.
pub fn read(path: &Path) -> Result<Scenario, FileError> {
    parse(&text_of(path)?, &path.display().to_string())
}

/// The text of a file.
pub(in crate::scenarios) fn text_of(path: &Path) -> Result<String, FileError> {
    kept::read(path, LARGEST).map_err(|why| FileError::Read {
        file: path.display().to_string(),
        why,
    })
}

/// Reads and checks the text of a scene file; `file` is what errors call it.
///
/// # Errors
/// [`FileError`] if the text is not a scene file or describes a scene that cannot be played.
pub fn parse(text: &str, file: &str) -> Result<Scenario, FileError> {
    let layout = layout(text, file)?;
    let (title, description) = (layout.title.clone(), layout.description.clone());
    let preset = layout.preset();
    let (look_for, expect) = (layout.look_for.clone(), layout.expect.clone());
    let cameras = layout.cameras.clone();
    let (free, ties) = (layout.free.clone(), layout.ties.clone());
    let folder = Path::new(file).parent().unwrap_or(Path::new(""));
    let scene = layout
        .into_scene(folder)
        .map_err(|error| error.in_file(file))?;
    expect::check(&scene, &expect).map_err(|error| LayoutError::from(error).in_file(file))?;
    search::check(&scene, &free, &ties).map_err(|error| LayoutError::from(error).in_file(file))?;
    let mut numbered = cameras.iter().enumerate();
    numbered
        .try_for_each(|(i, camera)| camera.check(i, &scene))
        .map_err(|error| error.in_file(file))?;
    Ok(Scenario {
        title,
        description,
        look_for,
        expect,
        cameras,
        free,
        ties,
        preset: preset.map(|name| preset::located(&name, folder)),
        scene,
    })
}

/// The title of the text of a scene file, without laying out its scene.
///
/// # Errors
/// [`FileError::Syntax`] if the text is not a scene file.
pub fn title(text: &str, file: &str) -> Result<String, FileError> {
    layout(text, file).map(|layout| layout.title)
}

/// Whether the text of a scene file asks for a crowd, without laying out its scene.
///
/// # Errors
/// [`FileError::Syntax`] if the text is not a scene file.
pub fn is_crowd(text: &str, file: &str) -> Result<bool, FileError> {
    layout(text, file).map(|layout| layout.is_crowd())
}

fn layout(text: &str, file: &str) -> Result<SceneFile, FileError> {
    spelled(text, file)
}

/// What a RON text says.
pub(in crate::scenarios) fn spelled<T: DeserializeOwned>(
    text: &str,
    file: &str,
) -> Result<T, FileError> {
    dialect()
        .from_str(text)
        .map_err(|error| FileError::syntax(file, text, &error))
}

/// The text of a scene file that reads back as this scene, bit for bit.
///
/// # Errors
/// [`FileError::Write`] if a number or a text cannot be spelled in RON.
pub fn write(scenario: &Scenario) -> Result<String, FileError> {
    let layout = SceneFile::of(scenario);
    let pretty = PrettyConfig::new().depth_limit(3).new_line("\n");
    let mut text = dialect()
        .to_string_pretty(&layout, pretty)
        .map_err(|error| FileError::Write {
            message: error.to_string(),
        })?;
    text.push('\n');
    Ok(text)
}

/// As [`write()`], in one line.
///
/// # Errors
/// As [`write()`].
pub(in crate::scenarios) fn write_short(scenario: &Scenario) -> Result<String, FileError> {
    let layout = SceneFile::of(scenario);
    let spelled = dialect().to_string(&layout);
    spelled.map_err(|error| FileError::Write {
        message: error.to_string(),
    })
}

/// RON in which `Some` may be left out and a variant needs one pair of brackets only.
fn dialect() -> ron::Options {
    ron::Options::default()
        .with_default_extension(Extensions::IMPLICIT_SOME | Extensions::UNWRAP_VARIANT_NEWTYPES)
}
