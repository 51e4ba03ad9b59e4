//! Several at once: judges J10 and J17, hard cases H3 and H4.

use glam::DVec3;

use masse::physics::ball::Ball;
use masse::physics::cue::Shot;
use masse::physics::exact::{Engine, Limits};
use masse::physics::laws::Laws;
use masse::physics::laws::ball_ball::BallBallLaw;
use masse::physics::record::EventKind;
use masse::physics::scene::{PlannedShot, Rack, Scene, Solver};
use masse::physics::table::Preset;

use super::{audit, play, put, scene, smooth};
use crate::closeness::{assert_close, assert_relative};

const R: f64 = Ball::POOL.radius;

#[test]
fn j10_a_frozen_pair_leaves_at_twice_the_tangent() {
    for degrees in [20.0_f64, 46.0, 70.0] {
        let mut scene = scene(Laws {
            ball_ball: smooth(0.95, 1.0).ball_ball,
            ..Laws::default()
        });
        scene.place("cue", Ball::POOL, 0.0, 0.0);
        scene.place("1", Ball::POOL, 2.0 * R, 0.0);
        let shot = Shot {
            heading: degrees.to_radians(),
            ..Shot::default()
        };
        scene.shot = Some(PlannedShot { ball: 0, shot });
        let record = play(&scene);
        let velocity = record.state_at(0, 0.0).velocity;
        let tangent = (velocity.z / velocity.x).abs();
        assert_relative(
            "tan θ",
            tangent,
            2.0 * libm::tan(degrees.to_radians()),
            1e-12,
            "",
        );
    }
}

#[test]
fn j17_two_balls_struck_at_once_leave_alike() {
    for (e, object, cue) in [(1.0, 0.692_820_323, -0.2), (0.95, 0.675_499_815, -0.17)] {
        for before in [0.0, 0.3] {
            let mut scene = scene(smooth(e, 1.0));
            let x = 3.0_f64.sqrt() * R;
            put(&mut scene, "cue", -x - before, 0.0, DVec3::X, DVec3::ZERO);
            put(&mut scene, "1", 0.0, R, DVec3::ZERO, DVec3::ZERO);
            put(&mut scene, "2", 0.0, -R, DVec3::ZERO, DVec3::ZERO);
            scene.time_limit = 0.5;
            let record = play(&scene);
            let [cue_end, one, two] = [0, 1, 2].map(|ball| record.end[ball].velocity);
            assert_close("cue", cue_end.x, cue, 1e-9, "m/s");
            assert_close("1", one.length(), object, 1e-9, "m/s");
            assert!((one - DVec3::new(two.x, 0.0, -two.z)).length() < 1e-14);
        }
    }
}

#[test]
fn h3_racks_mirror_and_permute() {
    // At 5 ms the first impact is over; what chaos makes of its rounding is not.
    let laws = Laws {
        ball_ball: BallBallLaw::all()[1],
        ..Laws::default()
    };
    for (rack, z) in [
        (Rack::NineBall, 0.0),
        (Rack::NineBall, 0.01),
        (Rack::EightBall, 0.0),
        (Rack::EightBall, 0.02),
    ] {
        let states = |mirror: f64, reverse: bool| {
            let mut scene = Scene::new(Preset::NineFoot.table(), laws);
            scene.solver = Solver::Exact;
            rack.place(&mut scene, Ball::POOL, 0.0, 1);
            scene.balls[0].state.position.x = 0.3;
            scene.balls[0].state.position.z = mirror * z;
            scene.balls[0].state.velocity = DVec3::X * 8.0;
            if mirror < 0.0 {
                for ball in &mut scene.balls[1..] {
                    ball.state.position.z *= -1.0;
                }
            }
            if reverse {
                scene.balls.reverse();
            }
            let mut engine = Engine::new(&scene, Limits::default()).expect("a sound scene");
            engine.advance(0.05, &mut ()).expect("a sound scene");
            let mut states: Vec<_> = (0..scene.balls.len())
                .map(|ball| engine.state(ball))
                .collect();
            if reverse {
                states.reverse();
            }
            states
        };
        let plain = states(1.0, false);
        assert!(
            plain.iter().all(|state| state.velocity != DVec3::ZERO),
            "the blow reaches every ball"
        );
        for (mirror, reverse) in [(1.0, true), (-1.0, false), (-1.0, true)] {
            for (ball, (one, two)) in plain.iter().zip(states(mirror, reverse)).enumerate() {
                let flipped = DVec3::new(two.velocity.x, 0.0, mirror * two.velocity.z);
                let error = (one.velocity - flipped).length();
                assert!(
                    error < 1e-12,
                    "{rack:?} z {z} mirror {mirror} reverse {reverse} ball {ball}: {error:e} m/s"
                );
            }
        }
    }
}

#[test]
fn h3_a_frozen_break_is_short_and_sound() {
    for rack in [Rack::NineBall, Rack::EightBall] {
        for seed in 0..10 {
            let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
            scene.solver = Solver::Exact;
            rack.place(&mut scene, Ball::POOL, 0.0, seed);
            scene.balls[0].state.velocity = DVec3::new(9.0, 0.0, 0.05 * seed as f64);
            let record = play(&scene);
            let hits = record
                .events
                .iter()
                .filter(|event| event.kind == EventKind::BallBall)
                .count();
            println!(
                "{rack:?} {seed}: {} events, {hits} hits",
                record.events.len()
            );
            assert!(
                record.events.len() < 400,
                "{rack:?} {seed}: {} events",
                record.events.len()
            );
            audit(&scene, &record, 1e-9);
        }
    }
}

fn cradle(e: f64, moving: usize, gap: f64) -> Vec<f64> {
    let mut scene = scene(smooth(e, 1.0));
    for i in 0..5 {
        let velocity = if i < moving { DVec3::X } else { DVec3::ZERO };
        let before = if i < moving { gap } else { 0.0 };
        put(
            &mut scene,
            &i.to_string(),
            2.0 * R * i as f64 - before,
            0.0,
            velocity,
            DVec3::ZERO,
        );
    }
    scene.time_limit = 0.5;
    let record = play(&scene);
    audit(&scene, &record, 1e-15);
    record.end.iter().map(|state| state.velocity.x).collect()
}

#[test]
fn h4_newtons_cradle() {
    for gap in [0.0, 0.1] {
        let one = cradle(1.0, 1, gap);
        assert!(one[..4].iter().all(|v| *v == 0.0), "{one:?}");
        assert_relative("last", one[4], 1.0, 1e-15, "m/s");
        let two = cradle(1.0, 2, gap);
        assert!(two[..3].iter().all(|v| *v == 0.0), "{two:?}");
        assert_relative("fourth", two[3], 1.0, 1e-15, "m/s");
        assert_relative("fifth", two[4], 1.0, 1e-15, "m/s");
        let lossy = cradle(0.95, 1, gap);
        for (v, wanted) in lossy
            .iter()
            .zip([0.02326, 0.02380, 0.02435, 0.02491, 0.90369])
        {
            assert_close("lossy", *v, wanted, 6e-6, "m/s");
        }
    }
}
