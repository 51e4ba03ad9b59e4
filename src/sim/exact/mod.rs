//! The exact solver on the live table: the same components, the same messages as the stepped one.
//!
//! The engine with its queue lives from the first tick of a shot to the last. A tick only asks it to go on to a later
//! time, so the length of a tick, and with it the frame rate, cannot change a bit of what happens.

use bevy::prelude::*;

use crate::physics::exact::{Engine, Limits, SolveError, Watch};
use crate::physics::record::{Event, EventKind, PathPiece};
use crate::physics::scene::Solver;
use crate::sim::SimSystems;
use crate::sim::clock::Clock;
use crate::sim::components::{AngularVelocity, BallIndex, MotionKind, Position, Velocity};
use crate::sim::messages::{Failed, MotionChanged, PathTurned, Pocketed, Struck, Touched};
use crate::sim::playfield::{BallQuery, Playfield, snapshot};

/// The engine of the present shot.
#[derive(Resource, Clone, Debug, Default)]
pub struct LiveEngine(pub Option<Engine>);

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<LiveEngine>()
        .init_resource::<Heard>()
        .add_systems(
            FixedUpdate,
            (begin.run_if(shot_begins), advance, tell, write)
                .chain()
                .in_set(SimSystems::Advance)
                .after(super::stepped::advance)
                .run_if(is_exact.and_then(is_moving)),
        );
}

fn is_exact(playfield: Res<Playfield>) -> bool {
    playfield.solver == Solver::Exact
}

fn is_moving(clock: Res<Clock>) -> bool {
    clock.moving
}

fn shot_begins(clock: Res<Clock>) -> bool {
    clock.ticks == 0
}

/// What the engine said in this tick.
#[derive(Resource, Debug, Default)]
struct Heard {
    events: Vec<Event>,
    pieces: Vec<(usize, PathPiece)>,
    failure: Option<SolveError>,
}

impl Watch for Heard {
    fn event(&mut self, event: &Event) {
        self.events.push(*event);
    }

    fn piece(&mut self, ball: usize, piece: &PathPiece) {
        self.pieces.push((ball, *piece));
    }
}

/// Gives the balls as they are to a new engine; what is frozen to a ball that was just struck goes along with it.
fn begin(
    mut live: ResMut<LiveEngine>,
    mut heard: ResMut<Heard>,
    mut struck: MessageReader<Struck>,
    playfield: Res<Playfield>,
    balls: BallQuery,
) {
    let struck = struck.read().last().map(|struck| struck.0.first.ball);
    let engine = Engine::new(&snapshot(&playfield, &balls), Limits::default());
    let engine = engine.and_then(|mut engine| {
        if let Some(ball) = struck {
            engine.push_off(ball, &mut *heard)?;
        }
        Ok(engine)
    });
    live.0 = engine
        .map_err(|error| heard.failure.get_or_insert(error).clone())
        .ok();
}

/// Goes on by one tick.
fn advance(mut live: ResMut<LiveEngine>, mut heard: ResMut<Heard>, mut clock: ResMut<Clock>) {
    clock.ticks += 1;
    let Some(engine) = &mut live.0 else { return };
    if let Err(error) = engine.advance(clock.time(), &mut *heard) {
        heard.failure = Some(error);
        live.0 = None;
    }
}

/// Passes on what was heard.
fn tell(
    mut heard: ResMut<Heard>,
    mut turned: MessageWriter<PathTurned>,
    mut touched: MessageWriter<Touched>,
    mut pocketed: MessageWriter<Pocketed>,
    mut changed: MessageWriter<MotionChanged>,
    mut failed: MessageWriter<Failed>,
    clock: Res<Clock>,
) {
    turned.write_batch(
        heard
            .pieces
            .drain(..)
            .map(|(ball, piece)| PathTurned { ball, piece }),
    );
    for event in heard.events.drain(..) {
        match event.kind {
            EventKind::Pocketed { .. } => {
                pocketed.write(Pocketed(event));
            }
            EventKind::Motion { .. } => {
                changed.write(MotionChanged(event));
            }
            EventKind::BallBall
            | EventKind::Cushion { .. }
            | EventKind::Slate
            | EventKind::Rim { .. }
            | EventKind::OffTable
            | EventKind::Strike { .. } => {
                touched.write(Touched(event));
            }
        }
    }
    if let Some(error) = heard.failure.take() {
        failed.write(Failed {
            time: clock.time(),
            reason: error.to_string(),
        });
    }
}

/// Writes the components of the balls that changed.
fn write(
    live: Res<LiveEngine>,
    mut balls: Query<(
        &BallIndex,
        &mut Position,
        &mut Velocity,
        Option<&mut AngularVelocity>,
        &mut MotionKind,
    )>,
) {
    let Some(engine) = &live.0 else { return };
    for (index, mut position, mut velocity, spin, mut motion) in &mut balls {
        let state = engine.state(index.0);
        position.set_if_neq(Position(state.position));
        velocity.set_if_neq(Velocity(state.velocity));
        motion.set_if_neq(MotionKind(state.motion));
        if let Some(mut spin) = spin {
            spin.set_if_neq(AngularVelocity(state.angular_velocity));
        }
    }
}
