//! Tables racked for a break.

use crate::physics::equipment::{BallSet, Equipment};
use crate::physics::scene::{Rack, Scene, Solver};
use crate::physics::table::{Preset, Table};

/// What a scene is played with; pool balls if it has none.
#[must_use]
pub fn of_scene(scene: &Scene) -> Equipment {
    Equipment {
        table: scene.table.clone(),
        laws: scene.laws,
        cue: scene.cue,
        balls: BallSet::in_scene(scene).unwrap_or_default(),
    }
}

/// This table racked, with the laws, the cue, the solver and the kinds of balls of a scene.
#[must_use]
pub fn racked(like: &Scene, table: Table, rack: Rack, seed: u64) -> Scene {
    let equipment = Equipment {
        table,
        ..of_scene(like)
    };
    set_up(&equipment, like.solver, rack, seed)
}

/// A rack with this equipment.
#[must_use]
pub fn set_up(equipment: &Equipment, solver: Solver, rack: Rack, seed: u64) -> Scene {
    let mut scene = equipment.scene();
    if solver != Solver::Exact || scene.laws.motion.is_closed_form() {
        scene.solver = solver;
    }
    rack.place(&mut scene, equipment.balls.object, 0.0, seed);
    equipment.balls.exchange(&mut scene);
    scene
}

/// The same for somebody who wants to play on whatever it is that lies there: where no cushion holds the balls, or the
/// rack has no room, it is one of pool balls, and at last one on a pool table.
#[must_use]
pub fn playable(equipment: &Equipment, solver: Solver, rack: Rack, seed: u64) -> Scene {
    let pool = Equipment {
        balls: BallSet::default(),
        ..equipment.clone()
    };
    let on_pool_table = Equipment {
        table: Preset::NineFoot.table(),
        ..pool.clone()
    };
    [equipment, &pool]
        .map(|equipment| set_up(equipment, solver, rack, seed))
        .into_iter()
        .find(|scene| scene.check().is_ok())
        .unwrap_or_else(|| set_up(&on_pool_table, solver, rack, seed))
}
