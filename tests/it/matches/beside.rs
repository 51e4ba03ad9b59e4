//! Saving beside the game: in the order of the game, waited for at the end, and tried again after it failed.

use std::fs;

use masse::game::matches::saver::Saver;
use masse::game::matches::store::AUTOSAVE;
use masse::game::matches::{Match, Phase, Session, Store};
use masse::game::rules::Game;

use super::{Hand, begin};
use crate::cli::folder;

fn nine() -> Game {
    Game::named("9-ball").expect("9-ball")
}

/// A match as it was after each of so many strokes.
fn as_it_went(strokes: usize) -> Vec<Match> {
    let mut game = begin(&nine(), 20, 4);
    let mut hand = Hand::new(4);
    (0..strokes)
        .map(|_| {
            hand.play(&mut game);
            if game.phase() == Phase::RackOver {
                game.next_rack().expect("the rack is over");
            }
            game.clone()
        })
        .collect()
}

#[test]
fn what_is_on_disk_is_never_older_than_it_was_and_in_the_end_it_is_the_last() {
    let store = Store::in_folder(folder("matches-beside"));
    let went = as_it_went(40);
    let saver = Saver::new(store.clone());
    let mut newest = 0;
    for game in &went {
        saver.save(game);
        if let Ok(found) = store.load(AUTOSAVE) {
            let at = went.iter().position(|game| *game == found);
            let at = at.expect("what is on disk is whole, and one of the moments of the match");
            assert!(at >= newest, "{at} after {newest}");
            newest = at;
        }
    }
    saver.finish();
    assert_eq!(store.load(AUTOSAVE).expect("whole"), went[39]);
    let outcomes = saver.outcomes();
    assert!((1..=40).contains(&outcomes.len()), "{}", outcomes.len());
    assert!(outcomes.iter().all(Result::is_ok), "{outcomes:?}");
    assert!(saver.outcomes().is_empty());
    // Nothing is left half written.
    let files = fs::read_dir(store.folder()).expect("it is there").count();
    assert_eq!(files, 1);
    // Whoever lets go of it waits.
    saver.save(&went[7]);
    drop(saver);
    assert_eq!(store.load(AUTOSAVE).expect("whole"), went[7]);
}

#[test]
fn a_match_that_cannot_be_saved_goes_on_and_is_saved_when_it_can_be() {
    let place = folder("matches-blocked").join("matches");
    fs::write(&place, "a file where the folder should be").expect("the test may write");
    let store = Store::in_folder(&place);
    let mut session = Session::new(begin(&nine(), 3, 1), Some(store.clone()));
    session.input(Match::concede).expect("the rack is on");
    session.finish_saving();
    let saves = session.saves();
    let error = saves[0].as_ref().expect_err("there is no folder");
    let file = place.display().to_string();
    assert!(error.to_string().contains(&file), "{error}");
    assert_eq!(session.game().ends().len(), 1, "nothing is lost");
    fs::remove_file(&place).expect("the test may remove");
    session.input(Match::next_rack).expect("the rack is over");
    session.finish_saving();
    assert!(session.saves()[0].is_ok());
    let resumed = Session::resume(store).expect("it is whole");
    assert_eq!(resumed.game(), session.game());
}
