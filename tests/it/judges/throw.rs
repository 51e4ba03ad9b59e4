//! J8 and J9: throw, spin transfer, gearing (Alciatore, TP A.14, with Marlow's friction).

use glam::DVec3;

use masse::physics::ball::{Ball, State};
use masse::physics::laws::ball_ball::{BallBallLaw, Friction};

use super::{SPEEDS, cut_line, hit, moving, rolling, rough, turn};
use crate::closeness::{assert_close, assert_printed, assert_vectors};

/// Angle in rad by which the object ball leaves the line of centres, along the motion of the cue ball's surface.
fn throw(law: &BallBallLaw, state: &State, cut: f64) -> f64 {
    let normal = cut_line(cut);
    -turn(normal, hit(law, state, normal).second.velocity)
}

fn stun(speed: f64) -> State {
    moving(DVec3::X * speed, DVec3::ZERO)
}

/// A stun ball with english whose surface speed is `share` of its speed.
fn with_side(speed: f64, share: f64) -> State {
    moving(
        DVec3::X * speed,
        DVec3::Y * (share * speed / Ball::POOL.radius),
    )
}

/// Marlow's coefficient by the formula of TP A.14.
fn marlow(slip: f64) -> f64 {
    9.951e-3 + 0.108 * libm::exp(-1.088 * slip)
}

#[test]
fn j8_throw_of_a_stun_shot() {
    for restitution in [1.0, 0.95, 0.6] {
        let law = rough(restitution, Friction::MARLOW);
        for speed in SPEEDS {
            for cut_deg in [1.0, 10.0, 20.0, 30.0, 45.0, 70.0, 85.0] {
                let cut = f64::to_radians(cut_deg);
                let sticking = 2.0 * libm::tan(cut) / (7.0 * (1.0 + restitution));
                let expected = marlow(speed * libm::sin(cut)).min(sticking);
                let value = throw(&law, &stun(speed), cut);
                assert_close("throw", value, libm::atan(expected), 1e-14, "rad");
            }
        }
    }
}

#[test]
fn j8_the_table_of_throw() {
    let cuts = [10.0, 20.0, 25.0, 30.0, 35.0, 40.0, 50.0, 60.0, 70.0];
    let stunned = [
        1.443, 2.976, 3.811, 4.715, 5.237, 5.083, 4.822, 4.621, 4.479,
    ];
    let rolled = [
        0.349, 0.687, 0.849, 1.004, 1.152, 1.291, 1.538, 1.739, 1.887,
    ];
    let law = rough(1.0, Friction::MARLOW);
    for (i, cut_deg) in cuts.into_iter().enumerate() {
        let cut = f64::to_radians(cut_deg);
        let value = throw(&law, &stun(SPEEDS[0]), cut).to_degrees();
        assert_printed(&format!("stun, {cut_deg}°"), value, stunned[i], 3, "°");
        let value = throw(&law, &rolling(SPEEDS[1]), cut).to_degrees();
        assert_printed(&format!("roll, {cut_deg}°"), value, rolled[i], 3, "°");
    }
}

