//! The languages: all say the same, none lacks a word that the window uses, and damage falls back to English.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use fluent_bundle::FluentValue;
use masse::game::rules::{Game, wording};
use masse::game::saying::Saying;
use masse::physics::table::Preset;
use masse::scenarios::{library, preset};
use masse::window::action::{CONTROLS, Topic};
use masse::window::language::{LANGUAGES, Language};

/// The messages of a file, with the names of the values in each.
fn messages(text: &str) -> BTreeMap<String, BTreeSet<String>> {
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut key = None;
    for line in text.lines() {
        if let Some((name, _)) = line
            .split_once(" =")
            .filter(|_| !line.starts_with([' ', '#']))
        {
            let before = found.insert(name.to_owned(), BTreeSet::new());
            assert_eq!(before, None, "{name} stands twice");
            key = Some(name.to_owned());
        }
        let Some(values) = key.as_ref().and_then(|key| found.get_mut(key)) else {
            continue;
        };
        for part in line.split('$').skip(1) {
            let end = part.find(|c: char| !c.is_alphanumeric() && c != '-');
            values.insert(part[..end.unwrap_or(part.len())].to_owned());
        }
    }
    found
}

pub(crate) fn english() -> BTreeMap<String, BTreeSet<String>> {
    messages(LANGUAGES[0].texts)
}

#[test]
fn every_language_has_the_same_keys_and_values_and_all_of_it_is_good() {
    assert!(LANGUAGES.len() >= 3);
    let english = english();
    assert!(english.len() > 200);
    for language in LANGUAGES {
        let own = messages(language.texts);
        for (key, values) in &english {
            assert_eq!(own.get(key), Some(values), "{}: {key}", language.code);
        }
        for key in own.keys() {
            assert!(english.contains_key(key), "{}: {key}", language.code);
        }
        let resource = fluent_bundle::FluentResource::try_new(language.texts.to_owned());
        let errors = resource.err().map(|(_, errors)| errors);
        assert_eq!(errors, None, "{}", language.code);
    }
}

#[test]
fn every_message_can_be_said_in_every_language() {
    for language in LANGUAGES {
        let spoken = Language::of_code(language.code);
        assert_eq!(spoken.code(), language.code);
        for (key, values) in english() {
            let filled: Vec<(&str, FluentValue)> = values
                .iter()
                .map(|name| (name.as_str(), FluentValue::from(2)))
                .collect();
            let said = spoken.with(&key, &filled);
            assert!(
                said != key && !said.contains('{'),
                "{}: {said}",
                language.code
            );
            if values.is_empty() {
                assert_eq!(spoken.find(&key), Some(said.as_str()));
            }
        }
    }
}

/// The text of every file of the window and the game, without its tests.
fn sources() -> Vec<(String, String)> {
    fn collect(folder: &Path, found: &mut Vec<(String, String)>) {
        for entry in fs::read_dir(folder)
            .expect("the sources are there")
            .flatten()
        {
            let path = entry.path();
            if path.is_dir() {
                collect(&path, found);
            } else {
                let text = fs::read_to_string(&path).expect("it can be read");
                let code = text.split("#[cfg(test)]").next().unwrap_or_default();
                found.push((path.display().to_string(), code.to_owned()));
            }
        }
    }
    let mut found = Vec::new();
    for room in ["src/window", "src/game", "src/scenarios/expect"] {
        collect(
            &Path::new(env!("CARGO_MANIFEST_DIR")).join(room),
            &mut found,
        );
    }
    found
}

/// String literals of a source that look like keys: small letters joined by at least one hyphen, or any that stand in a
/// call for a text.
fn literals(code: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for line in code.lines() {
        if line.trim_start().starts_with("//") {
            continue;
        }
        let parts: Vec<&str> = line.split('"').collect();
        for i in (1..parts.len()).step_by(2) {
            let is_key = parts[i].contains('-')
                && parts[i].starts_with(|c: char| c.is_ascii_lowercase())
                && parts[i]
                    .chars()
                    .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-')
                && !parts[i].ends_with('-');
            let is_asked = ["text(", "with(", "find("]
                .iter()
                .any(|call| parts[i - 1].ends_with(call));
            if is_key || is_asked {
                found.push(parts[i]);
            }
        }
    }
    found
}

