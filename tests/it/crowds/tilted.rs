//! A tilted table: parabolas, the energy of place and motion, and what comes to lie at the low end.

use glam::DVec3;
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::laws::ball_ball::{BallBallLaw, Frictionless};
use masse::physics::laws::cushion::{CushionLaw, Mirror};
use masse::physics::laws::motion::{Incline, MotionLaw};
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::sim::stepped::crowd::Census;
use masse::sim::stepping;

use super::{SMOOTH, as_crowd, gas, play};

pub(super) fn tilted(x: f64, z: f64, restitution: f64) -> Laws {
    Laws {
        motion: MotionLaw::Inclined(Incline { x, z }),
        ball_ball: BallBallLaw::Frictionless(Frictionless { restitution }),
        cushion: CushionLaw::Mirror(Mirror {
            restitution: restitution.into(),
        }),
        ..Laws::ideal()
    }
}

/// One ball that starts 1 m above the low cushion and 0.3 m/s across.
fn one_ball(restitution: f64) -> Scene {
    let table = Preset::Box {
        length: 2.0 + 2.0 * SMOOTH.radius,
        width: 8.0,
    };
    let mut scene = Scene::new(table.table(), tilted(1.25, 0.0, restitution));
    scene.place("1", SMOOTH, 0.0, -1.5);
    scene.balls[0].state.velocity.z = 0.3;
    scene
}

/// Where a ball of [`one_ball`] is that loses nothing: it falls for √(2 · 1 m / 1.25 m/s²) and rises as long.
fn by_galilei(time: f64) -> DVec3 {
    let fall = (2.0_f64 / 1.25).sqrt();
    let phase = libm::fmod(time + fall, 2.0 * fall) - fall;
    DVec3::new(0.625 * phase * phase, SMOOTH.radius, -1.5 + 0.3 * time)
}

#[test]
fn a_ball_follows_the_parabola_and_bounces_on_the_low_cushion() {
    let rate = 120.0;
    for crowd in [true, false] {
        let mut scene = one_ball(1.0);
        let solver = Stepped {
            tick: 1.0 / rate,
            grid: None,
            crowd,
            ..Stepped::default()
        };
        scene.solver = Solver::Stepped(solver);
        scene.check().expect("sound");
        let mut app = stepping::headless_app(&scene);
        for tick in 1..=1000 {
            stepping::step(&mut app, 1);
            let expected = by_galilei(f64::from(tick) / rate);
            let place = stepping::states(&mut app)[0].position;
            assert!(
                (place - expected).length() < 1e-10,
                "crowd {crowd}, tick {tick}: {place}, not {expected}"
            );
        }
    }
    let mut scene = one_ball(1.0);
    (scene.solver, scene.time_limit) = (Solver::Exact, 8.0);
    let record = solve(&scene, Limits::default()).expect("sound");
    assert!((record.end[0].position - by_galilei(8.0)).length() < 1e-12);
}

#[test]
fn a_gas_on_a_slope_keeps_its_energy_for_ten_thousand_ticks() {
    let scene = gas(300, 0.4, 1.0, tilted(0.4, -0.7, 1.0), SMOOTH);
    let energy = |states: &[masse::physics::ball::State]| -> (f64, f64) {
        let of = |state| scene.laws.motion.potential(&SMOOTH, state);
        (super::energy(states, &SMOOTH), states.iter().map(of).sum())
    };
    let start: Vec<_> = scene.balls.iter().map(|ball| ball.state).collect();
    let (kinetic, potential) = energy(&start);
    let (states, census) = play(&scene, 10_000, 2);
    let after = energy(&states);
    let change = (after.0 + after.1) / (kinetic + potential) - 1.0;
    assert!(change.abs() < 1e-9, "{change:e}: {census:?}");
    assert!((census.energy / after.0 - 1.0).abs() < 1e-12, "{census:?}");
    assert!(
        (census.potential / after.1 - 1.0).abs() < 1e-12,
        "{census:?}"
    );
    // The energies are exchanged. Which way is chance: a gas that fills the box lies about as low as the lattice, which has
    // no balls in the last places of its last row.
    let exchanged = (after.1 - potential).abs();
    assert!(exchanged > 0.02, "{potential} J: {census:?}");
    assert!(census.overlap < 0.01 * 2.0 * SMOOTH.radius, "{census:?}");
}

