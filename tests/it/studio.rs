//! The studio, without a window: exact places, balls that come and go, undo and redo, scenes that are saved.

use bevy::prelude::*;
use glam::DVec2;
use masse::game::GamePlugin;
use masse::game::aim::Aim;
use masse::game::practice::{Practice, PracticeCommand};
use masse::game::snap;
use masse::game::studio::StudioCommand;
use masse::physics::ball::Ball;
use masse::physics::laws::Laws;
use masse::physics::scene::Scene;
use masse::physics::table::Preset;
use masse::scenarios::file::{self, Scenario};
use masse::scenarios::library;
use masse::scenarios::own::Own;
use masse::sim::SimPlugin;
use masse::sim::playfield::lay_out;
use masse::sim::stepping;

fn table() -> Scene {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    scene.place("cue", Ball::POOL, -0.6, 0.0);
    scene.place("1", Ball::POOL, 0.31, 0.2);
    scene.place("8", Ball::POOL, 0.5, 0.27);
    scene
}

fn app() -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, SimPlugin, GamePlugin));
    app.finish();
    app.cleanup();
    lay_out(app.world_mut(), &table());
    app.update();
    stepping::step(&mut app, 2);
    app
}

fn build(app: &mut App, command: StudioCommand) -> Scene {
    app.world_mut().write_message(command);
    stepping::step(app, 2);
    stepping::scene(app)
}

fn ask(app: &mut App, command: PracticeCommand) -> Scene {
    app.world_mut().write_message(command);
    stepping::step(app, 2);
    stepping::scene(app)
}

fn plan(scene: &Scene, name: &str) -> DVec2 {
    let at = scene.balls[scene.ball_named(name).expect("it is there")]
        .state
        .position;
    DVec2::new(at.x, at.z)
}

fn names(scene: &Scene) -> Vec<&str> {
    scene.balls.iter().map(|ball| ball.name.as_str()).collect()
}

#[test]
fn a_frozen_ball_touches_within_rounding_and_is_playable() {
    let mut app = app();
    let scene = build(&mut app, StudioCommand::FreezeToBall(2, 1));
    let apart = plan(&scene, "1").distance(plan(&scene, "8"));
    assert!((apart - 2.0 * Ball::POOL.radius).abs() < 1e-11, "{apart}");
    assert_eq!(scene.check(), Ok(()));
    // It stays on the line on which it was seen.
    let before = table();
    let way = |scene: &Scene| (plan(scene, "8") - plan(scene, "1")).normalize();
    assert!(way(&scene).distance(way(&before)) < 1e-9);
    let scene = build(&mut app, StudioCommand::FreezeToRail(1));
    let reach = scene.table.reach(Ball::POOL.radius);
    let gap = 0.5 * scene.table.width - plan(&scene, "1").y - reach;
    assert!((0.0..1e-11).contains(&gap), "{gap}");
    assert_eq!(plan(&scene, "1").x, 0.31);
    assert_eq!(scene.check(), Ok(()));
}

#[test]
fn a_ball_freezes_beside_its_place_where_that_is_taken() {
    let mut scene = table();
    // Another ball stands where the 8 would touch the 1.
    let one = plan(&scene, "1");
    let way = (plan(&scene, "8") - one).normalize();
    let spot = one + 2.0 * Ball::POOL.radius * way;
    scene.place("2", Ball::POOL, spot.x + 0.01, spot.y);
    let found = snap::to_ball(&scene, 2, 1).expect("there is room beside it");
    assert!((found.distance(one) - 2.0 * Ball::POOL.radius).abs() < 1e-11);
    assert!(found.distance(plan(&scene, "2")) >= 2.0 * Ball::POOL.radius);
    assert_eq!(snap::nearest_ball(&scene, 2), Some(3));
    assert_eq!(snap::to_ball(&scene, 1, 1), None);
    assert_eq!(snap::to_ball(&scene, 1, 77), None);
}

#[test]
fn diamonds_are_exact_and_read_back() {
    let mut app = app();
    let scene = build(&mut app, StudioCommand::ToDiamond(1));
    let at = plan(&scene, "1");
    assert_eq!(at, DVec2::new(0.3175, 0.3175));
    assert_eq!(scene.table.diamonds_of(at), DVec2::new(1.0, 3.0));
    for point in [DVec2::new(0.1, -0.5), DVec2::new(-1.2, 0.33)] {
        let back = scene.table.at_diamonds(scene.table.diamonds_of(point));
        assert!(back.distance(point) < 1e-15, "{point} {back}");
    }
}

