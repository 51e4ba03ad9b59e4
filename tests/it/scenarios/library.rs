//! Every shot of the library does what it is said to do, with the same bits every time; where nothing is chaotic the stepped
//! solver agrees.

use masse::physics::exact::{self, Limits};
use masse::physics::record::{EventKind, Record};
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::scenarios::expect::Outcome;
use masse::scenarios::file::Scenario;
use masse::scenarios::library;
use masse::sim::stepping;

/// The scenes that say what must happen in them.
fn shots() -> Vec<(&'static str, Scenario)> {
    library::BUILT_IN
        .iter()
        .map(|built_in| {
            let scenario = built_in
                .scenario()
                .unwrap_or_else(|error| panic!("{error}"));
            (built_in.name, scenario)
        })
        .filter(|(_, scenario)| !scenario.expect.is_empty())
        .collect()
}

fn played(scene: &Scene) -> Record {
    match scene.solver {
        Solver::Exact => exact::solve(scene, Limits::default()).unwrap_or_else(|e| panic!("{e}")),
        Solver::Stepped(_) => stepping::run_to_rest(scene).0,
    }
}

fn missed(name: &str, outcomes: &[Outcome]) -> Vec<String> {
    let missed = outcomes.iter().filter(|outcome| !outcome.met);
    missed
        .map(|outcome| format!("{name}: {}", outcome.sentence()))
        .collect()
}

/// Whether balls touch at the start, or two things happen at one moment: a cluster, whose order is a convention.
fn has_cluster(scene: &Scene, record: &Record) -> bool {
    let touching = scene.balls.iter().enumerate().any(|(i, a)| {
        scene.balls[i + 1..].iter().any(|b| {
            let apart = a.state.position.distance(b.state.position);
            apart < a.ball.radius + b.ball.radius + 1e-6
        })
    });
    let hits = record
        .events
        .iter()
        .filter(|e| e.kind == EventKind::BallBall);
    let times: Vec<f64> = hits.map(|event| event.time).collect();
    touching || times.windows(2).any(|pair| pair[1] - pair[0] < 1e-6)
}

#[test]
fn every_shot_meets_its_expectations_with_the_same_bits_every_time() {
    let shots = shots();
    assert!(shots.len() >= 25, "{} shots", shots.len());
    let mut bad = Vec::new();
    for (name, scenario) in &shots {
        assert!(!scenario.look_for.is_empty(), "{name}: what to look for");
        assert!(!scenario.cameras.is_empty(), "{name}: a camera");
        let record = played(&scenario.scene);
        bad.extend(missed(name, &scenario.judge(&record)));
        // The debug form tells every bit of every number, of paths and events.
        let again = played(&scenario.scene);
        assert_eq!(format!("{record:?}"), format!("{again:?}"), "{name}");
    }
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

#[test]
fn the_stepped_solver_agrees_where_there_is_neither_jump_nor_cluster() {
    let mut bad = Vec::new();
    let mut compared = 0;
    for (name, mut scenario) in shots() {
        if scenario.scene.solver != Solver::Exact {
            continue;
        }
        let record = played(&scenario.scene);
        let jumps = record
            .events
            .iter()
            .any(|event| event.kind == EventKind::Slate);
        if jumps || has_cluster(&scenario.scene, &record) {
            continue;
        }
        scenario.scene.solver = Solver::Stepped(Stepped {
            tick: 1.0 / 2000.0,
            ..Stepped::default()
        });
        compared += 1;
        bad.extend(missed(name, &scenario.judge(&played(&scenario.scene))));
    }
    assert!(compared >= 12, "{compared} shots");
    assert!(bad.is_empty(), "{}", bad.join("\n"));
}

#[test]
fn the_throw_of_the_combination_comes_from_friction() {
    let mut scenario = library::open("throw-combo").unwrap_or_else(|error| panic!("{error}"));
    let of = |scenario: &Scenario| scenario.judge(&played(&scenario.scene));
    assert!(of(&scenario).iter().all(|outcome| outcome.met));
    scenario.scene.laws.ball_ball = masse::physics::laws::Laws::ideal().ball_ball;
    let smooth = of(&scenario);
    assert!(
        !smooth[0].met,
        "smooth balls are not thrown: {}",
        smooth[0].sentence()
    );
}

#[test]
fn the_butterfly_is_mirrored() {
    let scenario = library::open("butterfly").unwrap_or_else(|error| panic!("{error}"));
    let record = played(&scenario.scene);
    for (left, right) in [("1", "2"), ("3", "4"), ("5", "6")] {
        let path = |name: &str| {
            let ball = scenario.scene.ball_named(name).expect("a ball");
            record.state_at(ball, 0.4).position
        };
        let (left, right) = (path(left), path(right));
        assert!((left.x - right.x).abs() < 1e-9 && (left.z + right.z).abs() < 1e-9);
    }
}
