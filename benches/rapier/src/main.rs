//! Rapier 2D on the gas of `src/report/speed_and_error/many.rs`: the same box, radii, places, speeds and tick. Prints the time of a
//! tick beside what is left of the energy and how deep balls overlap.
//!
//! Arguments: balls, ticks, ticks a second, threads.

use std::time::Instant;

use rand::{RngExt, SeedableRng};
use rapier2d::prelude::*;

const RADIUS: f64 = 0.028_575;
/// Ticks before the clock starts.
const WARM: u32 = 10;

fn world(count: usize, rate: f64) -> (PhysicsWorld, Vec<RigidBodyHandle>) {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::new(0.0, 0.0);
    world.integration_parameters.dt = (1.0 / rate) as f32;
    // The scale of a ball, without which Rapier sees three contacts a ball where there is one.
    world.integration_parameters.length_unit = 0.1;
    let side = (count as f64 * std::f64::consts::PI / 0.4).sqrt() * RADIUS;
    let half = 0.5 * side as f32;
    for (x, z, w, h) in [
        (-half - 1.0, 0.0, 1.0, half + 2.0),
        (half + 1.0, 0.0, 1.0, half + 2.0),
        (0.0, -half - 1.0, half + 2.0, 1.0),
        (0.0, half + 1.0, half + 2.0, 1.0),
    ] {
        world.insert(
            RigidBodyBuilder::fixed().translation(Vector::new(x, z)),
            ColliderBuilder::cuboid(w, h).restitution(1.0).friction(0.0),
        );
    }
    let columns = (count as f64).sqrt().ceil();
    let pitch = side / columns;
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(5750);
    let mut signed = || rng.random_range(-1.0..1.0);
    let free = 0.9 * (0.5 * pitch - RADIUS);
    let mut drawn = Vec::with_capacity(count);
    for i in 0..count {
        let (column, row) = (i as f64 % columns, (i as f64 / columns).floor());
        let x = (column + 0.5) * pitch - 0.5 * side + free * signed();
        let z = (row + 0.5) * pitch - 0.5 * side + free * signed();
        let mut normal = || (0..12).map(|_| signed()).sum::<f64>() * 0.5 * 0.5_f64.sqrt();
        drawn.push(([x, z], [normal(), normal()]));
    }
    let squares: f64 = drawn.iter().map(|(_, v)| v[0] * v[0] + v[1] * v[1]).sum();
    let scale = (count as f64 / squares).sqrt();
    let mut balls = Vec::with_capacity(count);
    for ([x, z], velocity) in drawn {
        let velocity = Vector::new((scale * velocity[0]) as f32, (scale * velocity[1]) as f32);
        let (ball, _) = world.insert(
            RigidBodyBuilder::dynamic()
                .translation(Vector::new(x as f32, z as f32))
                .linvel(velocity)
                .can_sleep(false),
            ColliderBuilder::ball(RADIUS as f32)
                .restitution(1.0)
                .restitution_combine_rule(CoefficientCombineRule::Max)
                .friction(0.0)
                .friction_combine_rule(CoefficientCombineRule::Min),
        );
        balls.push(ball);
    }
    (world, balls)
}

fn energy(world: &PhysicsWorld, balls: &[RigidBodyHandle]) -> f64 {
    balls
        .iter()
        .map(|ball| f64::from(world.bodies[*ball].linvel().length_squared()))
        .sum()
}

/// Deepest overlap in diameters.
fn overlap(world: &PhysicsWorld, balls: &[RigidBodyHandle]) -> f64 {
    let mut places: Vec<[f64; 2]> = balls
        .iter()
        .map(|ball| world.bodies[*ball].translation())
        .map(|place| [f64::from(place.x), f64::from(place.y)])
        .collect();
    places.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut deepest = 0.0_f64;
    for (i, a) in places.iter().enumerate() {
        for b in places[i + 1..].iter().take_while(|b| b[0] - a[0] < 2.0 * RADIUS) {
            let (dx, dz) = (b[0] - a[0], b[1] - a[1]);
            deepest = deepest.max(1.0 - (dx * dx + dz * dz).sqrt() / (2.0 * RADIUS));
        }
    }
    deepest
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
    let count: usize = get(1, "5750").parse().expect("a number of balls");
    let ticks: u32 = get(2, "100").parse().expect("a number of ticks");
    let rate: f64 = get(3, "120").parse().expect("ticks a second");
    let threads: usize = get(4, "1").parse().expect("a number of threads");
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build_global()
        .expect("the first pool");
    let (mut world, balls) = world(count, rate);
    let before = energy(&world, &balls);
    for _ in 0..WARM {
        world.step();
    }
    let mut times = Vec::new();
    let mut deepest = 0.0_f64;
    let mut busy = 0.0;
    for tick in 0..ticks {
        let (start, used) = (Instant::now(), cpu());
        world.step();
        times.push(start.elapsed().as_secs_f64());
        busy += cpu() - used;
        if tick % 10 == 0 {
            deepest = deepest.max(overlap(&world, &balls));
        }
    }
    times.sort_by(f64::total_cmp);
    let middle = times[times.len() / 2];
    let per = 1e9 / count as f64;
    println!(
        "Rapier, {count} balls, {threads} threads: median {:.3} ms a tick, {:.1} ns a ball and tick, {:.1} ns of CPU; energy left {:.3}, overlap {:.2} diameters",
        1e3 * middle,
        per * middle,
        per * busy / f64::from(ticks),
        energy(&world, &balls) / before,
        deepest,
    );
}
