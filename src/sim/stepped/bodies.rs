//! The balls as the tick works on them: packed, in scene order.

use bevy::prelude::*;
use glam::DVec2;

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::contact::Track;
use crate::physics::laws::cluster::{self, Other, TOUCH, Touched};
use crate::physics::laws::motion::Piece;
use crate::physics::record::PathPiece;
use crate::physics::scene::{Solver, Stepped};
use crate::sim::clock::Clock;
use crate::sim::components::{
    AngularVelocity, BallIndex, Mass, MotionKind, Position, Radius, Velocity, ball_and_state,
};
use crate::sim::playfield::Playfield;
use crate::sim::recorder::Recorder;
use crate::sim::stepped::grid::CellRange;

/// One ball during a tick.
#[derive(Clone, Copy, Debug)]
pub(super) struct Body {
    pub entity: Entity,
    /// Index in the scene.
    pub index: usize,
    pub ball: Ball,
    /// The path it is on.
    pub piece: Piece,
    /// Time in the tick at which the piece began.
    pub since: f64,
    /// Raised whenever the path changes, so that contacts found for an older path are known to be stale.
    pub version: u32,
    /// Impacts in this tick.
    pub impacts: u32,
    /// Cells in which the ball is listed.
    pub cells: CellRange,
    /// State at the end of the tick.
    pub end: State,
}

impl Body {
    /// The state at this time of the tick.
    pub fn at(&self, time: f64) -> State {
        self.piece.at(time - self.since)
    }

    /// The path seen from this time of the tick.
    pub fn track(&self, time: f64) -> Track {
        Track::of(&self.piece, time - self.since)
    }

    /// Time of the tick at which the kind of motion changes.
    pub fn change(&self) -> f64 {
        self.since + self.piece.duration
    }

    pub fn is_in_play(&self) -> bool {
        self.piece.start.motion.in_play()
    }

    pub fn flies(&self) -> bool {
        self.piece.start.motion.flies()
    }

    pub fn translates(&self) -> bool {
        self.piece.start.motion.translates()
    }

    /// Puts the ball on the path that starts with this state.
    pub fn follow(&mut self, playfield: &Playfield, state: &State, time: f64) {
        self.piece = playfield.laws.piece(&playfield.table, &self.ball, state);
        self.since = time;
        self.version += 1;
    }

    /// A box in plan that holds the ball from `time` to `end` of the tick.
    pub fn sweep(&self, time: f64, end: f64) -> (DVec2, DVec2) {
        let track = self.track(time);
        let left = end - time;
        let plan = |v: glam::DVec3| DVec2::new(v.x, v.z);
        let from = plan(track.position);
        let to = from + left * plan(track.velocity);
        // The bend of the path, and room for what counts as touching.
        let margin = self.ball.radius + TOUCH + 0.5 * left * left * track.acceleration.length();
        (
            from.min(to) - DVec2::splat(margin),
            from.max(to) + DVec2::splat(margin),
        )
    }
}

/// All balls of the tick.
#[derive(Resource, Debug, Default)]
pub struct Bodies {
    pub(super) all: Vec<Body>,
    /// What each of them has touched lately, by the time of the shot.
    pub(super) touched: Vec<Touched>,
    /// Length of the tick, s.
    pub(super) tick: f64,
    /// Shot time at the start of the tick, s.
    pub(super) start: f64,
    /// Whether contacts are located inside the tick.
    pub(super) locate: bool,
}

impl Bodies {
    /// What each ball has touched lately, by the time of the shot.
    #[must_use]
    pub fn memory(&self) -> Vec<Vec<(Other, f64)>> {
        let lists = self.touched.iter();
        lists.map(|touched| touched.list().collect()).collect()
    }

    /// Takes up what [`Self::memory`] gave.
    pub fn remember(&mut self, memory: &[Vec<(Other, f64)>]) {
        let lists = memory.iter();
        self.touched = lists.map(|list| Touched::from_list(list)).collect();
    }

    /// When a contact found `wait` s after a time of the tick is to be looked at; see [`cluster::put_off`].
    pub(super) fn put_off(
        &self,
        ball: usize,
        other: Other,
        (wait, time): (f64, f64),
        overlap: impl Fn(f64) -> (f64, f64),
    ) -> f64 {
        cluster::put_off(wait, self.age(ball, other, time), overlap)
    }

    /// How many seconds before a time of the tick a ball touched something; infinity if never, or where contacts have no times.
    pub(super) fn age(&self, ball: usize, other: Other, time: f64) -> f64 {
        if self.locate {
            self.start + time - self.touched[ball].last(other)
        } else {
            f64::INFINITY
        }
    }

    /// The latest time of the tick at which a contact found at `time` may lie.
    pub(super) fn horizon(&self, time: f64) -> f64 {
        if self.locate { self.tick } else { time }
    }
}

/// Reads the components.
pub(super) fn gather(
    mut bodies: ResMut<Bodies>,
    playfield: Res<Playfield>,
    clock: Res<Clock>,
    recorder: Res<Recorder>,
    balls: Query<(
        Entity,
        &BallIndex,
        &Position,
        &Velocity,
        Option<&AngularVelocity>,
        &Mass,
        &Radius,
        &MotionKind,
    )>,
) {
    let Solver::Stepped(Stepped { tick, locate, .. }) = playfield.solver else {
        return;
    };
    let (laws, table) = (&playfield.laws, &playfield.table);
    bodies.tick = tick;
    bodies.start = clock.time();
    bodies.locate = locate;
    bodies.all.clear();
    bodies.all.extend(balls.iter().map(
        |(entity, index, position, velocity, spin, mass, radius, motion)| {
            let (ball, state) = ball_and_state(position, velocity, spin, mass, radius, motion);
            // The roll over an edge is exact only at the ends of its pieces: the one on which the ball is goes on.
            let last = recorder.paths.get(index.0).and_then(|path| path.last());
            let tips = |path: &&PathPiece| {
                state.motion == Motion::Tipping && path.piece.start.motion == Motion::Tipping
            };
            let (piece, since) = match last.filter(tips) {
                Some(path) => (path.piece, path.time - clock.time()),
                None => (laws.piece(table, &ball, &state), 0.0),
            };
            Body {
                entity,
                index: index.0,
                ball,
                piece,
                since,
                version: 0,
                impacts: 0,
                cells: CellRange::EMPTY,
                end: state,
            }
        },
    ));
    bodies.all.sort_unstable_by_key(|body| body.index);
    let count = bodies.all.len();
    if clock.ticks == 0 || bodies.touched.len() != count {
        bodies.touched.clear();
        bodies.touched.resize(count, Touched::NOTHING);
    }
}
