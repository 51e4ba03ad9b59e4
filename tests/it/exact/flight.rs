//! Balls that leave the slate: jumps, bounces, massé, rails.

use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use masse::physics::ball::{Ball, Motion};
use masse::physics::cue::{Cue, Shot};
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::laws::slate::{Bouncing, SlateLaw};
use masse::physics::record::{EndReason, EventKind, Record};
use masse::physics::scene::{PlannedShot, Rack, Scene};
use masse::physics::table::{Nose, Preset};

use super::play;

const R: f64 = Ball::POOL.radius;
const G: f64 = 9.81;

fn laws(restitution: f64, friction: f64) -> Laws {
    Laws {
        slate: SlateLaw::Bouncing(Bouncing {
            restitution,
            friction,
            settle: 1e-9,
        }),
        ..Laws::default()
    }
}

fn shot(elevation_deg: f64, speed: f64) -> Shot {
    Shot {
        elevation: elevation_deg.to_radians(),
        speed,
        ..Shot::default()
    }
}

/// A nine-foot table with a cue ball at the head spot, to be played along the table.
fn jump(laws: Laws, shot: Shot) -> Scene {
    let mut scene = Scene::new(Preset::NineFoot.table(), laws);
    let ball = scene.place("cue", Ball::POOL, -0.635, 0.0);
    scene.shot = Some(PlannedShot { ball, shot });
    scene
}

/// Kinetic and potential energy in J of the balls that are still in play, and that of the others when they left it.
fn energy(scene: &Scene, record: &Record, time: f64) -> f64 {
    let of = |ball: usize| {
        let (body, state) = (scene.balls[ball].ball, record.state_at(ball, time));
        body.kinetic_energy(&state) + body.mass * G * state.position.y
    };
    (0..scene.balls.len()).map(of).sum()
}

/// Energy never rises from event to event, no two balls overlap, and nobody sinks into the slate.
fn audit(scene: &Scene, record: &Record) {
    let mut last = f64::INFINITY;
    for event in &record.events {
        let now = energy(scene, record, event.time);
        let lost = if matches!(event.kind, EventKind::Strike { .. }) {
            f64::INFINITY
        } else {
            last
        };
        // Balls that lean on each other part with what gravity gives in half a contact time, 5 mm/s: 2 µJ.
        assert!(now <= lost + 3e-6, "{last} to {now} J: {event:?}");
        last = now;
        let states: Vec<_> = (0..scene.balls.len())
            .map(|ball| record.state_at(ball, event.time))
            .collect();
        for (one, a) in states.iter().enumerate() {
            if a.motion.in_play() && !a.motion.flies() {
                assert_eq!(a.position.y, scene.balls[one].ball.radius);
            }
            for (two, b) in states[..one].iter().enumerate() {
                let gap = (a.position - b.position).length()
                    - scene.balls[one].ball.radius
                    - scene.balls[two].ball.radius;
                assert!(
                    gap > -1e-8 || !a.motion.in_play() || !b.motion.in_play(),
                    "{one} and {two} overlap by {} m at {} s",
                    -gap,
                    event.time
                );
            }
        }
    }
}

#[test]
fn j16_a_dropped_ball_bounces_for_the_time_and_way_of_the_series() {
    let (h, e) = (0.1, 0.5);
    let mut scene = Scene::new(Preset::NineFoot.table(), laws(e, 0.2));
    let ball = scene.place("1", Ball::POOL, 0.3, 0.2);
    scene.balls[ball].state.position.y += h;
    let record = play(&scene);
    assert_eq!(record.reason, Some(EndReason::Rest));
    let time = (2.0 * h / G).sqrt() * (1.0 + e) / (1.0 - e);
    assert!((time - 0.428_352_94).abs() < 1e-8);
    assert!(
        (record.end_time - time).abs() < 1e-9 * time,
        "{}",
        record.end_time
    );
    let way: f64 = record
        .events
        .iter()
        .map(|event| event.first.after.velocity.y)
        .map(|up| up * up / G)
        .sum::<f64>()
        + h;
    let series = h * (1.0 + e * e) / (1.0 - e * e);
    assert!((way - series).abs() < 1e-9 * series, "{way} m");
    assert_eq!(record.end[0].position.y, R);
}

#[test]
fn j13_a_masse_ends_along_the_line_to_where_the_cue_points_whatever_slate_and_cloth() {
    // Elevation 60 degrees, 0.3 R of right english, J/m = 2 m/s: physics of the fixed points A and P (TP A.19).
    let expected = (5.0 / 7.0, 0.371_153_7);
    for slate in [
        SlateLaw::Held,
        SlateLaw::Rubbed { friction: 0.3 },
        SlateLaw::Bouncing(Bouncing::default()),
        SlateLaw::Bouncing(Bouncing {
            restitution: 0.7,
            friction: 0.05,
            settle: 1e-6,
        }),
    ] {
        let mut scene = jump(
            Laws {
                slate,
                ..Laws::default()
            },
            Shot {
                side: 0.3,
                ..shot(60.0, 1.0)
            },
        );
        scene.cue = Cue {
            end_mass: 0.0,
            ..Cue::default()
        };
        let planned = scene.shot.expect("a shot");
        let impulse = scene.struck(&planned).impulse / Ball::POOL.mass;
        scene.shot = Some(PlannedShot {
            shot: Shot {
                speed: 2.0 / impulse,
                ..planned.shot
            },
            ..planned
        });
        let record = play(&scene);
        let rolls = record
            .events
            .iter()
            .find(|event| event.first.after.motion == Motion::Rolling)
            .expect("it rolls at last");
        let v = rolls.first.after.velocity;
        assert!(
            (v.x - expected.0).abs() < 1e-7 && (v.z - expected.1).abs() < 1e-7,
            "{slate:?}: {v}"
        );
    }
}

