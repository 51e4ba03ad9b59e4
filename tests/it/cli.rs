//! The program itself, run as a person runs it.

use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

use masse::physics::scene::{Solver, Stepped};
use serde_json::Value;

/// An empty folder of this name, below the folder that cargo gives to tests.
pub(crate) fn folder(name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("cargo's folder for tests can be written");
    path
}

/// The program without any display to open a window on.
pub(crate) fn masse() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_masse"));
    command
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET");
    command
}

pub(crate) fn output(command: &mut Command) -> Output {
    command.output().expect("the program starts")
}

pub(crate) fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("text")
}

pub(crate) fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("text")
}

#[test]
fn help_tells_examples_and_exit_codes() {
    let help = output(masse().arg("--help"));
    assert_eq!(help.status.code(), Some(0));
    for part in ["masse run", "EXAMPLES", "EXIT CODES", "bad input"] {
        assert!(out(&help).contains(part), "{part}");
    }
}

#[test]
fn run_writes_events_and_a_summary() {
    let arguments = ["run", "stun-shot", "--solver", "stepped"];
    let run = output(masse().args(arguments));
    assert_eq!(run.status.code(), Some(0), "{}", err(&run));
    let lines: Vec<Value> = out(&run)
        .lines()
        .map(|line| serde_json::from_str(line).expect("JSON"))
        .collect();
    let [header, events @ .., summary] = lines.as_slice() else {
        panic!("no lines");
    };
    assert_eq!(header["format"], "masse record");
    assert_eq!(events[0]["kind"], "strike");
    let hit = events
        .iter()
        .find(|event| event["kind"] == "ball_ball")
        .expect("a hit");
    assert_eq!(hit["who"], serde_json::json!(["cue", "1"]));
    assert_eq!(hit["before"].as_array().map(Vec::len), Some(2));
    assert_eq!(summary["summary"]["reason"], "rest");
    assert!(err(&run).contains("Stun shot"));
    // The text is the same every time, and every number has all its digits.
    assert_eq!(out(&run), out(&output(masse().args(arguments))));
    let mut scene = masse::scenarios::library::open("stun-shot")
        .expect("a scene")
        .scene;
    scene.solver = Solver::Stepped(Stepped::default());
    let (record, _) = masse::sim::stepping::run_to_rest(&scene);
    let x = summary["summary"]["end"][0]["position"][0]
        .as_f64()
        .expect("a number");
    assert_eq!(x.to_bits(), record.end[0].position.x.to_bits());
    for (event, line) in record.events.iter().zip(events) {
        assert_eq!(
            Some(event.time.to_bits()),
            line["time"].as_f64().map(f64::to_bits)
        );
        assert_eq!(
            Some(event.impulse.to_bits()),
            line["impulse"].as_f64().map(f64::to_bits)
        );
    }
}

#[test]
fn a_scene_written_out_in_full_runs_the_same() {
    let folder = folder("write");
    let written = output(
        masse()
            .args(["write", "break-nine", "nine.ron"])
            .current_dir(&folder),
    );
    assert_eq!(written.status.code(), Some(0), "{}", err(&written));
    let events = |scene: &str| {
        let text = out(&output(masse().args(["run", scene]).current_dir(&folder)));
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        lines.pop();
        lines.remove(0);
        lines
    };
    let direct = events("break-nine");
    assert!(direct.len() > 20);
    assert_eq!(direct, events("nine.ron"));
}

#[test]
fn out_and_picture_go_to_files() {
    let folder = folder("files");
    let run = output(
        masse()
            .args([
                "run",
                "masse",
                "--quiet",
                "--out",
                "m.jsonl",
                "--picture",
                "m.svg",
            ])
            .current_dir(&folder),
    );
    assert_eq!(run.status.code(), Some(0), "{}", err(&run));
    assert_eq!((out(&run), err(&run)), (String::new(), String::new()));
    let picture = std::fs::read_to_string(folder.join("m.svg")).expect("a picture");
    assert!(picture.starts_with("<svg") && picture.contains("polyline"));
    assert!(
        std::fs::read_to_string(folder.join("m.jsonl"))
            .expect("events")
            .ends_with("}\n")
    );
    for option in ["--out", "--picture"] {
        let refused = output(
            masse()
                .args(["run", "masse", option, "no/such/folder/file"])
                .current_dir(&folder),
        );
        assert_eq!(refused.status.code(), Some(3), "{}", err(&refused));
        assert!(
            err(&refused).contains("no/such/folder/file"),
            "{}",
            err(&refused)
        );
    }
}

