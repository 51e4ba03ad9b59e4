//! Shots a second of a search, and the library played through.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use masse::physics::exact::{Limits, solve};
use masse::physics::scene::Solver;
use masse::scenarios::expect::miss;
use masse::scenarios::file;
use masse::scenarios::library;
use masse::scenarios::search::{self, Plan, Player};

/// Two balls: a pot, and the cue ball to a place.
const TWO_BALLS: &str = r#"(table: NineFoot,
    balls: [(name: "cue", position: (-0.6, 0.1)), (name: "1", position: (0.2, 0.25))],
    shot: (ball: "cue", heading_deg: -10, speed: 3),
    free: [Stroke(Heading, -25, 5), Stroke(Speed, 0.5, 5), Stroke(Side, -0.3, 0.3), Stroke(Height, -0.35, 0.35)],
    expect: [Potted(ball: "1", pocket: "foot right"), Near(ball: "cue", at: Position(-0.5, -0.3), within: 0.001)])"#;

fn searches(criterion: &mut Criterion) {
    let scenario = file::parse(TWO_BALLS, "bench").expect("a sound scene");
    let mut group = criterion.benchmark_group("search");
    group.sample_size(10);
    let plan = Plan { seed: 1, shots: 1 };
    let shots = search::solve(&scenario, plan, &()).expect("a search").shots;
    group.throughput(Throughput::Elements(shots));
    group.bench_function("a round with two balls, all threads", |bench| {
        bench.iter(|| search::solve(black_box(&scenario), plan, &()));
    });
    group.throughput(Throughput::Elements(1));
    let mut player = Player::default();
    group.bench_function("one shot with two balls, judged", |bench| {
        bench.iter(|| {
            let record = player
                .play(black_box(&scenario.scene))
                .expect("a sound shot");
            miss(&scenario.scene, record, &scenario.expect)
        });
    });
    group.finish();
}

fn the_library(criterion: &mut Criterion) {
    let mut shots = Vec::new();
    for built_in in library::BUILT_IN {
        let scenario = built_in.scenario().expect("a sound scene");
        if !scenario.expect.is_empty() && scenario.scene.solver == Solver::Exact {
            shots.push(scenario);
        }
    }
    let mut group = criterion.benchmark_group("library");
    group.throughput(Throughput::Elements(shots.len() as u64));
    group.bench_function("every shot by the exact solver, judged", |bench| {
        bench.iter(|| {
            for shot in &shots {
                let record = solve(&shot.scene, Limits::default()).expect("a sound scene");
                black_box(shot.judge(&record));
            }
        });
    });
    group.finish();
}

criterion_group!(benches, searches, the_library);
criterion_main!(benches);
