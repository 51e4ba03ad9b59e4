//! The game without pixels: what the player aims, sees and hears of it, practice on an open table.

pub mod aim;
pub mod aimed;
pub mod decisive;
pub mod equip;
pub mod guide;
pub mod history;
pub mod lift;
pub mod matches;
pub mod placing;
pub mod players;
pub mod practice;
pub mod preview;
pub mod racking;
pub mod replay;
pub mod rules;
pub mod saying;
pub mod scatter;
pub mod settings;
pub mod snap;
pub mod studio;
pub mod target;
pub mod turns;
pub mod twin;
pub mod view;
pub mod volume;
pub mod watch;

use bevy::prelude::*;

/// The game without pixels.
pub struct GamePlugin;

/// Whatever must be kept is kept before the program ends. Runs in [`Last`].
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Keeping;

impl Plugin for GamePlugin {
    fn build(&self, app: &mut App) {
        app.add_plugins((
            aim::plugin,
            equip::plugin,
            lift::plugin,
            practice::plugin,
            replay::plugin,
            settings::plugin,
            turns::plugin,
            twin::plugin,
            studio::plugin,
            view::plugin,
            watch::plugin,
        ));
    }
}
