//! What came of saving the match, and the last save before the program ends.

use bevy::prelude::*;

use crate::game::matches::saver::Outcome;
use crate::game::matches::store::Saved;
use crate::game::turns::{TurnNews, Turns};

/// Tells what came of saving: once when it fails, once when it works again.
pub(super) fn tell(mut turns: ResMut<Turns>, mut news: MessageWriter<TurnNews>) {
    let turns = turns.bypass_change_detection();
    let Some(session) = &turns.session else {
        return;
    };
    for outcome in session.saves() {
        tell_of(outcome, &mut turns.unsaved, &mut news);
    }
}

fn tell_of(outcome: Outcome, unsaved: &mut Option<String>, news: &mut MessageWriter<TurnNews>) {
    match outcome {
        Ok(Saved { put_aside, .. }) => {
            if let Some((kept, why)) = put_aside {
                news.write(TurnNews::PutAside { kept, why });
            }
            if unsaved.take().is_some() {
                news.write(TurnNews::SavedAgain);
            }
        }
        Err(error) => {
            let why = Some(error.to_string());
            if *unsaved != why {
                *unsaved = why;
                news.write(TurnNews::NotSaved(error));
            }
        }
    }
}

/// Waits for the last save. What could not be saved is tried once more, and told of again if that fails too.
fn wait(turns: &mut Turns, news: &mut MessageWriter<TurnNews>) {
    let Some(session) = &turns.session else {
        return;
    };
    session.finish_saving();
    for outcome in session.saves() {
        tell_of(outcome, &mut turns.unsaved, news);
    }
    if turns.unsaved.is_some() {
        session.save_again();
        // Whatever comes of that is told.
        turns.unsaved = Some(String::new());
        for outcome in session.saves() {
            tell_of(outcome, &mut turns.unsaved, news);
        }
    }
}

/// Lets go of the match. Its last save is waited for, so that nothing that went wrong with it stays untold.
pub(super) fn let_go(turns: &mut Turns, news: &mut MessageWriter<TurnNews>) {
    wait(turns, news);
    *turns = Turns::default();
}

/// The program ends when the match is saved.
pub(super) fn finish(mut turns: ResMut<Turns>, mut news: MessageWriter<TurnNews>) {
    wait(turns.bypass_change_detection(), &mut news);
}
