//! Capture of a ball by a pocket.

mod rim;

pub use rim::Rim;

use serde::{Deserialize, Serialize};

use crate::physics::ball::{Motion, State};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};
use crate::physics::table::Pocket;

/// When and how a pocket takes a ball.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum PocketLaw {
    /// A ball is gone when its centre passes the edge of the hole: from there the slate no longer holds it
    /// (Alciatore, TP 3.5 and 3.6, for a sharp edge). Nothing comes back.
    #[default]
    Capture,
    /// A ball falls: over a rounded edge, against the far rim and the liner, to the bottom; or back out.
    Rim(Rim),
}

impl PocketLaw {
    /// One of each registered law, with its default parameters.
    #[must_use]
    pub fn all() -> Vec<Self> {
        vec![Self::Capture, Self::Rim(Rim::default())]
    }

    /// Where the law comes from.
    #[must_use]
    pub fn source(&self) -> Source {
        match self {
            Self::Capture => Source {
                paper: "Alciatore, TP 3.5 and 3.6, for a sharp edge",
                formula: "gone when the centre passes the edge",
                leaves_out: "edge, wall, liner, and whatever comes back",
            },
            Self::Rim(_) => rim::SOURCE,
        }
    }

    /// The state of a captured ball: at rest at the bottom of the pocket.
    #[must_use]
    pub fn captured(self, pocket: &Pocket) -> State {
        let mut state = State::at_rest(glam::DVec3::new(
            pocket.center.x,
            -pocket.depth,
            pocket.center.y,
        ));
        state.motion = Motion::Pocketed;
        state
    }
}

impl Check for PocketLaw {
    fn parameters(&self) -> Vec<Parameter> {
        match self {
            Self::Capture => Vec::new(),
            Self::Rim(law) => law.parameters(),
        }
    }
}
