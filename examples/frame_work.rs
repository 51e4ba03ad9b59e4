//! What a frame costs without drawing: `cargo run --release --example frame_work -- 600`.
//!
//! Sixteen balls and the preview of the shot, for so many frames each: the cue at rest; turned a little every frame, so that
//! every frame solves the whole shot anew; and the balls rolling after the break. Every system of the program and of Bevy's
//! main world runs, panels are laid out; there is no window and no graphics adapter. The last column is what is left when
//! the same frame of Bevy and its panels alone is taken away.

use std::time::{Duration, Instant};

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use bevy_egui::{EguiInput, EguiPlugin, EguiPrimaryContextPass, PrimaryEguiContext, egui};
use masse::game::aim::Aim;
use masse::game::practice;
use masse::physics::scene::Scene;
use masse::sim::clock::Clock;
use masse::sim::messages::Strike;
use masse::sim::playfield::lay_out;
use masse::window::{unseen, windowed};

/// Frames before any is counted.
const WARM: usize = 60;

/// What a frame lasts on the screen.
const FRAME: Duration = Duration::from_micros(16_667);

/// Bevy without a window, a graphics adapter and sound.
fn bevy_alone() -> App {
    let mut app = App::new();
    app.add_plugins(unseen())
        .insert_resource(TimeUpdateStrategy::ManualDuration(FRAME));
    app
}

fn ready(mut app: App) -> App {
    app.finish();
    app.cleanup();
    for _ in 0..WARM {
        frame(&mut app);
    }
    app
}

fn whole_program(scene: &Scene) -> App {
    let mut app = bevy_alone();
    app.add_plugins(windowed());
    lay_out(app.world_mut(), scene);
    ready(app)
}

/// One frame, with a screen for the panels; how long it took.
fn frame(app: &mut App) -> Duration {
    let world = app.world_mut();
    let mut inputs = world.query_filtered::<&mut EguiInput, With<PrimaryEguiContext>>();
    if let Ok(mut input) = inputs.single_mut(world) {
        let size = egui::vec2(1280.0, 720.0);
        input.0.screen_rect = Some(egui::Rect::from_min_size(egui::Pos2::ZERO, size));
    }
    let begun = Instant::now();
    app.update();
    begun.elapsed()
}

/// Seconds of processor time that this process has used.
fn processor() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields: Vec<&str> = stat
        .rsplit(") ")
        .next()
        .unwrap_or_default()
        .split(' ')
        .collect();
    let ticks = |i: usize| fields.get(i).and_then(|field| field.parse::<f64>().ok());
    (ticks(11).unwrap_or(0.0) + ticks(12).unwrap_or(0.0)) / 100.0
}

/// Resident memory, KiB, where the system tells.
fn resident() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let number = line.and_then(|line| line.trim().split(' ').next()?.parse().ok());
    number.unwrap_or(0)
}

/// Plays frames, each after a change; prints what they cost and gives the median.
fn measure(
    name: &str,
    app: &mut App,
    frames: usize,
    floor: f64,
    mut change: impl FnMut(&mut App),
) -> f64 {
    let before = processor();
    let mut times: Vec<f64> = (0..frames)
        .map(|_| {
            change(app);
            1e3 * frame(app).as_secs_f64()
        })
        .collect();
    let used = 1e3 * (processor() - before) / frames as f64;
    times.sort_by(f64::total_cmp);
    let at = |share: f64| times[((frames - 1) as f64 * share) as usize];
    println!(
        "{name:44} least {:6.3} ms, median {:6.3}, 95 % {:6.3}; processor {used:6.3}; above Bevy {:6.3}",
        at(0.0),
        at(0.5),
        at(0.95),
        at(0.5) - floor
    );
    at(0.5)
}

/// The cue turns by a hundredth of a degree.
fn turn(app: &mut App) {
    app.world_mut().resource_mut::<Aim>().turn_deg(0.01);
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let frames = std::env::args()
        .nth(1)
        .map_or(Ok(600), |text| text.parse())?;
    let mut alone = bevy_alone();
    alone
        .add_plugins(EguiPlugin::default())
        .init_schedule(EguiPrimaryContextPass);
    alone.world_mut().spawn(Camera3d::default());
    let mut alone = ready(alone);
    let floor = measure("Bevy and its panels alone", &mut alone, frames, 0.0, |_| {});
    drop(alone);

    let rack = practice::opening();
    let mut app = whole_program(&rack);
    measure("racked, the cue at rest", &mut app, frames, floor, |_| {});
    measure(
        "racked, a break turned every frame",
        &mut app,
        frames,
        floor,
        turn,
    );
    let aim = *app.world().resource::<Aim>();
    app.world_mut().write_message(Strike {
        ball: aim.ball,
        shot: aim.shot,
    });
    frame(&mut app);
    frame(&mut app);
    let rolling = frames.min(120);
    measure("rolling after the break", &mut app, rolling, floor, |_| {});
    let mut patience = 0;
    while app.world().resource::<Clock>().moving && patience < 10_000 {
        frame(&mut app);
        patience += 1;
    }
    app.world_mut().resource_mut::<Aim>().set_speed(2.5);
    measure("spread, the cue at rest", &mut app, frames, floor, |_| {});
    measure(
        "spread, a shot of 2.5 m/s turned every frame",
        &mut app,
        frames,
        floor,
        turn,
    );
    println!(
        "resident memory without a window and a driver {} MiB",
        resident() / 1024
    );
    Ok(())
}
