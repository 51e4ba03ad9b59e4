//! Capture of a ball by a pocket.

use serde::{Deserialize, Serialize};

use crate::physics::ball::{Motion, State};
use crate::physics::table::Pocket;

/// When a pocket takes a ball.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum PocketLaw {
    /// A ball falls when its centre passes the edge of the hole: from there the slate no longer holds it
    /// (Alciatore, TP 3.5 and 3.6, for a sharp edge).
    #[default]
    Capture,
}

impl PocketLaw {
    /// The state of a captured ball: at rest at the bottom of the pocket.
    #[must_use]
    pub fn captured(self, pocket: &Pocket) -> State {
        let Self::Capture = self;
        let mut state = State::at_rest(glam::DVec3::new(
            pocket.center.x,
            -pocket.depth,
            pocket.center.y,
        ));
        state.motion = Motion::Pocketed;
        state
    }
}
