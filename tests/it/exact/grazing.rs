//! Near misses and fast balls: hard cases H6 and H12.

use glam::DVec3;

use masse::physics::ball::Ball;
use masse::physics::laws::Laws;
use masse::physics::record::EventKind;

use super::{play, put, scene, smooth};

const R: f64 = Ball::POOL.radius;

#[test]
fn h6_grazing_hits_are_a_square_root_and_end_at_tangency() {
    for laws in [
        smooth(1.0, 1.0),
        Laws {
            ball_ball: smooth(1.0, 1.0).ball_ball,
            ..Laws::default()
        },
    ] {
        for exponent in 3..=12 {
            let depth = libm::pow(10.0, -f64::from(exponent));
            let mut scene = scene(laws);
            put(
                &mut scene,
                "cue",
                -0.3,
                -(2.0 * R - depth),
                DVec3::X * 2.0,
                DVec3::ZERO,
            );
            put(&mut scene, "1", 0.0, 0.0, DVec3::ZERO, DVec3::ZERO);
            scene.time_limit = 1.0;
            let record = play(&scene);
            let hit = record
                .events
                .iter()
                .find(|event| event.kind == EventKind::BallBall);
            let hit = hit.unwrap_or_else(|| panic!("missed by {depth:e} m"));
            let struck = if hit.first.ball == 1 {
                hit.first
            } else {
                hit.second.expect("two balls")
            };
            let speed = hit
                .participants()
                .find(|p| p.ball == 0)
                .expect("cue")
                .before
                .velocity
                .length();
            let wanted =
                speed * (1.0 - (1.0 - depth / (2.0 * R)) * (1.0 - depth / (2.0 * R))).sqrt();
            // Seen from 0.3 m away the depth carries some 1e-16 m of rounding.
            let error = (struck.after.velocity.length() - wanted).abs() / wanted;
            assert!(error < 1e-12 + 3e-16 / depth, "depth {depth:e}: {error:e}");
            let mut miss = scene.clone();
            miss.balls[0].state.position.z = -(2.0 * R + depth);
            assert!(
                play(&miss)
                    .events
                    .iter()
                    .all(|event| event.kind != EventKind::BallBall),
                "hit beyond by {depth:e} m"
            );
        }
    }
}

#[test]
fn h12_fast_balls_miss_nothing() {
    for speed in [0.5, 2.0, 13.0, 30.0, 300.0] {
        for offset in [0.0, 0.02, 0.0571] {
            let mut scene = scene(smooth(1.0, 1.0));
            put(
                &mut scene,
                "cue",
                -10.0,
                offset,
                DVec3::X * speed,
                DVec3::ZERO,
            );
            put(&mut scene, "thin", 0.0, 0.0, DVec3::ZERO, DVec3::ZERO);
            scene.time_limit = 20.0 / speed;
            let hits = play(&scene)
                .events
                .iter()
                .filter(|event| event.kind == EventKind::BallBall)
                .count();
            assert_eq!(hits, 1, "{speed} m/s, offset {offset} m");
        }
    }
}
