//! A table saved in the middle of a shot goes on, in another app, with the same bits.

use masse::physics::ball::Ball;
use masse::physics::cue::Shot;
use masse::physics::laws::Laws;
use masse::physics::scene::{PlannedShot, Rack, Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::sim::clock::Clock;
use masse::sim::recorder::Recorder;
use masse::sim::saved::{SavedTable, restore, save};
use masse::sim::stepping::{headless_app, states, step};

fn break_shot(solver: Solver, laws: Laws) -> Scene {
    let mut scene = Scene::new(Preset::NineFoot.table(), laws);
    Rack::NineBall.place(&mut scene, Ball::POOL, 0.0, 7);
    let shot = Shot {
        heading: 0.003,
        side: 0.2,
        height: 0.1,
        speed: 7.0,
        ..Shot::default()
    };
    scene.shot = Some(PlannedShot { ball: 0, shot });
    scene.solver = solver;
    scene
}

#[test]
fn a_table_saved_mid_shot_goes_on_in_another_app_with_the_same_bits() {
    let stepped = Solver::Stepped(Stepped::default());
    for (solver, laws) in [
        (Solver::Exact, Laws::default()),
        (stepped, Laws::default()),
        (stepped, Laws::coursework()),
    ] {
        for ticks in [0, 1, 30, 157] {
            let mut app = headless_app(&break_shot(solver, laws));
            // The first tick plays the stroke.
            step(&mut app, 1 + ticks);
            let text =
                serde_json::to_string(&save(app.world_mut())).expect("everything in it is finite");
            let saved: SavedTable = serde_json::from_str(&text).expect("it was just written");
            let mut elsewhere = headless_app(&Scene::new(Preset::EightFoot.table(), laws));
            step(&mut elsewhere, 3);
            restore(elsewhere.world_mut(), &saved).expect("it was just saved");
            assert_eq!(save(elsewhere.world_mut()), saved);
            for further in [0, 1, 100, 900] {
                step(&mut app, further);
                step(&mut elsewhere, further);
                assert_eq!(
                    states(&mut app),
                    states(&mut elsewhere),
                    "{ticks} ticks, then {further}"
                );
            }
            let [one, two] = [&app, &elsewhere].map(|app| {
                let clock = app.world().resource::<Clock>();
                let recorder = app.world().resource::<Recorder>();
                (
                    *clock,
                    recorder.record(clock.time(), None),
                    &recorder.trails,
                )
            });
            assert!(one.1.events.len() > 20 || laws == Laws::coursework());
            assert_eq!(one, two);
        }
    }
}

#[test]
fn what_does_not_fit_together_is_refused_and_changes_nothing() {
    let mut app = headless_app(&break_shot(Solver::Exact, Laws::default()));
    step(&mut app, 20);
    let good = save(app.world_mut());
    let mut text = serde_json::to_value(&good).expect("everything in it is finite");
    text["scene"]["balls"]
        .as_array_mut()
        .expect("balls are a list")
        .pop();
    let bad: SavedTable = serde_json::from_value(text).expect("it has every field");
    let error = restore(app.world_mut(), &bad).expect_err("a ball is missing");
    assert!(error.to_string().contains("10"), "{error}");
    assert_eq!(save(app.world_mut()), good);
}
