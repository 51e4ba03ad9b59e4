//! H14: what the length of a tick does to the stepped solver, beside the exact one.

use glam::DVec3;

use masse::physics::ball::Ball;
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::sim::stepping::{headless_app, states, step};

/// Ticks a second.
const LADDER: [u32; 5] = [60, 120, 240, 480, 960];

/// When the tables are compared, s: after the hit, a cushion and all slides.
const UNTIL: u32 = 1;

/// A half-ball hit and a cushion, `start` metres earlier or later, so that the tick falls anywhere around the contacts.
fn shot(start: f64) -> Scene {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    let cue = scene.place("cue", Ball::POOL, 0.6 - start, 0.1);
    scene.place("1", Ball::POOL, 0.95, 0.1 + Ball::POOL.radius);
    scene.balls[cue].state.velocity = DVec3::X * 2.0;
    scene.time_limit = f64::from(UNTIL);
    scene
}

/// The mean error in m of the places of both balls, over many starts.
fn error(ticks: u32, locate: bool) -> f64 {
    const STARTS: u32 = 20;
    let mut sum = 0.0;
    for start in 0..STARTS {
        let mut scene = shot(0.05 * f64::from(start) / f64::from(STARTS));
        scene.solver = Solver::Exact;
        let truth = solve(&scene, Limits::default()).expect("a sound scene");
        assert!(truth.events.len() >= 4, "a hit, a cushion and two slides");
        scene.solver = Solver::Stepped(Stepped {
            tick: 1.0 / f64::from(ticks),
            locate,
            ..Stepped::default()
        });
        let mut app = headless_app(&scene);
        step(&mut app, ticks * UNTIL);
        for (stepped, exact) in states(&mut app).iter().zip(&truth.end) {
            sum += (stepped.position - exact.position).length();
        }
    }
    sum / f64::from(2 * STARTS)
}

/// The slope of log error against log tick, by least squares.
fn order(errors: &[f64]) -> f64 {
    let points = LADDER.iter().zip(errors);
    let points: Vec<(f64, f64)> = points
        .map(|(ticks, error)| (-libm::log(f64::from(*ticks)), libm::log(*error)))
        .collect();
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let product: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let square: f64 = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    product / square
}

#[test]
fn h14_located_contacts_make_any_tick_exact_and_others_are_of_first_order() {
    let located = LADDER.map(|ticks| error(ticks, true));
    println!("located: {located:?} m");
    // No order to be fitted: nothing but rounding is left at the longest tick.
    assert!(located.iter().all(|error| *error < 1e-10), "{located:?}");
    let plain = LADDER.map(|ticks| error(ticks, false));
    let order = order(&plain);
    println!("as the tick leaves them: {plain:?} m, order {order:.3}");
    assert!(plain[0] > 1e-3, "{plain:?}");
    assert!((0.75..1.25).contains(&order), "{order}");
}
