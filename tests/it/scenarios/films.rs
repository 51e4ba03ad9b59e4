//! `masse film`: what is refused, before anything is drawn.

use std::fs;
use std::path::PathBuf;

use super::command_line::{masse, text};

fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
        .join("films")
        .join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

#[track_caller]
fn refused(arguments: &[&str], code: i32, says: &str) {
    let run = masse(arguments);
    let told = text(&run.stderr);
    assert_eq!(run.status.code(), Some(code), "{arguments:?}: {told}");
    assert!(told.contains(says), "{arguments:?}: {told}");
}

#[test]
fn bad_numbers_sizes_and_scenes_are_named() {
    let out = folder("numbers").display().to_string();
    let film = ["film", "stop-shot", "--out", &out];
    for (option, value, says) in [
        ("--size", "1280", "such as 1280x720"),
        ("--size", "10x10", "from 64 to 8192"),
        ("--fps", "0", "from 1 to 240"),
        ("--fps", "NaN", "from 1 to 240"),
        ("--slow", "1000", "from 0.1 to 100"),
        ("--from", "-1", "from 0 to 3600"),
    ] {
        let value = format!("{option}={value}");
        refused(&[&film[..], &[&value]].concat(), 2, says);
    }
    refused(
        &["film", "no-such-shot", "--out", &out],
        2,
        "no built-in scene",
    );
    refused(&["film", "stop-shot"], 2, "--out");
    refused(&["film", "crowd-5750", "--out", &out], 2, "a crowd");
    let late = [&film[..], &["--from", "2", "--to", "1"]].concat();
    refused(&late, 2, "before it begins");
    let long = [&film[..], &["--fps", "240", "--slow", "100", "--to", "100"]].concat();
    refused(&long, 2, "frames are more than 99999");
    assert_eq!(fs::read_dir(&out).expect("it is there").count(), 0);
}

#[test]
fn frames_go_into_an_empty_folder_and_nowhere_else() {
    let full = folder("full");
    fs::write(full.join("frame-00001.png"), "of another film").expect("a file");
    let out = full.display().to_string();
    refused(&["film", "stop-shot", "--out", &out], 2, "not empty");
    let file = full.join("frame-00001.png").display().to_string();
    refused(
        &["film", "stop-shot", "--out", &file],
        2,
        "a folder is needed",
    );
    let below = format!("{file}/frames");
    refused(
        &["film", "stop-shot", "--out", &below],
        3,
        "cannot be written",
    );
    let kept = fs::read_to_string(full.join("frame-00001.png"));
    assert_eq!(kept.expect("it is there"), "of another film");
}

/// A build that cannot draw says so.
#[cfg(not(feature = "window"))]
#[test]
fn a_build_without_a_window_says_that_it_cannot_draw() {
    let out = folder("headless").display().to_string();
    refused(&["film", "stop-shot", "--out", &out], 5, "without a window");
}

#[test]
fn a_camera_that_is_not_there_is_named_with_those_that_are() {
    let out = folder("camera").display().to_string();
    for bad in ["3", "0", "above", "-1"] {
        let camera = format!("--camera={bad}");
        refused(
            &["film", "stop-shot", "--out", &out, &camera],
            2,
            "1 to 2 of this scene",
        );
    }
    let both = [
        "film",
        "stop-shot",
        "--out",
        &out,
        "--second",
        "follow",
        "--other-laws",
    ];
    refused(&both, 2, "cannot be used with");
}

#[cfg(feature = "window")]
#[test]
fn frames_are_numbered_pictures_of_the_size_asked_for() {
    let out = folder("frames");
    let path = out.display().to_string();
    let size = [
        "--size",
        "96x64",
        "--fps",
        "2",
        "--to",
        "1",
        "--quality",
        "low",
    ];
    let run = masse(&[&["film", "stop-shot", "--out", &path], &size[..]].concat());
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let mut names: Vec<String> = fs::read_dir(&out)
        .expect("it is there")
        .map(|entry| {
            entry
                .expect("a file")
                .file_name()
                .into_string()
                .expect("a name")
        })
        .collect();
    names.sort();
    assert_eq!(
        names,
        ["frame-00001.png", "frame-00002.png", "frame-00003.png"]
    );
    for name in names {
        let picture = image::open(out.join(name)).expect("a picture");
        assert_eq!((picture.width(), picture.height()), (96, 64));
    }
}
