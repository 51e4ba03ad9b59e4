//! A full disk, and folders that cannot be written.
//!
//! The system is asked not to let files grow beyond some bytes: what is written then fails half way, as on a full disk.

use bevy::prelude::*;
use masse::game::equip::Told;
use masse::game::matches::Store;
use masse::game::settings::{Settings, SettingsFile, file};
use masse::game::turns::{MatchStore, TurnCommand, TurnNews, Turns};

use super::{begin, frame, table};

/// What is told while this runs for so many frames of half a second.
fn told(app: &mut App, frames: usize) -> Vec<Told> {
    let mut all = Vec::new();
    for _ in 0..frames {
        frame(app, 0.5);
        let told = app.world().resource::<Messages<Told>>();
        all.extend(told.iter_current_update_messages().cloned());
    }
    all
}

/// Whether the match could not be saved, and whether it could be again, in the last frame.
fn saved(app: &App) -> (bool, bool) {
    let news = app.world().resource::<Messages<TurnNews>>();
    let any = |what: fn(&TurnNews) -> bool| news.iter_current_update_messages().any(what);
    (
        any(|news| matches!(news, TurnNews::NotSaved(_))),
        any(|news| matches!(news, TurnNews::SavedAgain)),
    )
}

fn settings_at(path: std::path::PathBuf) -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, masse::sim::SimPlugin))
        .insert_resource(SettingsFile(Some(path)))
        .add_plugins(masse::game::GamePlugin);
    app.finish();
    app.cleanup();
    frame(&mut app, 0.016);
    app
}

#[test]
fn settings_that_cannot_be_saved_are_told_of_once_and_saved_when_they_can_be() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = folder.path().join("masse");
    let path = place.join("settings.ron");
    let mut app = settings_at(path.clone());
    std::fs::write(&place, "a file where the folder should be").expect("the test may write");
    app.world_mut().resource_mut::<Settings>().scale = 1.5;
    let said = told(&mut app, 60);
    let [one] = said.as_slice() else {
        panic!("{said:?}");
    };
    assert!(one.is_failure && one.text.english.contains("settings.ron"));
    std::fs::remove_file(&place).expect("the test may remove");
    assert!(told(&mut app, 12).is_empty());
    assert_eq!(file::load(&path).0.scale, 1.5);
    // The next change is saved as soon as ever.
    app.world_mut().resource_mut::<Settings>().scale = 1.25;
    told(&mut app, 3);
    assert_eq!(file::load(&path).0.scale, 1.25);
}

#[test]
fn what_could_not_be_saved_is_tried_once_more_at_the_end() {
    for free in [true, false] {
        let folder = tempfile::tempdir().expect("a folder");
        let (settings, matches) = (
            folder.path().join("settings"),
            folder.path().join("matches"),
        );
        let path = settings.join("settings.ron");
        let mut app = settings_at(path.clone());
        for place in [&settings, &matches] {
            std::fs::write(place, "a file where the folder should be").expect("it is writable");
        }
        masse::sim::playfield::lay_out(app.world_mut(), &masse::game::practice::opening());
        app.insert_resource(MatchStore(Some(Store::in_folder(&matches))));
        app.world_mut().resource_mut::<Settings>().scale = 1.5;
        begin(&mut app);
        app.world_mut().write_message(TurnCommand::Concede);
        let mut unsaved = false;
        for _ in 0..200 {
            std::thread::sleep(std::time::Duration::from_millis(2));
            frame(&mut app, 0.01);
            unsaved |= saved(&app).0;
        }
        assert!(unsaved, "it is told that the match is not saved");
        if free {
            for place in [&settings, &matches] {
                std::fs::remove_file(place).expect("the test may remove");
            }
        }
        app.world_mut().write_message(AppExit::Success);
        let said = told(&mut app, 1);
        assert_eq!(saved(&app), (!free, free), "what came of it is told");
        let settings_failed = said.iter().any(|told| told.is_failure);
        assert_eq!(settings_failed, !free, "{said:?}");
        if free {
            let kept = Store::in_folder(&matches).load("autosave").expect("whole");
            assert_eq!(Some(&kept), app.world().resource::<Turns>().game());
            assert_eq!(file::load(&path).0.scale, 1.5);
        }
    }
}

#[cfg(unix)]
mod full {
    use std::ffi::OsStr;
    use std::fs;
    use std::path::{Path, PathBuf};
    use std::process::Command;

    use masse::physics::scene::Scene;
    use masse::scenarios::file::Scenario;
    use masse::scenarios::library;
    use masse::scenarios::own::Own;

    use super::*;
    use crate::cli::{err, folder, masse, out, output};

    /// Where the test within finds what is kept.
    const FOLDER: &str = "MASSE_TEST_FULL_DISK";

    /// This command where no file may have more than so many blocks of half a kilobyte, or of one.
    fn limited(blocks: u32, program: &OsStr, arguments: &[&str]) -> Command {
        let mut command = Command::new("sh");
        // Without the trap the system would end the program.
        command
            .args(["-c", "trap '' XFSZ; ulimit -f \"$0\"; exec \"$@\""])
            .arg(blocks.to_string())
            .arg(program)
            .args(arguments)
            .env_remove("DISPLAY")
            .env_remove("WAYLAND_DISPLAY");
        command
    }

