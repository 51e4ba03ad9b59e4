//! How loud the player wants the table.

use bevy::prelude::*;

/// Loudness of every sound of the game.
#[derive(Resource, Clone, Copy, Debug, PartialEq)]
pub struct Volume {
    /// From 0, silent, to 1.
    pub level: f32,
    /// Nothing is heard while this is set; the level is kept.
    pub muted: bool,
}

impl Volume {
    /// The level in use now, 0 to 1.
    #[must_use]
    pub fn audible(&self) -> f32 {
        if self.muted {
            0.0
        } else {
            self.level.clamp(0.0, 1.0)
        }
    }
}

impl Default for Volume {
    fn default() -> Self {
        Self {
            level: 0.8,
            muted: false,
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Volume>();
}
