//! Sentences for a player, in words that the window can translate.
//!
//! Rooms without pixels know no language: they say what happened with a key, the values in it and the English sentence.
//! The window looks the key up in the language that is spoken and falls back to the sentence.

/// A sentence for a player, or a part of one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saying {
    /// The key of its translation in `assets/languages`; empty if there is none.
    pub key: String,
    /// The values in it, by their names in the translation.
    pub values: Vec<(&'static str, Value)>,
    /// The whole sentence in English, without those that follow.
    pub english: String,
    /// Sentences that follow, each on a line of its own.
    pub then: Vec<Saying>,
}

/// A value in a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// The same in every language: what a person typed, the name of a file, a measure.
    Text(String),
    /// A number that decides between singular and plural.
    Number(i64),
    /// Words of their own.
    Saying(Box<Saying>),
    /// One or another of these.
    AnyOf(Vec<Saying>),
    /// All of these.
    AllOf(Vec<Saying>),
}

impl Value {
    /// In English.
    #[must_use]
    pub fn english(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Number(number) => number.to_string(),
            Self::Saying(saying) => saying.english.clone(),
            Self::AnyOf(list) => enumerated(list, "or"),
            Self::AllOf(list) => enumerated(list, "and"),
        }
    }
}

fn enumerated(list: &[Saying], last: &str) -> String {
    let names: Vec<&str> = list.iter().map(|saying| saying.english.as_str()).collect();
    match names.split_last() {
        None => "nothing".to_owned(),
        Some((only, [])) => (*only).to_owned(),
        Some((end, rest)) => format!("{} {last} {end}", rest.join(", ")),
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<i64> for Value {
    fn from(number: i64) -> Self {
        Self::Number(number)
    }
}

impl From<usize> for Value {
    fn from(number: usize) -> Self {
        Self::Number(i64::try_from(number).unwrap_or(i64::MAX))
    }
}

impl From<Saying> for Value {
    fn from(saying: Saying) -> Self {
        Self::Saying(Box::new(saying))
    }
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
                .map(|(name, value)| (*name, Value::from(*value)))
                .collect(),
            english: english.into(),
            then: Vec::new(),
        }
    }

    /// A sentence with a translation, whose English has the names of the values in braces.
    #[must_use]
    pub fn of(key: &str, values: Vec<(&'static str, Value)>, english: &str) -> Self {
        Self {
            english: filled(english, &values),
            key: key.to_owned(),
            values,
            then: Vec::new(),
        }
    }

    /// Sentences, each on a line of its own; `None` if there are none.
    #[must_use]
    pub fn lines(sayings: impl IntoIterator<Item = Self>) -> Option<Self> {
        let mut sayings = sayings.into_iter();
        let mut first = sayings.next()?;
        first.then.extend(sayings);
        Some(first)
    }
}

/// Every `{name}` is replaced by the value with that name. What is filled in is not looked at again.
fn filled(template: &str, values: &[(&'static str, Value)]) -> String {
    let mut text = String::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('{') {
        let Some((name, behind)) = after.split_once('}') else {
            break;
        };
        text.push_str(before);
        if let Some((_, value)) = values.iter().find(|(known, _)| *known == name) {
            text.push_str(&value.english());
        }
        rest = behind;
    }
    text.push_str(rest);
    text
}

/// A sentence that nobody has translated: the line and the field of a file that is no good, say.
impl From<String> for Saying {
    fn from(english: String) -> Self {
        Self::new("", &[], english)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn english_is_filled_in_once() {
        let values = vec![("name", "{many}".into()), ("many", 3_usize.into())];
        let said = Saying::of("key", values, "{name} has {many}{none} of {");
        assert_eq!(said.english, "{many} has 3 of {");
        let list = |count: usize| {
            let names = ["one", "two", "three"];
            names[..count]
                .iter()
                .map(|name| Saying::from((*name).to_owned()))
                .collect::<Vec<_>>()
        };
        assert_eq!(Value::AnyOf(list(0)).english(), "nothing");
        assert_eq!(Value::AnyOf(list(1)).english(), "one");
        assert_eq!(Value::AllOf(list(2)).english(), "one and two");
        assert_eq!(Value::AnyOf(list(3)).english(), "one, two or three");
        let lines = Saying::lines(list(3)).expect("there are three");
        assert_eq!((lines.english.as_str(), lines.then.len()), ("one", 2));
        assert_eq!(Saying::lines([]), None);
    }
}
