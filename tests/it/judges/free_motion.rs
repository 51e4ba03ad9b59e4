//! J1 and J2: slide, roll, spin, rest.

use glam::DVec3;

use masse::physics::ball::{Ball, Motion, State};

use super::{cloth, moving, rolling, settled};
use crate::closeness::{assert_close, assert_printed, assert_relative, assert_vectors};

const BALL: Ball = Ball::POOL;

/// (5/7) v + (2/7) R ω × ŷ: what no force at the lowest point of the ball can change.
fn roll_invariant(state: &State) -> DVec3 {
    5.0 / 7.0 * state.velocity + 2.0 / 7.0 * BALL.radius * state.angular_velocity.cross(DVec3::Y)
}

/// Sliding balls with draw, follow, side and masse spin.
fn sliders() -> [State; 5] {
    [
        moving(DVec3::X * 2.0, DVec3::ZERO),
        moving(DVec3::new(1.3, 0.0, -0.7), DVec3::new(40.0, 25.0, -60.0)),
        moving(DVec3::new(-3.0, 0.0, 0.2), DVec3::new(0.0, -80.0, -120.0)),
        moving(DVec3::new(0.0, 0.0, 1e-3), DVec3::new(300.0, 1.0, 0.0)),
        moving(DVec3::ZERO, DVec3::new(10.0, 0.0, -250.0)),
    ]
}

#[test]
fn j1_a_stunned_ball_slides_then_rolls() {
    let (v, mu, g) = (2.0, 0.2, 9.81);
    let start = moving(DVec3::X * v, DVec3::ZERO);
    assert_eq!(start.motion, Motion::Sliding);
    let slide = cloth().piece(&BALL, &start);
    assert_relative("t", slide.duration, 2.0 * v / (7.0 * mu * g), 1e-15, "s");
    assert_printed("t", slide.duration, 0.29124800, 8, "s");
    let roll = slide.end(&BALL);
    assert_eq!(roll.motion, Motion::Rolling);
    let distance = roll.position.x;
    assert_relative("d", distance, 12.0 * v * v / (49.0 * mu * g), 1e-14, "m");
    assert_printed("d", distance, 0.49928228, 8, "m");
    assert_relative("v", roll.velocity.x, 5.0 * v / 7.0, 1e-15, "m/s");
    let kept = BALL.kinetic_energy(&roll) / BALL.kinetic_energy(&start);
    assert_relative("energy kept", kept, 5.0 / 7.0, 1e-14, "1");
}

#[test]
fn j1_the_roll_ends_in_exact_rest() {
    let start = moving(DVec3::X * 2.0, DVec3::ZERO);
    let slide = cloth().piece(&BALL, &start);
    let roll = cloth().piece(&BALL, &slide.end(&BALL));
    let v = 10.0 / 7.0;
    assert_relative("roll time", roll.duration, v / (0.01 * 9.81), 1e-15, "s");
    assert_printed("roll time", roll.duration, 14.5623999, 7, "s");
    let rest = roll.end(&BALL);
    let rolled = rest.position.x - roll.start.position.x;
    assert_relative("roll", rolled, v * v / (2.0 * 0.01 * 9.81), 1e-14, "m");
    assert_printed(
        "total time",
        slide.duration + roll.duration,
        14.8536479,
        7,
        "s",
    );
    assert_printed("total", rest.position.x, 10.9009965, 7, "m");
    assert_eq!(rest.motion, Motion::Rest);
    assert_eq!(rest.velocity, DVec3::ZERO);
    assert_eq!(rest.angular_velocity, DVec3::ZERO);
    assert_eq!(cloth().advance(&BALL, &start, 15.0), rest);
    assert_eq!(cloth().advance(&BALL, &start, 1e6), rest);
}

#[test]
fn j2_the_roll_invariant_holds_through_sliding() {
    for start in sliders() {
        let slide = cloth().piece(&BALL, &start);
        let expected = roll_invariant(&start);
        let scale = start.velocity.length() + BALL.radius * start.angular_velocity.length();
        for step in 0..=100 {
            let state = slide.at(slide.duration * f64::from(step) / 100.0);
            let error = (roll_invariant(&state) - expected).length();
            assert!(
                error <= 1e-14 * scale,
                "W of {start:?} at step {step} is out by {error:e} m/s"
            );
        }
        let end = slide.end(&BALL);
        assert_vectors(
            "rolling velocity",
            end.velocity,
            expected,
            1e-14 * scale,
            "m/s",
        );
        assert_eq!(end.angular_velocity.x, BALL.rolling_spin(end.velocity).x);
        assert_eq!(end.angular_velocity.z, BALL.rolling_spin(end.velocity).z);
    }
}

#[test]
fn j2_slip_keeps_its_direction_and_falls_linearly() {
    for start in sliders() {
        let slide = cloth().piece(&BALL, &start);
        let slip = BALL.slip(start.velocity, start.angular_velocity);
        for step in 1..10 {
            let time = slide.duration * f64::from(step) / 10.0;
            let now = BALL.slip(slide.velocity(time), slide.angular_velocity(time));
            let expected = slip * (1.0 - f64::from(step) / 10.0);
            assert_vectors("slip", now, expected, 1e-14 * slip.length(), "m/s");
        }
        let lost = {
            let mut end = slide.end(&BALL);
            end.angular_velocity.y = start.angular_velocity.y;
            BALL.kinetic_energy(&start) - BALL.kinetic_energy(&end)
        };
        let work = BALL.mass * slip.length_squared() / 7.0;
        let rounding = 1e-14 * BALL.kinetic_energy(&start);
        assert!(
            (lost - work).abs() <= rounding,
            "friction took {lost:e} J, m u²/7 = {work:e} J"
        );
    }
}

