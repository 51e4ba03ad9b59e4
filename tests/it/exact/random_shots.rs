//! Random shots on every table with every law: none may fail, lose a ball, or go on for ever.

use glam::DVec3;
use proptest::prelude::*;

use masse::physics::ball::{Ball, Motion};
use masse::physics::cue::Shot;
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::laws::ball_ball::BallBallLaw;
use masse::physics::laws::cushion::CushionLaw;
use masse::physics::record::EndReason;
use masse::physics::scene::{PlannedShot, Rack, Scene, Solver};
use masse::physics::table::Preset;

use super::energy;

/// The most that the rule of lasting contact may add to the energy at one event, J: m (a t)² / 8 of a pressed ball, for a
/// handful of balls.
const SPRING: f64 = 1e-6;

fn shot() -> impl Strategy<Value = Shot> {
    (
        -3.2..3.2_f64,
        0.0..1.0_f64,
        -0.3..0.3_f64,
        -0.3..0.3_f64,
        0.1..12.0_f64,
    )
        .prop_map(|(heading, elevation, side, height, speed)| Shot {
            heading,
            elevation: if elevation < 0.7 { 0.0 } else { elevation },
            side,
            height,
            speed,
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn a_random_shot_ends_with_every_ball_accounted_for(
        shot in shot(),
        straight in any::<bool>(),
        table in prop::sample::select(Preset::NAMED.to_vec()),
        rack in prop::sample::select(vec![Rack::NineBall, Rack::EightBall]),
        gap in prop::sample::select(vec![0.0, 1e-6, 1e-4, 1e-3]),
        ball_ball in prop::sample::select(BallBallLaw::all()),
        cushion in prop::sample::select(CushionLaw::all()),
        seed in 0..1000_u64,
        moved in prop::collection::vec((-0.49..0.49_f64, -0.48..0.48_f64), 0..12),
    ) {
        let laws = Laws { ball_ball, cushion, ..Laws::default() };
        let mut scene = Scene::new(table.table(), laws);
        scene.solver = Solver::Exact;
        rack.place(&mut scene, Ball::POOL, gap, seed);
        let (length, width) = (scene.table.length - 0.058, scene.table.width - 0.058);
        for (ball, (x, z)) in moved.into_iter().enumerate().take(scene.balls.len()) {
            let place = DVec3::new(x * length, Ball::POOL.radius, z * width);
            let is_free = |(other, at): (usize, &masse::physics::scene::SceneBall)| {
                other == ball || (at.state.position - place).length() > 2.0 * Ball::POOL.radius
            };
            if scene.balls.iter().enumerate().all(is_free) {
                scene.balls[ball].state.position = place;
            }
        }
        let shot = Shot { heading: if straight { 0.01 * shot.heading } else { shot.heading }, ..shot };
        scene.shot = Some(PlannedShot { ball: 0, shot });
        let record = solve(&scene, Limits { events: 20_000 }).map_err(|error| TestCaseError::fail(error.to_string()))?;
        prop_assert_eq!(record.reason, Some(EndReason::Rest));
        for state in &record.end {
            let place = state.position.abs();
            let inside = place.x < 0.5 * scene.table.length + 0.05 && place.z < 0.5 * scene.table.width + 0.05;
            prop_assert!(inside || !state.motion.in_play(), "{:?}", state);
        }
        let mut last = f64::INFINITY;
        let mut tipped = false;
        for event in &record.events {
            let now = energy(&scene, &record, event.time);
            // Between its ends a piece of the roll over an edge is off the true energy by some 1e-5 J.
            let tips = (0..scene.balls.len()).any(|ball| record.state_at(ball, event.time).motion == Motion::Tipping);
            let more = if tips || tipped { 1e-4 } else { SPRING };
            tipped = tips;
            prop_assert!(now <= last + more, "energy rises by {} J at {} s", now - last, event.time);
            last = now;
        }
    }
}

#[test]
fn tell() {
    use rand::{RngExt, SeedableRng};
    let mut random = rand_chacha::ChaCha8Rng::seed_from_u64(17);
    struct Tell(Vec<masse::physics::record::Event>);
    impl masse::physics::exact::Watch for Tell {
        fn event(&mut self, e: &masse::physics::record::Event) {
            self.0.push(*e);
        }
    }
    let mut n = 0;
    let count = CushionLaw::all().len();
    for _ in 0..40000 {
        let cushion = CushionLaw::all()[random.random_range(0..count)];
        let laws = Laws {
            cushion,
            ..Laws::default()
        };
        let mut scene = Scene::new(Preset::SevenFoot.table(), laws);
        Rack::NineBall.place(&mut scene, Ball::POOL, 0.0, 0);
        for ball in 1..6 {
            let p = DVec3::new(
                random.random_range(-0.8..0.8),
                Ball::POOL.radius,
                random.random_range(-0.4..0.4),
            );
            scene.balls[ball].state.position = p;
        }
        scene.shot = Some(PlannedShot {
            ball: 0,
            shot: Shot {
                heading: random.random_range(-3.1..3.1),
                elevation: 0.0,
                side: 0.0,
                height: 0.0,
                speed: random.random_range(8.0..12.0),
            },
        });
        if scene.check().is_err() {
            continue;
        }
        let mut engine =
            masse::physics::exact::Engine::new(&scene, Limits { events: 3000 }).expect("x");
        let mut t = Tell(Vec::new());
        let planned = scene.shot.unwrap();
        engine.strike(0, &scene.cue, &planned.shot, &mut t).unwrap();
        if let Err(error) = engine.advance(f64::INFINITY, &mut t) {
            n += 1;
            if n > 3 {
                return;
            }
            println!("step {error} {cushion:?}");
            let (a, b) = t.0.split_at(t.0.len() - 4);
            let who = b[0].first.ball;
            let a: Vec<_> = a.iter().filter(|e| e.first.ball == who).copied().collect();
            let first = a
                .iter()
                .position(|e| e.time > b[0].time - 1e-3)
                .unwrap_or(0);
            for e in a[first.saturating_sub(3)..(first + 12).min(a.len())]
                .iter()
                .chain(b)
            {
                let c = e.first.before.position;
                let d = scene
                    .table
                    .pockets
                    .iter()
                    .map(|p| p.center.distance(glam::DVec2::new(c.x, c.z)) - p.radius)
                    .fold(9.0, f64::min);
                println!(
                    "{:.12} {:?} {} {:?} {:?}->{:?} d={d:e} y-R={:e} v={} -> {} w={}",
                    e.time,
                    e.kind,
                    e.first.ball,
                    e.second.map(|s| s.ball),
                    e.first.before.motion,
                    e.first.after.motion,
                    c.y - Ball::POOL.radius,
                    e.first.before.velocity,
                    e.first.after.velocity,
                    e.first.after.angular_velocity
                );
            }
        }
    }
}
