//! Listening to the engine.

use crate::physics::exact::Engine;
use crate::physics::record::{EndReason, Event, PathPiece, Record};

/// Hears what happens, in order of time. The unit type hears nothing and costs nothing.
pub trait Watch {
    /// An event has happened.
    fn event(&mut self, _event: &Event) {}

    /// From now on this ball follows this piece.
    fn piece(&mut self, _ball: usize, _piece: &PathPiece) {}
}

impl Watch for () {}

/// Writes everything down.
#[derive(Clone, Debug, Default)]
pub struct Recorder {
    record: Record,
}

impl Recorder {
    /// Begins with the paths on which the balls are now.
    #[must_use]
    pub fn new(engine: &Engine) -> Self {
        let mut recorder = Self::default();
        recorder.begin(engine);
        recorder
    }

    /// Forgets everything and begins again; the room is kept.
    pub fn begin(&mut self, engine: &Engine) {
        let record = &mut self.record;
        record.events.clear();
        record.paths.resize(engine.count(), Vec::new());
        for (ball, path) in record.paths.iter_mut().enumerate() {
            path.clear();
            path.push(engine.path(ball));
        }
    }

    /// What is written so far; its end is not set.
    #[must_use]
    pub fn so_far(&self) -> &Record {
        &self.record
    }

    /// The record, ended at this time.
    #[must_use]
    pub fn finish(mut self, engine: &Engine, time: f64, reason: EndReason) -> Record {
        self.end(engine, time, reason);
        self.record
    }

    /// What is written, with the end that it was given.
    #[must_use]
    pub fn into_record(self) -> Record {
        self.record
    }

    /// Ends the record at this time, and keeps it and its room.
    pub fn end(&mut self, engine: &Engine, time: f64, reason: EndReason) -> &Record {
        let record = &mut self.record;
        record.end.clear();
        record
            .end
            .extend((0..engine.count()).map(|ball| engine.state(ball)));
        record.end_time = time;
        record.reason = Some(reason);
        record
    }
}

impl Watch for Recorder {
    fn event(&mut self, event: &Event) {
        self.record.events.push(*event);
    }

    fn piece(&mut self, ball: usize, piece: &PathPiece) {
        let path = &mut self.record.paths[ball];
        // A piece that ends where it began was never seen.
        if path.last().is_some_and(|last| last.time >= piece.time) {
            path.pop();
        }
        path.push(*piece);
    }
}
