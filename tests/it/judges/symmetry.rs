//! No law knows left from right, north from south, or which ball is called the first; and ball-ball not even who moves.

use glam::DVec3;

use masse::physics::ball::{Ball, State};
use masse::physics::cue::{Cue, Shot};
use masse::physics::laws::ball_ball::{BallBallLaw, PairContact};
use masse::physics::laws::cue_ball::strike;
use masse::physics::laws::slate::SlateLaw;

use super::{moving, smooth};
use crate::frames::{distance, mirrored, rotated, rotated_vector};

const HEAVY: Ball = Ball {
    mass: 0.21,
    ..Ball::POOL
};

/// Two balls of unequal mass that meet with everything a ball can have.
fn pair() -> (State, State, PairContact) {
    let first = moving(DVec3::new(1.1, 0.0, -0.4), DVec3::new(20.0, -35.0, -50.0));
    let mut second = moving(DVec3::new(-0.5, 0.0, 0.3), DVec3::new(-8.0, 15.0, 2.0));
    let contact = PairContact {
        normal: DVec3::new(0.8, 0.0, 0.6),
        on_slate: true,
        restitution: None,
    };
    second.position += 2.0 * Ball::POOL.radius * contact.normal;
    (first, second, contact)
}

fn collide(law: &BallBallLaw, first: &State, second: &State, contact: &PairContact) -> [State; 2] {
    let after = law.collide((&Ball::POOL, first), (&HEAVY, second), contact);
    assert!(after.impulse > 0.0);
    [after.first, after.second]
}

#[track_caller]
fn assert_same(what: &str, value: [State; 2], expected: [State; 2]) {
    for (value, expected) in value.iter().zip(&expected) {
        let apart = distance(value, expected, Ball::POOL.radius);
        assert!(
            apart <= 1e-13,
            "{what}: {value:?}, expected {expected:?}, {apart:e} apart"
        );
    }
}

#[test]
fn ball_ball_is_the_same_from_every_side() {
    let (first, second, contact) = pair();
    for law in BallBallLaw::all() {
        let plain = collide(&law, &first, &second, &contact);
        for angle in [0.1, 1.0, 2.5, -3.0] {
            let turned = PairContact {
                normal: rotated_vector(contact.normal, angle),
                ..contact
            };
            let [a, b] = [&first, &second].map(|state| rotated(state, angle));
            let value = collide(&law, &a, &b, &turned);
            assert_same("turned", value, plain.map(|state| rotated(&state, angle)));
        }
    }
}

#[test]
fn ball_ball_mirrors() {
    let (first, second, contact) = pair();
    for law in BallBallLaw::all() {
        let plain = collide(&law, &first, &second, &contact);
        let flipped = PairContact {
            normal: crate::frames::mirrored_vector(contact.normal),
            ..contact
        };
        let value = collide(&law, &mirrored(&first), &mirrored(&second), &flipped);
        assert_same("mirrored", value, plain.map(|state| mirrored(&state)));
    }
}

#[test]
fn ball_ball_does_not_know_who_is_first() {
    let (first, second, contact) = pair();
    for law in BallBallLaw::all() {
        let [a, b] = collide(&law, &first, &second, &contact);
        let swapped = PairContact {
            normal: -contact.normal,
            ..contact
        };
        let after = law.collide((&HEAVY, &second), (&Ball::POOL, &first), &swapped);
        assert_same("swapped", [after.second, after.first], [a, b]);
    }
}

#[test]
fn ball_ball_is_the_same_on_a_moving_train() {
    let (first, second, contact) = pair();
    let train = DVec3::new(7.0, 0.0, -3.0);
    let boarded = |mut state: State| {
        state.velocity += train;
        state
    };
    for law in BallBallLaw::all() {
        // This one knows the cloth, which does not move with the train.
        if matches!(law, BallBallLaw::Mathavan2014(_)) {
            continue;
        }
        let plain = collide(&law, &first, &second, &contact);
        let value = collide(&law, &boarded(first), &boarded(second), &contact);
        assert_same("on a train", value, plain.map(boarded));
    }
}

#[test]
fn a_smooth_elastic_impact_runs_backwards() {
    let (first, second, contact) = pair();
    let reversed = |mut state: State| {
        state.velocity = -state.velocity;
        state
    };
    let [a, b] = collide(&smooth(1.0), &first, &second, &contact);
    let back = collide(&smooth(1.0), &reversed(a), &reversed(b), &contact);
    assert_same("backwards", back.map(reversed), [first, second]);
}

#[test]
fn a_stroke_is_the_same_from_every_side_and_in_a_mirror() {
    let rest = State::at_rest(DVec3::ZERO);
    let cue = Cue::default();
    for slate in SlateLaw::all() {
        for (side, height) in [(0.2, 0.3), (-0.4, 0.1), (0.6, -0.5)] {
            let shot = Shot {
                heading: 0.3,
                elevation: 0.4,
                side,
                height,
                speed: 4.0,
            };
            let plain = strike(&cue, &slate, &Ball::POOL, &rest, &shot).state;
            let turned = Shot {
                heading: 0.3 + 1.9,
                ..shot
            };
            let value = strike(&cue, &slate, &Ball::POOL, &rest, &turned).state;
            assert_same("turned", [value; 2], [rotated(&plain, 1.9); 2]);
            let flipped = Shot {
                heading: -0.3,
                side: -side,
                ..shot
            };
            let value = strike(&cue, &slate, &Ball::POOL, &rest, &flipped).state;
            assert_same("mirrored", [value; 2], [mirrored(&plain); 2]);
        }
    }
}
