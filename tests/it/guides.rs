//! What the guides in `docs` name is there: files, types, functions, commands, and a scene that plays. Code of theirs that
//! only a changed program compiles is followed by hand; what can drift without notice is held here.

use std::path::{Path, PathBuf};

use masse::cli;
use masse::physics::exact::{Limits, solve};
use masse::scenarios::file;

/// What a guide has its reader make.
const MADE: [&str; 4] = ["sticky", "equal", "my-shot", "found.ron"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Name and text of every guide.
fn guides() -> Vec<(String, String)> {
    let mut guides: Vec<_> = std::fs::read_dir(root().join("docs"))
        .expect("the folder of the guides")
        .map(|entry| entry.expect("an entry").path())
        .map(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let text = std::fs::read_to_string(&path).expect("a text");
            (name.into_owned(), text)
        })
        .collect();
    guides.sort();
    assert!(guides.len() >= 3);
    guides
}

/// The blocks of code of a guide in this language.
fn blocks(text: &str, language: &str) -> Vec<String> {
    let mut blocks = Vec::new();
    let mut block: Option<String> = None;
    for line in text.lines() {
        match (&mut block, line.trim()) {
            (Some(_), "```") => blocks.extend(block.take()),
            (Some(block), _) => {
                block.push_str(line);
                block.push('\n');
            }
            (None, fence) if fence.strip_prefix("```") == Some(language) => {
                block = Some(String::new());
            }
            _ => {}
        }
    }
    blocks
}

/// What stands between single backticks outside of blocks.
fn quoted(text: &str) -> Vec<&str> {
    let prose = text.split("```").step_by(2);
    prose
        .flat_map(|part| part.split('`').skip(1).step_by(2))
        .collect()
}

fn is_made(what: &str) -> bool {
    MADE.iter().any(|made| what.contains(made))
}

