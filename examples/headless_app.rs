//! A headless Bevy app with balls of its own: `cargo run --release --no-default-features --example headless_app`.
//!
//! Entities with `Position`, `Velocity`, `AngularVelocity`, `Mass` and `Radius` are all that the simulator needs. The app runs
//! by its own clock, here as fast as it can, pushes a ball when all have come to rest, and ends when they rest again.

use std::time::Duration;

use bevy::app::ScheduleRunnerPlugin;
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use glam::DVec3;
use masse::physics::ball::Ball;
use masse::sim::components::{AngularVelocity, BallName, Mass, Position, Radius, Velocity};
use masse::sim::messages::{AtRest, Failed, Restart, Touched};
use masse::sim::{SimPlugin, SimSystems, clock::Clock};

fn main() -> AppExit {
    let tick = Duration::from_secs_f64(Clock::FRAME);
    App::new()
        .add_plugins((
            MinimalPlugins.set(ScheduleRunnerPlugin::run_loop(Duration::ZERO)),
            SimPlugin,
        ))
        // One tick an update, whatever the time on the wall. Without this line the app runs in real time.
        .insert_resource(TimeUpdateStrategy::ManualDuration(tick))
        .insert_resource(Time::<Fixed>::from_duration(tick))
        .add_systems(Startup, spawn)
        .add_systems(
            FixedUpdate,
            (tell, push_or_end).chain().after(SimSystems::Judge),
        )
        .run()
}

/// A ball that slides with draw, and one that waits for it. What is not given is a pool ball's.
fn spawn(mut commands: Commands) {
    let at = |x: f64, z: f64| Position(DVec3::new(x, Ball::POOL.radius, z));
    commands.spawn((
        BallName("striker".to_owned()),
        at(-0.6, 0.01),
        Velocity(DVec3::new(2.0, 0.0, 0.0)),
        AngularVelocity(DVec3::new(0.0, 10.0, 60.0)),
    ));
    commands.spawn((
        BallName("target".to_owned()),
        at(0.3, 0.0),
        AngularVelocity::default(),
        Mass(0.2),
        Radius(Ball::POOL.radius),
    ));
}

fn tell(mut touched: MessageReader<Touched>, mut failed: MessageReader<Failed>) {
    for Touched(event) in touched.read() {
        println!(
            "{:.4} s {:?} {:.4} N s",
            event.time, event.kind, event.impulse
        );
    }
    for failure in failed.read() {
        eprintln!("{} s: {}", failure.time, failure.reason);
    }
}

/// At the first rest the target is pushed back; at the second the app ends.
fn push_or_end(
    mut rests: MessageReader<AtRest>,
    mut pushed: Local<bool>,
    mut balls: Query<(&BallName, &Position, &mut Velocity)>,
    mut restart: MessageWriter<Restart>,
    mut exit: MessageWriter<AppExit>,
) {
    for AtRest { time } in rests.read() {
        println!("at rest after {time:.3} s");
        for (name, position, mut velocity) in &mut balls {
            println!(
                "  {} at {:+.4}, {:+.4} m",
                name.0, position.0.x, position.0.z
            );
            if !*pushed && name.0 == "target" {
                velocity.0 = DVec3::new(-1.0, 0.0, 0.2);
            }
        }
        if *pushed {
            exit.write(AppExit::Success);
        }
        restart.write(Restart);
        *pushed = true;
    }
}
