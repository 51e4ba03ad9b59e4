//! The table as a Bevy world, headless: components, messages, the clock and the solvers as ordered systems.
//!
//! Every fixed tick runs [`SimSystems`] in order. Nothing above this room can tell which solver ran.

pub mod clock;
pub mod components;
pub mod exact;
pub mod messages;
pub mod play;
pub mod playfield;
pub mod recorder;
pub mod saved;
pub mod stepped;
pub mod stepping;

use bevy::prelude::*;

/// The order of one fixed tick.
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SimSystems {
    /// New scenes are laid out and the cue strikes. Runs in [`FixedUpdate`].
    Strike,
    /// The chosen solver advances every ball by one tick. Runs in [`FixedUpdate`].
    Advance,
    /// What happened is written to the [`recorder::Recorder`]. Runs in [`FixedUpdate`].
    Record,
    /// Rules and scenarios judge what happened. Runs in [`FixedUpdate`].
    Judge,
}

/// The simulation without anything to see or hear.
pub struct SimPlugin;

impl Plugin for SimPlugin {
    fn build(&self, app: &mut App) {
        app.configure_sets(
            FixedUpdate,
            (
                SimSystems::Strike,
                SimSystems::Advance,
                SimSystems::Record,
                SimSystems::Judge,
            )
                .chain(),
        )
        .add_plugins((
            messages::plugin,
            playfield::plugin,
            clock::plugin,
            exact::plugin,
            stepped::plugin,
            recorder::plugin,
        ));
    }
}