#[test]
fn balls_come_and_go_and_every_step_is_undone_and_done_again() {
    let mut app = app();
    let mut seen = vec![stepping::scene(&mut app)];
    let steps = [
        StudioCommand::Add("9".to_owned()),
        StudioCommand::FreezeToBall(3, 2),
        StudioCommand::FreezeToRail(1),
        StudioCommand::Remove(1),
    ];
    for step in steps {
        seen.push(build(&mut app, step));
    }
    assert_eq!(names(&seen[4]), ["cue", "8", "9"]);
    // These do nothing, and are no steps.
    for step in [
        StudioCommand::Add("9".to_owned()),
        StudioCommand::Add("  ".to_owned()),
        StudioCommand::Remove(0),
        StudioCommand::Remove(99),
        StudioCommand::FreezeToBall(0, 99),
        StudioCommand::FreezeToRail(99),
        StudioCommand::ToDiamond(99),
        StudioCommand::StrikeBall(99),
    ] {
        assert_eq!(build(&mut app, step), seen[4]);
    }
    for scene in seen[..4].iter().rev() {
        assert_eq!(&ask(&mut app, PracticeCommand::Undo), scene);
    }
    for scene in &seen[1..] {
        assert_eq!(&ask(&mut app, PracticeCommand::Redo), scene);
    }
    assert_eq!(ask(&mut app, PracticeCommand::Redo), seen[4]);
    ask(&mut app, PracticeCommand::Undo);
    // Something new cannot be followed by what was undone.
    let new = build(&mut app, StudioCommand::ToDiamond(2));
    assert_eq!(app.world().resource::<Practice>().history.undone(), 0);
    assert_eq!(ask(&mut app, PracticeCommand::Redo), new);
}

#[test]
fn thousands_of_steps_can_be_undone() {
    let mut app = app();
    let first = stepping::scene(&mut app);
    for step in 0..2500 {
        let command = PracticeCommand::PlaceBall {
            ball: 1 + step % 2,
            x: 0.1 + 0.0001 * step as f64,
            z: 0.1 * (step % 2) as f64,
        };
        app.world_mut().write_message(command);
    }
    stepping::step(&mut app, 2);
    let last = stepping::scene(&mut app);
    assert_eq!(app.world().resource::<Practice>().history.len(), 2500);
    for _ in 0..2500 {
        app.world_mut().write_message(PracticeCommand::Undo);
        stepping::step(&mut app, 1);
    }
    stepping::step(&mut app, 1);
    assert_eq!(stepping::scene(&mut app), first);
    for _ in 0..2500 {
        app.world_mut().write_message(PracticeCommand::Redo);
        stepping::step(&mut app, 1);
    }
    stepping::step(&mut app, 1);
    assert_eq!(stepping::scene(&mut app), last);
}

#[test]
fn another_ball_can_be_the_one_to_strike_and_stays_it() {
    let mut app = app();
    build(&mut app, StudioCommand::StrikeBall(2));
    build(&mut app, StudioCommand::Remove(1));
    let scene = stepping::scene(&mut app);
    let aim = *app.world().resource::<Aim>();
    assert_eq!(scene.balls[aim.ball].name, "8");
    ask(&mut app, PracticeCommand::Undo);
    assert_eq!(app.world().resource::<Aim>().ball, 2);
}

#[test]
fn own_scenes_are_saved_whole_and_come_back_with_every_bit() {
    let folder = tempfile::tempdir().expect("a folder");
    let own = Own::in_folder(folder.path().join("scenes"));
    assert_eq!(own.names(), Vec::<String>::new());
    let scenario = library::open("stop-shot").expect("it is built in");
    let path = own.save("my stop", &scenario).expect("it is saved");
    let read = file::read(&path).expect("it is read");
    assert_eq!(read.scene, scenario.scene);
    assert_eq!(read.expect, scenario.expect);
    let laid = library::open(&path.display().to_string()).expect("the library finds it");
    assert_eq!(laid.laid_out().shot, None);
    assert_eq!(own.names(), ["my stop"]);
    for name in ["", " ", "a/b", "../x", "a.b", &"x".repeat(101)] {
        let error = own.save(name, &scenario).expect_err(name).to_string();
        assert!(error.contains("cannot be the name"), "{error}");
    }
    // A scene in which an expectation has lost its ball is refused, and what was saved stays.
    let mut lost = Scenario {
        title: "lost".to_owned(),
        ..scenario.clone()
    };
    lost.scene.balls.truncate(1);
    let error = own
        .save("my stop", &lost)
        .expect_err("it cannot be read")
        .to_string();
    assert!(error.contains("expect"), "{error}");
    assert_eq!(
        file::read(&path).expect("it is still there").title,
        scenario.title
    );
}
