//! J5 to J7: where a rolling, drawing or following cue ball goes after the hit (Alciatore, TP A.4, B.13, 3.3).

use glam::DVec3;

use masse::physics::ball::Ball;
use masse::physics::laws::ball_ball::{BallBallLaw, Friction};

use super::{cloth, cut_line, hit, moving, rolling, rough, settled, smooth, turn};
use crate::closeness::{assert_close, assert_printed};

/// Deflection in rad and settled speed per speed of a cue ball with spin k times that of rolling.
fn deflection(law: &BallBallLaw, speed: f64, roll: f64, cut: f64) -> (f64, f64) {
    let spin = roll * Ball::POOL.rolling_spin(DVec3::X * speed);
    let after = hit(law, &moving(DVec3::X * speed, spin), cut_line(cut));
    let end = settled(&after.first).velocity;
    // The object ball goes to the left, so the cue ball is deflected to the right.
    (-turn(DVec3::X, end), end.length() / speed)
}

/// Cut angle in rad at which this much of the ball is hit.
fn hit_fraction(fraction: f64) -> f64 {
    libm::asin(1.0 - fraction)
}

#[test]
fn j5_the_thirty_degree_rule() {
    for speed in [0.3, 2.0, 9.0] {
        for cut_deg in [3.0, 10.0, 28.0, 45.0, 60.0, 80.0, 89.0] {
            let cut = f64::to_radians(cut_deg);
            let (s, c) = (libm::sin(cut), libm::cos(cut));
            let (angle, left) = deflection(&smooth(1.0), speed, 1.0, cut);
            let expected = libm::atan2(s * c, s * s + 0.4);
            assert_close("deflection", angle, expected, 1e-13, "rad");
            let expected = 5.0 / 7.0 * (s * s * c * c + (s * s + 0.4) * (s * s + 0.4)).sqrt();
            assert_close("speed kept", left, expected, 1e-14, "1");
        }
    }
}

#[test]
fn j5_printed_angles_and_speeds() {
    let angles = [
        (10.0, 21.6806),
        (20.0, 31.8683),
        (40.0, 31.1962),
        (45.0, 29.0546),
        (60.0, 20.6330),
        (80.0, 7.1159),
    ];
    for (cut_deg, printed) in angles {
        let (angle, _) = deflection(&smooth(1.0), 2.0, 1.0, f64::to_radians(cut_deg));
        assert_printed(
            &format!("{cut_deg}° cut"),
            angle.to_degrees(),
            printed,
            4,
            "°",
        );
    }
    for (fraction, printed) in [(0.5, 33.670497), (0.25, 27.266855), (0.75, 27.626486)] {
        let (angle, _) = deflection(&smooth(1.0), 2.0, 1.0, hit_fraction(fraction));
        assert_printed(
            &format!("{fraction} ball"),
            angle.to_degrees(),
            printed,
            6,
            "°",
        );
    }
    let speeds = [
        (10.0, 0.33064),
        (20.0, 0.43481),
        (30.0, 0.55787),
        (40.0, 0.67903),
        (45.0, 0.73540),
        (60.0, 0.87773),
    ];
    for (cut_deg, printed) in speeds {
        let (_, left) = deflection(&smooth(1.0), 2.0, 1.0, f64::to_radians(cut_deg));
        assert_printed(&format!("{cut_deg}° cut"), left, printed, 5, "1");
    }
}

#[test]
fn j5_the_largest_deflection_is_the_arc_sine_of_five_ninths() {
    let best = libm::asin((2.0_f64 / 9.0).sqrt());
    assert_printed("cut", best.to_degrees(), 28.125506, 6, "°");
    let (largest, _) = deflection(&smooth(1.0), 2.0, 1.0, best);
    assert_close("largest", largest, libm::asin(5.0 / 9.0), 1e-14, "rad");
    assert_printed("largest", largest.to_degrees(), 33.748989, 6, "°");
    for aside in [-1e-3, 1e-3] {
        assert!(deflection(&smooth(1.0), 2.0, 1.0, best + aside).0 < largest);
    }
    for (restitution, cut_deg, printed) in [(0.94, 28.996, 32.0091), (0.89, 29.686, 30.6261)] {
        let (angle, _) = deflection(&smooth(restitution), 2.0, 1.0, f64::to_radians(cut_deg));
        assert_printed("largest", angle.to_degrees(), printed, 4, "°");
    }
}

#[test]
fn j6_draw_and_follow() {
    for roll in [-2.0, -1.0, -0.625, 0.5, 1.0, 1.8] {
        for cut_deg in [5.0, 30.0, 48.6, 70.0] {
            let cut = f64::to_radians(cut_deg);
            let (s, c) = (libm::sin(cut), libm::cos(cut));
            let (angle, _) = deflection(&smooth(1.0), 1.7, roll, cut);
            let expected = libm::atan2(s * c, s * s + 0.4 * roll);
            assert_close("deflection", angle, expected, 1e-13, "rad");
        }
    }
    let printed = [
        (-1.0, 0.25, 71.86, 2),
        (-1.0, 0.5, 109.11, 2),
        (-1.0, 0.75, 144.35, 2),
        (-0.625, 0.25, 57.8, 1),
        (-0.625, 0.5, 90.0, 1),
        (-0.625, 0.75, 127.8, 1),
    ];
    for (roll, fraction, printed, decimals) in printed {
        let (angle, _) = deflection(&smooth(1.0), 2.0, roll, hit_fraction(fraction));
        let what = format!("k = {roll}, {fraction} ball");
        assert_printed(&what, angle.to_degrees(), printed, decimals, "°");
    }
}

/// Distance in m until rest.
fn path(state: &masse::physics::ball::State) -> f64 {
    let start = cloth().classify(&Ball::POOL, *state);
    (cloth().advance(&Ball::POOL, &start, 1e4).position - state.position).length()
}

#[test]
fn j7_rolling_head_on() {
    let cases = [
        (1.0, 0.0, Some(6.238)),
        (1.0, 0.05, Some(7.428)),
        (0.94, 0.05, Some(5.886)),
        (0.9, 0.1, None),
    ];
    for (restitution, mu, ratio) in cases {
        let v = 2.0;
        let law = rough(restitution, Friction::Constant(mu));
        let after = hit(&law, &rolling(v), DVec3::X);
        let (e, half) = (restitution, 0.5 * (1.0 + restitution));
        let cue = settled(&after.first).velocity;
        let object = settled(&after.second).velocity;
        let expected = 5.0 / 7.0 * 0.5 * (1.0 - e) + 2.0 / 7.0 * (1.0 - 2.5 * mu * half);
        assert_close("cue ball", cue.x / v, expected, 1e-14, "1");
        assert_close(
            "object ball",
            object.x / v,
            5.0 / 7.0 * half * (1.0 - mu),
            1e-14,
            "1",
        );
        assert_close("sideways", cue.z.abs() + object.z.abs(), 0.0, 1e-15, "m/s");
        if let Some(printed) = ratio {
            assert_printed(
                "distances",
                path(&after.second) / path(&after.first),
                printed,
                3,
                "1",
            );
        }
    }
}
