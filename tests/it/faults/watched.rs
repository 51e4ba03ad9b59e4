//! Files that are removed, edited or replaced while they are played with.

use std::fs;
use std::path::{Path, PathBuf};

use bevy::prelude::*;
use masse::game::equip::{ChoosePreset, OpenScene, Told};
use masse::physics::laws::Laws;
use masse::sim::playfield::Playfield;
use masse::sim::stepping;

use super::{frame, moves, strike, to_rest};
use crate::window::blind;

/// The windowed program, at a table of this preset file.
fn at_preset(file: &Path) -> App {
    let mut app = blind();
    frame(&mut app, 0.016);
    app.world_mut()
        .write_message(ChoosePreset(file.display().to_string()));
    look(&mut app);
    app
}

/// Looks at the files for a second, and gives what is told of them.
fn look(app: &mut App) -> Vec<Told> {
    let mut all = Vec::new();
    for _ in 0..12 {
        frame(app, 0.1);
        let told = app.world().resource::<Messages<Told>>();
        all.extend(told.iter_current_update_messages().cloned());
    }
    all
}

fn laws(app: &App) -> Laws {
    app.world().resource::<Playfield>().laws
}

fn restitution(app: &App) -> f64 {
    laws(app).cushion.restitution(1.0)
}

fn preset(restitution: f64) -> String {
    format!("(base: \"pool\", set: {{\"laws.cushion.restitution\": {restitution}}})")
}

/// Every way to spoil a file; what it was is put there again by whoever calls.
fn spoil(way: usize, path: &PathBuf, whole: &str) -> bool {
    let _ = fs::remove_file(path);
    let spoilt: Vec<u8> = match way {
        0 => return true,
        1 => {
            fs::create_dir(path).expect("a folder in its place");
            return true;
        }
        2 => Vec::new(),
        3 => whole.as_bytes()[..whole.len() / 2].to_vec(),
        4 => (0..5000_u32).map(|i| (i * 2_654_435_761) as u8).collect(),
        5 => vec![b'('; 1 << 26],
        6 => whole.replace("0.7", "-0.7").into_bytes(),
        _ => return false,
    };
    fs::write(path, spoilt).expect("it is writable");
    true
}

fn remove(path: &Path) {
    if path.is_dir() {
        fs::remove_dir(path).expect("it is empty");
    } else {
        let _ = fs::remove_file(path);
    }
}

#[test]
fn a_watched_preset_that_is_spoilt_in_any_way_changes_nothing_and_may_come_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("mine.ron");
    fs::write(&path, preset(0.8)).expect("it is writable");
    let mut app = at_preset(&path);
    assert_eq!(restitution(&app), 0.8);
    let whole = preset(0.7);
    let mut way = 0;
    while spoil(way, &path, &whole) {
        let told = look(&mut app);
        let [one] = told.as_slice() else {
            panic!("way {way}: told {told:?}");
        };
        assert!(one.is_failure && one.text.key == "notice-file-no-good");
        let text = &one.text.english;
        assert!(text.contains("mine.ron"), "{text}");
        assert!(text.contains("Playing on"), "{text}");
        assert!(text.len() < 1000, "{text}");
        assert_eq!(restitution(&app), 0.8, "way {way}");
        // It comes back, and is played with.
        remove(&path);
        fs::write(&path, &whole).expect("it is writable");
        let told = look(&mut app);
        assert!(told.iter().all(|told| !told.is_failure), "{told:?}");
        assert_eq!(restitution(&app), 0.7, "way {way}");
        remove(&path);
        fs::write(&path, preset(0.8)).expect("it is writable");
        look(&mut app);
        assert_eq!(restitution(&app), 0.8, "way {way}");
        way += 1;
    }
    assert_eq!(way, 7);
}

#[test]
fn a_scene_whose_file_is_gone_is_played_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.ron");
    let text = |set: &str| {
        format!(
            "(title: \"Mine\", preset: \"pool\", {set}balls: \
             [(name: \"cue\", position: (0, 0)), (name: \"1\", position: (0.5, 0))])"
        )
    };
    fs::write(&path, text("")).expect("it is writable");
    let mut app = blind();
    frame(&mut app, 0.016);
    let name = path.display().to_string();
    app.world_mut()
        .write_message(OpenScene { name, play: false });
    let told = look(&mut app);
    assert!(told.iter().all(|told| !told.is_failure), "{told:?}");
    let lies = stepping::states(&mut app);
    assert_eq!(lies.len(), 2);
    let before = laws(&app);
    fs::remove_file(&path).expect("it is there");
    let told = look(&mut app);
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0].is_failure && told[0].text.english.contains("scene.ron"));
    assert_eq!(laws(&app), before);
    assert_eq!(stepping::states(&mut app), lies);
    strike(&mut app);
    frame(&mut app, 0.1);
    assert!(moves(&app), "it can be played");
    to_rest(&mut app);
    let set = "set: {\"laws.cushion.restitution\": 0.6}, ";
    fs::write(&path, text(set)).expect("it is writable");
    look(&mut app);
    assert_eq!(restitution(&app), 0.6);
}

#[test]
fn a_file_edited_while_a_shot_rolls_changes_the_next_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("mine.ron");
    let ends = |edited: bool| {
        fs::write(&path, preset(0.8)).expect("it is writable");
        let mut app = at_preset(&path);
        strike(&mut app);
        frame(&mut app, 1.0 / 60.0);
        if edited {
            fs::write(&path, preset(0.5)).expect("it is writable");
            let told = look(&mut app);
            assert!(
                told.iter()
                    .any(|told| told.text.key == "notice-file-changed")
            );
            assert!(moves(&app), "it still rolls");
            assert_eq!(restitution(&app), 0.8, "the shot keeps its laws");
        }
        let end = to_rest(&mut app);
        frame(&mut app, 0.1);
        (end, restitution(&app))
    };
    let (undisturbed, _) = ends(false);
    let (end, next) = ends(true);
    assert_eq!(end, undisturbed);
    assert_eq!(next, 0.5);
}
