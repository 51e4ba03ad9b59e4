//! The live table: any frame rate, saving, the same bits as the solved shot; bad input.

use glam::DVec3;

use masse::physics::ball::{Ball, State};
use masse::physics::cue::Shot;
use masse::physics::exact::{Engine, Limits, Recorder, Saved, SolveError, solve};
use masse::physics::laws::Laws;
use masse::physics::record::EndReason;
use masse::physics::scene::{PlannedShot, Rack, Scene, Solver};
use masse::physics::table::Preset;

use super::{play, put, scene, smooth};

fn break_shot() -> Scene {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    scene.solver = Solver::Exact;
    Rack::NineBall.place(&mut scene, Ball::POOL, 0.0, 7);
    let shot = Shot {
        heading: 0.003,
        side: 0.2,
        height: 0.1,
        speed: 7.0,
        ..Shot::default()
    };
    scene.shot = Some(PlannedShot { ball: 0, shot });
    scene
}

/// A gas in a box, found by cells.
fn gas(count: u32) -> Scene {
    let side = (f64::from(count)).sqrt().ceil();
    let size = side * 0.08;
    let table = Preset::Box {
        length: size,
        width: size,
    };
    let mut scene = Scene::new(table.table(), smooth(1.0, 1.0));
    scene.solver = Solver::Exact;
    for i in 0..count {
        let (row, column) = ((f64::from(i) / side).floor(), f64::from(i) % side);
        let angle = f64::from(i) * 2.399_963;
        let velocity = DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
        let place = |k: f64| (k + 0.5) * 0.08 - 0.5 * size;
        put(
            &mut scene,
            &i.to_string(),
            place(column),
            place(row),
            velocity,
            DVec3::ZERO,
        );
    }
    scene.time_limit = 1.0;
    scene
}

fn states(engine: &Engine) -> Vec<State> {
    (0..engine.count()).map(|ball| engine.state(ball)).collect()
}

#[test]
fn h12_h14_any_frame_rate_gives_the_same_bits() {
    for scene in [break_shot(), gas(100)] {
        let record = play(&scene);
        let until = 0.9;
        for frames in [1_u32, 7, 60, 997] {
            let mut engine = Engine::new(&scene, Limits::default()).expect("a sound scene");
            let mut recorder = Recorder::new(&engine);
            if let Some(planned) = &scene.shot {
                engine
                    .strike(planned.ball, &scene.cue, &planned.shot, &mut recorder)
                    .expect("a sound shot");
            }
            for frame in 1..=frames {
                engine
                    .advance(until * f64::from(frame) / f64::from(frames), &mut recorder)
                    .expect("a sound scene");
            }
            for (ball, state) in states(&engine).into_iter().enumerate() {
                assert_eq!(
                    state,
                    record.state_at(ball, until),
                    "{frames} frames, ball {ball}"
                );
            }
            assert!(record.events.starts_with(&recorder.so_far().events));
        }
    }
}

#[test]
fn a_second_shot_on_the_live_table_has_the_bits_of_its_preview() {
    let scene = break_shot();
    let mut engine = Engine::new(&scene, Limits::default()).expect("a sound scene");
    let planned = scene.shot.expect("there is a shot");
    engine
        .strike(0, &scene.cue, &planned.shot, &mut ())
        .expect("a sound shot");
    engine
        .advance(f64::INFINITY, &mut ())
        .expect("a sound scene");
    assert!(engine.is_at_rest());
    engine
        .advance(engine.time() + 12.345, &mut ())
        .expect("nothing happens");
    let ball = (0..engine.count())
        .find(|&ball| engine.state(ball).motion.in_play())
        .expect("a ball is left");
    let mut preview = scene.clone();
    for (index, ball) in preview.balls.iter_mut().enumerate() {
        ball.state = engine.state(index);
    }
    preview.shot = Some(PlannedShot { ball, ..planned });
    let record = play(&preview);
    engine
        .strike(ball, &scene.cue, &planned.shot, &mut ())
        .expect("a sound shot");
    engine
        .advance(f64::INFINITY, &mut ())
        .expect("a sound scene");
    assert_eq!(engine.last_event_time(), record.end_time);
    assert_eq!(states(&engine), record.end);
}

#[test]
fn a_reloaded_engine_has_the_bits_of_a_new_one() {
    for mut scene in [break_shot(), gas(100)] {
        let mut engine = Engine::new(&scene, Limits::default()).expect("a sound scene");
        for i in 0..3 {
            scene.balls[0].state.velocity.x = 1.0 + 0.1 * f64::from(i);
            scene.shot = None;
            engine.advance(0.4, &mut ()).expect("a sound scene");
            engine.reload(&scene).expect("a sound scene");
            let mut fresh = Engine::new(&scene, Limits::default()).expect("a sound scene");
            engine.advance(0.7, &mut ()).expect("a sound scene");
            fresh.advance(0.7, &mut ()).expect("a sound scene");
            assert_eq!(states(&engine), states(&fresh));
            assert_eq!(engine.events(), fresh.events());
        }
    }
}

