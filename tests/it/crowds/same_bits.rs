//! One answer, whoever computes it, and near that of the solver for few balls.

use glam::DVec3;
use masse::physics::ball::{Ball, State};
use masse::physics::laws::Laws;
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::sim::stepping;

use super::{SMOOTH, as_crowd, gas, play};

/// The same scene in the solver for few balls.
fn few(scene: &Scene, ticks: u32) -> Vec<State> {
    let mut scene = scene.clone();
    let Solver::Stepped(stepped) = scene.solver else {
        panic!("a stepped scene");
    };
    scene.solver = Solver::Stepped(Stepped {
        grid: Some((60, 60)),
        crowd: false,
        ..stepped
    });
    let mut app = stepping::headless_app(&scene);
    stepping::step(&mut app, ticks);
    stepping::states(&mut app)
}

/// The same numbers but for rounding: the two solvers count time from different moments. A contact makes an error of a
/// bit some ten times as large.
fn assert_close(a: &[State], b: &[State], what: &str) {
    assert_eq!(a.len(), b.len());
    for (i, (a, b)) in a.iter().zip(b).enumerate() {
        let off = (a.position - b.position).length() + (a.velocity - b.velocity).length();
        assert!(off < 1e-8, "{what}: ball {i} is off by {off}");
    }
}

fn assert_same(a: &[State], b: &[State], what: &str) {
    assert_eq!(a.len(), b.len());
    for (i, (a, b)) in a.iter().zip(b).enumerate() {
        assert_eq!(a, b, "{what}: ball {i}");
    }
}

/// Most balls are where the solver for few balls has them. A crowd gives up the order of time for a few contacts in a
/// thousand, and what such a ball meets is off from then on: at most this share of the balls after this many ticks.
fn assert_nearly(scene: &Scene, ticks: u32, share: f64) {
    let (expected, (states, census)) = (few(scene, ticks), play(scene, ticks, 2));
    let off = |(a, b): &(&State, &State)| (a.position - b.position).length() > 1e-8;
    let off = expected.iter().zip(&states).filter(off).count();
    assert!(
        (off as f64) < share * states.len() as f64,
        "{off}: {census:?}"
    );
    assert!(census.late * 100 < census.contacts_in_all, "{census:?}");
}

#[test]
fn a_gas_ends_where_the_solver_for_few_balls_ends_it() {
    let scene = gas(3000, 0.4, 1.0, Laws::ideal(), SMOOTH);
    assert_nearly(&scene, 10, 0.05);
    let (_, census) = play(&scene, 20, 2);
    assert!(census.contacts_in_all > 5_000, "{census:?}");
    assert_eq!(census.parts, 1);
}

#[test]
fn threads_change_no_bit() {
    let scene = gas(2500, 0.5, 2.0, Laws::ideal(), SMOOTH);
    for grid in [None, Some((20, 20)), Some((50, 50)), Some((130, 7))] {
        let mut scene = scene.clone();
        as_crowd(&mut scene, 1.0 / 120.0, grid);
        let (expected, _) = play(&scene, 60, 1);
        for threads in [2, 3, 8] {
            let (states, _) = play(&scene, 60, threads);
            assert_same(&expected, &states, &format!("{threads} threads, {grid:?}"));
        }
    }
}

#[test]
fn threads_change_no_bit_with_cloth_and_spin() {
    let mut scene = gas(2500, 0.5, 2.0, Laws::default(), Ball::POOL);
    for ball in &mut scene.balls {
        ball.state.angular_velocity = 30.0 * ball.state.velocity;
    }
    let (expected, census) = play(&scene, 90, 1);
    assert!(census.contacts_in_all > 10_000, "{census:?}");
    for threads in [1, 2, 5] {
        let (states, _) = play(&scene, 90, threads);
        assert_same(&expected, &states, &format!("{threads} threads"));
    }
}

/// A row of touching balls carries a blow from one end to the other in no time, through every stripe.
#[test]
fn a_blow_runs_through_all_stripes_of_a_frozen_row() {
    let radius = SMOOTH.radius;
    let table = Preset::Box {
        length: 70.0 * radius,
        width: 500.0 * radius,
    };
    let mut scene = Scene::new(table.table(), Laws::ideal());
    for i in 0..200 {
        scene.place(
            &i.to_string(),
            SMOOTH,
            0.0,
            (2.0 * f64::from(i) - 200.0) * radius,
        );
    }
    let cue = scene.place("cue", SMOOTH, 0.0, -202.5 * radius);
    scene.balls[cue].state.velocity = DVec3::Z;
    as_crowd(&mut scene, 1.0 / 60.0, None);
    let (expected, _) = play(&scene, 20, 1);
    let (states, census) = play(&scene, 20, 2);
    assert_same(&expected, &states, "frozen row");
    // A crowd passes the blow on from ball to ball; the solver for few balls resolves what touches together.
    assert_close(&few(&scene, 20), &states, "frozen row");
    assert!(census.contacts_in_all >= 200, "{census:?}");
    assert!(states[199].velocity.z > 0.99, "{:?}", states[199]);
}

/// Pegs are cushions like any other.
#[test]
fn balls_among_pegs_end_where_the_solver_for_few_balls_ends_them() {
    let mut scene = gas(1600, 0.2, 1.5, Laws::ideal(), SMOOTH);
    let half = 0.5 * scene.table.length;
    for i in 0..200 {
        let (column, row) = (f64::from(i % 20), f64::from(i / 20));
        let pitch = 2.0 * half / 41.0;
        // Between the balls of the lattice.
        let center = glam::DVec2::new(
            column * 2.0 * pitch + pitch - half,
            row * 4.0 * pitch + pitch - half,
        );
        let arc = masse::physics::table::Arc {
            center,
            radius: 0.002,
        };
        scene
            .table
            .cushions
            .push(masse::physics::table::Cushion::Arc(arc));
    }
    assert_nearly(&scene, 20, 0.05);
    let (_, census) = play(&scene, 20, 2);
    assert!(census.cushions > 0);
}
