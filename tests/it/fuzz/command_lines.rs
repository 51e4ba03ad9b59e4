//! Random command lines: the parser never panics, and answers with the exit codes of the help text.

use std::ffi::OsString;

use proptest::prelude::*;
use proptest::sample::select;

use masse::cli;

use super::attack;
use super::texts::letters;

const WORDS: [&str; 48] = [
    "run",
    "judge",
    "list",
    "write",
    "play",
    "picture",
    "solve",
    "report",
    "help",
    "gas",
    "break-nine",
    "my.ron",
    "--help",
    "-h",
    "--version",
    "-V",
    "--solver",
    "--solver=exact",
    "--solver=fast",
    "exact",
    "stepped",
    "--tick",
    "0.001",
    "-1",
    "nan",
    "1e400",
    "--grid",
    "20x20",
    "0x0",
    "x",
    "none",
    "--out",
    "out.jsonl",
    "--quiet",
    "-q",
    "--json",
    "--hard",
    "sweep",
    "laws",
    "--over",
    "speed=1:2:3",
    "--allow",
    "--no-pictures",
    "--preset",
    "--",
    "-",
    "",
    "--time-limit=5",
];

#[test]
fn any_command_line_has_an_exit_code() {
    let word = prop_oneof![
        6 => select(WORDS.to_vec()).prop_map(OsString::from),
        1 => letters(12).prop_map(OsString::from),
        1 => letters(8).prop_map(|text| OsString::from(format!("--{text}"))),
    ];
    let line = prop::collection::vec(word, 0..8);
    attack(3000, &line, |line| {
        let arguments = std::iter::once(OsString::from("masse")).chain(line);
        match cli::read(arguments) {
            0 | 2 => Ok(()),
            code => Err(format!("exit code {code}")),
        }
    });
}

#[test]
fn what_a_line_is_worth() {
    for (line, code) in [
        (&["run", "gas"][..], 0),
        (&["--help"], 0),
        (&["run", "gas", "--tick", "x"], 2),
        (&["run"], 2),
        (&["judge", "--allow", "-1"], 2),
        (&["dance"], 2),
    ] {
        let arguments = ["masse"].iter().chain(line).map(OsString::from);
        assert_eq!(cli::read(arguments), code, "{line:?}");
    }
}