#[test]
fn options_change_the_scene() {
    let run = output(masse().args([
        "run",
        "gas",
        "--tick",
        "0.01",
        "--grid",
        "none",
        "--time-limit",
        "0.05",
    ]));
    let text = out(&run);
    let summary: Value =
        serde_json::from_str(text.lines().last().expect("a summary")).expect("JSON");
    let summary = &summary["summary"];
    assert_eq!(summary["solver"]["Stepped"]["tick"], 0.01);
    assert_eq!(summary["solver"]["Stepped"]["grid"], Value::Null);
    assert_eq!(summary["reason"], "time_limit");
}

#[test]
fn the_exact_solver_can_be_asked_for() {
    let folder = folder("exact");
    let run = output(
        masse()
            .args([
                "run",
                "break-nine",
                "--solver",
                "exact",
                "--picture",
                "nine.svg",
            ])
            .current_dir(&folder),
    );
    assert_eq!(run.status.code(), Some(0), "{}", err(&run));
    let text = out(&run);
    let summary: Value =
        serde_json::from_str(text.lines().last().expect("a summary")).expect("JSON");
    assert_eq!(summary["summary"]["solver"], "Exact");
    assert_eq!(summary["summary"]["reason"], "rest");
    let picture = std::fs::read_to_string(folder.join("nine.svg")).expect("a picture");
    assert!(picture.matches("<polyline").count() >= 9);
    let both = output(masse().args(["run", "break-nine", "--solver", "exact", "--tick", "0.01"]));
    assert_eq!(both.status.code(), Some(2), "{}", err(&both));
}

#[test]
fn bad_options_are_named() {
    let cases: &[(&[&str], &str)] = &[
        (&["run", "gas", "--tick", "0"], "solver.tick: 0"),
        (&["run", "gas", "--tick", "NaN"], "solver.tick: NaN"),
        (&["run", "gas", "--tick", "fast"], "fast"),
        (&["run", "gas", "--grid", "20"], "20"),
        (&["run", "gas", "--grid", "0x3"], "solver.grid.0: 0"),
        (&["run", "gas", "--time-limit", "inf"], "time_limit: inf"),
        (
            &["run", "coursework-3-backspin", "--solver", "exact"],
            "Coursework",
        ),
        (&["run", "gas", "--solver", "guess"], "guess"),
        (&["run", "no-such-scene"], "`no-such-scene`"),
        (&["run", "no/such/file.ron"], "no/such/file.ron"),
        (&["run", "."], ".: "),
        (&["write", "no-such-scene", "x.ron"], "`no-such-scene`"),
        (&["play", "no-such-scene"], "`no-such-scene`"),
        (&["run"], "SCENE"),
        (&["dance"], "dance"),
    ];
    let folder = folder("options");
    for (arguments, part) in cases {
        let refused = output(masse().args(*arguments).current_dir(&folder));
        assert_eq!(
            refused.status.code(),
            Some(2),
            "{arguments:?}: {}",
            err(&refused)
        );
        assert!(
            err(&refused).contains(part),
            "{arguments:?} lacks {part}: {}",
            err(&refused)
        );
        assert!(refused.stdout.is_empty(), "{arguments:?}");
    }
    assert_eq!(
        std::fs::read_dir(&folder).expect("a folder").count(),
        0,
        "something was written"
    );
}

