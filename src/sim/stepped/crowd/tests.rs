//! The short forms of laws are the laws.

use glam::{DVec2, DVec3};

use crate::physics::ball::{Ball, State};
use crate::physics::contact::{Track, pair};
use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::{BallBallLaw, Frictionless, PairContact};
use crate::sim::stepped::crowd::body::{Body, Gliding};
use crate::sim::stepped::crowd::meeting::{bent, straight};

/// Numbers that repeat after a long time, from -1 to 1.
fn numbers() -> impl FnMut() -> f64 {
    let mut k = 0.0;
    move || {
        k += 1.0;
        libm::fmod(k * 0.754_877_666_246_69 + k * k * 0.000_913, 2.0) - 1.0
    }
}

#[test]
fn straight_lines_meet_when_the_contact_of_all_balls_says() {
    let mut next = numbers();
    let (mut met, reach) = (0, 0.057);
    for _ in 0..20_000 {
        let offset = 0.15 * DVec2::new(next(), next());
        let velocity = 3.0 * DVec2::new(next(), next());
        let track = |position: DVec2, velocity: DVec2| Track {
            position: DVec3::new(position.x, 0.0, position.y),
            velocity: DVec3::new(velocity.x, 0.0, velocity.y),
            acceleration: DVec3::ZERO,
        };
        let paths = [track(DVec2::ZERO, DVec2::ZERO), track(offset, velocity)];
        let expected = pair(&paths[0], &paths[1], reach, 1e3).expect("finite");
        let gap = offset.length_squared() - reach * reach;
        let found = straight(gap, offset.dot(velocity), velocity.length_squared());
        assert_eq!(expected.is_some(), found.is_some(), "{offset} {velocity}");
        if let (Some(expected), Some(found)) = (expected, found) {
            assert!((expected - found).abs() < 1e-9, "{expected} {found}");
            met += 1;
        }
    }
    assert!(met > 3000, "{met}");
}

#[test]
fn bent_paths_meet_when_the_contact_of_all_balls_says() {
    let mut next = numbers();
    let (mut plain, mut met, reach, tick) = ([0; 3], [0; 3], 0.057, 0.02);
    for k in 0..40_000 {
        let offset = 0.15 * DVec2::new(next(), next());
        let velocity = 3.0 * DVec2::new(next(), next());
        let pull = [2.0, 20.0, 200.0][k % 3];
        let acceleration = pull * DVec2::new(next(), next());
        let track = |position: DVec2, velocity: DVec2, acceleration: DVec2| Track {
            position: DVec3::new(position.x, 0.0, position.y),
            velocity: DVec3::new(velocity.x, 0.0, velocity.y),
            acceleration: DVec3::new(acceleration.x, 0.0, acceleration.y),
        };
        let rest = track(DVec2::ZERO, DVec2::ZERO, DVec2::ZERO);
        let expected = pair(&rest, &track(offset, velocity, acceleration), reach, tick);
        let expected = expected.expect("finite");
        let are_apart = offset.length() > reach;
        met[k % 3] += u32::from(are_apart && expected.is_some());
        let Some(found) = bent(offset, velocity, acceleration, reach).filter(|time| *time < tick)
        else {
            continue;
        };
        plain[k % 3] += 1;
        let expected = expected.expect("what is plain is so");
        let off = (expected - found).abs();
        assert!(off < 1e-12 + 1e-11 * expected, "{expected} {found} {off:e}");
    }
    // Cloth pulls at 2 m/s², and a tick is no longer: there nearly all is plain.
    assert!(
        met[0] > 300 && 10 * plain[0] > 9 * met[0],
        "{plain:?} of {met:?}"
    );
}

#[test]
fn smooth_equal_balls_collide_by_the_law() {
    let (mut next, laws, ball) = (
        numbers(),
        Laws::ideal(),
        Ball {
            spins: false,
            ..Ball::POOL
        },
    );
    for _ in 0..1000 {
        let (normal, restitution) = (DVec2::from_angle(3.0 * next()), 0.5 + 0.5 * next());
        let state = |place: DVec2, velocity: DVec2| State {
            velocity: DVec3::new(velocity.x, 0.0, velocity.y),
            ..State::at_rest(DVec3::new(place.x, ball.radius, place.y))
        };
        let one = state(DVec2::ZERO, DVec2::new(next(), next()) + normal);
        let other = state(
            2.0 * ball.radius * normal,
            DVec2::new(next(), next()) - normal,
        );
        let law = BallBallLaw::Frictionless(Frictionless { restitution });
        let contact = PairContact::between(&one, &other);
        let outcome = law.collide((&ball, &one), (&ball, &other), &contact);
        if outcome.impulse == 0.0 {
            continue;
        }
        let at = 0.7;
        let start = |state: &State| Gliding::start(&laws.motion, &ball, state, at);
        let bodies = Gliding::collide([&start(&one), &start(&other)], at, restitution);
        for (body, state) in bodies
            .expect("a short form")
            .iter()
            .zip([outcome.first, outcome.second])
        {
            let off = (body.state(&ball, at).velocity - state.velocity).length();
            let moved = (body.state(&ball, at).position - state.position).length();
            assert!(off < 1e-13 && moved < 1e-13, "{off} m/s, {moved} m");
        }
    }
}
