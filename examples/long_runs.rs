//! Long runs: `cargo run --release --no-default-features --example long_runs -- 1000000 3600`.
//!
//! So many events on a table without friction, and so many seconds of a crowd: how far the energy drifts, and that the
//! memory stays what it was.

use std::time::Instant;

use glam::DVec3;
use masse::physics::ball::Ball;
use masse::physics::exact::{Engine, Limits};
use masse::physics::laws::Laws;
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::sim::stepped::crowd::Census;
use masse::sim::stepping::{headless_app, states, step};

/// Balls of the table, and of the crowd.
const FEW: u32 = 16;
const MANY: u32 = 1000;

/// Memory in use, KiB, where the system tells.
fn memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let number = line.and_then(|line| line.trim().split(' ').next()?.parse().ok());
    number.unwrap_or(0)
}

/// Balls in a square box, each at 1 m/s in its own direction.
fn gas(count: u32) -> Scene {
    let ball = Ball {
        spins: false,
        ..Ball::POOL
    };
    let side = 0.12 * f64::from(count).sqrt().ceil();
    let table = Preset::Box {
        length: side,
        width: side,
    };
    let mut scene = Scene::new(table.table(), Laws::ideal());
    let columns = f64::from(count).sqrt().ceil();
    for i in 0..count {
        let (column, row) = (f64::from(i) % columns, (f64::from(i) / columns).floor());
        let place = |k: f64| (k + 0.5) * side / columns - 0.5 * side;
        let index = scene.place(&i.to_string(), ball, place(column), place(row));
        let angle = 2.399_963 * f64::from(i);
        scene.balls[index].state.velocity = DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
    }
    scene
}

fn events(most: u64) -> Result<(), Box<dyn std::error::Error>> {
    let scene = gas(FEW);
    let mut engine = Engine::new(&scene, Limits { events: u64::MAX })?;
    let energy = |engine: &Engine| -> f64 {
        let balls = scene.balls.iter().enumerate();
        balls
            .map(|(index, ball)| ball.ball.kinetic_energy(&engine.state(index)))
            .sum()
    };
    let (start, begun) = (energy(&engine), Instant::now());
    let mut before = 0;
    let mut time: f64 = 0.0;
    while engine.events() < most {
        time += 1.0;
        engine.advance(time, &mut ())?;
        if before == 0 {
            before = memory();
        }
    }
    println!(
        "{} events of {FEW} balls in {:.0} s of the table and {:.2} s: energy drifts by {:.1e}, memory {before} KiB to {} KiB",
        engine.events(),
        engine.time(),
        begun.elapsed().as_secs_f64(),
        energy(&engine) / start - 1.0,
        memory(),
    );
    Ok(())
}

fn crowd(seconds: u32) {
    let mut scene = gas(MANY);
    scene.solver = Solver::Stepped(Stepped {
        crowd: true,
        grid: None,
        ..Stepped::default()
    });
    let mut app = headless_app(&scene);
    let energy = |states: &[masse::physics::ball::State]| -> f64 {
        let balls = scene.balls.iter().zip(states);
        balls
            .map(|(ball, state)| ball.ball.kinetic_energy(state))
            .sum()
    };
    step(&mut app, 120);
    let (start, before, begun) = (energy(&states(&mut app)), memory(), Instant::now());
    for _ in 1..seconds {
        step(&mut app, 120);
    }
    let drift = energy(&states(&mut app)) / start - 1.0;
    println!(
        "{seconds} s of a crowd of {MANY} in {:.1} s, {} contacts: energy drifts by {drift:.1e}, memory {before} KiB to {} KiB",
        begun.elapsed().as_secs_f64(),
        app.world().resource::<Census>().contacts_in_all,
        memory(),
    );
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let most = arguments
        .next()
        .map_or(Ok(1_000_000), |text| text.parse())?;
    let seconds = arguments.next().map_or(Ok(3600), |text| text.parse())?;
    events(most)?;
    crowd(seconds);
    Ok(())
}
