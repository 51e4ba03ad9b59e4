//! Practice on an open table, without a window: retry, undo, racks, balls placed by hand.

use bevy::prelude::*;
use masse::game::GamePlugin;
use masse::game::aim::Aim;
use masse::game::practice::{self, Practice, PracticeCommand};
use masse::game::{placing, target};
use masse::physics::ball::{Ball, Motion};
use masse::physics::laws::Laws;
use masse::physics::scene::{Rack, Scene};
use masse::physics::table::{Arc, Cushion, Line, Preset};
use masse::sim::SimPlugin;
use masse::sim::clock::Clock;
use masse::sim::messages::{LoadScene, Strike};
use masse::sim::playfield::lay_out;
use masse::sim::stepping;

/// A table with this scene and a player at it.
fn app(scene: &Scene) -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, SimPlugin, GamePlugin));
    app.finish();
    app.cleanup();
    lay_out(app.world_mut(), scene);
    // The first update has no fixed tick: it runs what happens at the start.
    app.update();
    stepping::step(&mut app, 2);
    app
}

fn ask(app: &mut App, command: PracticeCommand) {
    app.world_mut().write_message(command);
    stepping::step(app, 2);
}

/// Strikes as aimed and waits until everything rests.
fn strike(app: &mut App) {
    let aim = *app.world().resource::<Aim>();
    app.world_mut().write_message(Strike {
        ball: aim.ball,
        shot: aim.shot,
    });
    stepping::step(app, 1);
    for _ in 0..120 * 60 {
        if !app.world().resource::<Clock>().moving {
            return;
        }
        stepping::step(app, 1);
    }
    panic!("balls still move after a minute");
}

fn aim(app: &mut App) -> Mut<'_, Aim> {
    app.world_mut().resource_mut::<Aim>()
}

fn same_places(a: &Scene, b: &Scene) -> bool {
    a.balls.len() == b.balls.len()
        && a.balls
            .iter()
            .zip(&b.balls)
            .all(|(a, b)| a.name == b.name && a.state == b.state)
}

/// A cue ball at the head spot and one object ball at x, z.
fn two_balls(x: f64, z: f64) -> Scene {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    let head = scene.table.head_spot();
    scene.place("cue", Ball::POOL, head.x, head.y);
    scene.place("1", Ball::POOL, x, z);
    scene
}

#[test]
fn the_opening_is_ready_to_play() {
    let mut app = app(&practice::opening());
    let scene = stepping::scene(&mut app);
    assert_eq!(scene.balls.len(), 16);
    assert_eq!(scene.check(), Ok(()));
    let aim = *app.world().resource::<Aim>();
    assert_eq!(scene.balls[aim.ball].name, "cue");
    // The apex of the rack lies on the long axis, straight ahead of the cue ball.
    assert_eq!(aim.shot.heading, 0.0);
    assert_eq!(aim.shot.speed, practice::BREAK_SPEED);
}

#[test]
fn a_world_without_balls_is_racked() {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, SimPlugin, GamePlugin));
    app.finish();
    app.cleanup();
    app.update();
    stepping::step(&mut app, 2);
    assert_eq!(stepping::scene(&mut app).balls.len(), 16);
}

#[test]
fn retry_brings_back_table_and_aim_and_ends_in_the_same_bits() {
    let mut app = app(&practice::opening());
    aim(&mut app).turn_deg(0.321);
    let before = stepping::scene(&mut app);
    let shot = app.world().resource::<Aim>().shot;
    strike(&mut app);
    let first = stepping::scene(&mut app);
    assert!(!same_places(&before, &first));
    // Going back works in the middle of the next shot, and more than once.
    for _ in 0..2 {
        aim(&mut app).turn_deg(33.0);
        ask(&mut app, PracticeCommand::Retry);
        assert!(same_places(&before, &stepping::scene(&mut app)));
        assert_eq!(app.world().resource::<Aim>().shot, shot);
    }
    strike(&mut app);
    assert!(same_places(&first, &stepping::scene(&mut app)));
}

