//! Sentences for a player, in words that the window can translate.
//!
//! Rooms without pixels know no language: they say what happened with a key, the values in it and the English sentence.
//! The window looks the key up in the language that is spoken and falls back to the sentence.

/// A sentence for a player.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saying {
    /// The key of its translation in `assets/languages`; empty if there is none.
    pub key: String,
    /// The values in it, by their names in the translation.
    pub values: Vec<(&'static str, String)>,
    /// The whole sentence in English.
    pub english: String,
}

impl Saying {
    /// A sentence with a translation.
    #[must_use]
    pub fn new(
        key: impl Into<String>,
        values: &[(&'static str, &str)],
        english: impl Into<String>,
    ) -> Self {
        Self {
            key: key.into(),
            values: values
                .iter()
                .map(|(name, value)| (*name, (*value).to_owned()))
                .collect(),
            english: english.into(),
        }
    }
}

/// A sentence that nobody has translated: the line and the field of a file that is no good, say.
impl From<String> for Saying {
    fn from(english: String) -> Self {
        Self::new("", &[], english)
    }
}