#[test]
fn a_saved_table_goes_on_with_the_same_bits() {
    for scene in [break_shot(), gas(100)] {
        let mut engine = Engine::new(&scene, Limits::default()).expect("a sound scene");
        if let Some(planned) = &scene.shot {
            engine
                .strike(planned.ball, &scene.cue, &planned.shot, &mut ())
                .expect("a sound shot");
        }
        engine.advance(0.7, &mut ()).expect("a sound scene");
        let text = serde_json::to_string(&engine.save()).expect("everything in it is finite");
        let saved: Saved = serde_json::from_str(&text).expect("it was just written");
        assert_eq!(saved, engine.save());
        let mut restored =
            Engine::restore(&scene, &saved, Limits::default()).expect("a sound scene");
        for until in [0.8, 1.5] {
            engine.advance(until, &mut ()).expect("a sound scene");
            restored.advance(until, &mut ()).expect("a sound scene");
            assert_eq!(states(&engine), states(&restored), "at {until} s");
        }
        assert_eq!(engine.events(), restored.events());
    }
}

#[test]
fn cells_find_what_a_full_search_finds() {
    // 39 balls are searched in full; the 40th, far away and at rest, turns the cells on.
    let few = gas(39);
    let mut many = few.clone();
    many.table
        .cushions
        .extend(masse::physics::table::Table::closed_box(50.0, 50.0, 0.03).cushions);
    many.table.length = 50.0;
    many.table.width = 50.0;
    many.place("far", Ball::POOL, 20.0, 20.0);
    let (few, many) = (play(&few), play(&many));
    let hits: Vec<_> = few
        .events
        .iter()
        .map(|event| (event.kind, event.first.ball))
        .collect();
    assert!(hits.len() > 100);
    for (one, two) in few.events.iter().zip(&many.events) {
        assert_eq!(one.kind, two.kind);
        assert!(
            (one.time - two.time).abs() < 1e-6,
            "{} {}",
            one.time,
            two.time
        );
        if one.time > 0.3 {
            break;
        }
    }
}

#[test]
fn a_gas_keeps_its_energy() {
    let scene = gas(400);
    let mut engine = Engine::new(&scene, Limits::default()).expect("a sound scene");
    engine.advance(3.0, &mut ()).expect("a sound scene");
    let sum: f64 = states(&engine)
        .iter()
        .map(|state| state.velocity.length_squared())
        .sum();
    assert!((sum - 400.0).abs() < 1e-10, "{sum}");
    assert!(engine.events() > 10_000);
}

#[test]
fn bad_input_is_an_error_with_names_and_numbers() {
    let mut overlapping = scene(smooth(1.0, 1.0));
    put(&mut overlapping, "cue", 0.0, 0.0, DVec3::X, DVec3::ZERO);
    put(&mut overlapping, "1", 0.05, 0.0, DVec3::ZERO, DVec3::ZERO);
    assert!(matches!(
        solve(&overlapping, Limits::default()),
        Err(SolveError::Scene(_))
    ));
    let mut engine = Engine::new(&overlapping, Limits::default()).expect("found when it matters");
    let error = engine.advance(1.0, &mut ()).expect_err("they overlap");
    assert!(matches!(&error, SolveError::Overlap { .. }), "{error}");
    assert!(
        error.to_string().contains("`1`") && error.to_string().contains("0.0071"),
        "{error}"
    );

    let mut scene = gas(50);
    scene.time_limit = 1000.0;
    let error = solve(&scene, Limits { events: 500 }).expect_err("too many events");
    assert!(
        matches!(error, SolveError::EventLimit { events: 501, .. }),
        "{error}"
    );

    scene.balls[3].state.velocity.x = f64::NAN;
    let error = Engine::new(&scene, Limits::default()).expect_err("not a number");
    assert!(error.to_string().contains("`3`"), "{error}");

    let mut drawn = super::scene(Laws::coursework());
    put(&mut drawn, "cue", 0.0, 0.0, DVec3::X, DVec3::ZERO);
    assert_eq!(
        Engine::new(&drawn, Limits::default()).err(),
        Some(SolveError::NotClosedForm)
    );
}

#[test]
fn a_table_without_cloth_goes_quiet_or_runs_out_of_time() {
    let mut open = scene(smooth(1.0, 1.0));
    open.table.cushions.clear();
    put(&mut open, "cue", 0.0, 0.0, DVec3::X, DVec3::ZERO);
    assert_eq!(play(&open).reason, Some(EndReason::Quiet));
    let mut closed = gas(10);
    closed.time_limit = 0.5;
    let record = play(&closed);
    assert_eq!(record.reason, Some(EndReason::TimeLimit));
    assert_eq!(record.end_time, 0.5);
}
