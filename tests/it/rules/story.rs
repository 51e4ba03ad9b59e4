//! Records told event by event, for what a referee has to see.

use glam::{DVec2, DVec3};
use masse::game::rules::{Call, Game, GameState, Verdict};
use masse::physics::ball::{Motion, State};
use masse::physics::laws::Laws;
use masse::physics::laws::motion::Piece;
use masse::physics::record::{EndReason, Event, EventKind, Participant, PathPiece, Record};
use masse::physics::scene::Scene;
use masse::physics::table::Preset;

/// A table and what happens on it. Every happening is a tenth of a second after the last.
pub(super) struct Story {
    pub(super) scene: Scene,
    record: Record,
    clock: f64,
}

impl Story {
    /// Begins with the stroke of the ball `cue`.
    pub(super) fn of(scene: &Scene) -> Self {
        Self::with(scene, "cue")
    }

    /// Begins with the stroke of this ball.
    pub(super) fn with(scene: &Scene, cue: &str) -> Self {
        let mut story = Self {
            scene: scene.clone(),
            record: Record {
                reason: Some(EndReason::Rest),
                ..Record::default()
            },
            clock: 0.0,
        };
        for ball in &scene.balls {
            story.record.end.push(ball.state);
            story.record.paths.push(vec![PathPiece {
                time: 0.0,
                piece: Piece::uniform(ball.state),
            }]);
        }
        let cue = story.ball(cue);
        story.tell(EventKind::Strike { miscue: false }, cue, None);
        story
    }

    pub(super) fn ball(&self, name: &str) -> usize {
        let found = self.scene.ball_named(name);
        found.unwrap_or_else(|| panic!("there is no ball {name}"))
    }

    fn tell(&mut self, kind: EventKind, ball: usize, second: Option<usize>) {
        let who = |ball: usize| Participant {
            ball,
            before: self.record.end[ball],
            after: self.record.end[ball],
        };
        self.record.events.push(Event {
            time: self.clock,
            kind,
            first: who(ball),
            second: second.map(who),
            impulse: 0.1,
        });
        self.record.end_time = self.clock;
    }

    /// Some time passes.
    pub(super) fn wait(mut self, time: f64) -> Self {
        self.clock += time;
        self
    }

    /// Two balls meet.
    pub(super) fn meet(self, one: &str, other: &str) -> Self {
        self.wait(0.1).also_meet(one, other)
    }

    /// Two balls meet at the same time as what happened last.
    pub(super) fn also_meet(mut self, one: &str, other: &str) -> Self {
        let (one, other) = (self.ball(one), self.ball(other));
        self.tell(EventKind::BallBall, one, Some(other));
        self
    }

    /// A ball meets a cushion.
    pub(super) fn cushion(mut self, name: &str, cushion: usize) -> Self {
        self.clock += 0.1;
        let ball = self.ball(name);
        self.tell(EventKind::Cushion { cushion }, ball, None);
        self
    }

    /// A ball falls.
    pub(super) fn pot(mut self, name: &str, pocket: usize) -> Self {
        self.clock += 0.1;
        let ball = self.ball(name);
        self.record.end[ball].motion = Motion::Pocketed;
        let hole = &self.scene.table.pockets[pocket];
        self.record.end[ball].position = DVec3::new(hole.center.x, -hole.depth, hole.center.y);
        self.tell(EventKind::Pocketed { pocket }, ball, None);
        self
    }

    /// A ball leaves the table.
    pub(super) fn off(mut self, name: &str) -> Self {
        self.clock += 0.1;
        let ball = self.ball(name);
        self.record.end[ball].motion = Motion::OffTable;
        self.tell(EventKind::OffTable, ball, None);
        self
    }

    /// A ball changes its motion.
    pub(super) fn motion(mut self, name: &str, from: Motion, to: Motion) -> Self {
        let ball = self.ball(name);
        self.tell(EventKind::Motion { from, to }, ball, None);
        self
    }

    /// A ball is here from now on, x and z in m.
    pub(super) fn go(mut self, name: &str, x: f64, z: f64) -> Self {
        self.clock += 0.1;
        let ball = self.ball(name);
        let state = State::at_rest(DVec3::new(x, self.scene.balls[ball].ball.radius, z));
        self.record.end[ball] = state;
        self.record.paths[ball].push(PathPiece {
            time: self.clock,
            piece: Piece::uniform(state),
        });
        self.record.end_time = self.clock;
        self
    }

    /// A ball flies straight to here, x and z in m, above everything, and comes down there.
    pub(super) fn fly(mut self, name: &str, x: f64, z: f64) -> Self {
        let ball = self.ball(name);
        let from = self.record.end[ball].position;
        let start = DVec3::new(from.x, 0.1, from.z);
        let state = State {
            velocity: (DVec3::new(x, 0.1, z) - start) / 0.1,
            motion: Motion::Airborne,
            ..State::at_rest(start)
        };
        self.record.paths[ball].push(PathPiece {
            time: self.clock,
            piece: Piece::uniform(state),
        });
        self = self.go(name, x, z);
        self.tell(EventKind::Slate, ball, None);
        self
    }

    pub(super) fn record(&self) -> &Record {
        &self.record
    }

    pub(super) fn judge(&self, state: &GameState, call: &Call) -> Verdict {
        state.judge(&self.scene, &self.record, call)
    }

    /// Judges, and gives the table to play on too.
    pub(super) fn play(&self, state: &GameState, call: &Call) -> (Verdict, Scene) {
        let verdict = self.judge(state, call);
        let scene = verdict.table_after(&self.scene, &self.record);
        (verdict, scene)
    }
}

/// A game for two on its own kind of table, racked with seed 1.
pub(super) fn start(game: Game, table: Preset) -> (GameState, Scene) {
    let like = Scene::new(table.table(), Laws::default());
    GameState::start(game, 2, 0, &like, 1)
}

/// Lays balls out: those named lie where told (x and z in m), every other object ball is in a pocket.
pub(super) fn lay(scene: &mut Scene, balls: &[(&str, f64, f64)]) {
    for placed in &mut scene.balls {
        let told = balls.iter().find(|(name, ..)| *name == placed.name);
        placed.state.motion = Motion::Pocketed;
        if let Some(&(_, x, z)) = told {
            placed.state = State::at_rest(DVec3::new(x, placed.ball.radius, z));
        }
    }
}

/// Where a ball lies, x and z in m.
pub(super) fn place(scene: &Scene, name: &str) -> DVec2 {
    let ball = scene.ball_named(name).expect("the ball is there");
    let position = scene.balls[ball].state.position;
    DVec2::new(position.x, position.z)
}

/// Calls a ball by name.
pub(super) fn pot(scene: &Scene, name: &str, pocket: usize) -> Call {
    let ball = scene.ball_named(name).expect("the ball is there");
    Call::Pot { ball, pocket }
}
