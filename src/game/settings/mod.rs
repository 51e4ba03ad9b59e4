//! What a player has set once and for all: language, sizes, sounds, keys. One value, kept in one file.
//!
//! [`mod@file`] reads and writes it, the plugin loads it when the program starts and saves it when it has changed.

pub mod file;
mod keep;

pub use keep::SettingsFile;

use std::collections::BTreeMap;

use bevy::prelude::*;
use serde::{Deserialize, Serialize};

use crate::game::volume::Volume;

/// Every setting. The file holds exactly this value; what it leaves out has its default.
#[derive(Resource, Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Settings {
    /// The form of the file, [`file::VERSION`].
    pub version: u32,
    /// The language, such as `de`; none is that of the system.
    pub language: Option<String>,
    /// Size of letters and panels, in [`SCALES`](Self::SCALES).
    pub scale: f32,
    /// The camera jumps instead of gliding; nothing shakes and no time is stretched for show.
    pub reduced_motion: bool,
    /// The balls wait while the menu is open.
    pub pause_in_menu: bool,
    /// Which holds are toggles.
    pub toggles: Toggles,
    /// How balls are told apart without their colours.
    pub marks: Marks,
    /// How loud what is.
    pub volume: Volume,
    /// How much work a frame may be.
    pub quality: Quality,
    /// The cloth.
    pub cloth: ClothColour,
    /// The wood of the rails.
    pub wood: Wood,
    /// How the table is built.
    pub table: TableStyle,
    /// Time slows down for the ball that decides a rack as it drops.
    pub slow_motion: bool,
    /// The controls of an action by their names, for every action whose controls are not those it comes with.
    pub bindings: BTreeMap<String, Vec<String>>,
}

impl Settings {
    /// Sizes of letters and panels that can be set.
    pub const SCALES: std::ops::RangeInclusive<f32> = 0.5..=3.0;
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            version: file::VERSION,
            language: None,
            scale: 1.0,
            reduced_motion: false,
            pause_in_menu: true,
            toggles: Toggles::default(),
            marks: Marks::default(),
            volume: Volume::default(),
            quality: Quality::default(),
            cloth: ClothColour::default(),
            wood: Wood::default(),
            table: TableStyle::default(),
            slow_motion: true,
            bindings: BTreeMap::new(),
        }
    }
}

/// Actions that last as long as a key is held, or from one press to the next.
#[expect(
    clippy::struct_excessive_bools,
    reason = "four switches that a player sets apart"
)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Toggles {
    /// Finer steps.
    pub fine: bool,
    /// Much finer steps.
    pub very_fine: bool,
    /// The stroke by hand.
    pub stroke: bool,
    /// Playing faster.
    pub fast_forward: bool,
}

/// Help for whoever sees colours differently.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Marks {
    /// A number stands upright over every ball; solids and stripes have frames of different shapes.
    pub labels: bool,
    /// Every colour also has a pattern.
    pub patterns: bool,
}

/// How much work a frame may be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Quality {
    /// What suits the graphics adapter.
    #[default]
    Automatic,
    /// For a processor that draws.
    Low,
    /// For a laptop.
    Medium,
    /// For a graphics card.
    High,
    /// For a strong graphics card.
    Ultra,
}

/// Colour of the cloth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum ClothColour {
    /// The blue-green of televised pool.
    #[default]
    Tournament,
    /// The green of old.
    Green,
    /// Blue.
    Blue,
    /// Wine red.
    Burgundy,
    /// Grey: the balls stand out by their colours alone.
    Grey,
    /// Bright red.
    Red,
    /// Camel.
    Camel,
}

impl ClothColour {
    /// Every colour, in the order in which they are listed.
    pub const ALL: [Self; 7] = [
        Self::Tournament,
        Self::Green,
        Self::Blue,
        Self::Burgundy,
        Self::Grey,
        Self::Red,
        Self::Camel,
    ];
}

/// Wood of the rails and legs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Wood {
    /// Red-brown.
    #[default]
    Mahogany,
    /// Light.
    Oak,
    /// Nearly black.
    Ebony,
}

impl Wood {
    /// Every wood, in the order in which they are listed.
    pub const ALL: [Self; 3] = [Self::Mahogany, Self::Oak, Self::Ebony];
}

/// How the table is built, and which lamp hangs over it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum TableStyle {
    /// Turned legs, leather pockets, brass and ivory, three glass shades.
    #[default]
    Classic,
    /// Straight legs, black pockets, no ornament, one flat lamp.
    Modern,
    /// Chrome corners, rubber pockets, a lamp of coloured glass.
    BarBox,
}

impl TableStyle {
    /// Every style, in the order in which they are listed.
    pub const ALL: [Self; 3] = [Self::Classic, Self::Modern, Self::BarBox];

    /// The wood that such a table is made of, unless another is chosen.
    #[must_use]
    pub fn wood(self) -> Wood {
        match self {
            Self::Classic => Wood::Mahogany,
            Self::Modern => Wood::Ebony,
            Self::BarBox => Wood::Oak,
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Settings>()
        .init_resource::<SettingsFile>()
        .add_plugins(keep::plugin);
}