/// Keys that are put together while the program runs.
fn composed() -> BTreeSet<String> {
    let mut keys: BTreeSet<String> = CONTROLS.iter().map(|line| line.action.key()).collect();
    keys.extend(Topic::ALL.map(|topic| topic.key().to_owned()));
    for (action, _) in masse::window::action::Bindings::default().iter() {
        let key = format!("status-{}", action.key());
        keys.extend(english().contains_key(&key).then_some(key));
    }
    keys.extend(library::all().map(|scene| format!("scene-{}", scene.name)));
    for scene in library::BUILT_IN {
        let looked_for = scene.scenario().is_ok_and(|it| !it.look_for.is_empty());
        keys.extend(looked_for.then(|| format!("look-{}", scene.name)));
    }
    let named = |name: &str| format!("preset-{}", name.replace('_', "-"));
    keys.extend(preset::BUILT_IN.iter().map(|asset| named(asset.name)));
    keys.extend(
        preset::CLOTHS
            .iter()
            .map(|cloth| format!("cloth-{}", cloth.name)),
    );
    keys.extend(Game::all().iter().map(|game| wording::title(game).key));
    for table in Preset::NAMED {
        let pockets = table.table().pockets;
        keys.extend(
            pockets
                .iter()
                .map(|pocket| format!("pocket-{}", pocket.name.replace(' ', "-"))),
        );
    }
    keys
}

/// Literals with a hyphen that are no keys.
const NO_KEYS: [&str; 0] = [];

#[test]
fn no_key_that_the_code_uses_is_missing_and_none_is_there_for_nothing() {
    let english = english();
    let mut used = composed();
    for scene in library::all() {
        // A scene that nobody has translated yet is called by its own title.
        used.remove(&format!("scene-{}", scene.name));
    }
    for key in &used {
        assert!(english.contains_key(key), "{key} is missing");
    }
    used.extend(composed());
    for (path, code) in sources() {
        for key in literals(&code) {
            let is_said = path.contains("window") || path.contains("scenarios/expect");
            if is_said && !NO_KEYS.contains(&key) {
                let known = english.contains_key(key) || is_page(&code, key);
                assert!(known, "{path}: {key} is missing");
            }
            used.insert(key.to_owned());
            used.insert(format!("{key}-hint"));
        }
    }
    for key in english.keys() {
        assert!(used.contains(key), "{key} is there for nothing");
    }
}

/// Whether a literal is only the name of a page or of something that is laid out.
fn is_page(code: &str, key: &str) -> bool {
    ["PageId(", "Self(", "Id::new("]
        .iter()
        .any(|call| code.contains(&format!("{call}\"{key}\")")))
}

#[test]
fn no_word_on_the_screen_is_written_into_the_code() {
    let calls = [
        "label(\"",
        "button(\"",
        "strong(\"",
        "heading(\"",
        "weak(\"",
        "on_hover_text(\"",
        "Window::new(\"",
        "RichText::new(\"",
        "collapsing(\"",
        "hint_text(\"",
        "Button::new(\"",
        "selected_text(\"",
    ];
    for (path, code) in sources() {
        for line in code.lines() {
            for call in calls {
                let word = line.split(call).nth(1).unwrap_or_default();
                let word = word.split('"').next().unwrap_or_default();
                assert!(
                    word.chars().filter(|c| c.is_alphabetic()).count() < 2,
                    "{path}: {line}"
                );
            }
        }
    }
}

#[test]
fn what_a_language_lacks_or_spoils_is_said_in_english() {
    let spoiled = "menu-quit = Adieu\nmenu-back\nstatus-rolling = { $tyme } s\nhelp-title = {\n= ?\nload = Los { $x }\n";
    let language = Language::of_texts("de", spoiled);
    assert_eq!(language.text("menu-quit"), "Adieu");
    assert_eq!(language.text("menu-back"), "Back");
    assert_eq!(language.text("help-title"), "Controls");
    assert_eq!(language.text("load"), "Load");
    let time = [("time", FluentValue::from("1.5"))];
    assert_eq!(language.with("status-rolling", &time), "Rolling 1.5 s");
    assert_eq!(language.text("no-such-key"), "no-such-key");
    for text in ["", "\u{0}\u{feff}", "}}}}", "= = =\n-term"] {
        assert_eq!(Language::of_texts("??", text).text("menu-quit"), "Quit");
    }
}

#[test]
fn scenes_say_in_english_what_their_files_say_and_something_else_in_other_languages() {
    let [english, german, french] = ["en", "de", "fr"].map(Language::of_code);
    for scene in library::BUILT_IN {
        let scenario = scene.scenario().expect("it is built in");
        let key = format!("look-{}", scene.name);
        if scenario.look_for.is_empty() {
            continue;
        }
        assert_eq!(
            english.find(&key),
            Some(scenario.look_for.as_str()),
            "{key}"
        );
        for other in [&german, &french] {
            assert_ne!(other.find(&key), Some(scenario.look_for.as_str()), "{key}");
        }
    }
}

