//! Collapse, pressing and corners: hard cases H1, H2 and H5.

use glam::DVec3;

use masse::physics::ball::{Ball, Motion};
use masse::physics::cue::Shot;
use masse::physics::exact::{Contact, Engine, Limits};
use masse::physics::laws::Laws;
use masse::physics::laws::cushion::{CushionLaw, Mirror};
use masse::physics::record::{EndReason, EventKind};
use masse::physics::scene::{PlannedShot, Scene, Solver};
use masse::physics::table::Preset;

use super::{audit, play, put, scene, smooth};

const R: f64 = Ball::POOL.radius;

#[test]
fn h1_inelastic_rows_end_in_bounded_events() {
    for e in [0.05, 0.5, 0.95] {
        for count in [3, 8, 16] {
            // Into a wall, in a row, from the side of the open table.
            let mut scene = scene(smooth(e, e));
            for i in 0..count {
                let x = 50.0 - R - 0.01 - f64::from(i) * (2.0 * R + 0.003);
                put(
                    &mut scene,
                    &i.to_string(),
                    x,
                    0.0,
                    DVec3::X * 1.0,
                    DVec3::ZERO,
                );
            }
            scene.time_limit = 30.0;
            let record = play(&scene);
            assert!(
                record.events.len() < 20_000,
                "e {e}, {count} balls: {} events",
                record.events.len()
            );
            audit(&scene, &record, 1e-14);
        }
    }
}

#[test]
fn h1_inelastic_rows_come_to_rest_on_cloth() {
    for e in [0.05, 0.5, 0.95] {
        let laws = Laws {
            ball_ball: smooth(e, e).ball_ball,
            cushion: smooth(e, e).cushion,
            ..Laws::default()
        };
        let mut scene = scene(laws);
        for i in 0..10 {
            let x = 50.0 - R - 0.01 - f64::from(i) * (2.0 * R + 0.003);
            put(
                &mut scene,
                &i.to_string(),
                x,
                0.0,
                DVec3::X * 1.0,
                DVec3::ZERO,
            );
        }
        let record = play(&scene);
        assert_eq!(record.reason, Some(EndReason::Rest));
        assert!(
            record.events.len() < 20_000,
            "e {e}: {} events",
            record.events.len()
        );
        audit(&scene, &record, 1e-6);
    }
}

#[test]
fn h2_a_pressed_ball_rests_against_the_cushion() {
    for cushion in [
        CushionLaw::Mirror(Mirror {
            restitution: 0.8.into(),
        }),
        Laws::default().cushion,
    ] {
        for speed in [0.0, 0.5] {
            let laws = Laws {
                cushion,
                ..Laws::default()
            };
            let mut scene = scene(laws);
            // Heavy topspin towards the cushion that it touches.
            let spin = Ball::POOL.rolling_spin(DVec3::X * 4.0);
            put(&mut scene, "cue", 50.0 - R, 0.3, DVec3::X * speed, spin);
            let mut engine = Engine::new(&scene, Limits { events: 5000 }).expect("a sound scene");
            let mut rested = false;
            let mut turn = f64::INFINITY;
            for i in 1..200 {
                engine
                    .advance(0.01 * f64::from(i), &mut ())
                    .expect("bounded events");
                rested |= engine.contact(0) == Contact::RestingOnCushion { cushion: 1 };
                let state = engine.state(0);
                assert!(state.position.x <= 50.0 - R + 1e-9);
                // The spin that drives it on, until it rolls away.
                let spin = (-state.angular_velocity.z).max(0.0);
                assert!(
                    spin <= turn + 1e-6,
                    "spin grows from {turn} to {spin} rad/s"
                );
                turn = spin;
            }
            assert!(
                rested || speed > 0.0,
                "never rests, {} events",
                engine.events()
            );
            engine
                .advance(f64::INFINITY, &mut ())
                .expect("bounded events");
            assert!(engine.is_at_rest());
            println!("{} events", engine.events());
        }
    }
}

