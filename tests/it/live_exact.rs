//! The exact solver on the live table does what it does on paper, to the last bit.

use masse::physics::ball::Ball;
use masse::physics::cue::Shot;
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::scene::{PlannedShot, Rack, Scene, Solver};
use masse::physics::table::Preset;
use masse::sim::stepping::run_to_rest;

fn shot(rack: bool) -> Scene {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    if rack {
        Rack::EightBall.place(&mut scene, Ball::POOL, 0.0, 3);
    } else {
        scene.place("cue", Ball::POOL, -0.7, 0.1);
        scene.place("1", Ball::POOL, 0.3, 0.12);
        scene.place("2", Ball::POOL, 0.9, -0.3);
    }
    scene.shot = Some(PlannedShot {
        ball: 0,
        shot: Shot {
            heading: 0.02,
            elevation: 0.1,
            side: 0.25,
            height: -0.2,
            speed: 6.0,
        },
    });
    scene
}

#[test]
fn the_live_table_repeats_the_solver_bit_for_bit() {
    for rack in [false, true] {
        let scene = shot(rack);
        assert_eq!(scene.solver, Solver::Exact);
        let solved = solve(&scene, Limits::default()).expect("the scene is playable");
        let (live, _) = run_to_rest(&scene);
        assert_eq!(solved.events.len(), live.events.len(), "rack: {rack}");
        for (on_paper, on_the_table) in solved.events.iter().zip(&live.events) {
            assert_eq!(on_paper.time, on_the_table.time);
        }
        assert_eq!(solved.end, live.end, "rack: {rack}");
        assert_eq!(solved.paths, live.paths, "rack: {rack}");
    }
}
