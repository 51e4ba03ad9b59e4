//! Fields of a line: found by name, read, and compared with what they should be.

use serde::Deserialize;
use serde_json::Value;

/// A field of a line that is no good.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Problem {
    /// Path of the field.
    pub(super) field: String,
    /// What is wrong.
    pub(super) what: String,
}

impl Problem {
    pub(super) fn new(field: impl Into<String>, what: impl Into<String>) -> Self {
        Self {
            field: field.into(),
            what: what.into(),
        }
    }
}

/// A value of a line and the path that leads to it.
#[derive(Clone, Debug)]
pub(super) struct Field<'v> {
    path: String,
    value: &'v Value,
}

impl<'v> Field<'v> {
    /// A line as a whole.
    pub(super) fn line(value: &'v Value) -> Self {
        Self {
            path: String::new(),
            value,
        }
    }

    /// The field of an object.
    pub(super) fn get(&self, name: &str) -> Result<Self, Problem> {
        let path = join(&self.path, name);
        match self.value.get(name) {
            Some(value) => Ok(Self { path, value }),
            None => Err(Problem::new(path, "the field is missing")),
        }
    }

    /// The items of a list.
    pub(super) fn items(&self) -> Result<impl Iterator<Item = Self> + use<'v>, Problem> {
        let Value::Array(items) = self.value else {
            return Err(self.problem(format!("{} is no list", short(self.value))));
        };
        let path = self.path.clone();
        Ok(items.iter().enumerate().map(move |(i, value)| Self {
            path: format!("{path}[{i}]"),
            value,
        }))
    }

    /// The value.
    pub(super) fn read<T: Deserialize<'v>>(&self) -> Result<T, Problem> {
        T::deserialize(self.value).map_err(|error| self.problem(error.to_string()))
    }

    pub(super) fn problem(&self, what: impl Into<String>) -> Problem {
        Problem::new(self.path.clone(), what)
    }
}

/// The first place where the value found is not the one expected. Numbers are equal if their bits are.
pub(super) fn difference(found: &Value, expected: &Value) -> Result<(), Problem> {
    compare("", found, expected)
}

fn compare(path: &str, found: &Value, expected: &Value) -> Result<(), Problem> {
    match (found, expected) {
        (Value::Object(found), Value::Object(expected)) => {
            if let Some(name) = found.keys().find(|name| !expected.contains_key(*name)) {
                return Err(Problem::new(
                    join(path, name),
                    "no such field is known here",
                ));
            }
            expected
                .iter()
                .try_for_each(|(name, expected)| match found.get(name) {
                    Some(found) => compare(&join(path, name), found, expected),
                    None => Err(Problem::new(join(path, name), "the field is missing")),
                })
        }
        (Value::Array(found), Value::Array(expected)) if found.len() == expected.len() => found
            .iter()
            .zip(expected)
            .enumerate()
            .try_for_each(|(i, (found, expected))| {
                compare(&format!("{path}[{i}]"), found, expected)
            }),
        (Value::Number(a), Value::Number(b)) if bits(a) == bits(b) => Ok(()),
        _ if found == expected && !found.is_number() => Ok(()),
        _ => Err(Problem::new(
            path,
            format!(
                "{} does not fit the other lines, which make it {}",
                short(found),
                short(expected)
            ),
        )),
    }
}

fn bits(number: &serde_json::Number) -> Option<u64> {
    number.as_f64().map(f64::to_bits)
}

fn join(path: &str, name: &str) -> String {
    if path.is_empty() {
        name.to_owned()
    } else {
        format!("{path}.{name}")
    }
}

/// A value in at most some sixty characters.
fn short(value: &Value) -> String {
    let text = value.to_string();
    if text.chars().count() <= 60 {
        return text;
    }
    text.chars().take(57).chain("...".chars()).collect()
}