#[test]
fn j8_the_peak_of_throw() {
    let law = rough(1.0, Friction::MARLOW);
    // The printed peak is the highest of a grid of 0.05°; the true one is where sticking ends and slipping begins.
    let (mut peak, mut at) = (0.0, 0.0);
    for step in 0..1800 {
        let cut_deg = f64::from(step) * 0.05;
        let value = throw(&law, &stun(SPEEDS[0]), cut_deg.to_radians()).to_degrees();
        if value > peak {
            (peak, at) = (value, cut_deg);
        }
    }
    assert_printed("peak", peak, 5.301, 3, "°");
    assert_printed("cut at the peak", at, 33.05, 2, "°");
    let sticks = |cut: f64| libm::tan(cut) / 7.0 < marlow(SPEEDS[0] * libm::sin(cut));
    let (mut low, mut high) = (0.5, 0.6);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if sticks(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let expected = libm::atan(libm::tan(low) / 7.0);
    assert_close(
        "true peak",
        throw(&law, &stun(SPEEDS[0]), low),
        expected,
        1e-14,
        "rad",
    );
    assert!(expected.to_degrees() >= peak && expected.to_degrees() < peak + 2e-3);
}

#[test]
fn j8_constant_friction_has_a_plateau() {
    let law = rough(1.0, Friction::Constant(0.06));
    let crossover = libm::atan(7.0 * 0.06);
    assert_printed("crossover", crossover.to_degrees(), 22.782, 3, "°");
    for speed in SPEEDS {
        for (cut_deg, printed) in [(15.0, 2.192), (20.0, 2.976), (22.783, 3.434), (60.0, 3.434)] {
            let value = throw(&law, &stun(speed), f64::to_radians(cut_deg)).to_degrees();
            assert_printed(&format!("{cut_deg}°"), value, printed, 3, "°");
        }
        // A rolling ball slips with |u| = v exactly: tan(throw) = μ sin(cut) at every speed.
        for cut_deg in [25.0, 50.0, 80.0] {
            let cut = f64::to_radians(cut_deg);
            let expected = libm::atan(0.06 * libm::sin(cut));
            // In the plane friction acts along the slip, of which sin(cut) is horizontal.
            assert_close(
                "roll",
                throw(&law, &rolling(speed), cut),
                expected,
                1e-14,
                "rad",
            );
        }
    }
}

#[test]
fn j8_throw_by_english_of_a_straight_shot() {
    let law = rough(1.0, Friction::MARLOW);
    let shares = [0.25, 0.5, 0.75, 1.0, 1.25];
    let rows = [
        (SPEEDS[0], [2.045, 4.086, 4.855, 4.366, 3.933]),
        (SPEEDS[1], [2.045, 3.549, 2.640, 2.008, 1.569]),
    ];
    for (speed, row) in rows {
        for (share, printed) in shares.into_iter().zip(row) {
            let left = throw(&law, &with_side(speed, share), 0.0);
            let right = throw(&law, &with_side(speed, -share), 0.0);
            assert_printed(
                &format!("{share} at {speed}"),
                left.to_degrees().abs(),
                printed,
                3,
                "°",
            );
            assert_eq!(left, -right, "english throws alike to both sides");
            // ω along +y is counter-clockwise: right english. It throws to the left, away from the spin's side.
            assert!(
                left < 0.0
                    && hit(&law, &with_side(speed, share), DVec3::X)
                        .second
                        .velocity
                        .z
                        < 0.0
            );
        }
    }
    // Half of the most english a tip can give is b = 0.25 R, so R ω = 0.625 v.
    let half = throw(&law, &with_side(SPEEDS[0], 0.625), 0.0).abs();
    assert_printed("at half english", half.to_degrees(), 5.102, 3, "°");
    let most = (0..1500)
        .map(|step| throw(&law, &with_side(SPEEDS[0], f64::from(step) * 1e-3), 0.0).abs())
        .fold(0.0, f64::max);
    assert!(most >= half && most.to_degrees() < half.to_degrees() + 0.02);
}

#[test]
fn j9_gearing_has_no_throw_and_no_spin_transfer() {
    for speed in SPEEDS {
        for restitution in [0.5, 0.95, 1.0] {
            for cut_deg in [5.0, 20.0, 40.0, 75.0] {
                let cut = f64::to_radians(cut_deg);
                let law = rough(restitution, Friction::MARLOW);
                // The object ball goes left, so outside english is on the right.
                let share = gearing_share(cut);
                let after = hit(&law, &with_side(speed, share), cut_line(cut));
                let value = throw(&law, &with_side(speed, share), cut);
                assert_close("throw", value, 0.0, 1e-14, "rad");
                let surface = Ball::POOL.radius * after.second.angular_velocity.length();
                assert_close("transferred", surface, 0.0, 1e-14, "m/s");
            }
        }
    }
}

/// Surface speed of the english that gears, in units of the speed, signed as the spin about y.
fn gearing_share(cut: f64) -> f64 {
    libm::sin(cut)
}

#[test]
fn j9_spin_transfer_of_a_straight_shot() {
    let law = rough(1.0, Friction::MARLOW);
    let rows = [
        (SPEEDS[0], 0.357, 0.138),
        (SPEEDS[1], 0.213, 0.055),
        (SPEEDS[2], 0.091, 0.023),
    ];
    for (speed, half, full) in rows {
        // 50 and 100 % english: b = 0.25 and 0.5 R, and R ω = 2.5 b v.
        for (share, printed) in [(0.625, half), (1.25, full)] {
            let before = with_side(speed, share);
            let after = hit(&law, &before, DVec3::X);
            let ratio = after.second.angular_velocity.y / before.angular_velocity.y;
            let what = format!("{share} english at {speed}");
            assert_printed(&what, ratio.abs(), printed, 3, "1");
            assert!(
                ratio < 0.0,
                "{what}: english turns round, as between two gears"
            );
        }
    }
    let before = with_side(1.0, 0.1);
    let after = hit(&law, &before, DVec3::X);
    let ratio = -after.second.angular_velocity.y / before.angular_velocity.y;
    assert_close("sticking", ratio, 5.0 / 14.0, 1e-15, "1");
    // What one ball loses the other gets: the changes are the same.
    let lost = after.first.angular_velocity - before.angular_velocity;
    assert_vectors("spin", lost, after.second.angular_velocity, 1e-15, "rad/s");
}
