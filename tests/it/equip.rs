//! Other equipment on the open table, and a cue that is raised where it has no room. Without a window.

use bevy::prelude::*;
use masse::game::GamePlugin;
use masse::game::aim::Aim;
use masse::game::equip::Equip;
use masse::game::lift::{CueRoom, raise};
use masse::game::practice::{self, PracticeCommand};
use masse::physics::ball::Ball;
use masse::physics::cue_path::Obstacle;
use masse::physics::equipment::{BallSet, Equipment};
use masse::physics::laws::Laws;
use masse::physics::scene::{PlannedShot, Rack, Scene, Solver};
use masse::physics::table::Preset;
use masse::scenarios::preset;
use masse::sim::SimPlugin;
use masse::sim::clock::Clock;
use masse::sim::messages::Strike;
use masse::sim::playfield::{Playfield, lay_out};
use masse::sim::stepping;

fn app(scene: &Scene) -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, SimPlugin, GamePlugin))
        .add_systems(PreUpdate, raise);
    app.finish();
    app.cleanup();
    lay_out(app.world_mut(), scene);
    app.update();
    stepping::step(&mut app, 2);
    app
}

fn equipment(name: &str) -> Equipment {
    preset::open(name)
        .unwrap_or_else(|error| panic!("{error}"))
        .equipment
}

fn equip(app: &mut App, equipment: Equipment, rack: bool) {
    app.world_mut().write_message(Equip { equipment, rack });
    stepping::step(app, 3);
}

fn spread() -> Scene {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    scene.place("cue", Ball::POOL, -0.6, 0.0);
    scene.place("1", Ball::POOL, 0.3, 0.1);
    scene.place("2", Ball::POOL, 1.0, -0.5);
    scene
}

#[test]
fn other_laws_leave_the_balls_alone_and_can_be_tried_on_the_same_shot() {
    let mut app = app(&spread());
    let before = stepping::scene(&mut app);
    let mut other = Equipment {
        laws: equipment("heated_carom").laws,
        cue: equipment("snooker").cue,
        ..Equipment::default()
    };
    equip(&mut app, other.clone(), false);
    let after = stepping::scene(&mut app);
    assert_eq!(after.balls, before.balls);
    assert_eq!((after.laws, after.cue), (other.laws, other.cue));
    // Heavier balls of the same size come to the table where the old ones lay.
    other.balls = BallSet {
        cue: Ball {
            mass: 0.2,
            ..Ball::POOL
        },
        object: Ball::POOL,
    };
    equip(&mut app, other, false);
    let after = stepping::scene(&mut app);
    assert_eq!(after.balls[0].ball.mass, 0.2);
    assert_eq!(
        after.balls[0].state.position,
        before.balls[0].state.position
    );
    assert_eq!(after.balls[1..], before.balls[1..]);
}

#[test]
fn equipment_waits_for_the_balls_to_rest() {
    let mut app = app(&spread());
    let shot = app.world().resource::<Aim>().shot;
    app.world_mut().write_message(Strike { ball: 0, shot });
    stepping::step(&mut app, 5);
    let other = Equipment {
        laws: equipment("heated_carom").laws,
        ..Equipment::default()
    };
    equip(&mut app, other.clone(), false);
    assert!(app.world().resource::<Clock>().moving);
    assert_ne!(app.world().resource::<Playfield>().laws, other.laws);
    for _ in 0..120 * 60 {
        stepping::step(&mut app, 1);
        if !app.world().resource::<Clock>().moving {
            break;
        }
    }
    stepping::step(&mut app, 2);
    assert_eq!(app.world().resource::<Playfield>().laws, other.laws);
}

#[test]
fn another_table_is_racked_again_with_its_balls_and_can_be_undone() {
    let mut app = app(&practice::opening());
    let opening = stepping::scene(&mut app);
    let snooker = equipment("snooker");
    equip(&mut app, snooker.clone(), true);
    let scene = stepping::scene(&mut app);
    assert_eq!(scene.check(), Ok(()));
    assert_eq!((&scene.table, scene.laws), (&snooker.table, snooker.laws));
    assert_eq!(BallSet::in_scene(&scene), Some(snooker.balls));
    // A new rack keeps the kind of balls.
    app.world_mut()
        .write_message(PracticeCommand::Rack(Rack::NineBall));
    stepping::step(&mut app, 3);
    let scene = stepping::scene(&mut app);
    assert_eq!(
        (scene.balls.len(), BallSet::in_scene(&scene)),
        (10, Some(snooker.balls))
    );
    for _ in 0..2 {
        app.world_mut().write_message(PracticeCommand::Undo);
        stepping::step(&mut app, 3);
    }
    let back = stepping::scene(&mut app);
    assert_eq!((&back.table, &back.balls), (&opening.table, &opening.balls));
    // Balls that lie outside a smaller table are racked again.
    equip(&mut app, snooker.clone(), false);
    equip(&mut app, equipment("bar_box"), false);
    let small = stepping::scene(&mut app);
    assert_eq!(small.check(), Ok(()));
    assert_eq!(small.table, Preset::SevenFoot.table());
    assert_eq!(small.balls[0].ball.mass, 0.191);
}

#[test]
fn the_cue_is_raised_over_a_ball_and_comes_down_again() {
    let mut scene = spread();
    scene.place("3", Ball::POOL, -0.75, 0.0);
    let mut app = app(&scene);
    let elevation = |app: &mut App, heading: f64| {
        let mut aim = app.world_mut().resource_mut::<Aim>();
        aim.set_heading(heading);
        app.update();
        app.world().resource::<Aim>().shot.elevation
    };
    let over = elevation(&mut app, 0.0);
    assert!(over.to_degrees() > 10.0, "{} degrees", over.to_degrees());
    let lift = app.world().resource::<CueRoom>().lift.expect("room");
    assert_eq!((lift.over, lift.elevation), (Some(Obstacle::Ball(3)), over));
    // Beside the ball only the rail is in the way; the player's own wish comes back.
    let beside = elevation(&mut app, 0.6);
    assert!(beside.to_degrees() < 5.0, "{} degrees", beside.to_degrees());
    app.world_mut().resource_mut::<Aim>().set_elevation(0.7);
    assert_eq!(elevation(&mut app, 0.6), 0.7);
    assert_eq!(elevation(&mut app, 0.0), 0.7);
    app.world_mut().resource_mut::<Aim>().set_elevation(0.0);
    assert_eq!(elevation(&mut app, 0.0), over);
    // What is struck is what is shown, and it is free.
    let shot = app.world().resource::<Aim>().shot;
    let mut planned = stepping::scene(&mut app);
    planned.solver = Solver::Exact;
    planned.shot = Some(PlannedShot { ball: 0, shot });
    assert_eq!(masse::physics::cue_path::obstacle(&planned, 0, &shot), None);
}