#[test]
fn retry_stops_a_shot_that_still_runs() {
    let mut app = app(&practice::opening());
    let before = stepping::scene(&mut app);
    let aim = *app.world().resource::<Aim>();
    app.world_mut().write_message(Strike {
        ball: aim.ball,
        shot: aim.shot,
    });
    stepping::step(&mut app, 60);
    assert!(app.world().resource::<Clock>().moving);
    ask(&mut app, PracticeCommand::Retry);
    assert!(!app.world().resource::<Clock>().moving);
    assert!(same_places(&before, &stepping::scene(&mut app)));
}

#[test]
fn undo_goes_back_over_shots_racks_and_placed_balls() {
    let mut app = app(&practice::opening());
    let mut tables = vec![stepping::scene(&mut app)];
    strike(&mut app);
    tables.push(stepping::scene(&mut app));
    aim(&mut app).turn_deg(100.0);
    strike(&mut app);
    tables.push(stepping::scene(&mut app));
    ask(&mut app, PracticeCommand::Rack(Rack::NineBall));
    tables.push(stepping::scene(&mut app));
    assert_eq!(tables[3].balls.len(), 10);
    // One drag is many small moves, and one step back.
    for i in 1..=10 {
        ask(
            &mut app,
            PracticeCommand::PlaceBall {
                ball: 0,
                x: -0.6 - 0.01 * f64::from(i),
                z: 0.2,
            },
        );
    }
    assert!(!same_places(&tables[3], &stepping::scene(&mut app)));
    while let Some(table) = tables.pop() {
        ask(&mut app, PracticeCommand::Undo);
        assert!(same_places(&table, &stepping::scene(&mut app)));
    }
    assert!(app.world().resource::<Practice>().history.is_empty());
    // Nothing left: the table stays.
    let last = stepping::scene(&mut app);
    ask(&mut app, PracticeCommand::Undo);
    assert!(same_places(&last, &stepping::scene(&mut app)));
}

#[test]
fn laws_chosen_meanwhile_survive_going_back() {
    let mut app = app(&practice::opening());
    strike(&mut app);
    app.world_mut()
        .resource_mut::<masse::sim::playfield::Playfield>()
        .laws = Laws::coursework();
    ask(&mut app, PracticeCommand::Retry);
    assert_eq!(stepping::scene(&mut app).laws, Laws::coursework());
}

#[test]
fn a_pocketed_cue_ball_comes_back_to_the_head_spot() {
    // Straight into the corner: from the middle of the head half, along the line to the pocket.
    let mut scene = two_balls(0.9, 0.3);
    scene.balls[0].state.position.x = -0.9;
    scene.balls[0].state.position.z = 0.3;
    let pocket = scene
        .table
        .pockets
        .iter()
        .min_by(|a, b| (a.center.x - a.center.y).total_cmp(&(b.center.x - b.center.y)))
        .expect("a pool table has pockets")
        .center;
    let mut app = app(&scene);
    let from = scene.balls[0].state.position;
    let to = bevy::math::DVec3::new(pocket.x, from.y, pocket.y);
    aim(&mut app).set_heading(masse::physics::cue::Shot::heading_between(from, to));
    aim(&mut app).set_speed(1.5);
    strike(&mut app);
    let after = stepping::scene(&mut app);
    assert_eq!(after.balls[0].state.motion, Motion::Rest);
    let head = after.table.head_spot();
    let spot = after.balls[0].state.position;
    assert_eq!((spot.x, spot.z), (head.x, head.y));
    assert_eq!(after.check(), Ok(()));
    // And it can be played on.
    strike(&mut app);
}

#[test]
fn the_cue_points_at_the_next_ball_unless_the_player_has_aimed() {
    let mut app = app(&two_balls(0.3, 0.4));
    let aimed = app.world().resource::<Aim>().shot.heading;
    aim(&mut app).set_speed(1.0);
    strike(&mut app);
    let scene = stepping::scene(&mut app);
    let expected = target::heading(&scene, 0, Rack::EightBall).expect("two balls in play");
    assert_ne!(aimed, expected);
    assert_eq!(app.world().resource::<Aim>().shot.heading, expected);

    let shot = *app.world().resource::<Aim>();
    app.world_mut().write_message(Strike {
        ball: shot.ball,
        shot: shot.shot,
    });
    stepping::step(&mut app, 3);
    aim(&mut app).turn_deg(7.0);
    let chosen = app.world().resource::<Aim>().shot.heading;
    while app.world().resource::<Clock>().moving {
        stepping::step(&mut app, 1);
    }
    assert_eq!(app.world().resource::<Aim>().shot.heading, chosen);
}

