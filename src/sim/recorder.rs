//! What happened since the last stroke.

use bevy::prelude::*;

use crate::physics::ball::State;
use crate::physics::record::Event;
use crate::physics::scene::Scene;
use crate::sim::SimSystems;
use crate::sim::clock::Clock;
use crate::sim::components::{
    AngularVelocity, BallIndex, Mass, MotionKind, Position, Radius, Velocity, ball_and_state,
};
use crate::sim::messages::{LoadScene, MotionChanged, Pocketed, Struck, Touched};
use crate::sim::playfield::{BallQuery, Playfield, snapshot};

/// The events and the sampled paths of the present shot, or of the last one while nothing moves.
#[derive(Resource, Clone, Debug, Default)]
pub struct Recorder {
    /// Events in order of time; the first is the stroke.
    pub events: Vec<Event>,
    /// For each ball its state at the start, at every event it had and after every tick in which it moved, with the
    /// time in s.
    pub trails: Vec<Vec<(f64, State)>>,
    /// The table just before the stroke: what a retry goes back to.
    pub before: Option<Scene>,
}

impl Recorder {
    fn mark(&mut self, ball: usize, time: f64, state: State) {
        if self.trails.len() <= ball {
            self.trails.resize(ball + 1, Vec::new());
        }
        self.trails[ball].push((time, state));
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Recorder>()
        .add_systems(
            FixedUpdate,
            (
                forget.run_if(on_message::<LoadScene>).before(remember),
                remember.run_if(on_message::<crate::sim::messages::Strike>),
            )
                .in_set(SimSystems::Strike)
                .before(super::clock::strike)
                .before(super::playfield::load_scene),
        )
        .add_systems(
            FixedUpdate,
            record.in_set(SimSystems::Record).before(super::clock::rest),
        );
}

/// A new scene has no past.
fn forget(mut recorder: ResMut<Recorder>) {
    *recorder = Recorder::default();
}

/// Keeps the table as it is before a stroke.
fn remember(
    mut recorder: ResMut<Recorder>,
    playfield: Res<Playfield>,
    balls: BallQuery,
    clock: Res<Clock>,
) {
    if clock.moving || balls.is_empty() {
        return;
    }
    *recorder = Recorder {
        before: Some(snapshot(&playfield, &balls)),
        ..Recorder::default()
    };
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
        for participant in event.participants() {
            recorder.mark(participant.ball, event.time, participant.after);
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
