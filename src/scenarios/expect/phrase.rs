//! Sentences that can be said in any language: a key, the English of it, and the values in it. The command line says the
//! English; the window looks the key up among its texts.

use std::fmt::{self, Display, Formatter};

use serde::{Serialize, Serializer};

/// A phrase: its key, its English, and the values in it.
macro_rules! say {
    ($key:literal, $english:literal $(, $name:ident: $value:expr)* $(,)?) => {
        $crate::scenarios::expect::phrase::Phrase {
            key: $key,
            english: $english,
            values: vec![$((stringify!($name), $crate::scenarios::expect::phrase::Word::from($value))),*],
        }
    };
}

pub(super) use say;

/// A sentence, or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Phrase {
    /// The key of its translations.
    pub key: &'static str,
    /// The English text, in which `{name}` stands for a value.
    pub english: &'static str,
    /// The values by their names.
    pub values: Vec<(&'static str, Word)>,
}

/// A value in a sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum Word {
    /// The name of a ball.
    Ball(String),
    /// The name of a pocket.
    Pocket(String),
    /// A number with all its digits.
    Number(f64),
    /// A number with so many digits after the point.
    Digits(f64, usize),
    /// A whole number.
    Count(usize),
    /// A unit; every language writes it the same.
    Unit(&'static str),
    /// Another phrase.
    Part(Box<Phrase>),
    /// Another phrase that is apart from what stands before it, if there is one.
    Apart(Option<Box<Phrase>>),
    /// What comes one after the other.
    Then(Vec<Phrase>),
}

impl From<Phrase> for Word {
    fn from(phrase: Phrase) -> Self {
        Self::Part(Box::new(phrase))
    }
}

impl Display for Word {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Self::Ball(name) => write!(f, "`{name}`"),
            Self::Pocket(name) => f.write_str(name),
            Self::Number(value) => write!(f, "{value}"),
            Self::Digits(value, digits) => write!(f, "{value:.digits$}"),
            Self::Count(count) => write!(f, "{count}"),
            Self::Unit(unit) => f.write_str(unit),
            Self::Part(phrase) => phrase.fmt(f),
            Self::Apart(None) => Ok(()),
            Self::Apart(Some(phrase)) => write!(f, " {phrase}"),
            Self::Then(phrases) => {
                let told: Vec<String> = phrases.iter().map(Phrase::to_string).collect();
                f.write_str(&told.join(", then "))
            }
        }
    }
}

impl Display for Phrase {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let mut rest = self.english;
        while let Some((before, after)) = rest.split_once('{') {
            f.write_str(before)?;
            let (name, after) = after.split_once('}').unwrap_or((after, ""));
            if let Some((_, word)) = self.values.iter().find(|(other, _)| *other == name) {
                word.fmt(f)?;
            }
            rest = after;
        }
        f.write_str(rest)
    }
}

/// As the English sentence.
impl Serialize for Phrase {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
