//! Scenarios on the command line.

use std::path::PathBuf;
use std::process::{Command, Output};

use masse::report::record_file;
use serde_json::Value;

pub(super) fn masse(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_masse"))
        .args(arguments)
        .output()
        .expect("the program starts")
}

/// A file in a folder of its own.
pub(super) fn file(folder: &str, name: &str, text: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
        .join("scenarios")
        .join(folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join(name);
    std::fs::write(&path, text).expect("a file");
    path
}

pub(super) fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("text")
}

fn scene(expect: &str) -> String {
    format!(
        r#"(title: "T", table: NineFoot, balls: [(name: "cue", position: (-0.6, 0)), (name: "1", position: (0, 0))],
            shot: (ball: "cue", speed: 1), expect: [{expect}])"#
    )
}

#[test]
fn run_tells_each_expectation_and_ends_with_1_on_a_miss() {
    let good = r#"Order([Hit("cue", "1")]), Speed(ball: "1", least: 0.5, when: After("cue", "1"))"#;
    let bad = r#"Stays(ball: "cue"), Potted(ball: "1", pocket: "side left")"#;
    for (name, expect, code) in [("good.ron", good, 0), ("bad.ron", bad, 1)] {
        let path = file("run", name, &scene(expect));
        let run = masse(&["run", &path.display().to_string()]);
        assert_eq!(run.status.code(), Some(code), "{}", text(&run.stderr));
        let told = text(&run.stderr);
        assert_eq!(
            told.matches("\n  met: ").count(),
            2 - code as usize,
            "{told}"
        );
        assert_eq!(
            told.matches("\n  MISSED: ").count(),
            code as usize,
            "{told}"
        );
        // The record says so too, and reads back.
        let lines: Vec<Value> = text(&run.stdout)
            .lines()
            .map(|line| serde_json::from_str(line).expect("JSON"))
            .filter(|line: &Value| line.get("expected").is_some())
            .collect();
        assert_eq!(lines.len(), 2);
        assert_eq!(lines[1]["met"], code == 0);
        let read = record_file::parse(text(&run.stdout), "r").unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(read.expected.len(), 2);
        assert_eq!(read.expected[1].met, code == 0);
        // Quiet, only the exit code tells.
        let quiet = masse(&["run", "-q", &path.display().to_string()]);
        assert_eq!(quiet.status.code(), Some(code));
        assert!(quiet.stdout.is_empty() && quiet.stderr.is_empty());
    }
    let path = file("run", "never.ron", &scene(r#"Potted(ball: "4")"#));
    let run = masse(&["run", &path.display().to_string()]);
    assert_eq!(run.status.code(), Some(2));
    assert!(text(&run.stderr).contains("never.ron: expect[0].ball: `4`"));
}
