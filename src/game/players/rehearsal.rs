//! Shots played in the mind: the solver that plays the real ones, in the same room again and again.

use glam::{DVec2, DVec3};

use crate::game::players::sight;
use crate::physics::ball::State;
use crate::physics::cue::Shot;
use crate::physics::exact::{self, Engine, Limits, Recorder, SolveError, Watch};
use crate::physics::record::{Event, EventKind, Record};
use crate::physics::scene::{PlannedShot, Scene};

/// Events after which a rehearsal is given up.
const EVENTS: u64 = 20_000;

/// Seconds within which the cue ball must have met something.
const PATIENCE: f64 = 20.0;

/// What the cue ball meets first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The ball that was met.
    pub ball: usize,
    /// Its velocity in plan just after, m/s.
    pub velocity: DVec2,
}

/// A table in the mind.
#[derive(Clone, Debug)]
pub struct Rehearsal {
    scene: Scene,
    engine: Engine,
    recorder: Recorder,
    most: u32,
    /// Shots rehearsed so far.
    pub trials: u32,
}

impl Rehearsal {
    /// With the balls as they lie in a scene, for this many shots at most.
    ///
    /// # Errors
    /// [`SolveError`] if the scene cannot be played by the exact solver.
    pub fn new(scene: &Scene, most: u32) -> Result<Self, SolveError> {
        scene.check()?;
        let engine = Engine::new(scene, Limits { events: EVENTS })?;
        let recorder = Recorder::new(&engine);
        Ok(Self {
            scene: scene.clone(),
            engine,
            recorder,
            most,
            trials: 0,
        })
    }

    /// The table as it lies now.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Lays the balls as they lie in another scene with the same balls.
    pub fn lay(&mut self, scene: &Scene) {
        for (mine, other) in self.scene.balls.iter_mut().zip(&scene.balls) {
            mine.state = other.state;
        }
    }

    /// Puts a ball down at a point.
    pub fn put(&mut self, ball: usize, spot: DVec2) {
        let placed = &mut self.scene.balls[ball];
        placed.state = State::at_rest(DVec3::new(spot.x, placed.ball.radius, spot.y));
    }

    /// Plays a shot to the end. Gives the table before it and what happened; `None` if the
    /// solver gave up, or if there have been enough.
    pub fn play(&mut self, ball: usize, shot: &Shot) -> Option<(&Scene, &Record)> {
        if self.trials >= self.most {
            return None;
        }
        self.trials += 1;
        self.scene.shot = Some(PlannedShot { ball, shot: *shot });
        let played = self.engine.reload(&self.scene).and_then(|()| {
            self.recorder.begin(&self.engine);
            exact::play(&mut self.engine, &self.scene, &mut self.recorder).map(|_| ())
        });
        if played.is_err() {
            self.renew();
            return None;
        }
        Some((&self.scene, self.recorder.so_far()))
    }

    /// Plays a shot until the struck ball meets another; `None` if it meets none, or if there have been enough.
    pub fn hit(&mut self, ball: usize, shot: &Shot) -> Option<Hit> {
        if self.trials >= self.most {
            return None;
        }
        self.trials += 1;
        self.scene.shot = Some(PlannedShot { ball, shot: *shot });
        let mut watch = FirstHit {
            of: ball,
            hit: None,
        };
        let found = self.until_hit(ball, shot, &mut watch);
        if found.is_err() {
            self.renew();
        }
        watch.hit
    }

    fn until_hit(
        &mut self,
        ball: usize,
        shot: &Shot,
        watch: &mut FirstHit,
    ) -> Result<(), SolveError> {
        let (scene, engine) = (&self.scene, &mut self.engine);
        engine.reload(scene)?;
        engine.strike(ball, &scene.cue, shot, watch)?;
        while watch.hit.is_none() {
            match engine.next_time() {
                Some(time) if time < PATIENCE => engine.advance(time, watch)?,
                _ => break,
            }
        }
        Ok(())
    }

    /// After an error the engine is of no further use.
    fn renew(&mut self) {
        let limits = Limits { events: EVENTS };
        if let Ok(engine) = Engine::new(&self.scene, limits) {
            self.engine = engine;
        }
    }
}

/// Listens for the first contact of a ball with another.
struct FirstHit {
    of: usize,
    hit: Option<Hit>,
}

impl Watch for FirstHit {
    fn event(&mut self, event: &Event) {
        let (EventKind::BallBall, Some(second), None) = (event.kind, event.second, self.hit) else {
            return;
        };
        let other = match (event.first.ball == self.of, second.ball == self.of) {
            (true, _) => second,
            (_, true) => event.first,
            _ => return,
        };
        self.hit = Some(Hit {
            ball: other.ball,
            velocity: sight::plan(other.after.velocity),
        });
    }
}
