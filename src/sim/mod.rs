//! The table as a Bevy world, headless: components, messages, the clock and the solvers as ordered systems.
//!
//! Every fixed tick runs [`SimSystems`] in order. Nothing above this room can tell which solver ran.
//!
//! ```
//! use bevy::prelude::*;
//! use glam::DVec3;
//! use masse::sim::SimPlugin;
//! use masse::sim::components::{AngularVelocity, Mass, Position, Radius, Velocity};
//!
//! let mut app = App::new();
//! app.add_plugins((MinimalPlugins, SimPlugin));
//! let ball = app.world_mut().spawn((
//!     Position(DVec3::new(-0.5, 0.028575, 0.0)),
//!     Velocity(DVec3::new(1.0, 0.0, 0.0)),
//!     AngularVelocity::default(),
//!     Mass(0.17),
//!     Radius(0.028575),
//! )).id();
//! // An app that runs does this by itself, 64 times a second; a tick of the simulation is 1/120 s, see `Time<Fixed>`.
//! for _ in 0..60 {
//!     app.world_mut().run_schedule(FixedUpdate);
//! }
//! assert!(app.world().get::<Position>(ball).expect("a ball").0.x > -0.2);
//! ```

pub mod clock;
pub mod components;
pub mod exact;
pub mod joining;
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
            joining::plugin,
        ));
    }
}
