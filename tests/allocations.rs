//! The exact solver allocates nothing per event once it is warm. A binary of its own: the crate that counts puts itself
//! between the program and the allocator.

use std::hint::black_box;

use allocation_counter::measure;
use glam::DVec3;
use masse::physics::ball::Ball;
use masse::physics::cue::Shot;
use masse::physics::exact::{Engine, Limits};
use masse::physics::laws::Laws;
use masse::physics::scene::{PlannedShot, Rack, Scene, Solver};
use masse::physics::table::Preset;

/// What a closure allocates, in blocks, and how many events it answers for.
fn cost(run: impl FnOnce() -> u64) -> (u64, u64) {
    let mut events = 0;
    let info = measure(|| events = run());
    (info.count_total, events)
}

#[test]
fn the_counter_counts() {
    let (blocks, _) = cost(|| black_box(vec![0_u8; 100]).len() as u64);
    assert_eq!(blocks, 1);
}

#[test]
fn a_break_played_again_allocates_nothing() {
    for (rack, gap) in [
        (Rack::NineBall, 0.0),
        (Rack::EightBall, 0.0),
        (Rack::EightBall, 1e-4),
    ] {
        let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
        scene.solver = Solver::Exact;
        rack.place(&mut scene, Ball::POOL, gap, 3);
        let shot = Shot {
            heading: 0.004,
            side: 0.1,
            height: 0.1,
            speed: 7.0,
            ..Shot::default()
        };
        scene.shot = Some(PlannedShot { ball: 0, shot });
        let mut engine = Engine::new(&scene, Limits::default()).expect("a sound scene");
        let mut play = || {
            engine.reload(&scene).expect("a sound scene");
            engine
                .strike(0, &scene.cue, &shot, &mut ())
                .expect("a sound shot");
            engine
                .advance(f64::INFINITY, &mut ())
                .expect("a sound scene");
            engine.events()
        };
        play();
        let (blocks, events) = cost(play);
        assert!(events > 60, "{events} events");
        assert_eq!(blocks, 0, "{rack:?} {gap}: {events} events");
    }
}

#[test]
fn a_shot_of_a_search_played_and_judged_again_allocates_nothing() {
    let scenario = masse::scenarios::file::parse(
        r#"(table: NineFoot,
            balls: [(name: "cue", position: (-0.6, 0.1)), (name: "1", position: (0.2, 0.25))],
            shot: (ball: "cue", heading_deg: -10, speed: 3),
            expect: [Potted(ball: "1", pocket: "foot left"), Order([Hit("cue", "1"), Rail("1"), Falls("1")]),
                Near(ball: "cue", at: Position(-0.5, -0.3), within: 0.05), Stays(ball: "cue"),
                Gap(ball: "cue", of: "1", least: 1), Time(of: Falls("1"), least: 1),
                Advances(ball: "cue", from: Rail("cue", 9), most: 0)])"#,
        "test",
    )
    .expect("a sound scene");
    let mut player = masse::scenarios::search::Player::default();
    let mut play = || {
        let record = player.play(&scenario.scene).expect("a sound shot");
        let missed = masse::scenarios::expect::miss(&scenario.scene, record, &scenario.expect);
        assert!(missed > 0.0);
        record.events.len() as u64
    };
    play();
    let (blocks, events) = cost(play);
    assert!(events > 5, "{events} events");
    assert_eq!(blocks, 0, "{events} events");
}

#[test]
fn a_gas_found_by_cells_allocates_nothing() {
    for laws in [Laws::ideal(), Laws::default()] {
        let count = 400_u32;
        let ball = Ball {
            spins: laws != Laws::ideal(),
            ..Ball::POOL
        };
        let side = 20.0 * 0.075;
        let table = Preset::Box {
            length: side,
            width: side,
        };
        let mut scene = Scene::new(table.table(), laws);
        scene.solver = Solver::Exact;
        for i in 0..count {
            let place = |k: u32| (f64::from(k) + 0.5) * 0.075 - 0.5 * side;
            let index = scene.place(&i.to_string(), ball, place(i % 20), place(i / 20));
            let angle = f64::from(i) * 2.399_963;
            scene.balls[index].state.velocity =
                3.0 * DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
        }
        let mut engine = Engine::new(&scene, Limits::default()).expect("a sound scene");
        engine.advance(0.3, &mut ()).expect("a sound scene");
        let before = engine.events();
        let (blocks, events) = cost(|| {
            engine.advance(0.8, &mut ()).expect("a sound scene");
            engine.events() - before
        });
        assert!(events > 2000, "{events} events");
        assert_eq!(blocks, 0, "{events} events");
    }
}
