//! The stepped solver against closed forms and against itself.

use glam::DVec3;

use crate::physics::ball::{Ball, Motion};
use crate::physics::cue::Shot;
use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::{BallBallLaw, Frictionless};
use crate::physics::scene::{PlannedShot, Rack, Scene, Solver, Stepped};
use crate::physics::table::Preset;
use crate::sim::stepping::{headless_app, run_to_rest, states, step};

fn stepped(scene: &mut Scene, tick: f64, grid: Option<(u32, u32)>) {
    scene.solver = Solver::Stepped(Stepped {
        tick,
        grid,
        locate: true,
        crowd: false,
        ..Stepped::default()
    });
}

/// A nine-foot table with room for a long roll: a box 40 m long.
fn long_box() -> Scene {
    Scene::new(
        Preset::Box {
            length: 40.0,
            width: 4.0,
        }
        .table(),
        Laws::default(),
    )
}

#[test]
fn j1_lone_ball_is_exact_at_60_hz() {
    let mut scene = long_box();
    scene.place("cue", Ball::POOL, -18.0, 0.0);
    scene.balls[0].state.velocity = DVec3::new(2.0, 0.0, 0.0);
    stepped(&mut scene, 1.0 / 60.0, Some((20, 20)));
    let (record, _) = run_to_rest(&scene);
    let rolls = record.events[0];
    let expected = 0.291_247_996_505_168_9; // 2 v / (7 mu g)
    assert!(
        (rolls.time - 2.0 * 2.0 / (7.0 * 0.2 * 9.81)).abs() < 1e-12,
        "slide ends at {} s, expected {expected} s",
        rolls.time
    );
    let slid = rolls.first.after.position.x + 18.0;
    let slide = 12.0 * 4.0 / (49.0 * 0.2 * 9.81);
    assert!(
        (slid - slide).abs() < 1e-12,
        "slid {slid} m, expected {slide} m"
    );
    let speed = rolls.first.after.velocity.x;
    assert!((speed - 10.0 / 7.0).abs() < 1e-12, "rolls at {speed} m/s");
    let roll = (10.0 / 7.0) * (10.0 / 7.0) / (2.0 * 0.01 * 9.81);
    let total = record.end[0].position.x + 18.0;
    assert!(
        (total - slide - roll).abs() < 1e-12 * 100.0,
        "total {total} m, expected {} m",
        slide + roll
    );
    assert_eq!(record.end[0].motion, Motion::Rest);
    assert_eq!(record.end[0].velocity, DVec3::ZERO);
    let stop = record.events.last().map_or(0.0, |event| event.time);
    assert!((stop - 14.853_647_9).abs() < 1e-6, "stops at {stop} s");
}

#[test]
fn j2_roll_invariant_holds_through_a_curved_slide() {
    let mut scene = long_box();
    scene.place("cue", Ball::POOL, 0.0, 0.0);
    scene.balls[0].state.velocity = DVec3::new(0.3, 0.0, 2.0);
    scene.balls[0].state.angular_velocity = DVec3::new(-40.0, 20.0, 70.0);
    stepped(&mut scene, 1.0 / 60.0, None);
    let invariant = |state: &crate::physics::ball::State| {
        5.0 / 7.0 * state.velocity
            + 2.0 / 7.0 * Ball::POOL.radius * state.angular_velocity.cross(DVec3::Y)
    };
    let expected = invariant(&scene.balls[0].state);
    let mut app = headless_app(&scene);
    for tick in 0..40 {
        step(&mut app, 1);
        let state = states(&mut app)[0];
        if state.motion != Motion::Sliding {
            break;
        }
        let error = (invariant(&state) - expected).length();
        assert!(
            error < 1e-14,
            "tick {tick}: invariant is off by {error} m/s"
        );
    }
}

fn break_shot(grid: Option<(u32, u32)>) -> Scene {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    Rack::EightBall.place(&mut scene, Ball::POOL, 0.0, 1);
    scene.shot = Some(PlannedShot {
        ball: 0,
        shot: Shot {
            speed: 7.0,
            heading: 0.003,
            ..Shot::default()
        },
    });
    stepped(&mut scene, 1.0 / 120.0, grid);
    scene
}

#[test]
fn a_break_ends_in_the_same_bits_with_any_grid_and_without() {
    let (without, _) = run_to_rest(&break_shot(None));
    for grid in [(20, 20), (50, 50), (1, 1), (7, 3)] {
        let (with, _) = run_to_rest(&break_shot(Some(grid)));
        assert_eq!(without.events.len(), with.events.len(), "grid {grid:?}");
        for (a, b) in without.events.iter().zip(&with.events) {
            assert_eq!(a, b, "grid {grid:?}");
        }
        assert_eq!(without.end, with.end, "grid {grid:?}");
    }
    assert!(without.events.len() > 60, "{} events", without.events.len());
}

