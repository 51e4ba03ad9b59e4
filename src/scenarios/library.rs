//! The scenes that are built in, and how any scene is found by the name a person gives.
//!
//! A scene is a file in `assets/scenes` and a line here.

use std::path::Path;

use thiserror::Error;

use crate::scenarios::file::{self, FileError, Scenario};
use crate::scenarios::share::{self, ShareError};

/// A scene that is built in.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// What `masse run` calls it.
    pub name: &'static str,
    text: &'static str,
}

/// A line of the library: the name of a file in `assets/scenes`.
macro_rules! scene {
    ($name:literal) => {
        scene!("", $name)
    };
    ($folder:literal, $name:literal) => {
        BuiltIn {
            name: $name,
            text: include_str!(concat!("../../assets/scenes/", $folder, $name, ".ron")),
        }
    };
}

/// Every built-in scene, in the order in which they are listed.
pub const BUILT_IN: &[BuiltIn] = &[
    // Breaks.
    scene!("break-eight"),
    scene!("break-nine"),
    scene!("golden-break"),
    // Spin and the two ways of two balls.
    scene!("stop-shot"),
    scene!("stun-shot"),
    scene!("follow"),
    scene!("draw-back"),
    scene!("power-draw"),
    scene!("throw"),
    scene!("throw-combo"),
    // Curves and flights.
    scene!("masse"),
    scene!("jump-shot"),
    scene!("partial-jump"),
    scene!("baby-jump"),
    scene!("rebound-jump"),
    scene!("circular-follow"),
    // Banks and kicks.
    scene!("bank-cross-side"),
    scene!("bank-cross-corner"),
    scene!("bank-two-rails"),
    scene!("bank-three-rails"),
    scene!("kick-one-rail"),
    scene!("kick-two-rails"),
    scene!("kick-three-rails"),
    scene!("three-cushion"),
    scene!("dollar-bill"),
    scene!("rail-hug"),
    scene!("machine-gun"),
    // Balls that touch.
    scene!("cradle"),
    scene!("newton-pocket"),
    scene!("hustler-bank"),
    scene!("carom-kick"),
    scene!("frozen-kick"),
    scene!("frozen-proposition"),
    scene!("two-ball-spread"),
    scene!("just-showing-off"),
    scene!("butterfly"),
    scene!("football"),
    // The coursework and what is real of it.
    scene!("coursework-1-collisions"),
    scene!("coursework-2-grid"),
    scene!("coursework-2-grid-50"),
    scene!("coursework-3-backspin"),
    scene!("coursework-3-side-curve"),
    scene!("coursework-3-draw-english"),
    scene!("real-backspin"),
    scene!("real-side-curve"),
    scene!("real-draw-english"),
    scene!("given-backspin"),
    scene!("given-curve"),
    scene!("gas"),
];

/// Built-in scenes with thousands of balls, played as crowds: they take a while to lay out, and have no record.
pub const CROWDS: &[BuiltIn] = &[
    scene!("crowds/", "crowd-5750"),
    scene!("crowds/", "rack-5050"),
    scene!("crowds/", "galton"),
    scene!("crowds/", "dam-break"),
    scene!("crowds/", "million"),
];

/// Every built-in scene, crowds last.
pub fn all() -> impl Iterator<Item = &'static BuiltIn> {
    BUILT_IN.iter().chain(CROWDS)
}

impl BuiltIn {
    /// The scene.
    ///
    /// # Errors
    /// [`FileError`] if the file it is made of is no good; a test holds that none is.
    pub fn scenario(&self) -> Result<Scenario, FileError> {
        file::parse(self.text, self.name)
    }

    /// Whether the scene is a crowd, without laying it out.
    ///
    /// # Errors
    /// [`FileError`] as for [`scenario`](Self::scenario).
    pub fn is_crowd(&self) -> Result<bool, FileError> {
        file::is_crowd(self.text, self.name)
    }

    /// One line about the scene.
    ///
    /// # Errors
    /// [`FileError`] as for [`scenario`](Self::scenario).
    pub fn title(&self) -> Result<String, FileError> {
        file::title(self.text, self.name)
    }
}

/// Why there is no such scene.
#[derive(Debug, Error)]
pub enum OpenError {
    /// Neither a built-in scene nor a file.
    #[error("scene: there is no built-in scene and no file `{name}`; built in are {known}")]
    Unknown {
        /// The name given.
        name: String,
        /// The names that are known.
        known: String,
    },
    /// A scene file that is no good.
    #[error(transparent)]
    File(#[from] FileError),
    /// A shared text that is no good.
    #[error(transparent)]
    Share(#[from] ShareError),
}

/// The scene that a person calls by this name: a built-in one, a shared text, else a file.
///
/// # Errors
/// [`OpenError`] with the names that are known, or with what is wrong in the file.
pub fn open(name: &str) -> Result<Scenario, OpenError> {
    if share::is_shared(name) {
        return Ok(share::read(name)?);
    }
    if let Some(built_in) = all().find(|scene| scene.name == name) {
        return Ok(built_in.scenario()?);
    }
    let path = Path::new(name);
    let looks_like_a_file = path.components().count() > 1 || path.extension().is_some();
    if looks_like_a_file || path.exists() {
        return Ok(file::read(path)?);
    }
    let names: Vec<&str> = all().map(|scene| scene.name).collect();
    Err(OpenError::Unknown {
        name: name.to_owned(),
        known: names.join(", "),
    })
}
