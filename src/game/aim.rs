//! The shot the player is preparing.

use bevy::prelude::*;

use crate::physics::cue::Shot;

/// The stroke as it stands: what the cue shows, what the preview plays and what a strike will do.
#[derive(Resource, Clone, Copy, Debug, PartialEq)]
pub struct Aim {
    /// Index of the ball to strike.
    pub ball: usize,
    /// The stroke.
    pub shot: Shot,
    /// How far the cue is drawn back, 0 to 1 of a full backstroke: what the picture shows.
    pub draw_back: f64,
}

impl Aim {
    /// Fastest stroke a player can ask for, m/s.
    pub const TOP_SPEED: f64 = 10.0;
    /// Largest offset from the centre a player can ask for, R.
    pub const TOP_OFFSET: f64 = 0.6;
    /// Steepest cue a player can ask for, rad.
    pub const TOP_ELEVATION: f64 = 1.4;
}

impl Default for Aim {
    fn default() -> Self {
        Self {
            ball: 0,
            shot: Shot::default(),
            draw_back: 0.0,
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Aim>();
}
