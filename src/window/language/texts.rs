//! The texts of one file.

use std::collections::HashMap;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use unic_langid::LanguageIdentifier;

/// The texts of one file.
pub(super) struct Texts {
    bundle: FluentBundle<FluentResource>,
    /// Those without values, which are asked for many times a frame.
    plain: HashMap<String, String>,
}

impl Texts {
    /// Reads a file. What is no good in it is left out.
    pub fn read(code: &str, text: &str) -> Self {
        let language: LanguageIdentifier = code.parse().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![language]);
        bundle.set_use_isolating(false);
        let resource = match FluentResource::try_new(text.to_owned()) {
            Ok(resource) | Err((resource, _)) => resource,
        };
        // The first of two texts with the same key stays.
        let _ = bundle.add_resource(resource);
        let mut texts = Self {
            bundle,
            plain: HashMap::new(),
        };
        for key in keys(text) {
            if let Some(filled) = texts.filled(key, &[]) {
                texts.plain.insert(key.to_owned(), filled);
            }
        }
        texts
    }

    /// A text without values.
    pub fn plain(&self, key: &str) -> Option<&str> {
        self.plain.get(key).map(String::as_str)
    }

    /// A text with these values; none if it is not there or asks for others.
    pub fn filled(&self, key: &str, values: &[(&str, FluentValue)]) -> Option<String> {
        let pattern = self.bundle.get_message(key)?.value()?;
        let args: FluentArgs = values
            .iter()
            .map(|(name, value)| (*name, value.clone()))
            .collect();
        let mut errors = Vec::new();
        let filled = self
            .bundle
            .format_pattern(pattern, Some(&args), &mut errors)
            .into_owned();
        errors.is_empty().then_some(filled)
    }
}

/// The keys that begin a line of a file.
fn keys(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| {
        let (key, _) = line.split_once('=')?;
        let key = key.trim_end();
        let is_key = key.starts_with(|c: char| c.is_ascii_alphabetic())
            && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '-');
        is_key.then_some(key)
    })
}
