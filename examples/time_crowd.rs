//! What a crowd costs and how well it is kept: `cargo run --release --no-default-features --example time_crowd -- 50000 200`.
//!
//! Arguments: balls, ticks, ticks a second, `gas`, `single` (the same in f32), `cloth`, or `rest` (the same with one ball that moves), threads, `mirror` or `bare`.

use std::time::Instant;

use glam::DVec3;
use masse::physics::ball::Ball;
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::report::speed_and_error::gas;
use masse::sim::stepped::crowd::{Census, Crowd, Mirror, Pass};
use masse::sim::stepping;

/// The gas of the report as a crowd. On cloth the balls are let go without spin, and of those at rest one moves.
fn scene(count: u32, rate: f64, kind: &str) -> Scene {
    let mut scene = gas(count, matches!(kind, "cloth" | "rest"), 0);
    for (i, ball) in scene.balls.iter_mut().enumerate() {
        ball.state.angular_velocity = DVec3::ZERO;
        if kind == "rest" && i > 0 {
            ball.state.velocity = DVec3::ZERO;
        }
    }
    scene.solver = Solver::Stepped(Stepped {
        tick: 1.0 / rate,
        grid: None,
        crowd: true,
        single: kind == "single",
        ..Stepped::default()
    });
    scene
}

/// Seconds of CPU all threads of this process have used, where the system tells.
fn cpu() -> f64 {
    let Ok(tasks) = std::fs::read_dir("/proc/self/task") else {
        return 0.0;
    };
    tasks
        .flatten()
        .filter_map(|task| std::fs::read_to_string(task.path().join("schedstat")).ok())
        .filter_map(|text| text.split(' ').next().and_then(|ns| ns.parse::<f64>().ok()))
        .sum::<f64>()
        * 1e-9
}

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let get = |i: usize, default: &str| args.get(i).cloned().unwrap_or(default.to_owned());
    let count: u32 = get(1, "5750").parse().expect("a number of balls");
    let ticks: u32 = get(2, "200").parse().expect("a number of ticks");
    let rate: f64 = get(3, "120").parse().expect("ticks a second");
    let scene = scene(count, rate, &get(4, "gas"));
    let mut app = stepping::headless_app(&scene);
    drop(scene);
    {
        let mut crowd = app.world_mut().resource_mut::<Crowd>();
        crowd.threads = get(5, "").parse().ok();
        if get(6, "mirror") == "bare" {
            crowd.mirror = Mirror::WhenAsked;
        }
    }
    stepping::step(&mut app, 10);
    let first = app.world().resource::<Census>().clone();
    let mut times: Vec<f64> = Vec::new();
    let mut passes = [0.0; 6];
    let (mut overlap, mut parts) = (0.0_f64, 0);
    let busy = cpu();
    for _ in 0..ticks {
        let start = Instant::now();
        stepping::step(&mut app, 1);
        times.push(start.elapsed().as_secs_f64());
        let census = app.world().resource::<Census>();
        overlap = overlap.max(census.overlap);
        parts += census.parts;
        for (sum, time) in passes.iter_mut().zip(census.times) {
            *sum += time.as_secs_f64();
        }
    }
    let busy = cpu() - busy;
    times.sort_by(f64::total_cmp);
    let census = app.world().resource::<Census>();
    let per = 1e9 / f64::from(count);
    let middle = times[times.len() / 2];
    println!(
        "{count} balls: median {:.3} ms a tick, {:.1} ns a ball and tick, {:.1} ns of CPU",
        1e3 * middle,
        per * middle,
        per * busy / f64::from(ticks),
    );
    for pass in Pass::ALL {
        print!(
            "{pass:?} {:.1}  ",
            per * passes[pass as usize] / f64::from(ticks)
        );
    }
    let time = f64::from(ticks) / rate;
    println!();
    println!(
        "collisions {:.2} per ball and second, energy {:.3e}, overlap {:.2e} diameters, parts {:.2}, late {:.2} of a thousand contacts, saturated {}, speed {:.2}",
        2.0 * (census.contacts_in_all - first.contacts_in_all) as f64 / f64::from(count) / time,
        census.energy / first.energy - 1.0,
        overlap / (2.0 * Ball::POOL.radius),
        f64::from(parts) / f64::from(ticks),
        1e3 * (census.late - first.late) as f64
            / (census.contacts_in_all - first.contacts_in_all).max(1) as f64,
        census.saturated,
        census.speed,
    );
}
