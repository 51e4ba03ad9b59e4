//! Times whole shots of the exact solver and prints them as JSON, each with its scene, so that another program can play
//! the same shots: `scripts/compare_pooltool.py` does.
//!
//! `cargo run --release --no-default-features --example time_shots [SECONDS]`; a shot is repeated for at least SECONDS of
//! processor time (0.5 without it) and at least five times.

use std::fs;
use std::process::ExitCode;
use std::time::Instant;

use glam::DVec3;
use masse::physics::ball::Ball;
use masse::physics::cue::Shot;
use masse::physics::exact::{Limits, SolveError, solve};
use masse::physics::laws::Laws;
use masse::physics::laws::cushion::{CushionLaw, Stronge2018};
use masse::physics::scene::{PlannedShot, Rack, Scene};
use masse::physics::table::{Preset, Table};
use serde_json::{Value, json};

/// Gap in m between neighbours of a rack: a thousandth of a radius, as pooltool racks.
const GAP: f64 = 1e-3 * Ball::POOL.radius;

/// Fewest repetitions that make a median.
const LEAST: usize = 5;

/// Coulomb cloth, Marlow's throw, Stronge's cushion; a tip that gives all energy back, as pooltool's does.
fn scene(table: Table) -> Scene {
    let laws = Laws {
        cushion: CushionLaw::Stronge2018(Stronge2018::default()),
        ..Laws::default()
    };
    let mut scene = Scene::new(table, laws);
    scene.cue.tip_restitution = 1.0;
    scene
}

fn aimed(mut scene: Scene, at: usize, shot: Shot) -> Scene {
    let (from, to) = (
        scene.balls[0].state.position,
        scene.balls[at].state.position,
    );
    let heading = shot.heading + Shot::heading_between(from, to);
    scene.shot = Some(PlannedShot {
        ball: 0,
        shot: Shot { heading, ..shot },
    });
    scene
}

/// From beside the head spot at the first ball of the rack.
fn break_shot(rack: Rack) -> Scene {
    let mut scene = scene(Preset::NineFoot.table());
    rack.place(&mut scene, Ball::POOL, GAP, 1);
    scene.balls[0].state.position.z = 0.15;
    aimed(
        scene,
        1,
        Shot {
            speed: 8.0,
            ..Shot::default()
        },
    )
}

/// A cut of some 30 degrees with right english and some follow.
fn cut() -> Scene {
    let mut scene = scene(Preset::NineFoot.table());
    scene.place("cue", Ball::POOL, -0.5, 0.1);
    scene.place("1", Ball::POOL, 0.3, -0.2);
    aimed(
        scene,
        1,
        Shot {
            heading: 0.033,
            side: 0.3,
            height: 0.1,
            speed: 1.5,
            ..Shot::default()
        },
    )
}

/// 200 balls at 1 m/s in all directions, a third of a closed box.
fn crowd() -> Scene {
    const COLUMNS: u32 = 20;
    const ROWS: u32 = 10;
    let pitch = Ball::POOL.radius * (std::f64::consts::PI / 0.33).sqrt();
    let (length, width) = (f64::from(COLUMNS) * pitch, f64::from(ROWS) * pitch);
    let mut scene = scene(Preset::Box { length, width }.table());
    for i in 0..COLUMNS * ROWS {
        let (column, row) = (f64::from(i % COLUMNS), f64::from(i / COLUMNS));
        let index = scene.place(
            &i.to_string(),
            Ball::POOL,
            (column + 0.5) * pitch - 0.5 * length,
            (row + 0.5) * pitch - 0.5 * width,
        );
        let angle = f64::from(i) * 2.399_963;
        scene.balls[index].state.velocity = DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
    }
    scene.time_limit = 0.2;
    scene
}

/// Processor time of this thread in s, where the system tells it.
fn processor_time() -> Option<f64> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds: f64 = text.split_whitespace().next()?.parse().ok()?;
    (nanoseconds > 0.0).then_some(1e-9 * nanoseconds)
}

/// Repeats a shot and tells what one costs.
fn timed(name: &str, scene: &Scene, least_seconds: f64) -> Result<Value, SolveError> {
    let record = solve(scene, Limits::default())?;
    let mut elapsed = Vec::new();
    let (begun, before) = (Instant::now(), processor_time());
    while elapsed.len() < LEAST || begun.elapsed().as_secs_f64() < least_seconds {
        let start = Instant::now();
        solve(scene, Limits::default())?;
        elapsed.push(start.elapsed().as_secs_f64());
    }
    let processor = before
        .zip(processor_time())
        .map(|(before, after)| (after - before) / elapsed.len() as f64);
    elapsed.sort_by(f64::total_cmp);
    // What interrupts the thread lengthens some repetitions; the median of the elapsed times knows nothing of it.
    let median = elapsed[elapsed.len() / 2];
    Ok(json!({
        "name": name,
        "seconds": median,
        "processor_seconds_mean": processor,
        "repetitions": elapsed.len(),
        "events": record.events.len(),
        "events_per_second": record.events.len() as f64 / median,
        "end_time": record.end_time,
        "scene": scene,
    }))
}

fn main() -> ExitCode {
    let least_seconds = match std::env::args().nth(1).map(|text| text.parse()) {
        None => 0.5,
        Some(Ok(seconds)) => seconds,
        Some(Err(error)) => {
            eprintln!("SECONDS: {error}");
            return ExitCode::from(2);
        }
    };
    let shots = [
        ("nine-ball break", break_shot(Rack::NineBall)),
        ("eight-ball break", break_shot(Rack::EightBall)),
        ("two-ball cut with english", cut()),
        ("200 moving balls in a box", crowd()),
    ];
    let mut timings = Vec::new();
    for (name, scene) in &shots {
        match timed(name, scene, least_seconds) {
            Ok(timing) => timings.push(timing),
            Err(error) => {
                eprintln!("{name}: {error}");
                return ExitCode::from(4);
            }
        }
    }
    println!("{}", Value::Array(timings));
    ExitCode::SUCCESS
}
