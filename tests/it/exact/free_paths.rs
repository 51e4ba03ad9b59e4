//! Paths of one ball: judges J1, J2, J11 to J13.

use glam::DVec3;

use masse::physics::ball::Ball;
use masse::physics::cue::{Cue, Shot};
use masse::physics::laws::Laws;
use masse::physics::record::{EndReason, EventKind};
use masse::physics::scene::PlannedShot;

use super::{play, put, scene};
use crate::closeness::{assert_close, assert_relative, assert_vectors};

#[test]
fn j1_slide_roll_rest() {
    let mut scene = scene(Laws::default());
    put(&mut scene, "cue", 0.0, 0.0, DVec3::X * 2.0, DVec3::ZERO);
    let record = play(&scene);
    assert_eq!(record.events.len(), 2);
    let roll = &record.events[0];
    assert_close("slide", roll.time, 0.291_248_00, 1e-8, "s");
    assert_close("way", roll.first.after.position.x, 0.499_282_28, 1e-8, "m");
    assert_relative(
        "speed",
        roll.first.after.velocity.x,
        10.0 / 7.0,
        1e-14,
        "m/s",
    );
    assert_close("end", record.end_time, 14.853_647_9, 1e-6, "s");
    assert_close("stop", record.end[0].position.x, 10.900_996_5, 1e-6, "m");
    assert_eq!(record.reason, Some(EndReason::Rest));
}

#[test]
fn j2_the_roll_invariant_holds_through_a_slide() {
    let mut scene = scene(Laws::default());
    let spin = DVec3::new(30.0, 12.0, -45.0);
    put(&mut scene, "cue", 0.0, 0.0, DVec3::new(1.0, 0.0, 0.4), spin);
    let record = play(&scene);
    let invariant = |time: f64| {
        let state = record.state_at(0, time);
        5.0 / 7.0 * state.velocity
            + 2.0 / 7.0 * Ball::POOL.radius * state.angular_velocity.cross(DVec3::Y)
    };
    let end = record.events[0].time;
    for i in 0..=100 {
        let drift = (invariant(end * f64::from(i) / 100.0) - invariant(0.0)).length();
        assert!(drift < 1e-14, "{drift:e} m/s");
    }
}

#[test]
fn j11_speed_of_the_cue_ball() {
    for (side, ratio) in [
        (0.0, 1.538_47),
        (0.1, 1.509_44),
        (0.2, 1.428_58),
        (0.3, 1.311_48),
        (0.5, 1.038_96),
    ] {
        let mut scene = scene(Laws::default());
        scene.cue = Cue {
            tip_restitution: 1.0,
            ..Cue::default()
        };
        scene.place("cue", Ball::POOL, 0.0, 0.0);
        let shot = Shot {
            height: side,
            speed: 3.0,
            ..Shot::default()
        };
        scene.shot = Some(PlannedShot { ball: 0, shot });
        let record = play(&scene);
        let struck = &record.events[0];
        assert_eq!(struck.kind, EventKind::Strike { miscue: false });
        assert_close("v/V", struck.first.after.velocity.x / 3.0, ratio, 6e-6, "");
    }
}

#[test]
fn j12_squirt() {
    for (side, degrees) in [
        (0.1, 0.4257),
        (0.2, 0.8403),
        (0.3, 1.2317),
        (0.4, 1.5861),
        (0.5, 1.8860),
    ] {
        let mut scene = scene(Laws::default());
        scene.cue.end_mass = Ball::POOL.mass / 30.0;
        scene.place("cue", Ball::POOL, 0.0, 0.0);
        let shot = Shot {
            side,
            ..Shot::default()
        };
        scene.shot = Some(PlannedShot { ball: 0, shot });
        let velocity = play(&scene).events[0].first.after.velocity;
        // Right english sends the ball to the left: towards −z.
        assert_close(
            "squirt",
            libm::atan2(-velocity.z, velocity.x).to_degrees(),
            degrees,
            6e-5,
            "°",
        );
    }
}

#[test]
fn j13_masse_settles_along_coriolis_line() {
    // The ball as the slate leaves it: v = 1 m/s along x, slip (−1.299038, 1) in the judge's axes.
    let mut scene = scene(Laws::default());
    let slip = DVec3::new(1.0, 0.0, 1.299_038_105_676_658);
    let velocity = DVec3::X;
    // u = v − R ω × ŷ, so ω = (v − u) × ... solved for horizontal ω.
    let difference = (velocity - slip) / Ball::POOL.radius;
    let spin = DVec3::Y.cross(difference);
    put(&mut scene, "cue", 0.0, 0.0, velocity, spin);
    let record = play(&scene);
    let roll = &record.events[0];
    assert_close("slide", roll.time, 0.238_730_1, 1e-7, "s");
    let state = &roll.first.after;
    assert_vectors(
        "way",
        state.position,
        DVec3::new(0.204_625_8, Ball::POOL.radius, -0.044_302_8),
        1e-7,
        "m",
    );
    assert_vectors(
        "roll",
        state.velocity,
        DVec3::new(0.714_285_7, 0.0, -0.371_153_7),
        1e-7,
        "m/s",
    );
}
