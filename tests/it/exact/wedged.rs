//! Balls that nothing lets move come to rest off the slate, and go on when they are dislodged.

use glam::DVec3;

use masse::physics::ball::{Ball, Motion, State};
use masse::physics::cue::Shot;
use masse::physics::exact::{Engine, Limits, Saved};
use masse::physics::laws::Laws;
use masse::physics::laws::pocket::{PocketLaw, Rim};
use masse::physics::scene::{Scene, SceneBall, Solver, Stepped};
use masse::physics::table::Preset;
use masse::report::audit::Audit;
use masse::scenarios::file::{self, Scenario};
use masse::sim::stepping;

/// Two balls that come to rest in a corner pocket.
fn jammed() -> Scene {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/hard");
    let path = folder.join("jammed-in-a-pocket.ron");
    file::read(&path)
        .unwrap_or_else(|error| panic!("{error}"))
        .scene
}

fn engine(scene: &Scene) -> Engine {
    Engine::new(scene, Limits::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// The same balls where and as they are at the end.
fn at_rest() -> Scene {
    let mut scene = jammed();
    let mut engine = engine(&scene);
    engine.advance(scene.time_limit, &mut ()).expect("it ends");
    assert!(engine.is_at_rest(), "{:?}", engine.state(0));
    for ball in 0..2 {
        scene.balls[ball].state = engine.state(ball);
    }
    scene
}

#[test]
fn balls_jammed_in_a_pocket_come_to_rest() {
    let scene = jammed();
    let mut engine = engine(&scene);
    let mut audit = Audit::new(&scene);
    engine
        .advance(scene.time_limit, &mut audit)
        .expect("it ends");
    for ball in 0..2 {
        let state = engine.state(ball);
        assert_eq!(state.motion, Motion::Wedged);
        assert_eq!(state.velocity, DVec3::ZERO);
    }
    assert_eq!(engine.next_time(), None);
    assert!(audit.worst().energy <= 0.0, "{:?}", audit.worst());
}

/// Whatever the solver, what is wedged stays where it is, through a file too, until something comes.
#[test]
fn wedged_balls_stay() {
    let scene = at_rest();
    let text = file::write(&Scenario::plain("wedged", "", scene.clone())).expect("text");
    let mut again = file::parse(&text, "wedged.ron")
        .unwrap_or_else(|error| panic!("{error}"))
        .scene;
    assert_eq!(again.balls, scene.balls);
    for solver in [Solver::Exact, Solver::Stepped(Stepped::default())] {
        again.solver = solver;
        let (record, _) = stepping::try_run_to_rest(&again).expect("nothing happens");
        assert!(record.events.is_empty(), "{:?}", record.events);
        for (end, ball) in record.end.iter().zip(&scene.balls) {
            assert_eq!(*end, ball.state);
        }
    }
    let mut engine = engine(&scene);
    let saved = engine.save();
    engine.advance(1.0, &mut ()).expect("nothing happens");
    assert!(engine.is_at_rest());
    let text = serde_json::to_string(&saved).expect("plain data");
    let saved: Saved = serde_json::from_str(&text).expect("the same");
    let restored = Engine::restore(&scene, &saved, Limits::default()).expect("of this scene");
    assert!(restored.is_at_rest());
}

/// A ball that comes down on them at some speed, by either solver.
#[test]
fn a_blow_dislodges_wedged_balls() {
    let mut scene = at_rest();
    let below = scene.balls[0].state.position;
    let mut state = State::at_rest(below + DVec3::new(0.02, 0.12, 0.02));
    state.velocity = DVec3::new(0.0, -3.0, 0.0);
    state.motion = Motion::Airborne;
    scene.balls.push(SceneBall {
        name: "hammer".into(),
        ball: Ball::POOL,
        state,
    });
    scene.time_limit = 0.2;
    for solver in [Solver::Exact, Solver::Stepped(Stepped::default())] {
        scene.solver = solver;
        let (record, _) = stepping::try_run_to_rest(&scene).expect("a sound scene");
        let dislodged = record.paths[0]
            .iter()
            .any(|path| path.piece.start.motion == Motion::Airborne);
        assert!(dislodged, "{:?}", record.events);
        let worst = Audit::of(&scene, &record);
        assert!(worst.energy <= 1e-12 && worst.overlap <= 1e-9, "{worst:?}");
    }
}

/// What is said to be wedged and is not falls; so does what a ball bore that is taken away.
#[test]
fn what_nothing_holds_falls() {
    let laws = Laws {
        pocket: PocketLaw::Rim(Rim::default()),
        ..Laws::default()
    };
    let mut aloft = Scene::new(Preset::NineFoot.table(), laws);
    aloft.place("1", Ball::POOL, 0.2, 0.1);
    let mut alone = at_rest();
    alone.balls.remove(0);
    for scene in [&mut aloft, &mut alone] {
        scene.balls[0].state.motion = Motion::Wedged;
        if scene.balls[0].state.position.y == Ball::POOL.radius {
            scene.balls[0].state.position.y = 0.3;
        }
        let height = scene.balls[0].state.position.y;
        for solver in [Solver::Exact, Solver::Stepped(Stepped::default())] {
            scene.solver = solver;
            let (record, _) = stepping::try_run_to_rest(scene).expect("a sound scene");
            assert!(record.end[0].position.y < height - 1e-3, "{:?}", record.end);
        }
    }
}

#[test]
fn a_wedged_ball_can_be_struck() {
    let scene = at_rest();
    let mut engine = engine(&scene);
    let shot = Shot {
        speed: 2.0,
        ..Shot::default()
    };
    let mut audit = Audit::new(&scene);
    engine
        .strike(1, &scene.cue, &shot, &mut audit)
        .expect("a sound shot");
    assert_eq!(engine.state(1).motion, Motion::Airborne);
    engine.advance(2.0, &mut audit).expect("it ends");
    assert!(audit.worst().energy <= 1e-12, "{:?}", audit.worst());
}
