//! Settings: what is saved comes back, and no kind of damage loses a file or stops the program.

use std::fs;
use std::path::{Path, PathBuf};

use bevy::prelude::*;
use masse::game::GamePlugin;
use masse::game::equip::Told;
use masse::game::settings::file::{self, VERSION};
use masse::game::settings::{ClothColour, Settings, SettingsFile};
use masse::sim::SimPlugin;
use tempfile::TempDir;

fn folder() -> TempDir {
    tempfile::tempdir().expect("there is room for a folder")
}

fn changed() -> Settings {
    let mut settings = Settings {
        language: Some("fr".to_owned()),
        scale: 1.25,
        reduced_motion: true,
        cloth: ClothColour::Burgundy,
        ..Settings::default()
    };
    settings.volume.rolling = 0.3;
    settings.toggles.stroke = true;
    settings.marks.patterns = true;
    let controls = vec!["Key KeyA".to_owned(), "Pad South".to_owned()];
    settings.bindings.insert("Strike".to_owned(), controls);
    settings
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .expect("the folder is there")
        .map(|entry| {
            let name = entry.expect("it can be listed").file_name();
            name.to_string_lossy().into_owned()
        })
        .collect();
    names.sort();
    names
}

#[test]
fn what_is_saved_comes_back_and_nothing_else_lies_about() {
    let folder = folder();
    let path = folder.path().join("deep/inside/settings.ron");
    for settings in [Settings::default(), changed()] {
        file::save(&path, &settings).expect("it can be saved");
        let (loaded, damage) = file::load(&path);
        assert!(damage.is_none());
        assert_eq!(loaded, settings);
    }
    let inside = path.parent().expect("it has a folder");
    assert_eq!(names(inside), ["settings.ron"]);
}

#[test]
fn a_first_start_finds_no_file_and_says_nothing() {
    let (settings, damage) = file::load(&folder().path().join("settings.ron"));
    assert!(damage.is_none());
    assert_eq!(settings, Settings::default());
}

#[test]
fn what_a_file_leaves_out_has_its_default() {
    let settings = file::parse("(version: 1, scale: 2.0)").expect("it is good");
    let defaults = Settings::default();
    assert_eq!(settings.scale, 2.0);
    assert_eq!(settings.volume, defaults.volume);
}

/// Kinds of damage, and what the explanation names.
fn damages() -> Vec<(Vec<u8>, &'static str)> {
    let whole = ron::to_string(&changed()).expect("it can be written");
    let text = |text: &str| text.as_bytes().to_vec();
    vec![
        (Vec::new(), "1:1"),
        (text("\0\0\0\0\0\0\0\0"), "1:1"),
        (text(&whole[..whole.len() / 2]), "1:"),
        (b"(version: 1, language: Some(\"\xff\xfe\"))".to_vec(), "29"),
        (text("(scale: 1.0)"), "version"),
        (text("(version: 1, colour: 3)"), "colour"),
        (text("(version: 1, scale: \"large\")"), "1:"),
        (text("(version: 1, scale: NaN)"), "scale: NaN"),
        (text("(version: 1, scale: 40.0)"), "scale: 40"),
        (
            text("(version: 1, volume: (cue: -0.5))"),
            "volume.cue: -0.5",
        ),
        (
            text("(version: 1, volume: (level: inf))"),
            "volume.level: inf",
        ),
        (text("(version: 1, cloth: Tartan)"), "Tartan"),
        (text("(version: 0)"), "0 is no version"),
        (text("(version: 2, hologram: On)"), "2 is newer than 1"),
        (text("(version: -1)"), "1:"),
        (
            vec![b'x'; (1 << 20) + 1],
            "1048577 bytes are more than the 1048576",
        ),
    ]
}

#[test]
fn every_damaged_file_is_explained_and_kept_bit_for_bit() {
    assert_eq!(VERSION, 1, "the newer versions above are newer");
    let folder = folder();
    let path = folder.path().join("settings.ron");
    for (i, (bytes, named)) in damages().into_iter().enumerate() {
        fs::write(&path, &bytes).expect("it can be written");
        let (settings, damage) = file::load(&path);
        let damage = damage.unwrap_or_else(|| panic!("{named}: nothing was found"));
        assert_eq!(settings, Settings::default());
        let reason = damage.error.to_string();
        assert!(reason.contains(named), "{named}: {reason}");
        let kept = damage.kept.expect("it can be renamed");
        assert_eq!(fs::read(&kept).expect("it is there"), bytes, "{named}");
        assert!(!path.exists());
        // Those before are still there.
        assert_eq!(names(folder.path()).len(), i + 1);
    }
}

/// A program without a window that keeps its settings in this file.
fn app(path: PathBuf) -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, SimPlugin))
        .insert_resource(SettingsFile(Some(path)))
        .add_plugins(GamePlugin);
    app.finish();
    app.cleanup();
    app
}

fn told(app: &mut App) -> Vec<Told> {
    let mut told = app.world_mut().resource_mut::<Messages<Told>>();
    told.drain().collect()
}

#[test]
fn the_program_loads_tells_of_damage_and_saves_once_a_change_has_settled() {
    let folder = folder();
    let path = folder.path().join("settings.ron");
    fs::write(&path, "(version: 1, scale: 99)").expect("it can be written");
    let mut app = app(path.clone());
    app.update();
    let said = told(&mut app);
    assert_eq!(said.len(), 1);
    assert!(said[0].is_failure);
    let text = &said[0].text;
    assert_eq!(text.key, "notice-settings-damaged");
    for part in ["settings.ron", "scale: 99", "0.5 and 3", ".damaged-1"] {
        assert!(text.english.contains(part), "{part}: {}", text.english);
    }
    assert_eq!(names(folder.path()), ["settings.ron.damaged-1"]);

    app.world_mut().resource_mut::<Settings>().scale = 1.5;
    app.update();
    assert!(!path.exists(), "a change settles first");
    std::thread::sleep(std::time::Duration::from_millis(600));
    app.update();
    assert_eq!(file::load(&path).0.scale, 1.5);
    assert!(told(&mut app).is_empty());

    app.world_mut().resource_mut::<Settings>().scale = 1.75;
    app.world_mut().write_message(AppExit::Success);
    app.update();
    assert_eq!(file::load(&path).0.scale, 1.75, "the end waits for nothing");
}

#[test]
fn what_cannot_be_saved_is_told_and_the_program_goes_on() {
    let folder = folder();
    let in_the_way = folder.path().join("file");
    fs::write(&in_the_way, "no folder").expect("it can be written");
    let mut app = app(in_the_way.join("settings.ron"));
    app.update();
    // A file stands where the folder should be: reading fails and so does renaming.
    let said = told(&mut app);
    assert!(said.iter().all(|told| told.is_failure));
    assert_eq!(said.len(), 1);
    app.world_mut().resource_mut::<Settings>().scale = 2.0;
    app.world_mut().write_message(AppExit::Success);
    app.update();
    assert_eq!(app.world().resource::<Settings>().scale, 2.0);
    assert_eq!(fs::read(&in_the_way).expect("it is there"), b"no folder");
}