#[test]
fn h2_a_ball_pressed_against_another_ends_in_bounded_events() {
    let mut scene = scene(Laws::default());
    let spin = Ball::POOL.rolling_spin(DVec3::X * 5.0);
    put(&mut scene, "cue", 50.0 - 3.0 * R, 0.0, DVec3::ZERO, spin);
    put(&mut scene, "1", 50.0 - R, 0.0, DVec3::ZERO, DVec3::ZERO);
    let record = play(&scene);
    assert_eq!(record.reason, Some(EndReason::Rest));
    assert!(record.events.len() < 5000, "{} events", record.events.len());
    assert!(
        record
            .end
            .iter()
            .all(|state| state.position.x <= 50.0 - R + 1e-9)
    );
}

#[test]
fn h5_a_ball_at_the_cushion_stays_in() {
    for laws in [Laws::default(), smooth(0.9, 0.9)] {
        for speed in [1e-12, 1e-6, 0.1, 2.0, 30.0] {
            for degrees in [0.0_f64, 30.0, 60.0, 89.0, 90.0] {
                for gap in [0.0, 1e-12, 1e-16, -1e-12] {
                    let mut scene = scene(laws);
                    let angle = degrees.to_radians();
                    let velocity = speed * DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
                    put(
                        &mut scene,
                        "cue",
                        50.0 - R - gap,
                        0.0,
                        velocity,
                        DVec3::ZERO,
                    );
                    scene.time_limit = 5.0;
                    let record = play(&scene);
                    for i in 0..=200 {
                        let x = record
                            .state_at(0, record.end_time * f64::from(i) / 200.0)
                            .position
                            .x;
                        assert!(
                            x <= 50.0 - R + 1e-9,
                            "{speed} m/s {degrees}° gap {gap:e}: x = {x}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn h5_a_corner_sends_a_ball_back_along_its_line() {
    for (first, second) in [
        (1.0, 1.0),
        (1.0, 1.0 + 1e-15),
        (1.0 + 1e-15, 1.0),
        (1.0, 1.0 - 1e-9),
    ] {
        let table = Preset::Box {
            length: 2.0,
            width: 2.0,
        };
        let mut scene = Scene::new(table.table(), smooth(1.0, 0.8));
        scene.solver = Solver::Exact;
        put(
            &mut scene,
            "cue",
            0.0,
            0.0,
            DVec3::new(first, 0.0, second),
            DVec3::ZERO,
        );
        scene.time_limit = 1.5;
        let record = play(&scene);
        let hits = record
            .events
            .iter()
            .filter(|event| matches!(event.kind, EventKind::Cushion { .. }))
            .count();
        assert_eq!(hits, 2);
        let velocity = record.end[0].velocity;
        assert!(
            (velocity - DVec3::new(-0.8 * first, 0.0, -0.8 * second)).length() < 1e-14,
            "{velocity:?}"
        );
        assert_eq!(record.end[0].motion, Motion::Gliding);
    }
}

#[test]
fn h2_a_ball_between_the_edge_of_a_pocket_and_a_nose_gets_out() {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    scene.solver = Solver::Exact;
    // It jumps into the far side of a corner pocket, and on its way out meets the nose from below.
    scene.place(
        "cue",
        Ball::POOL,
        -0.992_410_546_244_571_5,
        0.096_022_910_363_046_83,
    );
    scene.shot = Some(PlannedShot {
        ball: 0,
        shot: Shot {
            heading: 1.946_287_199_593_663_3,
            elevation: 0.0,
            side: -0.167_809_556_990_789_84,
            height: -0.249_424_800_410_358_1,
            speed: 6.053_508_120_241_644,
        },
    });
    let record = play(&scene);
    assert_eq!(record.reason, Some(EndReason::Rest));
    assert!(record.events.len() < 1000, "{} events", record.events.len());
}
