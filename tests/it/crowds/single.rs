//! A crowd that is kept in single precision.

use masse::physics::ball::{Ball, State};
use masse::physics::laws::Laws;
use masse::physics::scene::{Scene, Solver};

use super::tilted::tilted;
use super::{SMOOTH, energy, gas, play};

fn single(mut scene: Scene) -> Scene {
    let Solver::Stepped(stepped) = &mut scene.solver else {
        panic!("a crowd is stepped");
    };
    stepped.single = true;
    scene
}

#[test]
fn it_is_in_single_precision_and_the_same_on_any_number_of_threads() {
    let scene = single(gas(3000, 0.4, 1.0, Laws::ideal(), SMOOTH));
    let (states, census) = play(&scene, 60, 1);
    assert!(census.contacts_in_all > 20_000, "{census:?}");
    for state in &states {
        for number in [
            state.position.x,
            state.position.z,
            state.velocity.x,
            state.velocity.z,
        ] {
            assert_eq!(number, f64::from(number as f32), "more digits than f32 has");
        }
    }
    assert_eq!(states, play(&scene, 60, 3).0);
}

/// Rounding of half a unit in the last place at each contact, at random, adds up as its root; here it may all go one way.
#[test]
fn energy_is_kept_but_for_the_rounding_of_every_contact() {
    let scene = single(gas(300, 0.4, 1.0, Laws::ideal(), SMOOTH));
    let start: Vec<State> = scene.balls.iter().map(|ball| ball.state).collect();
    let before = energy(&start, &SMOOTH);
    let (states, census) = play(&scene, 10_000, 2);
    let change = (energy(&states, &SMOOTH) / before - 1.0).abs();
    let contacts = 2.0 * (census.contacts_in_all as f64) / 300.0;
    println!("{change:e} after {contacts} contacts of each ball");
    assert!(change > 1e-12, "f64 loses less than f32 can: {change:e}");
    assert!(
        change < contacts * 2.0 * f64::from(f32::EPSILON),
        "{change:e}, {contacts} contacts"
    );
    assert!(census.overlap < 0.01 * 2.0 * SMOOTH.radius, "{census:?}");
}

#[test]
fn it_begins_as_in_double_precision() {
    let double = gas(900, 0.4, 1.0, Laws::ideal(), SMOOTH);
    let (expected, _) = play(&double, 2, 1);
    let (states, _) = play(&single(double), 2, 1);
    let off = |(one, other): (&State, &State)| (one.position - other.position).length();
    let most = expected.iter().zip(&states).map(off).fold(0.0, f64::max);
    assert!(most > 0.0 && most < 1e-5, "{most} m");
}

#[test]
fn cloth_spin_and_slopes_are_refused_by_name() {
    for scene in [
        gas(10, 0.4, 1.0, Laws::default(), SMOOTH),
        gas(10, 0.4, 1.0, Laws::ideal(), Ball::POOL),
        gas(10, 0.4, 1.0, tilted(1.0, 0.0, 1.0), SMOOTH),
    ] {
        let refusal = single(scene).check().expect_err("a refusal").to_string();
        assert!(refusal.starts_with("solver.single: true"), "{refusal}");
    }
    single(gas(10, 0.4, 1.0, Laws::ideal(), SMOOTH))
        .check()
        .expect("sound");
}