#[test]
fn every_file_that_a_guide_names_is_there() {
    let folders = [
        "src/",
        "tests/",
        "assets/",
        "docs/",
        "examples/",
        "scripts/",
    ];
    let mut missing = Vec::new();
    for (name, text) in guides() {
        for path in quoted(&text) {
            let named =
                folders.iter().any(|folder| path.starts_with(folder)) && !path.contains(' ');
            // Where the reader makes a file its folder is there.
            let place = root().join(path);
            let place = if is_made(path) {
                place.parent().map_or_else(PathBuf::new, Path::to_path_buf)
            } else {
                place
            };
            if named && !place.exists() {
                missing.push(format!("{name}: `{path}`"));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

/// The file of a module of the crate, or of the module that has it as an item.
fn module(path: &[&str]) -> Option<String> {
    let place = path
        .iter()
        .fold(root().join("src"), |at, part| at.join(part));
    [place.with_extension("rs"), place.join("mod.rs")]
        .into_iter()
        .find_map(|file| std::fs::read_to_string(file).ok())
}

/// Whether a text has this word.
fn has_word(text: &str, word: &str) -> bool {
    text.split(|letter: char| !letter.is_alphanumeric() && letter != '_')
        .any(|part| part == word)
}

#[test]
fn every_item_that_a_guide_uses_is_there() {
    let (mut missing, mut seen) = (Vec::new(), 0);
    for (name, text) in guides() {
        for block in blocks(&text, "rust") {
            for line in block.lines().map(str::trim) {
                let Some(path) = line
                    .strip_prefix("use crate::")
                    .and_then(|path| path.strip_suffix(';'))
                else {
                    continue;
                };
                let (path, items) = path.rsplit_once("::").expect("a path");
                let module = module(&path.split("::").collect::<Vec<_>>());
                for item in items.trim_matches(['{', '}']).split(", ") {
                    seen += 1;
                    if !module.as_ref().is_some_and(|text| has_word(text, item)) {
                        missing.push(format!("{name}: {item} in {path}"));
                    }
                }
            }
        }
    }
    assert!(seen > 10, "{seen} items");
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

/// The functions of a rule set are those of the trait: none is missing that must be there, none has another name.
#[test]
fn the_rule_set_of_the_guide_fits_the_trait() {
    let (_, guide) = guides()
        .into_iter()
        .find(|(name, _)| name == "add-a-rule-set.md")
        .expect("the guide");
    let rules = module(&["game", "rules"]).expect("the rules");
    let from = rules.find("pub trait RuleSet").expect("the trait");
    let body = &rules[from..from + rules[from..].find("\n}").expect("its end")];
    let names = |text: &str| -> Vec<String> {
        let starts = text.split("fn ").skip(1);
        let name = |start: &str| start.split('(').next().unwrap_or_default().to_owned();
        starts.map(name).collect()
    };
    let guided = names(&blocks(&guide, "rust")[0]);
    let known = names(body);
    for name in &guided {
        assert!(known.contains(name), "{name} is not in the trait");
    }
    // Those without a body of their own must be written.
    for part in body.split("fn ").skip(1) {
        let head = part.split(['{', ';']).next().unwrap_or_default();
        let must = part[head.len()..].starts_with(';');
        let name = head.split('(').next().unwrap_or_default().to_owned();
        assert!(!must || guided.contains(&name), "{name} must be written");
    }
}

#[test]
fn the_scene_of_the_guide_does_what_it_says() {
    let (_, guide) = guides()
        .into_iter()
        .find(|(name, _)| name == "add-a-scenario.md")
        .expect("the guide");
    let blocks = blocks(&guide, "ron");
    let [plain, more] = blocks.as_slice() else {
        panic!("{} blocks", blocks.len());
    };
    let end = plain.rfind(')').expect("a scene");
    let trick = format!("{}{more}{}", &plain[..end], &plain[end..]);
    for (text, expected) in [(plain, 0), (&trick, 2)] {
        let scenario = file::parse(text, "my-shot").unwrap_or_else(|error| panic!("{error}"));
        let record = solve(&scenario.scene, Limits::default()).expect("it plays");
        let outcomes = scenario.judge(&record);
        assert_eq!(outcomes.len(), expected);
        for outcome in outcomes {
            assert!(outcome.met, "{}", outcome.sentence());
        }
    }
}

/// Names of tests, lists and macros that a reader is sent to.
#[test]
fn what_a_guide_sends_its_reader_to_is_found() {
    for (file, what) in [
        ("src/scenarios/library.rs", "BUILT_IN"),
        ("src/scenarios/library.rs", "scene"),
        ("src/game/rules/mod.rs", "games"),
        ("src/game/players/worth.rs", "to_go"),
        ("tests/it/matches/random.rs", "conserved"),
        ("src/physics/laws/motion/mod.rs", "is_closed_form"),
        ("src/physics/laws/ball_ball/mod.rs", "laws"),
        ("src/physics/laws/cushion/mod.rs", "Cushioning"),
        ("tests/it/properties/inputs.rs", "BallBallLaw"),
        (
            "tests/it/properties/ball_ball.rs",
            "the_balls_part_with_the_restitution_asked_for",
        ),
        ("tests/it/same_bits.rs", "MASSE_UPDATE_BITS"),
    ] {
        let text = std::fs::read_to_string(root().join(file)).expect("a file");
        assert!(has_word(&text, what), "{what} in {file}");
        let told = guides().iter().any(|(_, guide)| has_word(guide, what));
        assert!(told, "no guide speaks of {what} any more");
    }
}

#[test]
fn the_commands_of_the_guides_are_known() {
    let mut commands = 0;
    for (name, text) in guides() {
        for block in blocks(&text, "sh") {
            for line in block.lines() {
                let Some((_, command)) = line.split_once(" -- ") else {
                    continue;
                };
                let line = std::iter::once("masse").chain(command.split_whitespace());
                assert_eq!(cli::read(line.map(Into::into)), 0, "{name}: {command}");
                commands += 1;
            }
        }
    }
    assert!(commands > 0);
}

/// An example that nobody runs is one that no longer runs.
#[test]
fn every_example_is_run_by_what_a_pull_request_must_pass() {
    let run = std::fs::read_to_string(root().join(".ci/run")).expect("a script");
    let examples = std::fs::read_dir(root().join("examples")).expect("the folder of the examples");
    let mut found = 0;
    for example in examples {
        let path = example.expect("an entry").path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let asked = run.lines().any(|line| {
            line.starts_with("cargo run") && line.contains(&format!("--example {name} "))
        });
        assert!(asked, "no line of .ci/run runs the example {name}");
        found += 1;
    }
    assert!(found >= 5);
}

/// The rows of the judge that the README shows are rows that the judge prints, figure by figure.
#[test]
fn the_readme_shows_what_the_judge_prints() {
    let readme = std::fs::read_to_string(root().join("README.md")).expect("a text");
    let packed = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
    let printed = crate::judge::judged().text();
    let printed: Vec<String> = printed.lines().map(packed).collect();
    let mut rows = 0;
    for block in blocks(&readme, "text") {
        let is_row = |line: &&str| line.ends_with("pass") || line.ends_with("MISS");
        for row in block.lines().filter(is_row) {
            assert!(
                printed.contains(&packed(row)),
                "the judge does not print: {row}"
            );
            rows += 1;
        }
    }
    assert!(rows >= 4, "{rows} rows");
}
