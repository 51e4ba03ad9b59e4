//! Damaged saved tables: refused, or a table that goes on or says why not.

use masse::physics::ball::Ball;
use masse::physics::cue::Shot;
use masse::physics::laws::Laws;
use masse::physics::scene::{PlannedShot, Rack, Scene, Solver, Stepped};
use masse::physics::table::Preset;
use masse::sim::saved::{SavedTable, restore, save};
use masse::sim::stepping::{headless_app, step};

use super::attack;
use super::texts::{damage, damaged};

fn saved(solver: Solver) -> String {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    Rack::NineBall.place(&mut scene, Ball::POOL, 0.0, 7);
    let shot = Shot {
        speed: 7.0,
        heading: 0.003,
        ..Shot::default()
    };
    scene.shot = Some(PlannedShot { ball: 0, shot });
    scene.solver = solver;
    let mut app = headless_app(&scene);
    step(&mut app, 60);
    serde_json::to_string(&save(app.world_mut())).expect("everything in it is finite")
}

#[test]
fn damaged_saved_tables_are_refused_or_go_on() {
    for solver in [Solver::Exact, Solver::Stepped(Stepped::default())] {
        let text = saved(solver);
        attack(150, &damage(), |damages| {
            let Ok(saved) = serde_json::from_str::<SavedTable>(&damaged(&text, &damages)) else {
                return Ok(());
            };
            let mut app = headless_app(&Scene::new(Preset::EightFoot.table(), Laws::default()));
            if restore(app.world_mut(), &saved).is_ok() {
                step(&mut app, 5);
            }
            Ok(())
        });
    }
}
