//! Balls that are entities of somebody else: spawned, pushed and despawned beside the simulation.

use bevy::prelude::*;
use glam::DVec3;
use masse::physics::ball::{Ball, Motion, State};
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::scene::{Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::sim::SimPlugin;
use masse::sim::clock::Clock;
use masse::sim::components::{
    AngularVelocity, BallIndex, BallName, Mass, MotionKind, Position, Radius, Velocity,
};
use masse::sim::messages::{AtRest, Failed, Restart};
use masse::sim::playfield::Playfield;
use masse::sim::recorder::Recorder;
use masse::sim::stepped::crowd::Census;
use masse::sim::stepping::{scene, states, step};

const R: f64 = Ball::POOL.radius;

/// An app without balls.
fn empty(laws: Laws, solver: Solver) -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, SimPlugin));
    app.insert_resource(Playfield {
        table: Preset::NineFoot.table(),
        laws,
        solver,
        ..Playfield::default()
    });
    app.finish();
    app.cleanup();
    app
}

fn spawn(app: &mut App, (x, z): (f64, f64), (v_x, v_z): (f64, f64)) -> Entity {
    let ball = (
        Position(DVec3::new(x, R, z)),
        Velocity(DVec3::new(v_x, 0.0, v_z)),
        AngularVelocity::default(),
        Mass(Ball::POOL.mass),
        Radius(R),
    );
    app.world_mut().spawn(ball).id()
}

/// The same as a scene.
fn as_scene(laws: Laws, solver: Solver, balls: &[((f64, f64), (f64, f64))]) -> Scene {
    let mut scene = Scene::new(Preset::NineFoot.table(), laws);
    scene.solver = solver;
    for (i, ((x, z), (v_x, v_z))) in balls.iter().enumerate() {
        scene.place(&i.to_string(), Ball::POOL, *x, *z);
        scene.balls[i].state.velocity = DVec3::new(*v_x, 0.0, *v_z);
    }
    scene
}

const BALLS: [((f64, f64), (f64, f64)); 3] = [
    ((-0.6, 0.1), (2.0, 0.1)),
    ((0.2, 0.12), (0.0, 0.0)),
    ((0.7, -0.3), (-0.5, 0.4)),
];

#[test]
fn spawned_balls_do_what_the_scene_does_to_the_last_bit() {
    for solver in [Solver::Exact, Solver::Stepped(Stepped::default())] {
        let mut app = empty(Laws::default(), solver);
        // Nothing is there yet: the clock stands, and goes when there is something.
        step(&mut app, 3);
        for (place, velocity) in BALLS {
            spawn(&mut app, place, velocity);
        }
        step(&mut app, 200);
        let own = states(&mut app);
        let mut other =
            masse::sim::stepping::headless_app(&as_scene(Laws::default(), solver, &BALLS));
        step(&mut other, 200);
        assert_eq!(own, states(&mut other));
        let events = |app: &App| app.world().resource::<Recorder>().events.clone();
        assert!(!events(&app).is_empty());
        assert_eq!(events(&app), events(&other));
        let clock = app.world().resource::<Clock>();
        assert_eq!((clock.ticks, clock.moving), (200, true));
    }
}

/// What the record says of a shot is what the exact solver says on paper.
#[test]
fn a_ball_with_nothing_but_a_position_is_a_pool_ball_without_spin() {
    let mut app = empty(Laws::default(), Solver::Exact);
    let ball = app
        .world_mut()
        .spawn(Position(DVec3::new(0.0, R, 0.0)))
        .id();
    step(&mut app, 1);
    let entity = app.world().entity(ball);
    assert_eq!(entity.get::<Mass>(), Some(&Mass(Ball::POOL.mass)));
    assert_eq!(entity.get::<Radius>(), Some(&Radius(R)));
    assert_eq!(entity.get::<BallIndex>(), Some(&BallIndex(0)));
    assert_eq!(entity.get::<BallName>(), Some(&BallName("0".to_owned())));
    assert_eq!(entity.get::<MotionKind>(), Some(&MotionKind(Motion::Rest)));
    assert!(entity.get::<AngularVelocity>().is_none());
}

