//! Running the table without a window: what tests, the command line and benchmarks use.
//!
//! ```
//! use masse::physics::ball::Ball;
//! use masse::physics::laws::Laws;
//! use masse::physics::scene::Scene;
//! use masse::physics::table::Preset;
//! use masse::sim::stepping;
//!
//! let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
//! let cue = scene.place("cue", Ball::POOL, 0.0, 0.0);
//! scene.balls[cue].state.velocity.x = 1.0;
//!
//! let mut app = stepping::headless_app(&scene);
//! stepping::step(&mut app, 60);
//! let states = stepping::states(&mut app);
//! assert!(states[cue].position.x > 0.3);
//! ```

use bevy::ecs::schedule::SingleThreadedExecutor;
use bevy::prelude::*;

use crate::physics::ball::State;
use crate::physics::record::{EndReason, Record};
use crate::physics::scene::Scene;
use crate::sim::SimPlugin;
use crate::sim::clock::Clock;
use crate::sim::messages::Failed;
use crate::sim::playfield::{BallQuery, Playfield, lay_out, snapshot};
use crate::sim::recorder::Recorder;

/// An app with this scene on the table and nothing to see. It runs by [`step`], not by its own clock.
pub fn headless_app(scene: &Scene) -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, SimPlugin));
    app.edit_schedule(FixedUpdate, |schedule| {
        // The systems of a tick depend on each other: to wake threads for them takes longer than a small tick.
        schedule.set_executor(SingleThreadedExecutor::new());
    });
    app.finish();
    app.cleanup();
    lay_out(app.world_mut(), scene);
    app
}

/// Advances an app by this many fixed ticks.
pub fn step(app: &mut App, ticks: u32) {
    for _ in 0..ticks {
        app.world_mut().run_schedule(FixedUpdate);
    }
}

/// The table as a scene, as it is now.
///
/// # Panics
/// If the app has no [`SimPlugin`].
pub fn scene(app: &mut App) -> Scene {
    app.world_mut()
        .run_system_cached(|playfield: Res<Playfield>, balls: BallQuery| {
            snapshot(&playfield, &balls)
        })
        .expect("both parameters exist in every app with SimPlugin")
}

/// The state of every ball now, in scene order.
pub fn states(app: &mut App) -> Vec<State> {
    scene(app).balls.iter().map(|ball| ball.state).collect()
}

/// Runs a scene until every ball rests or its time limit is over, and returns what happened.
///
/// # Panics
/// If the solver fails; [`try_run_to_rest`] returns the failure instead.
#[must_use]
pub fn run_to_rest(scene: &Scene) -> (Record, Recorder) {
    try_run_to_rest(scene).unwrap_or_else(|failed| panic!("{failed:?}"))
}

/// Runs a scene until every ball rests or its time limit is over, and returns what happened.
///
/// # Errors
/// [`Failed`] with the ball, the time and the numbers if the solver cannot go on.
pub fn try_run_to_rest(scene: &Scene) -> Result<(Record, Recorder), Failed> {
    let mut app = headless_app(scene);
    let reason = loop {
        step(&mut app, 1);
        let failed = app
            .world_mut()
            .resource_mut::<Messages<Failed>>()
            .drain()
            .last();
        if let Some(failed) = failed {
            return Err(failed);
        }
        let clock = app.world().resource::<Clock>();
        if !clock.moving {
            break EndReason::Rest;
        }
        if clock.time() >= scene.time_limit {
            break EndReason::TimeLimit;
        }
    };
    let recorder = app
        .world_mut()
        .remove_resource::<Recorder>()
        .unwrap_or_default();
    let mut record = recorder.record(app.world().resource::<Clock>().time(), Some(reason));
    record.end = states(&mut app);
    Ok((record, recorder))
}
