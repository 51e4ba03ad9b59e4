//! One tick of the stepped solver: with the report's grids and without a grid, in one run.
//!
//! Part 1 of the coursework report is the pipeline without a grid, part 2 the one with 20 x 20 and 50 x 50 cells.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use glam::DVec3;
use masse::physics::ball::Ball;
use masse::physics::laws::Laws;
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::sim::stepping;

/// An elastic gas at area fraction 0.4, 1 m/s, in a square box.
fn gas(count: u32, grid: Option<(u32, u32)>, spins: bool) -> Scene {
    let ball = Ball {
        spins,
        ..Ball::POOL
    };
    let columns = f64::from(count).sqrt().ceil();
    let side = (f64::from(count) * std::f64::consts::PI / 0.4).sqrt() * ball.radius;
    let table = Preset::Box {
        length: side,
        width: side,
    }
    .table();
    let laws = if spins {
        Laws::default()
    } else {
        Laws::ideal()
    };
    let mut scene = Scene::new(table, laws);
    let pitch = side / columns;
    for i in 0..count {
        let (column, row) = (f64::from(i) % columns, (f64::from(i) / columns).floor());
        let index = scene.place(
            &i.to_string(),
            ball,
            (column + 0.5) * pitch - 0.5 * side,
            (row + 0.5) * pitch - 0.5 * side,
        );
        let angle = f64::from(i) * 2.399_963;
        scene.balls[index].state.velocity = DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
    }
    scene.solver = Solver::Stepped(Stepped {
        grid,
        ..Stepped::default()
    });
    scene
}

fn ticks(c: &mut Criterion) {
    let mut group = c.benchmark_group("tick");
    group.sample_size(10);
    for (count, spins) in [(100, false), (1000, false), (1000, true), (5750, false)] {
        for grid in [None, Some((20, 20)), Some((50, 50)), Some((70, 70))] {
            if count > 1000 && grid.is_none() {
                continue; // 16 million pairs a tick: the point is made at 1,000
            }
            let name = format!(
                "{count} balls{}",
                if spins { " with spin and cloth" } else { "" }
            );
            let cells = grid.map_or("every pair".to_owned(), |(x, z)| format!("{x}x{z}"));
            let mut app = stepping::headless_app(&gas(count, grid, spins));
            group.bench_function(BenchmarkId::new(name, cells), |b| {
                b.iter(|| stepping::step(black_box(&mut app), 1));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, ticks);
criterion_main!(benches);
