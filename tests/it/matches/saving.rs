//! Matches on disk: resumed with the same bits, replaced whole, never over a file that is no good.

use std::fs;

use masse::game::matches::saved::VERSION;
use masse::game::matches::store::{AUTOSAVE, StoreError};
use masse::game::matches::{Phase, SavedError, Session, Store};
use masse::game::rules::Game;
use masse::physics::cue::Shot;
use masse::physics::exact::{Limits, solve};

use super::{Hand, begin};
use crate::cli::folder;

fn played(name: &str, strokes: usize) -> masse::game::matches::Match {
    let game = Game::named(name).expect("there is such a game");
    let mut played = begin(&game, 20, 4);
    let mut hand = Hand::new(4);
    for _ in 0..strokes {
        hand.play(&mut played);
        if played.phase() == Phase::RackOver {
            played.next_rack().expect("the rack is over");
        }
    }
    played
}

#[test]
fn a_match_of_every_game_is_resumed_as_it_was_and_goes_on_with_the_same_bits() {
    let store = Store::in_folder(folder("matches-resumed"));
    for game in Game::all() {
        let name = game.rules().code().name;
        let file = name.replace('.', "_");
        let mut before = played(name, 12);
        assert!(
            store
                .save(&file, &before)
                .expect("it can be written")
                .put_aside
                .is_none()
        );
        let mut after = store.load(&file).expect("it is whole");
        assert_eq!(before, after, "{name}");
        let (mut one, mut other) = (Hand::new(9), Hand::new(9));
        for _ in 0..4 {
            if before.phase() == Phase::RackOver {
                break;
            }
            assert_eq!(one.play(&mut before), other.play(&mut after), "{name}");
        }
        assert_eq!(before, after, "{name}");
    }
    assert_eq!(store.names().len(), Game::all().len());
}

#[test]
fn a_session_saves_itself_after_every_shot_and_goes_on_from_there() {
    let store = Store::in_folder(folder("matches-session").join("new folder"));
    let mut session = Session::new(
        begin(&Game::named("9-ball").expect("9-ball"), 3, 1),
        Some(store.clone()),
    );
    for shots in 1..=4 {
        if session.game().phase() == Phase::Choose {
            let choice = session.game().targets().choices[0];
            session.choose(choice).expect("offered");
        }
        let shot = Shot {
            speed: 2.0,
            heading: 0.3,
            ..Shot::default()
        };
        let record = solve(&session.game().scene_with(shot), Limits::default()).expect("played");
        session.played(shot, &record, 0.5).expect("a stroke is due");
        session.finish_saving();
        let saved = session.saves().pop().expect("it has a store");
        let saved = saved.expect("it can be written");
        assert_eq!(saved.path, store.path(AUTOSAVE).expect("a name"));
        let resumed = Session::resume(store.clone()).expect("it is whole");
        assert_eq!(resumed.game(), session.game());
        assert_eq!(resumed.game().shots().len(), shots);
    }
    let concede = session.input(masse::game::matches::Match::concede);
    assert_eq!(concede, Ok(()));
    // The last save is waited for.
    drop(session);
    assert_eq!(store.load(AUTOSAVE).expect("whole").ends().len(), 1);
    // Without a store a match is played all the same.
    let mut loose = Session::new(begin(&Game::named("9-ball").expect("9-ball"), 3, 1), None);
    loose
        .input(masse::game::matches::Match::concede)
        .expect("the rack is on");
    loose.finish_saving();
    assert!(loose.saves().is_empty());
}

#[test]
fn a_damaged_file_is_kept_and_never_overwritten() {
    let store = Store::in_folder(folder("matches-damaged"));
    let game = played("8-ball", 3);
    let path = store.save("mine", &game).expect("it can be written").path;
    let whole = fs::read(&path).expect("it is there");
    for (number, damage) in (1..).zip([
        whole[..whole.len() / 2].to_vec(),
        b"nonsense".to_vec(),
        vec![],
        vec![0xff; 9],
    ]) {
        fs::write(&path, &damage).expect("the test may write");
        let error = store.load("mine").expect_err("it is damaged").to_string();
        assert!(error.contains("mine.masse"), "{error}");
        assert_eq!(
            fs::read(&path).expect("it is there"),
            damage,
            "reading changes nothing"
        );
        let saved = store.save("mine", &game).expect("it can be written");
        let (aside, why) = saved.put_aside.expect("the damaged file is put aside");
        assert!(!why.to_string().is_empty());
        assert_eq!(fs::read(&aside).expect("it is kept"), damage);
        assert!(
            aside.ends_with(format!("mine damaged {number}.masse")),
            "{}",
            aside.display()
        );
        assert_eq!(store.load("mine").expect("the new one is whole"), game);
    }
    assert_eq!(store.names().len(), 5);
}

#[test]
fn a_file_of_a_newer_program_says_so_and_is_kept() {
    let store = Store::in_folder(folder("matches-newer"));
    let game = played("8-ball", 2);
    let path = store.save("mine", &game).expect("it can be written").path;
    let text = fs::read_to_string(&path).expect("it is there");
    let newer = text.replacen(&format!("\"version\":{VERSION}"), "\"version\":7", 1);
    fs::write(&path, &newer).expect("the test may write");
    let error = store.load("mine").expect_err("it is newer");
    assert!(matches!(error, SavedError::Newer { version: 7, .. }));
    assert!(
        error.to_string().contains("version: 7 is newer than 1"),
        "{error}"
    );
    let (aside, _) = store
        .save("mine", &game)
        .expect("written")
        .put_aside
        .expect("put aside");
    assert!(aside.ends_with("mine newer 1.masse"));
    assert_eq!(fs::read_to_string(aside).expect("it is kept"), newer);
}

#[test]
fn what_cannot_be_written_leaves_the_old_file() {
    let place = folder("matches-unwritable");
    let store = Store::in_folder(&place);
    let game = played("8-ball", 1);
    for name in ["", "../up", "a/b", "a.b", " a", "nul\0", &"x".repeat(101)] {
        assert!(
            matches!(store.save(name, &game), Err(StoreError::Name { .. })),
            "{name:?}"
        );
    }
    assert!(store.save("Größe 1_2-3", &game).is_ok());
    // What a crash left half written beside is no match.
    fs::write(place.join(".tmpA1b2"), "half").expect("the test may write");
    assert_eq!(store.names(), ["Größe 1_2-3"]);
    let blocked = place.join("file");
    fs::write(&blocked, "a file where the folder should be").expect("the test may write");
    let error = Store::in_folder(&blocked)
        .save("mine", &game)
        .expect_err("no folder");
    assert!(matches!(error, StoreError::Write { .. }), "{error}");
    assert!(matches!(
        Store::in_folder(place.join("none")).load("mine"),
        Err(SavedError::Read { .. })
    ));
    assert!(Store::in_folder(place.join("none")).names().is_empty());
}

#[test]
fn the_platform_has_a_place_for_matches() {
    if let Some(store) = Store::of_platform() {
        assert!(store.folder().is_absolute() && store.folder().ends_with("matches"));
    }
}
