//! Plays one shot after another in the same memory.

use crate::physics::exact::{self, Engine, Limits, Recorder, SolveError};
use crate::physics::record::Record;
use crate::physics::scene::Scene;

/// Most events of a shot in a search: a break has a few hundred.
const EVENTS: u64 = 20_000;

/// An exact solver that keeps its memory: scenes on one table with as many balls as the last are played without allocation.
#[derive(Debug, Default)]
pub struct Player {
    engine: Option<Engine>,
    recorder: Recorder,
}

impl Player {
    /// Plays a scene with its shot to the end. The record is that of [`exact::solve`] to the last bit; the scene is taken as
    /// it is, unchecked.
    ///
    /// # Errors
    /// [`SolveError`] as [`exact::solve`].
    pub fn play(&mut self, scene: &Scene) -> Result<&Record, SolveError> {
        let engine = match &mut self.engine {
            Some(engine) => {
                engine.reload(scene)?;
                engine
            }
            none => none.insert(Engine::new(scene, Limits { events: EVENTS })?),
        };
        self.recorder.begin(engine);
        exact::play(engine, scene, &mut self.recorder)
    }

    /// Forgets an engine that is of no further use after an error.
    pub fn forget(&mut self) {
        self.engine = None;
    }
}
