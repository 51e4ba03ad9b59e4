//! Free motion.

use proptest::prelude::*;

use masse::physics::ball::{Ball, Motion};

use super::inputs::{ball_and_state, coursework, motion_law, share};
use super::{assert_no_gain, cases};
use crate::frames::{distance, mirrored, rotated, size};

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn two_short_times_are_one_long(
        law in motion_law(), (ball, state) in ball_and_state(), first in share(10.0), second in share(10.0),
    ) {
        let start = law.classify(&ball, state);
        let stop = law.advance(&ball, &start, first);
        let twice = law.advance(&ball, &stop, second);
        let once = law.advance(&ball, &start, first + second);
        prop_assert!(stop.is_finite() && twice.is_finite() && once.is_finite());
        let apart = distance(&once, &twice, ball.radius);
        let speed = size(&start, ball.radius) + (first + second) * law.pull().length();
        let allowed = 1e-13 * (1.0 + first + second) * speed;
        prop_assert!(apart <= allowed, "{once:?} and {twice:?} are {apart:e} apart, allowed {allowed:e}");
    }

    #[test]
    fn energy_only_falls(law in motion_law(), (ball, state) in ball_and_state(), time in share(30.0)) {
        let mut before = law.classify(&ball, state);
        assert_no_gain(ball.kinetic_energy(&state), ball.kinetic_energy(&before));
        for _ in 0..10 {
            let after = law.advance(&ball, &before, time / 10.0);
            // What a slope gives to the motion it takes from the place.
            let given = ball.mass * law.pull().dot(after.position - before.position);
            assert_no_gain(ball.kinetic_energy(&before) + given.max(0.0), ball.kinetic_energy(&after) + (-given).max(0.0));
            before = after;
        }
    }

    #[test]
    fn a_label_says_what_the_ball_does(law in motion_law(), (ball, state) in ball_and_state(), time in share(30.0)) {
        let start = law.classify(&ball, state);
        for state in [start, law.advance(&ball, &start, time)] {
            let slip = ball.slip(state.velocity, state.angular_velocity);
            match state.motion {
                Motion::Rest => prop_assert!(state.velocity.length() + state.angular_velocity.length() == 0.0),
                Motion::Spinning => prop_assert!(state.velocity.length() == 0.0),
                Motion::Rolling if ball.spins => {
                    prop_assert!(slip.length() <= 1e-13 * size(&start, ball.radius), "rolls with slip {slip:?}");
                }
                _ => {}
            }
        }
        if law.is_closed_form() && start.motion != Motion::Gliding {
            prop_assert_eq!(law.classify(&ball, start), start, "a label given twice is the same label");
        }
    }

    #[test]
    fn no_side_is_preferred(
        law in motion_law().prop_filter("level", |law| law.pull() == glam::DVec3::ZERO), (ball, state) in ball_and_state(), time in share(10.0), angle in -3.2..3.2_f64,
    ) {
        let start = law.classify(&ball, state);
        let end = law.advance(&ball, &start, time);
        let allowed = 1e-13 * (1.0 + time) * size(&start, ball.radius);
        let image = law.advance(&ball, &law.classify(&ball, mirrored(&state)), time);
        prop_assert!(distance(&image, &mirrored(&end), ball.radius) <= allowed);
        let turned = law.advance(&ball, &law.classify(&ball, rotated(&state, angle)), time);
        prop_assert!(distance(&turned, &rotated(&end, angle), ball.radius) <= allowed);
    }

    #[test]
    fn coursework_friction_makes_no_energy_with_its_defaults(
        (ball, state) in ball_and_state(), dt in 1e-4..0.1_f64,
    ) {
        let after = masse::physics::laws::coursework::Coursework::default().rub(&ball, &state, dt);
        assert_no_gain(ball.kinetic_energy(&state), ball.kinetic_energy(&after));
    }

    #[test]
    fn coursework_friction_is_finite_and_mirrors(
        law in coursework(), (ball, state) in ball_and_state(), dt in 1e-6..0.25_f64,
    ) {
        let after = law.rub(&ball, &state, dt);
        prop_assert!(after.is_finite());
        let image = law.rub(&ball, &mirrored(&state), dt);
        let size = size(&state, ball.radius) + size(&after, ball.radius);
        prop_assert!(distance(&image, &mirrored(&after), ball.radius) <= 1e-13 * size);
    }
}

#[test]
fn every_ball_on_cloth_comes_to_exact_rest() {
    let law = masse::physics::laws::Laws::default().motion;
    let mut runner = proptest::test_runner::TestRunner::new(cases());
    runner
        .run(&ball_and_state(), |(ball, state): (Ball, _)| {
            let start = law.classify(&ball, state);
            let end = law.advance(&ball, &start, 1e4);
            prop_assert_eq!(end.motion, Motion::Rest);
            prop_assert_eq!(end.velocity.length() + end.angular_velocity.length(), 0.0);
            Ok(())
        })
        .unwrap();
}