#[test]
fn a_tilted_crowd_follows_the_exact_solver_on_any_number_of_threads() {
    for (restitution, rates) in [(1.0, [60_u32, 240]), (0.8, [960, 3840])] {
        let mut scene = gas(49, 0.2, 0.6, tilted(-1.0, 0.5, restitution), SMOOTH);
        let mut exact = scene.clone();
        (exact.solver, exact.time_limit) = (Solver::Exact, 0.5);
        let record = solve(&exact, Limits::default()).expect("sound");
        assert!(record.events.len() > 80, "{} events", record.events.len());
        // What closes slowly and soon after another contact loses nothing; with short ticks there is none of it.
        for rate in rates {
            as_crowd(&mut scene, 1.0 / f64::from(rate), None);
            let (states, _) = play(&scene, rate / 2, 1);
            assert_eq!(states, play(&scene, rate / 2, 3).0);
            for (i, (one, other)) in states.iter().zip(&record.end).enumerate() {
                let error = (one.position - other.position).length();
                assert!(error < 1e-9, "{rate} Hz, ball {i}: {error} m");
            }
        }
    }
}

/// Six hundred balls that lose a third of their speed at each impact fall to the low end and stay there.
#[test]
fn what_falls_comes_to_lie() {
    let scene = gas(600, 0.25, 0.3, tilted(1.5, 0.0, 0.66), SMOOTH);
    let mut app = stepping::headless_app(&scene);
    let (mut last, mut deepest, mut gains) = (f64::INFINITY, 0.0_f64, 0.0);
    for _ in 0..3000 {
        stepping::step(&mut app, 1);
        let census = app.world().resource::<Census>();
        let energy = census.energy + census.potential;
        // What sets balls apart that overlap at a cushion adds a little.
        gains += (energy - last).max(0.0);
        (last, deepest) = (energy, deepest.max(census.overlap));
    }
    let census = app.world().resource::<Census>().clone();
    let states = stepping::states(&mut app);
    let half = 0.5 * scene.table.length - SMOOTH.radius;
    let energy_of_fall = -census.potential;
    let rms = (2.0 * census.energy / (600.0 * SMOOTH.mass)).sqrt();
    println!("{rms} m/s, overlap {deepest} m, gains {gains} J, {census:?}");
    assert!(
        gains < 1e-3 * energy_of_fall,
        "{gains} J of {energy_of_fall} J"
    );
    assert!(rms < 0.05, "{rms} m/s: {census:?}");
    assert!(deepest < 0.05 * 2.0 * SMOOTH.radius, "{deepest} m");
    let mut places: Vec<f64> = states.iter().map(|state| half - state.position.x).collect();
    places.sort_by(f64::total_cmp);
    assert!(places[0] > -1e-3, "{} m through the cushion", -places[0]);
    // They fill the low end to a fifth more than they would lie closest.
    let covered = 600.0 * 3.0_f64.sqrt() * 2.0 * SMOOTH.radius * SMOOTH.radius;
    let high = covered / scene.table.width;
    assert!(
        places[599] < 1.35 * high + 2.0 * SMOOTH.radius,
        "{} m, {high} m",
        places[599]
    );
}

/// The solvers for few balls know contacts that last from balls at cushions.
#[test]
fn one_ball_comes_to_lie_by_every_solver() {
    let low = 1.0;
    for crowd in [true, false] {
        let mut scene = one_ball(0.5);
        as_crowd(&mut scene, 1.0 / 120.0, None);
        if let Solver::Stepped(stepped) = &mut scene.solver {
            stepped.crowd = crowd;
        }
        let mut app = stepping::headless_app(&scene);
        stepping::step(&mut app, 1200);
        let state = stepping::states(&mut app)[0];
        assert!(
            (state.position.x - low).abs() < 1e-4,
            "crowd {crowd}: {state:?}"
        );
        assert!(state.velocity.x.abs() < 0.01, "crowd {crowd}: {state:?}");
    }
    let mut scene = one_ball(0.5);
    (scene.solver, scene.time_limit) = (Solver::Exact, 10.0);
    let end = solve(&scene, Limits::default()).expect("sound").end[0];
    assert!((end.position.x - low).abs() < 1e-4, "{end:?}");
}

#[test]
fn a_slope_beyond_upright_is_refused() {
    let scene = gas(10, 0.4, 1.0, tilted(0.0, 11.0, 1.0), SMOOTH);
    let refusal = scene.check().expect_err("a refusal").to_string();
    assert!(refusal.contains("laws.motion.z: 11"), "{refusal}");
}
