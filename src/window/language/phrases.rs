//! Phrases of the rooms without pixels in the language that is spoken.

use fluent_bundle::FluentValue;

use super::Language;
use crate::scenarios::expect::{Phrase, Word};

impl Language {
    /// A phrase; in English if no language knows it.
    #[must_use]
    pub fn phrase(&self, phrase: &Phrase) -> String {
        let words = phrase.values.iter();
        let told: Vec<(&str, String)> =
            words.map(|(name, word)| (*name, self.word(word))).collect();
        let values = told
            .iter()
            .map(|(name, text)| (*name, text.as_str().into()));
        let values: Vec<(&str, FluentValue)> = values.collect();
        let of = |texts: &super::Texts| texts.filled(phrase.key, &values);
        of(&self.0.own)
            .or_else(|| of(&self.0.english))
            .unwrap_or_else(|| phrase.to_string())
    }

    fn word(&self, word: &Word) -> String {
        match word {
            Word::Ball(name) => self.with("ball-in-sentence", &[("name", name.as_str().into())]),
            Word::Pocket(name) => {
                let key = format!("pocket-{}", name.replace(' ', "-"));
                self.find(&key).unwrap_or(name).to_owned()
            }
            Word::Number(_) | Word::Digits(..) | Word::Count(_) | Word::Unit(_) => word.to_string(),
            Word::Part(phrase) => self.phrase(phrase),
            Word::Apart(None) => String::new(),
            Word::Apart(Some(phrase)) => format!(" {}", self.phrase(phrase)),
            Word::Then(phrases) => {
                let told = phrases.iter().map(|phrase| self.phrase(phrase));
                let joined = told.reduce(|first, next| {
                    let values = [("first", first.into()), ("next", next.into())];
                    self.with("contact-then", &values)
                });
                joined.unwrap_or_default()
            }
        }
    }
}
