//! Damaged language files: every text of the screen is said all the same, in that language or in English.

use fluent_bundle::FluentValue;
use proptest::sample::select;

use masse::window::language::{LANGUAGES, Language};

use super::attack;
use super::texts::{damage, damaged};
use crate::languages::english;

#[test]
fn damaged_languages_leave_nothing_unsaid() {
    let keys = english();
    let texts: Vec<&str> = LANGUAGES.iter().map(|language| language.texts).collect();
    attack(100, &(select(texts), damage()), |(text, damages)| {
        let language = Language::of_texts("de", &damaged(text, &damages));
        for (key, values) in &keys {
            let filled: Vec<(&str, FluentValue)> = values
                .iter()
                .map(|name| (name.as_str(), FluentValue::from(2)))
                .collect();
            let said = language.with(key, &filled);
            if said.is_empty() || said == *key {
                return Err(format!("{key} is said as `{said}`"));
            }
        }
        Ok(())
    });
}
