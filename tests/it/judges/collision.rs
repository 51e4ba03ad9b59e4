//! J3 and J4: stun shots, head-on shots, unequal masses.

use glam::DVec3;

use masse::physics::ball::{Ball, State};
use masse::physics::laws::ball_ball::{Friction, PairContact};

use super::{cut_line, hit, moving, rough, smooth, turn};
use crate::closeness::{assert_close, assert_printed, assert_relative};

#[test]
fn j3_stun_leaves_at_a_right_angle() {
    for cut_deg in [1.0, 10.0, 30.0, 45.0, 60.0, 80.0, 89.0] {
        let cut = f64::to_radians(cut_deg);
        let after = hit(&smooth(1.0), &moving(DVec3::X, DVec3::ZERO), cut_line(cut));
        let (cue, object) = (after.first.velocity, after.second.velocity);
        assert_close("object", object.length(), libm::cos(cut), 1e-15, "m/s");
        assert_close("cue", cue.length(), libm::sin(cut), 1e-14, "m/s");
        assert_close("v₁·v₂", cue.dot(object), 0.0, 1e-15, "m²/s²");
    }
}

#[test]
fn j3_restitution_closes_the_angle() {
    let cut = f64::to_radians(30.0);
    for (restitution, printed) in [(0.95, 87.521), (0.897, 84.903)] {
        let after = hit(
            &smooth(restitution),
            &moving(DVec3::X, DVec3::ZERO),
            cut_line(cut),
        );
        let angle = turn(after.first.velocity, after.second.velocity).abs();
        let expected = libm::atan(2.0 * libm::tan(cut) / (1.0 - restitution));
        assert_close("separation", angle, expected, 1e-14, "rad");
        assert_printed("separation", angle.to_degrees(), printed, 3, "°");
    }
}

#[test]
fn j3_friction_closes_it_further() {
    let (sin, cos) = (0.5, libm::cos(f64::to_radians(30.0)));
    let cases = [
        (0.95, 0.06, 83.808),
        (0.897, 0.06, 80.915),
        (0.95, 0.1, 82.273),
        (0.897, 0.1, 79.089),
    ];
    for (restitution, mu, printed) in cases {
        let law = rough(restitution, Friction::Constant(mu));
        let after = hit(
            &law,
            &moving(DVec3::X, DVec3::ZERO),
            cut_line(f64::to_radians(30.0)),
        );
        let angle = turn(after.first.velocity, after.second.velocity).abs();
        let share = 0.5 * (1.0 + restitution) * cos;
        let thrown = f64::min(mu * share, sin / 7.0);
        let cue = libm::atan2(sin - thrown, cos - share);
        let object = libm::atan2(thrown, share);
        assert_close("separation", angle, cue - object, 1e-13, "rad");
        // The printed values at 0.1 are those of the sticking branch where friction suffices to stick.
        assert_printed("separation", angle.to_degrees(), printed, 3, "°");
    }
}

#[test]
fn j4_head_on_shares_the_speed() {
    for restitution in [0.0, 0.5, 0.89, 0.95, 1.0] {
        for law in [smooth(restitution), rough(restitution, Friction::MARLOW)] {
            let after = hit(&law, &moving(DVec3::X * 3.0, DVec3::ZERO), DVec3::X);
            let (cue, object) = (after.first.velocity.x, after.second.velocity.x);
            assert_close("cue", cue, 1.5 * (1.0 - restitution), 1e-15, "m/s");
            assert_close("object", object, 1.5 * (1.0 + restitution), 1e-15, "m/s");
        }
    }
    // The coursework report's formula is the elastic case: equal balls swap.
    let after = hit(&smooth(1.0), &moving(DVec3::X * 3.0, DVec3::ZERO), DVec3::X);
    assert_eq!(after.first.velocity, DVec3::ZERO);
    assert_eq!(after.second.velocity, DVec3::X * 3.0);
}

#[test]
fn j4_unequal_masses_up_to_a_million_to_one() {
    let contact = PairContact {
        normal: DVec3::X,
        on_slate: true,
        restitution: None,
    };
    for ratio in [1e-6, 1e-3, 0.5, 1.0, 2.0, 1e3, 1e6] {
        for restitution in [0.0, 0.95, 1.0] {
            let (m_1, m_2, v) = (0.17 * ratio, 0.17, 2.0);
            let first = Ball {
                mass: m_1,
                ..Ball::POOL
            };
            let second = Ball {
                mass: m_2,
                ..Ball::POOL
            };
            let before = moving(DVec3::X * v, DVec3::ZERO);
            let rest = State::at_rest(DVec3::X);
            let after = smooth(restitution).collide((&first, &before), (&second, &rest), &contact);
            let (v_1, v_2) = (after.first.velocity.x, after.second.velocity.x);
            let total = m_1 + m_2;
            // At m₁ = e m₂ the first ball stops: there only an absolute error has a meaning.
            let expected = (m_1 - restitution * m_2) / total * v;
            assert_close("v₁", v_1, expected, 1e-15, "m/s");
            if (m_1 - restitution * m_2).abs() > 0.1 * m_1.max(m_2) {
                assert_relative("v₁", v_1, expected, 1e-12, "m/s");
            }
            let expected = (1.0 + restitution) * m_1 / total * v;
            assert_relative("v₂", v_2, expected, 1e-12, "m/s");
            let momentum = m_1 * v_1 + m_2 * v_2;
            assert_relative("momentum", momentum, m_1 * v, 1e-15, "kg m/s");
            assert_relative("impulse", after.impulse, m_2 * v_2, 1e-14, "N s");
        }
    }
}

#[test]
fn a_pair_that_separates_is_left_alone() {
    for law in [smooth(1.0), rough(0.9, Friction::MARLOW)] {
        for velocity in [-DVec3::X, DVec3::Z, DVec3::ZERO] {
            let before = moving(velocity, DVec3::new(1.0, 2.0, 3.0));
            let after = hit(&law, &before, DVec3::X);
            assert_eq!(after.first, before);
            assert_eq!(after.impulse, 0.0);
        }
    }
}
