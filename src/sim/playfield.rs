//! What surrounds the balls: the table, the laws, the cue; and how a scene gets into the world and out of it.

use bevy::prelude::*;

use crate::physics::cue::Cue;
use crate::physics::laws::Laws;
use crate::physics::scene::{Scene, SceneBall, Solver};
use crate::physics::table::{Preset, Table};
use crate::sim::SimSystems;
use crate::sim::clock::Clock;
use crate::sim::components::{
    AngularVelocity, BallBundle, BallIndex, BallName, Mass, MotionKind, Position, Radius, Velocity,
    ball_and_state,
};
use crate::sim::messages::LoadScene;
use crate::sim::recorder::Recorder;

/// The table, its laws, the cue and the solver in use.
#[derive(Resource, Clone, Debug, PartialEq)]
pub struct Playfield {
    /// The table.
    pub table: Table,
    /// Which laws hold.
    pub laws: Laws,
    /// The cue.
    pub cue: Cue,
    /// Who advances the balls.
    pub solver: Solver,
}

impl Default for Playfield {
    fn default() -> Self {
        Self {
            table: Preset::NineFoot.table(),
            laws: Laws::default(),
            cue: Cue::default(),
            solver: Solver::default(),
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Playfield>().add_systems(
        FixedUpdate,
        load_scene
            .in_set(SimSystems::Strike)
            .before(super::clock::strike)
            .run_if(on_message::<LoadScene>),
    );
}

/// Lays out the newest scene asked for.
pub(super) fn load_scene(world: &mut World) {
    let newest = world.resource_mut::<Messages<LoadScene>>().drain().last();
    if let Some(LoadScene(scene)) = newest {
        lay_out(world, &scene);
    }
}

/// Replaces the balls, the table and the laws of a world by those of a scene, and plays its planned shot on the next
/// tick.
pub fn lay_out(world: &mut World, scene: &Scene) {
    let old: Vec<Entity> = world
        .query_filtered::<Entity, With<BallIndex>>()
        .iter(world)
        .collect();
    for entity in old {
        world.despawn(entity);
    }
    // Before the balls: whoever dresses them asks what they are part of.
    world.insert_resource(Playfield {
        table: scene.table.clone(),
        laws: scene.laws,
        cue: scene.cue,
        solver: scene.solver,
    });
    for (index, ball) in scene.balls.iter().enumerate() {
        let mut ball = ball.clone();
        ball.state = scene.laws.motion.classify(&ball.ball, ball.state);
        let mut entity = world.spawn(BallBundle::new(index, &ball));
        if ball.ball.spins {
            entity.insert(AngularVelocity(ball.state.angular_velocity));
        }
    }
    world.insert_resource(Clock::new(&scene.solver));
    world.insert_resource(Recorder::start(scene));
    if let Some(planned) = scene.shot {
        world.write_message(crate::sim::messages::Strike {
            ball: planned.ball,
            shot: planned.shot,
        });
    }
}

/// The balls of the world as they are now, in scene order.
pub type BallQuery<'w, 's> = Query<
    'w,
    's,
    (
        &'static BallIndex,
        &'static BallName,
        &'static Position,
        &'static Velocity,
        Option<&'static AngularVelocity>,
        &'static Mass,
        &'static Radius,
        &'static MotionKind,
    ),
>;

/// The present table as a scene: what a preview, a saved game or a retry starts from.
#[must_use]
pub fn snapshot(playfield: &Playfield, balls: &BallQuery) -> Scene {
    let mut indexed: Vec<(usize, SceneBall)> = balls
        .iter()
        .map(
            |(index, name, position, velocity, spin, mass, radius, motion)| {
                let (ball, state) = ball_and_state(position, velocity, spin, mass, radius, motion);
                (
                    index.0,
                    SceneBall {
                        name: name.0.clone(),
                        ball,
                        state,
                    },
                )
            },
        )
        .collect();
    indexed.sort_by_key(|(index, _)| *index);
    Scene {
        cue: playfield.cue,
        balls: indexed.into_iter().map(|(_, ball)| ball).collect(),
        solver: playfield.solver,
        ..Scene::new(playfield.table.clone(), playfield.laws)
    }
}