    fn files(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
        let entries = fs::read_dir(folder).expect("a folder");
        let mut all: Vec<_> = entries
            .map(|entry| entry.expect("an entry").path())
            .map(|path| {
                let bytes = if path.is_dir() {
                    files(&path)
                        .into_iter()
                        .flat_map(|(_, bytes)| bytes)
                        .collect()
                } else {
                    fs::read(&path).expect("it is readable")
                };
                (path, bytes)
            })
            .collect();
        all.sort();
        all
    }

    #[test]
    fn a_command_that_finds_the_disk_full_leaves_the_old_file() {
        let folder = folder("disk-full");
        let program = masse().get_program().to_owned();
        let commands: [&[&str]; 6] = [
            &["write", "snooker", "table.ron"],
            &["write", "break-nine", "scene.ron"],
            &["run", "break-nine", "--quiet", "--out", "record.jsonl"],
            &["run", "stun-shot", "--quiet", "--picture", "paths.svg"],
            &["picture", "stun-shot", "picture.png"],
            &["picture", "break-nine", "picture.svg", "--before"],
        ];
        for arguments in commands {
            let path = arguments.iter().rfind(|word| word.contains('.'));
            let path = folder.join(path.expect("a file"));
            let name = path.file_name().expect("a name").to_string_lossy();
            fs::write(&path, "what somebody made").expect("it is writable");
            let before = files(&folder);
            let mut command = limited(1, &program, arguments);
            let full = output(command.current_dir(&folder));
            assert_eq!(full.status.code(), Some(3), "{arguments:?}: {}", err(&full));
            assert!(err(&full).contains(&*name), "{}", err(&full));
            assert!(err(&full).contains("cannot be written"), "{}", err(&full));
            assert_eq!(files(&folder), before, "{arguments:?}");
            let whole = output(masse().args(arguments).current_dir(&folder));
            assert_eq!(whole.status.code(), Some(0), "{}", err(&whole));
            let written = fs::read(&path).expect("it is there");
            assert!(
                written.len() > 1024,
                "{arguments:?} is longer than the disk was"
            );
        }
        // A stream is written to as it is.
        let stream = output(masse().args(["write", "snooker", "/dev/stdout"]));
        assert!(out(&stream).contains("snooker"), "{}", err(&stream));
    }

    /// Runs the test below where nothing can be written at all.
    #[test]
    fn everything_kept_survives_a_full_disk() {
        let folder = folder("disk-full-game");
        let own = Own::in_folder(folder.join("scenes"));
        own.save("mine", &scenario()).expect("there is room yet");
        file::save(&folder.join("settings.ron"), &Settings::default()).expect("there is room yet");
        let mut app = table();
        app.insert_resource(MatchStore(Some(Store::in_folder(folder.join("matches")))));
        begin(&mut app);
        app.world_mut().write_message(TurnCommand::Concede);
        frame(&mut app, 0.1);
        app.world_mut().write_message(AppExit::Success);
        frame(&mut app, 0.1);
        let before = files(&folder);
        assert_eq!(before.len(), 3);
        let program = std::env::current_exe().expect("this test");
        let inside = "faults::disk::full::where_nothing_can_be_written";
        let arguments = [inside, "--exact", "--ignored", "--nocapture"];
        let mut command = limited(0, program.as_os_str(), &arguments);
        let inside = output(command.env(FOLDER, &folder));
        assert!(inside.status.success(), "{}{}", out(&inside), err(&inside));
        assert!(out(&inside).contains("1 passed"), "{}", out(&inside));
        assert_eq!(
            files(&folder),
            before,
            "nothing is lost, nothing is left half written"
        );
    }

    fn scenario() -> Scenario {
        library::open("stun-shot").expect("a built-in scene")
    }

    #[test]
    #[ignore = "is run by the test above, on a disk that is full"]
    fn where_nothing_can_be_written() {
        let Some(folder) = std::env::var_os(FOLDER).map(PathBuf::from) else {
            return;
        };
        let own = Own::in_folder(folder.join("scenes"));
        for name in ["mine", "new"] {
            let mut other = scenario();
            other.title.push_str(", changed");
            let error = own.save(name, &other).expect_err("there is no room");
            assert!(
                error.to_string().contains(&format!("{name}.ron")),
                "{error}"
            );
        }
        let kept = masse::kept::add(&folder, 1, |number| format!("photo-{number}"), [7; 99]);
        assert!(kept.is_err());
        let mut app = settings_at(folder.join("settings.ron"));
        masse::sim::playfield::lay_out(app.world_mut(), &Scene::clone(&scenario().scene));
        app.insert_resource(MatchStore(Some(Store::in_folder(folder.join("matches")))));
        app.world_mut().write_message(TurnCommand::Resume);
        frame(&mut app, 0.1);
        app.world_mut().write_message(TurnCommand::NextRack);
        app.world_mut().resource_mut::<Settings>().scale = 1.5;
        let mut unsaved = false;
        for _ in 0..200 {
            std::thread::sleep(std::time::Duration::from_millis(2));
            frame(&mut app, 0.1);
            unsaved |= saved(&app).0;
        }
        assert!(unsaved, "it is told that the match is not saved");
        let turns = app.world().resource::<Turns>();
        let phase = turns.phase();
        assert!(phase.is_some(), "the match goes on");
        app.world_mut().write_message(AppExit::Success);
        let said = told(&mut app, 1);
        assert!(saved(&app).0 && said.iter().any(|told| told.is_failure));
    }
}