#[test]
fn in_nine_ball_the_lowest_number_is_next() {
    let mut scene = two_balls(0.9, 0.5);
    scene.place("5", Ball::POOL, -0.5, 0.0);
    let lowest = target::heading(&scene, 0, Rack::NineBall);
    let nearest = target::heading(&scene, 0, Rack::EightBall);
    assert_eq!(nearest, Some(0.0));
    assert!(lowest.is_some_and(|heading| heading < 0.0));
}

#[test]
fn balls_cannot_be_placed_while_others_move() {
    let mut app = app(&two_balls(0.3, 0.0));
    let aim = *app.world().resource::<Aim>();
    app.world_mut().write_message(Strike {
        ball: aim.ball,
        shot: aim.shot,
    });
    stepping::step(&mut app, 5);
    ask(
        &mut app,
        PracticeCommand::PlaceBall {
            ball: 1,
            x: -1.0,
            z: 0.5,
        },
    );
    assert!(stepping::scene(&mut app).balls[1].state.position.x > 0.2);
}

#[test]
fn a_placed_ball_never_overlaps_and_lands_as_near_as_it_can() {
    let mut scene = practice::opening();
    scene.table.cushions.push(Cushion::Arc(Arc {
        center: bevy::math::DVec2::new(-0.2, 0.2),
        radius: 0.05,
    }));
    scene.table.cushions.push(Cushion::Line(Line {
        from: bevy::math::DVec2::new(-0.4, -0.5),
        to: bevy::math::DVec2::new(-0.1, -0.2),
    }));
    // A grid of wishes over the whole table and beyond it.
    for i in -30..=30_i32 {
        for j in -16..=16_i32 {
            let wish = bevy::math::DVec2::new(0.05 * f64::from(i), 0.05 * f64::from(j));
            let spot = placing::nearest_free(&scene, 0, wish).expect("the table is nearly empty");
            assert!(placing::is_free(&scene, 0, spot));
            let mut placed = scene.clone();
            assert!(placing::place(&mut placed, 0, wish));
            assert_eq!(placed.check(), Ok(()));
            if placing::is_free(&scene, 0, wish) {
                assert_eq!(spot, wish);
            }
            // No spot tried by brute force around the wish is nearer.
            let distance = spot.distance(wish);
            for k in 0..72_i32 {
                let angle = f64::from(k) * 5.0_f64.to_radians();
                for share in [0.25, 0.5, 0.75, 0.98] {
                    let way = bevy::math::DVec2::new(libm::cos(angle), libm::sin(angle));
                    let other = wish + share * distance * way;
                    // Spots nearer than the clearance left on purpose do not count.
                    assert!(
                        distance < 1e-4 || !placing::is_free(&scene, 0, other),
                        "wish {wish}, spot {spot}, but {other} is free"
                    );
                }
            }
        }
    }
    assert_eq!(
        placing::nearest_free(&scene, 0, bevy::math::DVec2::new(f64::NAN, 0.0)),
        None
    );
}

#[test]
fn a_scene_laid_out_by_others_brings_its_own_shot() {
    let mut app = app(&practice::opening());
    let mut scene = two_balls(0.1, 0.1);
    scene.balls.swap(0, 1);
    app.world_mut().write_message(LoadScene(scene));
    stepping::step(&mut app, 2);
    assert_eq!(app.world().resource::<Aim>().ball, 1);
}

#[test]
fn the_finest_step_of_the_aim_is_kept() {
    let mut aim = Aim::default();
    for _ in 0..90_000 {
        aim.turn_deg(0.001);
    }
    assert!((aim.heading_deg() - 90.0).abs() < 1e-9);
}
