//! The language that is spoken: every word on the screen comes from a file in `assets/languages`.
//!
//! A language is a file there and a line in [`LANGUAGES`]. What a file lacks is said in English.

pub mod letters;
mod phrases;
mod texts;

use std::sync::Arc;

use bevy::ecs::message::MessageUpdateSystems;
use bevy::prelude::*;
use fluent_bundle::FluentValue;

use crate::game::saying::{Saying, Value};
use crate::game::settings::Settings;
use texts::Texts;

/// A language that is built in.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// What the settings call it, such as `de`.
    pub code: &'static str,
    /// What its speakers call it.
    pub name: &'static str,
    /// Its texts, in Fluent.
    pub texts: &'static str,
}

/// A line of the list: the code and the name of a language.
macro_rules! language {
    ($code:literal, $name:literal) => {
        BuiltIn {
            code: $code,
            name: $name,
            texts: include_str!(concat!("../../../assets/languages/", $code, ".ftl")),
        }
    };
}

/// Every language, English first.
pub const LANGUAGES: &[BuiltIn] = &[
    language!("en", "English"),
    language!("de", "Deutsch"),
    language!("fr", "Français"),
];

/// The language that is spoken now. A copy is cheap.
#[derive(Resource, Clone)]
pub struct Language(Arc<Spoken>);

struct Spoken {
    code: String,
    own: Texts,
    english: Texts,
}

impl Language {
    /// A language by its code; English if there is none with it.
    #[must_use]
    pub fn of_code(code: &str) -> Self {
        let known = LANGUAGES.iter().find(|language| language.code == code);
        let language = known.unwrap_or(&LANGUAGES[0]);
        Self::of_texts(language.code, language.texts)
    }

    /// A language from the text of a file. What is no good in it is said in English.
    #[must_use]
    pub fn of_texts(code: &str, texts: &str) -> Self {
        let english = LANGUAGES[0];
        Self(Arc::new(Spoken {
            code: code.to_owned(),
            own: Texts::read(code, texts),
            english: Texts::read(english.code, english.texts),
        }))
    }

    /// The code of the language.
    #[must_use]
    pub fn code(&self) -> &str {
        &self.0.code
    }

    /// A text without values. A key that no language knows stands for itself.
    #[must_use]
    pub fn text<'a>(&'a self, key: &'a str) -> &'a str {
        self.find(key).unwrap_or(key)
    }

    /// A text without values, if there is one.
    #[must_use]
    pub fn find(&self, key: &str) -> Option<&str> {
        self.0.own.plain(key).or_else(|| self.0.english.plain(key))
    }

    /// A text with values.
    #[must_use]
    pub fn with(&self, key: &str, values: &[(&str, FluentValue)]) -> String {
        let of = |texts: &Texts| texts.filled(key, values);
        of(&self.0.own)
            .or_else(|| of(&self.0.english))
            .unwrap_or_else(|| key.to_owned())
    }

    /// A sentence of a room without pixels, with those that follow it.
    #[must_use]
    pub fn say(&self, saying: &Saying) -> String {
        let values: Vec<(&str, FluentValue)> = saying
            .values
            .iter()
            .map(|(name, value)| (*name, self.value(value)))
            .collect();
        let of = |texts: &Texts| texts.filled(&saying.key, &values);
        let mut said = of(&self.0.own)
            .or_else(|| of(&self.0.english))
            .unwrap_or_else(|| saying.english.clone());
        for next in &saying.then {
            said.push('\n');
            said.push_str(&self.say(next));
        }
        said
    }

    /// Whether this language itself, and not English in its place, has the words for a sentence and everything in it.
    #[must_use]
    pub fn knows(&self, saying: &Saying) -> bool {
        let parts = saying.values.iter().flat_map(|(_, value)| match value {
            Value::Text(_) | Value::Number(_) => [].as_slice(),
            Value::Saying(part) => std::slice::from_ref(&**part),
            Value::AnyOf(parts) | Value::AllOf(parts) => parts.as_slice(),
        });
        let values: Vec<(&str, FluentValue)> = saying
            .values
            .iter()
            .map(|(name, value)| (*name, self.value(value)))
            .collect();
        self.0.own.filled(&saying.key, &values).is_some()
            && parts.chain(&saying.then).all(|part| self.knows(part))
    }

    fn value(&self, value: &Value) -> FluentValue<'static> {
        match value {
            Value::Text(text) => text.clone().into(),
            Value::Number(number) => (*number).into(),
            Value::Saying(saying) => self.say(saying).into(),
            Value::AnyOf(list) => self.enumerated(list, "list-any").into(),
            Value::AllOf(list) => self.enumerated(list, "list-all").into(),
        }
    }

    fn enumerated(&self, list: &[Saying], key: &str) -> String {
        let mut names: Vec<String> = list.iter().map(|saying| self.say(saying)).collect();
        let Some(last) = names.pop() else {
            return self.text("list-none").to_owned();
        };
        if names.is_empty() {
            return last;
        }
        let values = [("first", names.join(", ").into()), ("last", last.into())];
        self.with(key, &values)
    }
}

impl Default for Language {
    fn default() -> Self {
        Self::of_code(LANGUAGES[0].code)
    }
}

/// The first built-in language among those that the system prefers.
#[must_use]
pub fn of_system() -> &'static str {
    best(sys_locale::get_locales())
}

/// The first of these locales, such as `de-AT`, that a built-in language suits.
fn best(locales: impl IntoIterator<Item = String>) -> &'static str {
    locales
        .into_iter()
        .find_map(|locale| {
            let wanted: unic_langid::LanguageIdentifier = locale.parse().ok()?;
            let known = LANGUAGES
                .iter()
                .find(|language| language.code == wanted.language.as_str());
            known.map(|language| language.code)
        })
        .unwrap_or(LANGUAGES[0].code)
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Language>()
        .add_systems(First, speak.after(MessageUpdateSystems));
}

/// Speaks the language of the settings, or that of the system.
fn speak(settings: Res<Settings>, mut language: ResMut<Language>) {
    if !settings.is_changed() {
        return;
    }
    let code = settings.language.as_deref().unwrap_or_else(|| of_system());
    let known = LANGUAGES.iter().any(|language| language.code == code);
    let code = if known { code } else { LANGUAGES[0].code };
    if language.code() != code {
        *language = Language::of_code(code);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_system_chooses_the_first_language_that_is_there() {
        let of = |locales: &[&str]| best(locales.iter().map(|locale| (*locale).to_owned()));
        assert_eq!(of(&["de-AT"]), "de");
        assert_eq!(of(&["tlh", "fr-CA", "de"]), "fr");
        assert_eq!(of(&["pt-BR"]), "en");
        assert_eq!(of(&["C", "!?"]), "en");
        assert_eq!(of(&[]), "en");
    }
}
