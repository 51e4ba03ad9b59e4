//! A tick of a crowd: gas without friction and balls with slide, roll and spin, on one thread and two.
//!
//! `cargo bench --no-default-features --bench crowd`. The same gas in Rapier 2D: `benches/rapier`; both in one run:
//! `scripts/compare_rapier.sh`.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use glam::DVec3;
use masse::physics::ball::Ball;
use masse::physics::laws::Laws;
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::sim::stepped::crowd::{Census, Crowd, Mirror, Pass};
use masse::sim::stepping;

/// Balls on a lattice that cover 0.4 of a square box, 1 m/s each in its own direction.
fn crowd(count: u32, rate: f64, laws: Laws, ball: Ball, grid: Option<(u32, u32)>) -> Scene {
    let columns = f64::from(count).sqrt().ceil();
    let pitch = ball.radius * (std::f64::consts::PI / 0.4).sqrt();
    let side = columns * pitch;
    let table = Preset::Box {
        length: side,
        width: side,
    };
    let mut scene = Scene::new(table.table(), laws);
    for i in 0..count {
        let (column, row) = (f64::from(i) % columns, (f64::from(i) / columns).floor());
        let place = |k: f64| (k + 0.5) * pitch - 0.5 * side;
        let index = scene.place(&i.to_string(), ball, place(column), place(row));
        let angle = f64::from(i) * 2.399_963;
        scene.balls[index].state.velocity = DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
    }
    scene.solver = Solver::Stepped(Stepped {
        tick: 1.0 / rate,
        grid,
        locate: true,
        crowd: true,
        ..Stepped::default()
    });
    scene
}

const SMOOTH: Ball = Ball {
    spins: false,
    ..Ball::POOL
};

fn run(c: &mut Criterion, group: &str, name: BenchmarkId, scene: &Scene, set: impl Fn(&mut Crowd)) {
    let mut group = c.benchmark_group(group);
    group.sample_size(10);
    group.measurement_time(Duration::from_secs(3));
    group.throughput(Throughput::Elements(scene.balls.len() as u64));
    let mut app = stepping::headless_app(scene);
    set(&mut app.world_mut().resource_mut::<Crowd>());
    stepping::step(&mut app, 20);
    group.bench_function(name, |b| {
        b.iter(|| stepping::step(black_box(&mut app), 1));
    });
    group.finish();
    let census = app.world().resource::<Census>();
    let per = 1e9 / scene.balls.len() as f64;
    for pass in Pass::ALL {
        let time = census.times[pass as usize].as_secs_f64();
        print!("{pass:?} {:.1} ns  ", per * time);
    }
    println!(
        "a ball; overlap {:.1e} m, {} contacts",
        census.overlap, census.contacts
    );
}

fn crowds(c: &mut Criterion) {
    for count in [1000, 5750, 50_000, 250_000, 1_000_000] {
        let gas = crowd(count, 120.0, Laws::ideal(), SMOOTH, None);
        let cloth = crowd(count, 60.0, Laws::default(), Ball::POOL, None);
        let mut rest = cloth.clone();
        for ball in &mut rest.balls[1..] {
            ball.state.velocity = DVec3::ZERO;
        }
        for threads in [1, 2] {
            let set = |crowd: &mut Crowd| crowd.threads = Some(threads);
            let name = |what| BenchmarkId::new(what, format!("{threads} threads"));
            let group = format!("{count} balls");
            run(c, &group, name("gas, 120 Hz"), &gas, set);
            run(c, &group, name("slide, roll and spin, 60 Hz"), &cloth, set);
            run(c, &group, name("all but one at rest"), &rest, set);
            run(
                c,
                &group,
                name("gas, components not written"),
                &gas,
                |crowd| {
                    crowd.threads = Some(threads);
                    crowd.mirror = Mirror::WhenAsked;
                },
            );
        }
    }
}

/// The report's own experiment: 5,750 balls, frame time against cells.
fn cells(c: &mut Criterion) {
    for cells in [1, 5, 10, 20, 50, 70, 100, 150, 200, 400] {
        let scene = crowd(5750, 60.0, Laws::ideal(), SMOOTH, Some((cells, cells)));
        let name = BenchmarkId::from_parameter(format!("{cells} x {cells}"));
        run(c, "5750 balls, 60 Hz, cells", name, &scene, |crowd| {
            crowd.threads = Some(1);
        });
    }
}

criterion_group!(benches, crowds, cells);
criterion_main!(benches);
