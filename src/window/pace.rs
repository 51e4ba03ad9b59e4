//! The fixed tick of the app follows the tick of the solver.

use std::time::Duration;

use bevy::prelude::*;

use crate::sim::clock::Clock;

pub(super) fn plugin(app: &mut App) {
    app.add_systems(
        RunFixedMainLoop,
        keep_pace.in_set(RunFixedMainLoopSystems::BeforeFixedMainLoop),
    );
}

/// A scene may bring its own tick. A fast machine shows it at its true speed, a slow one falls behind the wall clock but
/// plays the same ticks.
fn keep_pace(clock: Res<Clock>, mut fixed: ResMut<Time<Fixed>>) {
    let tick = Duration::from_secs_f64(clock.tick.clamp(1e-6, 1.0));
    if fixed.timestep() != tick {
        fixed.set_timestep(tick);
    }
}
