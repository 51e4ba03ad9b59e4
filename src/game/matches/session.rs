//! A match that saves itself after everything that happens.

use glam::DVec2;

use crate::game::matches::saver::{Outcome, Saver};
use crate::game::matches::store::{AUTOSAVE, Store};
use crate::game::matches::{Match, Refused, SavedError};
use crate::game::rules::{Choice, Verdict};
use crate::physics::cue::Shot;
use crate::physics::record::Record;

/// A match at play, saved after every shot and every choice. Saving is done beside the game; the last save is waited for
/// when the session is dropped.
#[derive(Debug)]
pub struct Session {
    game: Match,
    saver: Option<Saver>,
}

impl Session {
    /// Begins with a match. Without a store nothing is saved.
    #[must_use]
    pub fn new(game: Match, store: Option<Store>) -> Self {
        let saver = store.map(Saver::new);
        Self { game, saver }
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

    /// What came of the saves since this was asked last: where they are, or why there are none.
    #[must_use]
    pub fn saves(&self) -> Vec<Outcome> {
        self.saver.as_ref().map(Saver::outcomes).unwrap_or_default()
    }

    /// Waits for the last save.
    pub fn finish_saving(&self) {
        if let Some(saver) = &self.saver {
            saver.finish();
        }
    }

    /// Saves the match as it is, after that failed, and waits for it.
    pub fn save_again(&self) {
        self.save();
        self.finish_saving();
    }

    fn save(&self) {
        if let Some(saver) = &self.saver {
            saver.save(&self.game);
        }
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
