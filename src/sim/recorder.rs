//! What happened since the last stroke.

use bevy::prelude::*;

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::laws::Laws;
use crate::physics::record::{EndReason, Event, Participant, PathPiece, Record};
use crate::physics::scene::Scene;
use crate::sim::SimSystems;
use crate::sim::clock::Clock;
use crate::sim::components::{
    AngularVelocity, BallIndex, Mass, MotionKind, Position, Radius, Velocity, ball_and_state,
};
use crate::sim::messages::{MotionChanged, Pocketed, Struck, Touched};
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
        let motion = &scene.laws.motion;
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
                        piece: motion.piece(&ball, &state),
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

    fn turn(&mut self, laws: &Laws, ball: &Ball, index: usize, time: f64, state: State) {
        if let Some(path) = self.paths.get_mut(index) {
            path.push(PathPiece {
                time,
                piece: laws.motion.piece(ball, &state),
            });
        }
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
            record.in_set(SimSystems::Record).before(super::clock::rest),
        ),
    );
}

/// Keeps the table as it is before a stroke.
fn remember(
    mut recorder: ResMut<Recorder>,
    playfield: Res<Playfield>,
    balls: BallQuery,
    kinds: Query<&MotionKind>,
) {
    let still = |kind: &MotionKind| matches!(kind.0, Motion::Rest | Motion::Pocketed);
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
    let bodies: Vec<Ball> = recorder
        .before
        .iter()
        .flat_map(|scene| scene.balls.iter().map(|ball| ball.ball))
        .collect();
    for at in first..recorder.events.len() {
        let event = recorder.events[at];
        for Participant { ball, after, .. } in event.participants() {
            recorder.mark(*ball, event.time, *after);
            if let Some(body) = bodies.get(*ball) {
                recorder.turn(&playfield.laws, body, *ball, event.time, *after);
            }
        }
    }
    for (index, position, velocity, spin, mass, radius, motion) in &balls {
        let still = !motion.0.translates();
        if still
            && recorder
                .trails
                .get(index.0)
                .is_some_and(|trail| !trail.is_empty())
        {
            continue;
        }
        let (_, state) = ball_and_state(position, velocity, spin, mass, radius, motion);
        recorder.mark(index.0, clock.time(), state);
    }
}