#[test]
fn the_order_is_slide_roll_spin_rest() {
    let start = moving(DVec3::X * 0.5, DVec3::Y * 100.0);
    let mut kinds = vec![start.motion];
    let mut state = start;
    let mut time = 0.0;
    while state.motion != Motion::Rest {
        let piece = cloth().piece(&BALL, &state);
        time += piece.duration;
        state = piece.end(&BALL);
        kinds.push(state.motion);
    }
    assert_eq!(
        kinds,
        [
            Motion::Sliding,
            Motion::Rolling,
            Motion::Spinning,
            Motion::Rest
        ]
    );
    assert_close("time to rest", time, 100.0 / 10.9, 1e-14, "s");
    assert_eq!(state.angular_velocity, DVec3::ZERO);
}

#[test]
fn spin_about_the_vertical_decays_in_every_state() {
    let spin = 60.0;
    let mut spinning = State::at_rest(DVec3::Y * BALL.radius);
    spinning.angular_velocity = DVec3::Y * spin;
    let mut roll = rolling(1.0);
    roll.angular_velocity.y = spin;
    let slide = moving(DVec3::X * 5.0, DVec3::Y * spin);
    let kinds = [Motion::Spinning, Motion::Rolling, Motion::Sliding];
    for sign in [1.0, -1.0] {
        for (state, kind) in [spinning, roll, slide].into_iter().zip(kinds) {
            let mut state = cloth().classify(&BALL, state);
            state.angular_velocity.y *= sign;
            assert_eq!(state.motion, kind);
            let later = cloth().advance(&BALL, &state, 0.5);
            assert_eq!(later.motion, kind);
            let expected = sign * (spin - 0.5 * 10.9);
            assert_relative("spin", later.angular_velocity.y, expected, 1e-15, "rad/s");
        }
    }
}

#[test]
fn a_spinning_ball_does_not_drift_and_stops_on_time() {
    let start = moving(DVec3::ZERO, DVec3::Y * -33.0);
    assert_eq!(start.motion, Motion::Spinning);
    let piece = cloth().piece(&BALL, &start);
    assert_relative("time", piece.duration, 33.0 / 10.9, 1e-15, "s");
    let end = piece.end(&BALL);
    assert_eq!(end, State::at_rest(start.position));
}

#[test]
fn a_slow_roll_stops_where_it_should_and_never_turns_back() {
    for speed in [1e-12, 1e-9, 1e-6, 1e-3] {
        let start = rolling(speed);
        assert_eq!(start.motion, Motion::Rolling);
        let roll = cloth().piece(&BALL, &start);
        let rest = roll.end(&BALL);
        let expected = speed * speed / (2.0 * 0.01 * 9.81);
        assert_relative("path", rest.position.x, expected, 1e-14, "m");
        for step in 0..=20 {
            let v = roll.velocity(roll.duration * f64::from(step) / 20.0).x;
            assert!(v >= -1e-15 * speed, "the ball turns back with {v:e} m/s");
        }
    }
}

#[test]
fn draw_that_just_cancels_the_speed_stops_the_ball_dead() {
    // W = 0 needs R ω = −(5/2) v, and friction then stops the ball when slipping ends.
    for v in [0.1, 1.0, 3.0] {
        let spin = -2.5 * BALL.rolling_spin(DVec3::X * v);
        let start = moving(DVec3::X * v, spin);
        let rest = settled(&start);
        assert_eq!(rest.motion, Motion::Rest);
        assert_eq!(rest.velocity, DVec3::ZERO);
        assert_eq!(rest.angular_velocity, DVec3::ZERO);
    }
}

#[test]
fn a_ball_that_almost_rolls_is_no_number_trouble() {
    // Slip of 1e-18 to 1e-6 of the speed: its direction is noise, its effect must be too.
    for power in 6..=18 {
        let slip = libm::pow(10.0, f64::from(-power));
        let mut state = rolling(1.0);
        state.velocity += DVec3::new(slip, 0.0, slip);
        let state = cloth().classify(&BALL, state);
        let later = cloth().advance(&BALL, &state, 1.0);
        let exact = cloth().advance(&BALL, &rolling(1.0), 1.0);
        assert!(later.is_finite());
        assert_vectors(
            "position",
            later.position,
            exact.position,
            2.0 * slip + 1e-15,
            "m",
        );
    }
}

#[test]
fn every_moment_of_a_change_of_motion_can_be_a_start() {
    // A tick that ends exactly on a transition leaves a slip or a speed of 0 behind, whose direction is no number.
    let start = moving(DVec3::new(1.0, 0.0, 0.5), DVec3::Y * 20.0);
    let mut time = 0.0;
    let mut state = start;
    while state.motion != Motion::Rest {
        let piece = cloth().piece(&BALL, &state);
        time += piece.duration;
        for moment in [time.next_down(), time, time.next_up()] {
            let stop = cloth().advance(&BALL, &start, moment);
            let later = cloth().advance(&BALL, &stop, 0.25);
            let whole = cloth().advance(&BALL, &start, moment + 0.25);
            assert!(later.is_finite(), "{moment} s: {stop:?} becomes {later:?}");
            assert_vectors("position", later.position, whole.position, 1e-13, "m");
            assert_vectors("velocity", later.velocity, whole.velocity, 1e-13, "m/s");
        }
        state = piece.end(&BALL);
    }
    for motion in [Motion::Sliding, Motion::Rolling, Motion::Spinning] {
        let mislabelled = State {
            motion,
            ..State::at_rest(DVec3::Y * BALL.radius)
        };
        let later = cloth().advance(&BALL, &mislabelled, 1.0);
        assert_eq!(later, State::at_rest(DVec3::Y * BALL.radius));
    }
}