#[test]
fn a_steep_stroke_jumps_over_a_ball_that_a_level_one_hits() {
    for (elevation, clears) in [(45.0, true), (0.0, false)] {
        let mut scene = jump(Laws::default(), shot(elevation, 4.0));
        scene.place("1", Ball::POOL, -0.335, 0.0);
        let record = play(&scene);
        audit(&scene, &record);
        let met = record
            .events
            .iter()
            .find(|event| event.kind == EventKind::BallBall);
        // The jumping ball may come back from the far rail.
        let first = met.map_or(f64::INFINITY, |event| event.first.before.velocity.x);
        if clears {
            let over = (0..2000).map(|i| record.state_at(0, 5e-4 * f64::from(i)));
            let near = over
                .filter(|state| (state.position.x + 0.335).abs() < R)
                .map(|state| state.position.y)
                .next();
            assert!(near.is_some_and(|y| y > 3.0 * R), "{near:?}");
            assert!(met.is_none_or(|event| event.time > 0.5));
        } else {
            assert!(first > 0.0);
        }
    }
}

#[test]
fn a_ball_on_the_slate_meets_the_nose_where_spheres_touch() {
    let table = Preset::NineFoot.table();
    let rise = table.nose_height - R;
    let expected = 1.27 - (R * R - rise * rise).sqrt();
    let record = play(&jump(Laws::default(), shot(0.0, 2.0)));
    let met = record
        .events
        .iter()
        .find(|event| matches!(event.kind, EventKind::Cushion { .. }))
        .expect("the foot rail");
    let x = met.first.before.position.x;
    assert!((x - expected).abs() < 1e-12, "{x} m, not {expected} m");
}

#[test]
fn a_ball_in_flight_meets_the_nose_at_its_radius_in_space_or_clears_it() {
    let mut met = 0;
    let mut cleared = 0;
    for step in 0..60 {
        let mut scene = jump(Laws::default(), shot(0.0, 0.0));
        scene.shot = None;
        let state = &mut scene.balls[0].state;
        // Towards the foot rail, a little away from it, at many heights.
        state.position = DVec3::new(1.1, R + 0.002 * f64::from(step), 0.1);
        state.velocity = DVec3::new(3.0, 0.4, 0.3);
        let record = play(&scene);
        audit(&scene, &record);
        let first = record
            .events
            .iter()
            .find(|event| matches!(event.kind, EventKind::Cushion { .. } | EventKind::OffTable))
            .expect("it comes to the rail");
        if first.kind == EventKind::OffTable {
            cleared += 1;
            assert_eq!(record.end[0].motion, Motion::OffTable);
            continue;
        }
        met += 1;
        assert_eq!(cleared, 0, "a higher ball is turned back");
        let at = first.first.before;
        let nose = scene.table.nose_height;
        let (out, up) = (at.position.x - 1.27, at.position.y - nose);
        let distance = (out * out + up * up).sqrt();
        assert!((distance - R).abs() < 1e-11, "{distance} m");
    }
    assert!(
        met > 5 && cleared > 5,
        "{met} met the nose, {cleared} cleared it"
    );
}

#[test]
fn no_ball_clears_a_wall() {
    let mut scene = jump(Laws::default(), shot(40.0, 6.0));
    scene.table.nose = Nose::Wall;
    scene.table.pockets.clear();
    let record = play(&scene);
    assert!(record.end[0].motion.in_play());
    assert!(
        record
            .events
            .iter()
            .any(|event| matches!(event.kind, EventKind::Cushion { .. })
                && event.first.before.motion == Motion::Airborne)
    );
}

#[test]
fn random_elevated_shots_at_racks_lose_energy_and_overlap_nobody() {
    let mut random = ChaCha8Rng::seed_from_u64(16);
    let (mut flown, mut off) = (0, 0);
    for _ in 0..150 {
        let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
        Rack::NineBall.place(&mut scene, Ball::POOL, 0.0, random.random());
        scene.shot = Some(PlannedShot {
            ball: 0,
            shot: Shot {
                heading: random.random_range(-0.3..0.3),
                side: random.random_range(-0.3..0.3),
                height: random.random_range(-0.3..0.3),
                ..shot(
                    random.random_range(5.0..80.0),
                    random.random_range(1.0..9.0),
                )
            },
        });
        let record = solve(&scene, Limits::default()).expect("every scene can be advanced");
        audit(&scene, &record);
        assert_eq!(record.reason, Some(EndReason::Rest));
        flown += record
            .events
            .iter()
            .filter(|event| event.kind == EventKind::Slate)
            .count();
        off += record
            .end
            .iter()
            .filter(|end| end.motion == Motion::OffTable)
            .count();
    }
    println!("{flown} landings, {off} balls off the table in 150 shots");
    assert!(flown > 150 && off > 5);
}