#[test]
fn energy_never_rises_in_a_break() {
    let scene = break_shot(Some((20, 20)));
    let mut app = headless_app(&scene);
    let mut last = f64::INFINITY;
    for tick in 0..600 {
        step(&mut app, 1);
        let energy: f64 = states(&mut app)
            .iter()
            .map(|state| {
                // Pocketed balls have fallen.
                let height = state.position.y - Ball::POOL.radius;
                Ball::POOL.kinetic_energy(state) + Ball::POOL.mass * 9.81 * height
            })
            .sum();
        assert!(
            energy <= last + 1e-13,
            "tick {tick}: {last} J became {energy} J"
        );
        last = energy;
    }
}

#[test]
fn nothing_overlaps_and_nobody_leaves_after_a_break() {
    let scene = break_shot(Some((20, 20)));
    let mut app = headless_app(&scene);
    for tick in 0..1200 {
        step(&mut app, 1);
        let states = states(&mut app);
        for (i, a) in states
            .iter()
            .enumerate()
            .filter(|(_, s)| s.motion.in_play())
        {
            assert!(
                a.position.x.abs() < 1.4 && a.position.z.abs() < 0.8,
                "tick {tick} ball {i}"
            );
            for b in states[..i].iter().filter(|s| s.motion.in_play()) {
                let overlap = 2.0 * Ball::POOL.radius - (a.position - b.position).length();
                assert!(overlap < 1e-6, "tick {tick}: overlap {overlap} m");
            }
        }
    }
}

#[test]
fn fast_ball_in_a_box_keeps_its_energy_and_stays() {
    for speed in [13.0, 30.0, 100.0] {
        let mut scene = Scene::new(Preset::NineFoot.table(), Laws::ideal());
        scene.table = Preset::Box {
            length: 2.54,
            width: 1.27,
        }
        .table();
        scene.place("cue", Ball::POOL, 0.1, 0.05);
        scene.place("1", Ball::POOL, 0.6, 0.05);
        scene.balls[0].state.velocity = DVec3::new(0.8, 0.0, 0.6) * speed;
        stepped(&mut scene, 1.0 / 60.0, Some((20, 20)));
        let mut app = headless_app(&scene);
        step(&mut app, 600);
        let end = states(&mut app);
        let energy: f64 = end.iter().map(|s| s.velocity.length_squared()).sum();
        assert!((energy / (speed * speed) - 1.0).abs() < 1e-12, "{energy}");
        for state in end {
            assert!(state.position.x.abs() <= 1.27 && state.position.z.abs() <= 0.635);
        }
    }
}

#[test]
fn coursework_runs_with_and_without_location() {
    for locate in [true, false] {
        let mut scene = Scene::new(
            Preset::Box {
                length: 2.54,
                width: 1.27,
            }
            .table(),
            Laws::coursework(),
        );
        scene.place("cue", Ball::POOL, -0.6, 0.0);
        scene.place("1", Ball::POOL, 0.3, 0.01);
        scene.balls[0].state.velocity = DVec3::new(12.0, 0.0, 3.0);
        scene.solver = Solver::Stepped(Stepped {
            tick: 1.0 / 60.0,
            grid: Some((20, 20)),
            locate,
            crowd: false,
            ..Stepped::default()
        });
        scene.time_limit = 30.0;
        let (record, _) = run_to_rest(&scene);
        for state in &record.end {
            assert!(
                state.position.x.abs() < 1.27 && state.position.z.abs() < 0.635,
                "{state:?}"
            );
        }
        assert!(record.events.len() > 5);
        assert!(
            record.end.iter().all(|state| state.motion == Motion::Rest),
            "{:?}",
            record.end
        );
    }
}

#[test]
fn a_ball_without_spin_carries_none() {
    let mut scene = long_box();
    scene.laws.ball_ball = BallBallLaw::Frictionless(Frictionless { restitution: 1.0 });
    scene.place(
        "cue",
        Ball {
            spins: false,
            ..Ball::POOL
        },
        0.0,
        0.0,
    );
    scene.balls[0].state.velocity = DVec3::X;
    let (record, _) = run_to_rest(&scene);
    assert_eq!(record.end[0].angular_velocity, DVec3::ZERO);
    let distance = 1.0 / (2.0 * 0.01 * 9.81);
    assert!((record.end[0].position.x - distance).abs() < 1e-12 * 10.0);
}

#[test]
fn the_record_knows_every_state_between_the_events() {
    let scene = break_shot(Some((20, 20)));
    let mut app = headless_app(&scene);
    step(&mut app, 240);
    let now = states(&mut app);
    let clock = *app.world().resource::<crate::sim::clock::Clock>();
    let recorder = app.world().resource::<crate::sim::recorder::Recorder>();
    let record = recorder.record(clock.time(), None);
    for (ball, state) in now.iter().enumerate() {
        let error = (record.end[ball].position - state.position).length();
        assert!(error < 1e-12, "ball {ball}: {error} m");
    }
}
