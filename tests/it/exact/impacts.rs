//! Two balls: judges J3 to J9.

use glam::DVec3;

use masse::physics::ball::Ball;
use masse::physics::laws::Laws;
use masse::physics::laws::ball_ball::{BallBallLaw, Friction, Frictional};
use masse::physics::record::{EventKind, Record};
use masse::physics::scene::Scene;

use super::{first_hit, play, put, scene, smooth};
use crate::closeness::{assert_close, assert_relative};

const R: f64 = Ball::POOL.radius;

/// A cue ball along x that meets a ball at the origin at this cut angle in rad, after `before` metres.
fn cut(laws: Laws, velocity: f64, spin: DVec3, angle: f64, before: f64) -> Scene {
    let mut scene = scene(laws);
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    put(
        &mut scene,
        "cue",
        -2.0 * R * cos - before,
        -2.0 * R * sin,
        DVec3::X * velocity,
        spin,
    );
    put(&mut scene, "1", 0.0, 0.0, DVec3::ZERO, DVec3::ZERO);
    scene
}

fn heading(velocity: DVec3) -> f64 {
    libm::atan2(velocity.z, velocity.x).to_degrees()
}

fn rough(restitution: f64, friction: Friction) -> Laws {
    Laws {
        ball_ball: BallBallLaw::Frictional(Frictional {
            restitution,
            friction,
        }),
        ..Laws::default()
    }
}

/// The first rolling state of a ball after the first hit.
fn settled(record: &Record, ball: usize) -> DVec3 {
    let hit = record
        .events
        .iter()
        .position(|event| event.kind == EventKind::BallBall)
        .expect("a hit");
    record.events[hit..]
        .iter()
        .find(|event| matches!(event.kind, EventKind::Motion { .. }) && event.first.ball == ball)
        .expect("it settles")
        .first
        .after
        .velocity
}

#[test]
fn j3_stun_shots_part_at_a_right_angle() {
    for degrees in [10.0_f64, 30.0, 45.0, 70.0] {
        let angle = degrees.to_radians();
        let (cue, object) = first_hit(&play(&cut(smooth(1.0, 1.0), 2.0, DVec3::ZERO, angle, 0.5)));
        assert_relative(
            "object",
            object.velocity.length(),
            2.0 * libm::cos(angle),
            1e-13,
            "m/s",
        );
        assert_relative(
            "cue",
            cue.velocity.length(),
            2.0 * libm::sin(angle),
            1e-13,
            "m/s",
        );
        assert!(cue.velocity.dot(object.velocity).abs() < 1e-13);
    }
    let (cue, object) = first_hit(&play(&cut(
        smooth(0.95, 1.0),
        2.0,
        DVec3::ZERO,
        30.0_f64.to_radians(),
        0.5,
    )));
    assert_close(
        "separation",
        heading(object.velocity) - heading(cue.velocity),
        87.521,
        6e-4,
        "°",
    );
}

#[test]
fn j4_head_on() {
    for e in [0.0, 0.5, 0.95, 1.0] {
        let (cue, object) = first_hit(&play(&cut(smooth(e, 1.0), 2.0, DVec3::ZERO, 0.0, 0.5)));
        // A contact without rebound parts at 1e-12 m/s.
        assert_close("cue", cue.velocity.x, 1.0 - e, 1e-12, "m/s");
        assert_close("object", object.velocity.x, 1.0 + e, 1e-12, "m/s");
    }
}

#[test]
fn j5_thirty_degree_rule() {
    for (degrees, bend) in [
        (10.0_f64, 21.6806),
        (20.0, 31.8683),
        (30.0, 33.670_497),
        (45.0, 29.0546),
        (80.0, 7.1159),
    ] {
        let laws = rough(1.0, Friction::Constant(0.0));
        let spin = Ball::POOL.rolling_spin(DVec3::X * 1.5);
        let scene = cut(laws, 1.5, spin, degrees.to_radians(), 0.0);
        let cue = settled(&play(&scene), 0);
        assert_close("deviation", heading(cue).abs(), bend, 6e-5 / bend, "°");
    }
}

#[test]
fn j6_draw() {
    for (cut_fraction, bend) in [(0.75_f64, 71.86), (0.5, 109.11), (0.25, 144.35)] {
        let laws = rough(1.0, Friction::Constant(0.0));
        let spin = -Ball::POOL.rolling_spin(DVec3::X * 1.5);
        let scene = cut(laws, 1.5, spin, libm::asin(cut_fraction), 0.0);
        assert_close(
            "deviation",
            heading(settled(&play(&scene), 0)).abs(),
            bend,
            6e-3 / bend,
            "°",
        );
    }
}

#[test]
fn j7_rolling_head_on() {
    let laws = rough(1.0, Friction::Constant(0.0));
    let scene = cut(laws, 1.0, Ball::POOL.rolling_spin(DVec3::X), 0.0, 0.0);
    let record = play(&scene);
    assert_close("cue", settled(&record, 0).x, 2.0 / 7.0, 1e-13, "m/s");
    assert_close("object", settled(&record, 1).x, 5.0 / 7.0, 1e-13, "m/s");
    let ratio = record.end[1].position.x / (record.end[0].position.x + 2.0 * R);
    assert_close("distance ratio", ratio, 6.238, 1e-3, "");
}

#[test]
fn j8_j9_throw_and_gearing() {
    for (degrees, throw) in [
        (10.0_f64, 1.443),
        (20.0, 2.976),
        (30.0, 4.715),
        (50.0, 4.822),
    ] {
        let scene = cut(
            rough(1.0, Friction::MARLOW),
            0.447,
            DVec3::ZERO,
            degrees.to_radians(),
            0.0,
        );
        let (_, object) = first_hit(&play(&scene));
        assert_close(
            "throw",
            degrees - heading(object.velocity),
            throw,
            6e-4 / throw,
            "°",
        );
    }
    // Gearing english: R ω = v sin c.
    let angle = 30.0_f64.to_radians();
    let spin = DVec3::Y * (0.447 * libm::sin(angle) / R);
    let candidates = [spin, -spin].map(|spin| {
        let (_, object) = first_hit(&play(&cut(
            rough(0.95, Friction::MARLOW),
            0.447,
            spin,
            angle,
            0.0,
        )));
        (heading(object.velocity) - 30.0).abs() + object.angular_velocity.y.abs()
    });
    assert!(candidates[0].min(candidates[1]) < 1e-11, "{candidates:?}");
}

#[test]
fn balls_of_different_size_meet_where_they_touch() {
    let mut scene = scene(Laws::ideal());
    let small = Ball {
        radius: 0.01,
        ..Ball::POOL
    };
    put(&mut scene, "large", -0.5, 0.0, DVec3::X, DVec3::ZERO);
    scene.place("small", small, 0.0, 0.0);
    scene.time_limit = 2.0;
    let record = play(&scene);
    let hit = &record.events[0];
    assert_relative(
        "distance in plan",
        -hit.first
            .before
            .position
            .x
            .min(hit.second.expect("two").before.position.x),
        2.0 * (R * 0.01_f64).sqrt(),
        1e-13,
        "m",
    );
}
