//! Cushions: the mirror, and Han's impact where it has a short closed form.

use glam::DVec3;

use masse::physics::ball::{Ball, State};
use masse::physics::laws::cushion::{CushionContact, CushionLaw, Han2005, Mirror};
use masse::physics::table::Nose;

use super::{moving, rolling};
use crate::closeness::{assert_close, assert_vectors};

const BALL: Ball = Ball::POOL;

/// A cushion across the path of a ball that comes along x.
fn across(nose_height: f64) -> CushionContact {
    CushionContact {
        normal: -DVec3::X,
        nose_height,
        nose: Nose::Wall,
        restitution: None,
    }
}

fn han(restitution: f64, friction: f64) -> CushionLaw {
    CushionLaw::Han2005(Han2005 {
        restitution: restitution.into(),
        friction: friction.into(),
    })
}

fn rebound(law: &CushionLaw, state: &State, nose_height: f64) -> State {
    law.rebound(&BALL, state, &across(nose_height)).state
}

#[test]
fn the_mirror_turns_the_normal_velocity_and_nothing_else() {
    let spin = DVec3::new(5.0, -20.0, 30.0);
    for restitution in [0.0, 0.5, 0.85, 1.0] {
        let law = CushionLaw::Mirror(Mirror {
            restitution: restitution.into(),
        });
        let before = moving(DVec3::new(2.0, 0.0, 0.7), spin);
        let after = law.rebound(&BALL, &before, &across(0.0366));
        assert_close(
            "normal",
            after.state.velocity.x,
            -2.0 * restitution,
            1e-15,
            "m/s",
        );
        assert_eq!(after.state.velocity.z, 0.7);
        assert_eq!(after.state.angular_velocity, spin);
        let expected = BALL.mass * 2.0 * (1.0 + restitution);
        assert_close("impulse", after.impulse, expected, 1e-15, "N s");
    }
}

#[test]
fn han_2005_at_the_height_of_the_centre() {
    // With h = R the normal is horizontal and the nose rubs like a wall.
    let (e, v_n, v_t) = (0.8, 2.0, 0.3);
    let before = moving(DVec3::new(v_n, 0.0, v_t), DVec3::ZERO);
    let after = rebound(&han(e, 1.0), &before, BALL.radius);
    let expected = DVec3::new(-e * v_n, 0.0, 5.0 / 7.0 * v_t);
    assert_vectors("sticking", after.velocity, expected, 1e-15, "m/s");
    let mu = 0.02;
    let after = rebound(&han(e, mu), &before, BALL.radius);
    let expected = DVec3::new(-e * v_n, 0.0, v_t - mu * (1.0 + e) * v_n);
    assert_vectors("slipping", after.velocity, expected, 1e-15, "m/s");
    // English with no speed along the cushion is turned into it: (2/7) R ω.
    let spin = 12.0;
    let before = moving(DVec3::X * v_n, DVec3::Y * spin);
    let after = rebound(&han(e, 1.0), &before, BALL.radius);
    let expected = 2.0 / 7.0 * BALL.radius * spin;
    assert_close("english", after.velocity.z.abs(), expected, 1e-15, "m/s");
    assert_close(
        "spin left",
        after.angular_velocity.y,
        2.0 / 7.0 * spin,
        1e-14,
        "rad/s",
    );
    // ω along +y is right english: off a cushion straight ahead the ball leaves to the right of the shooter.
    assert!(after.velocity.z > 0.0);
}

#[test]
fn han_2005_square_on_without_spin() {
    for height in [0.8, 1.2, 1.28, 1.4] {
        let sin: f64 = height - 1.0;
        let square = 1.0 - sin * sin;
        for (e, v) in [(0.85, 0.5), (0.85, 3.0), (0.5, 2.0)] {
            let before = moving(DVec3::X * v, DVec3::ZERO);
            let after = rebound(&han(e, 1.0), &before, height * BALL.radius);
            let expected = v * (1.0 - 2.0 / 7.0 * sin * sin - (1.0 + e) * square);
            assert_vectors(
                "velocity",
                after.velocity,
                DVec3::X * expected,
                1e-15,
                "m/s",
            );
            let spin = 5.0 / 7.0 * v * sin / BALL.radius;
            assert_vectors(
                "spin",
                after.angular_velocity,
                DVec3::Z * spin,
                1e-14,
                "rad/s",
            );
        }
    }
}

#[test]
fn running_english_widens_and_check_english_narrows() {
    let law = CushionLaw::Han2005(Han2005::default());
    let angle = |english: f64| {
        let mut state = rolling(1.0);
        state.velocity = DVec3::new(1.0, 0.0, 1.0);
        state.angular_velocity = BALL.rolling_spin(state.velocity) + DVec3::Y * english;
        let after = rebound(&law, &state, 0.0366).velocity;
        libm::atan2(after.z, -after.x).to_degrees()
    };
    let (check, plain, running) = (angle(-40.0), angle(0.0), angle(40.0));
    assert!(
        check < plain - 1.0 && plain + 1.0 < running,
        "{check} {plain} {running}"
    );
}

#[test]
fn a_ball_that_leaves_is_left_alone() {
    for law in CushionLaw::all() {
        for velocity in [-DVec3::X, DVec3::Z, DVec3::ZERO] {
            let before = moving(velocity, DVec3::new(3.0, 2.0, 1.0));
            let after = law.rebound(&BALL, &before, &across(0.0366));
            assert_eq!(after.state, before);
            assert_eq!(after.impulse, 0.0);
        }
    }
}
