//! Damaged texts: scene files, presets, record files. Whatever is in them, an error names the file, and what is read is
//! playable.

use proptest::prelude::*;
use proptest::sample::select;

use masse::report::record_file;
use masse::scenarios::{file, library, preset};
use masse::sim::stepping;

use super::attack;

/// A few letters and signs of any kind.
pub fn letters(most: usize) -> impl Strategy<Value = String> {
    let letter = prop_oneof![4 => proptest::char::range(' ', '~'), 1 => any::<char>()];
    prop::collection::vec(letter, 0..=most).prop_map(String::from_iter)
}

/// One damage to a text: where, how much, and what comes there instead.
#[derive(Clone, Debug)]
pub struct Damage {
    place: f64,
    length: usize,
    instead: String,
    /// Whether a whole number or word is replaced.
    token: bool,
}

pub fn damage() -> impl Strategy<Value = Vec<Damage>> {
    let odd = select(
        [
            "",
            " ",
            "0",
            "-0.0",
            "-1",
            "1e308",
            "1e-320",
            "-1e308",
            "inf",
            "NaN",
            "nan",
            "99999999999999999999",
            "4294967296",
            "0.1",
            "1e-9",
            "(",
            ")",
            "[",
            "]",
            "{",
            "}",
            "\"",
            "'",
            ",",
            ":",
            "//",
            "/*",
            "#",
            "\\",
            "\0",
            "\u{feff}",
            "é",
            "\u{1F3B1}",
            "Some(",
            "None",
            "true",
            "null",
            "Box",
            "Full",
            "Custom",
            "cue",
            "1",
            "((((((((((((((((((((((((",
            "[[[[[[[[[[[[[[[[[[[[",
        ]
        .map(str::to_owned)
        .to_vec(),
    );
    let instead = prop_oneof![4 => odd, 1 => letters(6)];
    let one = (0.0..1.0_f64, 0..12_usize, instead, any::<bool>()).prop_map(
        |(place, length, instead, token)| Damage {
            place,
            length,
            instead,
            token,
        },
    );
    prop::collection::vec(one, 1..5)
}

/// The text with all damages done, in characters.
pub fn damaged(text: &str, damages: &[Damage]) -> String {
    let mut text: Vec<char> = text.chars().collect();
    for damage in damages {
        let mut from = ((text.len() as f64) * damage.place) as usize;
        let mut to = (from + damage.length).min(text.len());
        if damage.token {
            let part = |c: &char| c.is_alphanumeric() || "_.-+".contains(*c);
            while from < text.len() && !part(&text[from]) {
                from += 1;
            }
            while from > 0 && part(&text[from - 1]) {
                from -= 1;
            }
            to = from;
            while to < text.len() && part(&text[to]) {
                to += 1;
            }
        }
        text.splice(from..to, damage.instead.chars());
    }
    text.into_iter().collect()
}

/// The texts of all files in a folder of assets.
pub fn assets(folder: &str) -> Vec<String> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("assets")
        .join(folder);
    let mut paths: Vec<_> = std::fs::read_dir(folder)
        .expect("a folder of assets")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    paths
        .iter()
        .filter(|path| path.extension().is_some_and(|extension| extension == "ron"))
        .map(|path| std::fs::read_to_string(path).expect("text"))
        .collect()
}

fn names_its_file(error: &impl ToString) -> Result<(), String> {
    let message = error.to_string();
    // A file that the text names in turn may not be there.
    if message.contains("damaged")
        || ["os error", "file name"]
            .iter()
            .any(|what| message.contains(what))
    {
        Ok(())
    } else {
        Err(format!("the message names no file: {message}"))
    }
}

#[test]
fn damaged_scene_files_are_refused_or_playable() {
    attack(
        2000,
        &(select(assets("scenes")), damage()),
        |(text, damages)| match file::parse(&damaged(&text, &damages), "damaged") {
            Err(error) => names_its_file(&error),
            Ok(scenario) => scenario.scene.check().map_err(|error| error.to_string()),
        },
    );
}

#[test]
fn damaged_presets_are_refused_or_playable() {
    attack(
        2000,
        &(select(assets("presets")), damage()),
        |(text, damages)| match preset::parse(&damaged(&text, &damages), "damaged") {
            Err(error) => names_its_file(&error),
            Ok(read) => {
                let equipment = &read.equipment;
                let mut scene =
                    masse::physics::scene::Scene::new(equipment.table.clone(), equipment.laws);
                scene.place("cue", equipment.balls.cue, 0.0, 0.0);
                scene.cue = equipment.cue;
                scene
                    .check_surroundings()
                    .map_err(|error| error.to_string())
            }
        },
    );
}

/// A record of a short shot with cushions and balls.
fn record() -> String {
    let scenario = library::open("stun-shot").expect("a built-in scene");
    let (record, _) = stepping::run_to_rest(&scenario.scene);
    let mut text = Vec::new();
    record_file::write(&mut text, "stun-shot", "Stun", &scenario.scene, &record).expect("a record");
    String::from_utf8(text).expect("text")
}

#[test]
fn damaged_records_are_refused_or_whole() {
    let text = record();
    attack(1000, &damage(), |damages| {
        match record_file::parse(&damaged(&text, &damages), "damaged") {
            Err(error) => names_its_file(&error),
            Ok(run) => {
                run.scene.check().map_err(|error| error.to_string())?;
                for ball in 0..run.scene.balls.len() {
                    for time in [0.0, 0.5 * run.record.end_time, run.record.end_time] {
                        if !run.record.state_at(ball, time).is_finite() {
                            return Err(format!("ball {ball} is nowhere at {time} s"));
                        }
                    }
                }
                Ok(())
            }
        }
    });
}