#[test]
fn every_expectation_of_the_library_is_said_in_every_language_with_all_its_values() {
    for scene in library::BUILT_IN {
        let scenario = scene.scenario().expect("it is built in");
        for expected in &scenario.expect {
            let wanted = expected.wanted();
            let said: Vec<String> = LANGUAGES
                .iter()
                .map(|language| Language::of_code(language.code).phrase(&wanted))
                .collect();
            assert_ne!(said[0], said[1], "{}: {wanted}", scene.name);
            assert_ne!(said[1], said[2], "{}: {wanted}", scene.name);
            let digits = |text: &str| text.chars().filter(char::is_ascii_digit).count();
            for text in &said {
                assert!(!text.contains(['{', '$', '`']), "{}: {text}", scene.name);
                assert_eq!(
                    digits(text),
                    digits(&wanted.to_string()),
                    "{wanted}: {text}"
                );
            }
        }
    }
}

#[test]
fn what_became_of_an_expectation_is_said_in_german() {
    let scene = library::open("butterfly").expect("it is built in");
    let record =
        masse::physics::exact::solve(&scene.scene, masse::physics::exact::Limits::default());
    let outcomes = scene.judge(&record.expect("it can be played"));
    let german = Language::of_code("de");
    let first = &outcomes[0];
    assert_eq!(
        german.phrase(&first.wanted),
        "Kugel 1 fällt in die Tasche Fuß links"
    );
    let seen = german.phrase(&first.seen);
    assert!(
        seen.starts_with("fiel bei 1.") || seen.starts_with("fiel bei 0."),
        "{seen}"
    );
    assert!(seen.ends_with(" s in die Tasche Fuß links"), "{seen}");
    // A word that no language knows is said in English.
    let unknown = masse::scenarios::expect::Phrase {
        key: "no-such-phrase",
        english: "{a} sings",
        values: vec![("a", masse::scenarios::expect::Word::Ball("1".to_owned()))],
    };
    assert_eq!(german.phrase(&unknown), "`1` sings");
}

#[test]
fn plurals_follow_the_language() {
    let said = |code: &str, count: i32| {
        let values = [("count", FluentValue::from(count))];
        Language::of_code(code).with("controls-clashes", &values)
    };
    assert_eq!(said("en", 1), "One control does two things.");
    assert_eq!(said("en", 2), "2 controls do two things.");
    assert!(said("de", 1).starts_with("Eine"));
    // In French zero is singular.
    assert_eq!(said("fr", 0), said("fr", 1));
}

#[test]
fn sentences_of_other_rooms_are_translated_or_said_as_they_are() {
    let german = Language::of_code("de");
    let known = Saying::new("notice-miscue", &[], "Miscue.");
    assert!(german.say(&known).starts_with("Kicks"));
    let unknown = Saying::new("notice-of-tomorrow", &[("x", "1")], "It is 1.");
    assert_eq!(german.say(&unknown), "It is 1.");
    let spoiled = Saying::new("notice-file-changed", &[], "changed");
    assert_eq!(german.say(&spoiled), "changed", "a value is missing");
}

#[test]
fn every_letter_of_every_language_and_every_control_has_a_picture() {
    use bevy_egui::egui;
    let context = egui::Context::default();
    context.set_fonts(masse::window::language::letters::fonts());
    let _ = context.run_ui(egui::RawInput::default(), |_| {});
    let font = egui::FontId::proportional(14.0);
    let mut texts: Vec<String> = Vec::new();
    for language in LANGUAGES {
        let spoken = Language::of_code(language.code);
        texts.push(language.name.to_owned());
        texts.extend(english().keys().filter_map(|key| {
            let text = spoken.find(key)?;
            Some(text.to_owned())
        }));
        let bindings = masse::window::action::Bindings::default();
        let controls = bindings.iter().flat_map(|(_, controls)| controls.to_vec());
        texts.extend(controls.map(|control| control.name(&spoken)));
    }
    assert!(texts.iter().any(|text| text.contains('→')));
    let mut lacking = BTreeSet::new();
    for text in texts {
        // Of the font that has the sign for what is lacking the panels cannot tell; it has these.
        let letters = text.chars().filter(|letter| !" ◀▶".contains(*letter));
        lacking.extend(
            letters.filter(|letter| !context.fonts_mut(|fonts| fonts.has_glyph(&font, *letter))),
        );
    }
    assert!(lacking.is_empty(), "{lacking:?}");
}
