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
