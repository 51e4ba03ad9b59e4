//! What happened since the last stroke.

use bevy::prelude::*;

use crate::physics::ball::State;
use crate::physics::record::{EndReason, Event, Participant, PathPiece, Record};
use crate::physics::scene::Scene;
use crate::sim::SimSystems;
use crate::sim::clock::Clock;
use crate::sim::components::{
    AngularVelocity, BallIndex, Mass, MotionKind, Position, Radius, Velocity, ball_and_state,
};
use crate::sim::messages::{MotionChanged, PathTurned, Pocketed, Struck, Touched};
use crate::sim::playfield::{BallQuery, Playfield, snapshot};

/// The events and the paths of the present shot, or of the last one while nothing moves.
#[derive(Resource, Clone, Debug, Default)]
pub struct Recorder {
    /// Events in order of time; the first is the stroke.
    pub events: Vec<Event>,
    /// For each ball the closed-form pieces of its path.
    pub paths: Vec<Vec<PathPiece>>,
    /// For each ball its state at the start, at every event it had and after every tick in which it moved, with the
    /// time in s.
    pub trails: Vec<Vec<(f64, State)>>,
    /// The table as the shot found it: what a retry goes back to.
    pub before: Option<Scene>,
}

impl Recorder {
    /// An empty record of a shot that begins with this scene.
    #[must_use]
    pub fn start(scene: &Scene) -> Self {
        if scene.solver.is_crowd() {
            // A crowd is counted, not written down.
            return Self {
                before: Some(scene.clone()),
                ..Self::default()
            };
        }
        let motion = &scene.laws.motion;
        let (laws, table) = (&scene.laws, &scene.table);
        let states = scene
            .balls
            .iter()
            .map(|ball| (ball.ball, motion.classify(&ball.ball, ball.state)));
        Self {
            events: Vec::new(),
            paths: states
                .clone()
                .map(|(ball, state)| {
                    vec![PathPiece {
                        time: 0.0,
                        piece: laws.piece(table, &ball, &state),
                    }]
                })
                .collect(),
            trails: states.map(|(_, state)| vec![(0.0, state)]).collect(),
            before: Some(scene.clone()),
        }
    }

    /// What happened so far, complete: the state of every ball at any time up to `end_time`.
    #[must_use]
    pub fn record(&self, end_time: f64, reason: Option<EndReason>) -> Record {
        let mut record = Record {
            events: self.events.clone(),
            paths: self.paths.clone(),
            end: Vec::new(),
            end_time: f64::INFINITY,
            reason,
        };
        record.end = (0..self.paths.len())
            .map(|ball| record.state_at(ball, end_time))
            .collect();
        record.end_time = end_time;
        record
    }

    /// From this time on the ball follows this piece; one that ends where it began was never seen.
    fn turn(&mut self, ball: usize, piece: PathPiece) {
        let Some(path) = self.paths.get_mut(ball) else {
            return;
        };
        if path.last().is_some_and(|last| last.time >= piece.time) {
            path.pop();
        }
        path.push(piece);
    }

    fn mark(&mut self, ball: usize, time: f64, state: State) {
        if let Some(trail) = self.trails.get_mut(ball) {
            trail.push((time, state));
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Recorder>().add_systems(
        FixedUpdate,
        (
            remember
                .run_if(on_message::<crate::sim::messages::Strike>)
                .in_set(SimSystems::Strike)
                .after(super::playfield::load_scene)
                .before(super::clock::strike),
            record
                .run_if(not(super::stepped::crowd::is_crowd))
                .in_set(SimSystems::Record)
                .before(super::clock::rest),
        ),
    );
}

/// Keeps the table as it is before a stroke.
pub(super) fn remember(
    mut recorder: ResMut<Recorder>,
    playfield: Res<Playfield>,
    balls: BallQuery,
    kinds: Query<&MotionKind>,
) {
    let still = |kind: &MotionKind| kind.0.is_still();
    if kinds.iter().all(still) && !balls.is_empty() {
        *recorder = Recorder::start(&snapshot(&playfield, &balls));
    }
}

/// Writes down what the solver said, and where the balls are.
#[expect(
    clippy::too_many_arguments,
    reason = "one reader for each kind of message"
)]
fn record(
    mut recorder: ResMut<Recorder>,
    mut struck: MessageReader<Struck>,
    mut touched: MessageReader<Touched>,
    mut pocketed: MessageReader<Pocketed>,
    mut changed: MessageReader<MotionChanged>,
    mut turned: MessageReader<PathTurned>,
    clock: Res<Clock>,
    playfield: Res<Playfield>,
    balls: Query<(
        &BallIndex,
        &Position,
        &Velocity,
        Option<&AngularVelocity>,
        &Mass,
        &Radius,
        &MotionKind,
    )>,
) {
    if !clock.moving {
        return;
    }
    let first = recorder.events.len();
    recorder
        .events
        .extend(struck.read().map(|message| message.0));
    recorder
        .events
        .extend(touched.read().map(|message| message.0));
    recorder
        .events
        .extend(pocketed.read().map(|message| message.0));
    recorder
        .events
        .extend(changed.read().map(|message| message.0));
    // Messages of one kind come in order of time; the sort is stable, so equal times keep their kinds' order.
    recorder.events[first..].sort_by(|a, b| a.time.total_cmp(&b.time));
    for at in first..recorder.events.len() {
        let event = recorder.events[at];
        for Participant { ball, after, .. } in event.participants() {
            recorder.mark(*ball, event.time, *after);
        }
    }
    for PathTurned { ball, piece } in turned.read() {
        recorder.turn(*ball, *piece);
    }
    for (index, position, velocity, spin, mass, radius, motion) in &balls {
        if !motion.0.translates() {
            continue;
        }
        let (ball, state) = ball_and_state(position, velocity, spin, mass, radius, motion);
        recorder.mark(index.0, clock.time(), state);
        if !playfield.laws.motion.is_closed_form() {
            // The coursework's friction comes after each tick, so each tick is a piece of its own.
            recorder.turn(
                index.0,
                PathPiece {
                    time: clock.time(),
                    piece: playfield.laws.piece(&playfield.table, &ball, &state),
                },
            );
        }
    }
}
