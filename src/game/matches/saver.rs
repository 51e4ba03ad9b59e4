//! Saves beside the game: a match that saves itself after every shot does not hold up a frame.
//!
//! One thread writes, one save after another, each as [`Store::autosave`] does it: aside, synced, renamed. A match that is
//! handed over while the thread writes waits; of several that wait the newest is written, so the order is that of the
//! game. Whoever drops a [`Saver`] waits for the last save.

use std::mem;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};

use crate::game::matches::Match;
use crate::game::matches::store::{Saved, Store, StoreError};

/// What came of a save.
pub type Outcome = Result<Saved, StoreError>;

#[derive(Debug, Default)]
struct Desk {
    /// The newest match that is not written yet.
    due: Option<Match>,
    writes: bool,
    closes: bool,
    outcomes: Vec<Outcome>,
}

#[derive(Debug, Default)]
struct Shared {
    desk: Mutex<Desk>,
    changed: Condvar,
}

impl Shared {
    fn desk(&self) -> MutexGuard<'_, Desk> {
        self.desk.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn wait<'a>(&self, desk: MutexGuard<'a, Desk>) -> MutexGuard<'a, Desk> {
        let waited = self.changed.wait(desk);
        waited.unwrap_or_else(PoisonError::into_inner)
    }

    /// What the thread does until it is told to close and nothing is due.
    fn write(&self, store: &Store) {
        let mut desk = self.desk();
        loop {
            if let Some(game) = desk.due.take() {
                desk.writes = true;
                drop(desk);
                let outcome = store.autosave(&game);
                desk = self.desk();
                desk.writes = false;
                desk.outcomes.push(outcome);
                self.changed.notify_all();
            } else if desk.closes {
                return;
            } else {
                desk = self.wait(desk);
            }
        }
    }
}

/// Saves matches to a store, one after another, beside the game.
#[derive(Debug)]
pub struct Saver {
    store: Store,
    shared: Arc<Shared>,
    /// `None` where the system has no thread for it: then whoever saves waits.
    thread: Option<JoinHandle<()>>,
}

impl Saver {
    /// Saves to this store.
    #[must_use]
    pub fn new(store: Store) -> Self {
        let shared = Arc::new(Shared::default());
        let (desk, folder) = (shared.clone(), store.clone());
        let builder = thread::Builder::new().name("autosave".to_owned());
        let thread = builder.spawn(move || desk.write(&folder)).ok();
        Self {
            store,
            shared,
            thread,
        }
    }

    /// Hands over a match, to be saved as the one to go on with.
    pub fn save(&self, game: &Match) {
        if self.thread.is_some() {
            self.shared.desk().due = Some(game.clone());
            self.shared.changed.notify_all();
        } else {
            let outcome = self.store.autosave(game);
            self.shared.desk().outcomes.push(outcome);
        }
    }

    /// What came of the saves since this was asked last, in their order.
    #[must_use]
    pub fn outcomes(&self) -> Vec<Outcome> {
        mem::take(&mut self.shared.desk().outcomes)
    }

    /// Waits until everything that was handed over is written, or cannot be.
    pub fn finish(&self) {
        let works = || {
            self.thread
                .as_ref()
                .is_some_and(|thread| !thread.is_finished())
        };
        let mut desk = self.shared.desk();
        while works() && (desk.writes || desk.due.is_some()) {
            desk = self.shared.wait(desk);
        }
    }
}

impl Drop for Saver {
    fn drop(&mut self) {
        self.shared.desk().closes = true;
        self.shared.changed.notify_all();
        if let Some(thread) = self.thread.take() {
            // A thread that panicked has nothing left to write.
            let _ = thread.join();
        }
    }
}