#[test]
fn a_ball_that_is_pushed_goes_on_from_where_it_is() {
    let mut app = empty(Laws::default(), Solver::Exact);
    let ball = spawn(&mut app, (0.0, 0.0), (0.5, 0.0));
    let mut rests = 0;
    for _ in 0..2000 {
        step(&mut app, 1);
        rests += app
            .world_mut()
            .resource_mut::<Messages<AtRest>>()
            .drain()
            .count();
    }
    assert_eq!(rests, 1);
    let at = app.world().get::<Position>(ball).expect("a ball").0;
    assert!(at.x > 0.1);
    let push = DVec3::new(0.0, 0.0, 0.7);
    app.world_mut().get_mut::<Velocity>(ball).expect("a ball").0 = push;
    // Nobody has said so yet: the table stands still.
    step(&mut app, 5);
    assert_eq!(app.world().get::<Position>(ball).expect("a ball").0, at);
    app.world_mut().write_message(Restart);
    step(&mut app, 60);
    let mut pushed = Scene::new(Preset::NineFoot.table(), Laws::default());
    pushed.place("0", Ball::POOL, at.x, at.z);
    pushed.balls[0].state = State {
        velocity: push,
        ..State::at_rest(at)
    };
    let record = solve(&pushed, Limits::default()).expect("it can be played");
    assert_eq!(states(&mut app)[0], record.state_at(0, 60.0 * Clock::FRAME));
}

#[test]
fn a_ball_that_is_despawned_leaves_no_gap() {
    for solver in [Solver::Exact, Solver::Stepped(Stepped::default())] {
        let mut app = empty(Laws::default(), solver);
        let entities = BALLS.map(|(place, velocity)| spawn(&mut app, place, velocity));
        step(&mut app, 30);
        let before = states(&mut app);
        app.world_mut().despawn(entities[1]);
        step(&mut app, 1);
        let after = scene(&mut app);
        let names: Vec<&str> = after.balls.iter().map(|ball| ball.name.as_str()).collect();
        assert_eq!(names, ["0", "2"]);
        assert_eq!(
            app.world().get::<BallIndex>(entities[2]),
            Some(&BallIndex(1))
        );
        // The other two go on from where they were, past the place of the third.
        step(&mut app, 59);
        let mut rest = as_scene(Laws::default(), solver, &[BALLS[0], BALLS[2]]);
        (rest.balls[0].state, rest.balls[1].state) = (before[0], before[2]);
        let mut other = masse::sim::stepping::headless_app(&rest);
        step(&mut other, 60);
        assert_eq!(states(&mut app), states(&mut other));
        // And a new one has the name that is free.
        spawn(&mut app, (0.0, -0.5), (0.0, 0.0));
        step(&mut app, 1);
        let names: Vec<String> = scene(&mut app)
            .balls
            .into_iter()
            .map(|ball| ball.name)
            .collect();
        assert_eq!(names, ["0", "2", "1"]);
    }
}

#[test]
fn balls_that_cannot_be_played_are_told_of_and_nothing_moves() {
    for (place, word) in [((0.01, 0.0), "overlap"), ((5.0, 0.0), "balls")] {
        let mut app = empty(Laws::default(), Solver::Exact);
        spawn(&mut app, (0.0, 0.0), (1.0, 0.0));
        spawn(&mut app, place, (0.0, 0.0));
        step(&mut app, 1);
        let failed: Vec<Failed> = app
            .world_mut()
            .resource_mut::<Messages<Failed>>()
            .drain()
            .collect();
        assert_eq!(failed.len(), 1);
        assert!(failed[0].reason.contains(word), "{}", failed[0].reason);
        step(&mut app, 10);
        assert_eq!(states(&mut app)[0].position.x, 0.0);
    }
}

#[test]
fn a_crowd_takes_new_balls_in() {
    let crowd = Solver::Stepped(Stepped {
        grid: None,
        crowd: true,
        ..Stepped::default()
    });
    let mut app = empty(Laws::ideal(), crowd);
    app.insert_resource(Playfield {
        table: Preset::Box {
            length: 2.0,
            width: 1.0,
        }
        .table(),
        laws: Laws::ideal(),
        solver: crowd,
        ..Playfield::default()
    });
    for i in 0..20 {
        let x = 0.09 * f64::from(i) - 0.9;
        spawn(
            &mut app,
            (x, 0.0),
            (0.3, if i % 2 == 0 { 0.5 } else { -0.5 }),
        );
    }
    step(&mut app, 60);
    assert_eq!(app.world().resource::<Census>().balls, 20);
    spawn(&mut app, (0.0, 0.47 - R), (0.0, 0.0));
    let energy = |app: &mut App| -> f64 {
        let balls = scene(app).balls;
        balls.iter().map(|b| b.ball.kinetic_energy(&b.state)).sum()
    };
    let before = energy(&mut app);
    step(&mut app, 60);
    assert_eq!(app.world().resource::<Census>().balls, 21);
    let after = energy(&mut app);
    assert!((after / before - 1.0).abs() < 1e-12, "{before} {after}");
}
