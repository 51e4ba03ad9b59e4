//! Saving the table, in the middle of a shot too, and going on from there with the same bits.

use bevy::prelude::*;
use serde::{Deserialize, Serialize};

use crate::physics::ball::State;
use crate::physics::exact::{Engine, Limits, Saved, SolveError};
use crate::physics::laws::cluster::Other;
use crate::physics::record::{Event, PathPiece};
use crate::physics::scene::{Scene, Solver};
use crate::sim::clock::Clock;
use crate::sim::components::{AngularVelocity, BallIndex, MotionKind, Position, Velocity};
use crate::sim::exact::LiveEngine;
use crate::sim::playfield::{BallQuery, Playfield, lay_out, snapshot};
use crate::sim::recorder::Recorder;
use crate::sim::stepped::Bodies;

/// A table as it is, to be written to a file: balls in motion, the clock, the solver's plans, and what the shot has done so
/// far. A stroke that was asked for and not yet played is not in it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SavedTable {
    scene: Scene,
    ticks: u64,
    moving: bool,
    engine: Option<Saved>,
    events: Vec<Event>,
    /// When each piece of each path began, and how: the motion law tells the rest.
    paths: Vec<Vec<(f64, State)>>,
    trails: Vec<Vec<(f64, State)>>,
    before: Option<Scene>,
    /// What each ball has touched lately, where the stepped solver knows.
    #[serde(default)]
    touched: Vec<Vec<(Other, f64)>>,
}

impl SavedTable {
    /// The table with its balls as they were when it was saved.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Every ball that is told of is there, and the solver is one for these laws.
    fn check_balls(&self) -> Result<(), SolveError> {
        let count = self.scene.balls.len();
        let lists = [self.paths.len(), self.trails.len()];
        let crowd = self.scene.solver.is_crowd();
        let other = lists.into_iter().find(|length| !crowd && *length != count);
        let balls = |event: &Event| event.participants().map(|one| one.ball).max();
        let touched = self.touched.iter().flatten();
        let met = |(what, _): &(Other, f64)| match what {
            Other::Ball(ball) => Some(*ball as usize),
            Other::Cushion(_) | Other::Rim(_) | Other::Wall(_) => None,
        };
        let told = self.events.iter().filter_map(balls);
        let told = told.chain(touched.clone().filter_map(met)).max();
        if let Some(ball) = other.or(told.filter(|ball| *ball >= count)) {
            return Err(SolveError::NoSuchBall { ball, count });
        }
        if self.scene.solver == Solver::Exact && !self.scene.laws.motion.is_closed_form() {
            return Err(SolveError::NotClosedForm);
        }
        Ok(())
    }
}

/// The table of a world as it is.
///
/// # Panics
/// If the world has no [`SimPlugin`](crate::sim::SimPlugin).
pub fn save(world: &mut World) -> SavedTable {
    let scene = world
        .run_system_cached(|playfield: Res<Playfield>, balls: BallQuery| {
            snapshot(&playfield, &balls)
        })
        .expect("both parameters exist in every world with SimPlugin");
    let (clock, recorder) = (world.resource::<Clock>(), world.resource::<Recorder>());
    let starts = |path: &Vec<PathPiece>| {
        path.iter()
            .map(|piece| (piece.time, piece.piece.start))
            .collect()
    };
    SavedTable {
        scene,
        ticks: clock.ticks,
        moving: clock.moving,
        engine: world.resource::<LiveEngine>().0.as_ref().map(Engine::save),
        events: recorder.events.clone(),
        paths: recorder.paths.iter().map(starts).collect(),
        trails: recorder.trails.clone(),
        before: recorder.before.clone(),
        touched: world.resource::<Bodies>().memory(),
    }
}

/// Lays a saved table out in place of the present one. It goes on as if it had never been saved, to the last bit.
///
/// # Errors
/// [`SolveError`] if what was saved does not fit together; the world is then as before.
pub fn restore(world: &mut World, saved: &SavedTable) -> Result<(), SolveError> {
    let SavedTable { scene, engine, .. } = saved;
    scene.check_numbers()?;
    saved.check_balls()?;
    let restored = |engine| Engine::restore(scene, engine, Limits::default());
    let engine = engine.as_ref().map(restored).transpose()?;
    lay_out(world, scene);
    let mut balls = world.query::<(
        &BallIndex,
        &mut Position,
        &mut Velocity,
        Option<&mut AngularVelocity>,
        &mut MotionKind,
    )>();
    // A table is laid out with its states freed of rounding; these had their rounding already.
    for (index, mut position, mut velocity, spin, mut motion) in balls.iter_mut(world) {
        let Some(ball) = scene.balls.get(index.0) else {
            continue;
        };
        position.0 = ball.state.position;
        velocity.0 = ball.state.velocity;
        motion.0 = ball.state.motion;
        if let Some(mut spin) = spin {
            spin.0 = ball.state.angular_velocity;
        }
    }
    world.resource_mut::<Bodies>().remember(&saved.touched);
    world.insert_resource(LiveEngine(engine));
    world.insert_resource(Clock {
        ticks: saved.ticks,
        moving: saved.moving,
        ..Clock::new(&scene.solver)
    });
    let path = |(ball, starts): (usize, &Vec<(f64, State)>)| -> Vec<PathPiece> {
        let Some(body) = scene.balls.get(ball) else {
            return Vec::new();
        };
        let piece = |&(time, start): &(f64, State)| PathPiece {
            time,
            piece: scene.laws.piece(&scene.table, &body.ball, &start),
        };
        starts.iter().map(piece).collect()
    };
    world.insert_resource(Recorder {
        events: saved.events.clone(),
        paths: saved.paths.iter().enumerate().map(path).collect(),
        trails: saved.trails.clone(),
        before: saved.before.clone(),
    });
    Ok(())
}
