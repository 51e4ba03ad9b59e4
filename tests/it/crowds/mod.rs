//! Crowds against the solver for few balls, against the exact solver, and against the laws of conservation.

mod collision_rate;
mod conservation;
mod galton;
mod refusals;
mod same_bits;
mod scenes;
mod single;
mod tilted;
mod with_cloth;

use glam::DVec3;
use masse::physics::ball::{Ball, State};
use masse::physics::laws::Laws;
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::sim::stepped::crowd::{Census, Crowd};
use masse::sim::stepping;

/// A ball without spin.
const SMOOTH: Ball = Ball {
    spins: false,
    ..Ball::POOL
};

/// Balls on a lattice in a square box, so dense that they cover this share of it, each at this speed in its own direction.
fn gas(count: usize, share: f64, speed: f64, laws: Laws, ball: Ball) -> Scene {
    let columns = (count as f64).sqrt().ceil();
    let pitch = ball.radius * (std::f64::consts::PI / share).sqrt();
    let side = columns * pitch;
    let table = Preset::Box {
        length: side,
        width: side,
    };
    let mut scene = Scene::new(table.table(), laws);
    for i in 0..count {
        let (column, row) = (i as f64 % columns, (i as f64 / columns).floor());
        let place = |k: f64| (k + 0.5) * pitch - 0.5 * side;
        let index = scene.place(&i.to_string(), ball, place(column), place(row));
        let angle = i as f64 * 2.399_963;
        let velocity = speed * DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
        scene.balls[index].state.velocity = velocity;
    }
    as_crowd(&mut scene, 1.0 / 120.0, None);
    scene
}

fn as_crowd(scene: &mut Scene, tick: f64, grid: Option<(u32, u32)>) {
    scene.solver = Solver::Stepped(Stepped {
        tick,
        grid,
        locate: true,
        crowd: true,
        ..Stepped::default()
    });
}

/// Plays so many ticks on so many threads.
fn play(scene: &Scene, ticks: u32, threads: usize) -> (Vec<State>, Census) {
    let mut app = stepping::headless_app(scene);
    let mut crowd = app.world_mut().resource_mut::<Crowd>();
    crowd.threads = Some(threads);
    stepping::step(&mut app, ticks);
    let census = app.world().resource::<Census>().clone();
    (stepping::states(&mut app), census)
}

fn energy(states: &[State], ball: &Ball) -> f64 {
    states.iter().map(|state| ball.kinetic_energy(state)).sum()
}
