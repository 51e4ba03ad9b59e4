//! How often balls of a gas meet: by the crowd, by the exact solver, and by kinetic theory.

use masse::physics::exact::{Engine, Limits, Watch};
use masse::physics::laws::Laws;
use masse::physics::record::{Event, EventKind};
use masse::physics::scene::Scene;
use masse::report::speed_and_error::enskog_rate;
use masse::sim::stepped::crowd::Census;
use masse::sim::stepping;

use super::{SMOOTH, as_crowd, gas};

const BALLS: usize = 2500;
/// Seconds after which the lattice is forgotten, fifty contacts of each ball.
const SETTLE: u32 = 1;
/// Seconds that are counted: a hundred and thirty thousand contacts, of which chance alone makes 0.3 % more or less.
const COUNT: u32 = 2;

#[derive(Default)]
struct Pairs(u64);

impl Watch for Pairs {
    fn event(&mut self, event: &Event) {
        self.0 += u64::from(event.kind == EventKind::BallBall);
    }
}

/// Contacts of a ball in a second: each of a pair counts for both.
fn of_a_ball(pairs: u64) -> f64 {
    2.0 * pairs as f64 / BALLS as f64 / f64::from(COUNT)
}

fn exact(scene: &Scene) -> f64 {
    let mut engine = Engine::new(scene, Limits { events: u64::MAX }).expect("sound");
    engine.advance(f64::from(SETTLE), &mut ()).expect("sound");
    let mut pairs = Pairs::default();
    let end = f64::from(SETTLE + COUNT);
    engine.advance(end, &mut pairs).expect("sound");
    of_a_ball(pairs.0)
}

fn crowd(scene: &Scene, rate: u32) -> f64 {
    let mut scene = scene.clone();
    as_crowd(&mut scene, 1.0 / f64::from(rate), None);
    let mut app = stepping::headless_app(&scene);
    stepping::step(&mut app, SETTLE * rate);
    let first = app.world().resource::<Census>().contacts_in_all;
    stepping::step(&mut app, COUNT * rate);
    of_a_ball(app.world().resource::<Census>().contacts_in_all - first)
}

#[test]
fn a_ball_of_a_crowd_meets_as_many_others_as_by_the_exact_solver() {
    let scene = gas(BALLS, 0.4, 1.0, Laws::ideal(), SMOOTH);
    let truth = exact(&scene);
    let rates = [60, 120, 1000].map(|rate| (rate, crowd(&scene, rate)));
    let theory = enskog_rate(0.4, SMOOTH.radius, 1.0);
    println!("exact {truth:.2}, crowd {rates:.2?}, Enskog {theory:.2} contacts of a ball a second");
    for (rate, ours) in rates {
        assert!(
            (ours / truth - 1.0).abs() < 0.02,
            "1/{rate} s: {ours}, exact {truth}"
        );
    }
    // Balls at a wall are nearer to each other: in a box of 2,500 the rate is 1 % above that of an endless gas.
    let above = truth / theory - 1.0;
    assert!((0.0..0.02).contains(&above), "{truth}, Enskog {theory}");
}
