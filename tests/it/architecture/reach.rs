//! A file that no `mod` names is compiled by nobody: its tests pass because they never run.

use std::collections::BTreeSet;

use super::tokens::tokens;
use super::{Finding, Source, assert_none, sources};

/// Files that Cargo names itself.
const ROOTS: [&str; 3] = ["src/lib.rs", "src/main.rs", "tests/it/main.rs"];

/// The files in which the `mod` of this one may stand, and its name.
fn declared_in(path: &str) -> Option<([String; 2], &str)> {
    let (folder, file) = path.rsplit_once('/')?;
    let (folder, name) = match file.strip_suffix(".rs")? {
        "mod" => folder.rsplit_once('/')?,
        name => (folder, name),
    };
    let root = if folder == "src" {
        "src/lib.rs"
    } else {
        "tests/it/main.rs"
    };
    Some(([format!("{folder}/mod.rs"), root.to_owned()], name))
}

fn unreached(sources: &[Source]) -> Vec<Finding> {
    let mut declared = BTreeSet::new();
    for source in sources {
        for three in tokens(&source.text).windows(3) {
            if three[0].text == "mod" && three[2].text == ";" {
                declared.insert((source.path.clone(), three[1].text.clone()));
            }
        }
    }
    let lost = sources.iter().filter(|source| {
        !ROOTS.contains(&source.path.as_str())
            && declared_in(&source.path).is_none_or(|(parents, name)| {
                !parents
                    .iter()
                    .any(|parent| declared.contains(&(parent.clone(), name.to_owned())))
            })
    });
    lost.map(|source| Finding {
        path: source.path.clone(),
        line: 1,
        what: "no `mod` names this file: nothing in it is compiled".to_owned(),
    })
    .collect()
}

#[test]
fn every_file_is_compiled() {
    for folder in ["src", "tests/it"] {
        assert_none(&unreached(&sources(folder)));
    }
}

#[test]
fn a_forgotten_file_is_found() {
    let findings = unreached(&[
        Source::new("src/lib.rs", "pub mod physics;"),
        Source::new("src/physics/mod.rs", "mod ball; // mod cue;"),
        Source::new("src/physics/ball.rs", ""),
        Source::new("src/physics/cue.rs", ""),
        Source::new("src/physics/laws/mod.rs", ""),
    ]);
    let paths: Vec<&str> = findings
        .iter()
        .map(|finding| finding.path.as_str())
        .collect();
    assert_eq!(paths, ["src/physics/cue.rs", "src/physics/laws/mod.rs"]);
}
