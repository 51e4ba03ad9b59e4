//! A match that saves itself after everything that happens.

use glam::DVec2;

use crate::game::matches::store::{AUTOSAVE, Saved, Store, StoreError};
use crate::game::matches::{Match, Refused, SavedError};
use crate::game::rules::{Choice, Verdict};
use crate::physics::cue::Shot;
use crate::physics::record::Record;

/// A match at play, with the store that it is saved to after every shot and every choice.
#[derive(Debug)]
pub struct Session {
    game: Match,
    store: Option<Store>,
    last_save: Option<Result<Saved, StoreError>>,
}

impl Session {
    /// Begins with a match. Without a store nothing is saved.
    #[must_use]
    pub fn new(game: Match, store: Option<Store>) -> Self {
        Self {
            game,
            store,
            last_save: None,
        }
    }

    /// Goes on with the match that saved itself last.
    ///
    /// # Errors
    /// [`SavedError`] with the file, the field and the value; the file stays as it is, and is put aside when another match
    /// saves itself.
    pub fn resume(store: Store) -> Result<Self, SavedError> {
        let game = store.load(AUTOSAVE)?;
        Ok(Self::new(game, Some(store)))
    }

    /// The match.
    #[must_use]
    pub fn game(&self) -> &Match {
        &self.game
    }

    /// What came of the last save: where it is, or why there is none. Taken away by asking.
    pub fn last_save(&mut self) -> Option<Result<Saved, StoreError>> {
        self.last_save.take()
    }

    fn save(&mut self) {
        self.last_save = self.store.as_ref().map(|store| store.autosave(&self.game));
    }

    /// As [`Match::played`], and saves.
    ///
    /// # Errors
    /// As there.
    pub fn played(
        &mut self,
        shot: Shot,
        record: &Record,
        thought: f64,
    ) -> Result<Verdict, Refused> {
        let verdict = self.game.played(shot, record, thought)?;
        self.save();
        Ok(verdict)
    }

    /// As [`Match::choose`], and saves.
    ///
    /// # Errors
    /// As there.
    pub fn choose(&mut self, choice: Choice) -> Result<Verdict, Refused> {
        let verdict = self.game.choose(choice)?;
        self.save();
        Ok(verdict)
    }

    /// Any other input of a match, and saves if it is accepted.
    ///
    /// # Errors
    /// As the input says.
    pub fn input(
        &mut self,
        input: impl FnOnce(&mut Match) -> Result<(), Refused>,
    ) -> Result<(), Refused> {
        input(&mut self.game)?;
        self.save();
        Ok(())
    }

    /// As [`Match::place`]. A cue ball that is being dragged is not saved at every point.
    ///
    /// # Errors
    /// As there.
    pub fn place(&mut self, at: DVec2) -> Result<(), Refused> {
        self.game.place(at)
    }
}
