//! The game without pixels: what the player aims, what the player sees of it, practice on an open table.

pub mod aim;
pub mod practice;
pub mod replay;
pub mod view;

use bevy::prelude::*;

/// The game without pixels.
pub struct GamePlugin;

impl Plugin for GamePlugin {
    fn build(&self, app: &mut App) {
        app.add_plugins((aim::plugin, practice::plugin, replay::plugin, view::plugin));
    }
}