#[test]
fn bad_scene_files_are_named_with_place_and_value() {
    let ball = |fields: &str| {
        format!(
            "(table: NineFoot, balls: [(name: \"cue\", position: (-1, 0)), (name: \"1\", {fields})])"
        )
    };
    let nested = "[".repeat(10_000_000);
    let cases: Vec<(String, &[&str])> = vec![
        (String::new(), &["bad.ron:1:1"]),
        (
            "(table: NineFoot,\n balls: [(name: \"cue\"".to_owned(),
            &["bad.ron:2:"],
        ),
        (nested, &["bad.ron:1:"]),
        (
            "(table: TenFoot)".to_owned(),
            &["bad.ron:1:", "TenFoot", "NineFoot"],
        ),
        ("(balls: [])".to_owned(), &["bad.ron: table", "preset"]),
        (
            "(table: NineFoot, balls: [])".to_owned(),
            &["balls", "0 balls"],
        ),
        (
            ball("position: (-0.99, 0)"),
            &["`cue`", "`1`", "overlap by 0.047"],
        ),
        (
            ball("position: (0.5, 0.62)"),
            &["`1`", "inside cushion", "0.0125"],
        ),
        (ball("position: (NaN, 0)"), &["position.x: NaN"]),
        (ball("position: (0, inf)"), &["position.z: inf"]),
        (ball("position: (0, 0), mass: 0"), &["(`1`).mass: 0"]),
        (ball("position: (0, 0), mass: -1"), &["(`1`).mass: -1"]),
        (ball("position: (0, 0), radius: 0"), &["(`1`).radius: 0"]),
        (
            ball("position: (0, 0), radius: -0.5"),
            &["(`1`).radius: -0.5"],
        ),
        (
            ball("position: (0, 0), mass: \"light\""),
            &["bad.ron:1:", "light"],
        ),
        (
            ball("position: (0, 0), weight: 1"),
            &["bad.ron:1:", "weight", "mass"],
        ),
        (
            "(table: Box(length: 0.02, width: 0.02), balls: [(name: \"cue\", position: (0, 0))])"
                .to_owned(),
            &["table", "0.02", "`cue`"],
        ),
    ];
    let folder = folder("bad");
    for (text, parts) in &cases {
        std::fs::write(folder.join("bad.ron"), text)
            .expect("cargo's folder for tests can be written");
        let arguments = [
            "run",
            "bad.ron",
            "--out",
            "out.jsonl",
            "--picture",
            "out.svg",
        ];
        let refused = output(masse().args(arguments).current_dir(&folder));
        let (shown, message) = (&text[..text.len().min(160)], err(&refused));
        assert_eq!(refused.status.code(), Some(2), "{shown}: {message}");
        assert!(refused.stdout.is_empty(), "{shown}");
        assert!(
            message.contains("bad.ron") && !message.contains("panicked"),
            "{shown}: {message}"
        );
        for part in *parts {
            assert!(message.contains(part), "{shown}\n  lacks {part}: {message}");
        }
        assert_eq!(
            std::fs::read_dir(&folder).expect("a folder").count(),
            1,
            "{shown}: something was written"
        );
    }
    std::fs::write(folder.join("bad.ron"), [0xff, 0xfe, 0x00])
        .expect("cargo's folder for tests can be written");
    let refused = output(masse().args(["run", "bad.ron"]).current_dir(&folder));
    assert_eq!(refused.status.code(), Some(2));
    assert!(err(&refused).contains("byte 0"), "{}", err(&refused));
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    for arguments in [&["list"][..], &["run", "gas"], &["--help"]] {
        let mut child = masse()
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        drop(child.stdout.take());
        let done = child.wait_with_output().expect("the program ends");
        assert_eq!(done.status.code(), Some(0), "{arguments:?}: {}", err(&done));
        assert!(
            !err(&done).contains("panicked"),
            "{arguments:?}: {}",
            err(&done)
        );
    }
}

#[test]
#[cfg(target_os = "linux")]
fn without_a_display_the_break_is_drawn() {
    let folder = folder("no-display");
    let played = output(masse().current_dir(&folder));
    assert_eq!(played.status.code(), Some(0), "{}", err(&played));
    assert_eq!(
        err(&played).lines().count(),
        1,
        "one plain sentence: {}",
        err(&played)
    );
    assert!(
        out(&played).contains("every ball is at rest"),
        "{}",
        out(&played)
    );
    let picture = std::fs::read_to_string(folder.join("masse-break.svg")).expect("a picture");
    assert!(picture.contains("Eight-ball break"));
}
