//! Reading a record file.

use std::path::Path;

use serde_json::Value;

use crate::kept;
use crate::report::record_file::body::{self, Body};
use crate::report::record_file::fields::Problem;
use crate::report::record_file::{FORMAT, RecordFileError, Recorded, VERSION};

/// Largest record file that is read, in bytes: some two million events.
const LARGEST: u64 = 1 << 30;

/// Reads a record file.
///
/// # Errors
/// [`RecordFileError`] if it cannot be read or is not a complete record.
pub fn read(path: &Path) -> Result<Recorded, RecordFileError> {
    let file = path.display().to_string();
    match kept::read(path, LARGEST) {
        Ok(text) => parse(&text, &file),
        Err(why) => Err(RecordFileError::Read { file, why }),
    }
}

/// Reads the text of a record file; `file` is what errors call it.
///
/// # Errors
/// [`RecordFileError`] if it is not a complete record.
pub fn parse(text: &str, file: &str) -> Result<Recorded, RecordFileError> {
    let mut lines = text.lines().enumerate().map(|(i, line)| (i + 1, line));
    let in_line = |line: usize| {
        move |problem: Problem| RecordFileError::Field {
            file: file.to_owned(),
            line,
            field: problem.field,
            problem: problem.what,
        }
    };
    let first = lines.next().map_or("", |(_, line)| line);
    let value = json(first, 1, file)?;
    check_format(&value, file)?;
    let mut recorded = body::header(&value).map_err(in_line(1))?;
    recorded
        .scene
        .check()
        .map_err(|problem| RecordFileError::Scene {
            file: file.to_owned(),
            problem,
        })?;
    let mut body = Body::of(&recorded);
    let mut last = 1;
    let mut record = None;
    for (line, text) in lines {
        if record.is_some() {
            return Err(RecordFileError::AfterTheEnd {
                file: file.to_owned(),
                line,
            });
        }
        record = body.line(&json(text, line, file)?).map_err(in_line(line))?;
        last = line;
    }
    let expected = std::mem::take(&mut body.expected);
    recorded.record = record.ok_or_else(|| RecordFileError::CutOff {
        file: file.to_owned(),
        line: last,
    })?;
    recorded.expected = expected;
    Ok(recorded)
}

fn json(line: &str, number: usize, file: &str) -> Result<Value, RecordFileError> {
    serde_json::from_str(line).map_err(|error| {
        let message = error.to_string();
        let place = format!(" at line {} column {}", error.line(), error.column());
        RecordFileError::Syntax {
            file: file.to_owned(),
            line: number,
            column: error.column().max(1),
            message: message.strip_suffix(&place).unwrap_or(&message).to_owned(),
        }
    })
}

fn check_format(value: &Value, file: &str) -> Result<(), RecordFileError> {
    let file = file.to_owned();
    if value.get("format").and_then(Value::as_str) != Some(FORMAT) {
        return Err(RecordFileError::NotARecord { file });
    }
    match value.get("version").and_then(Value::as_u64) {
        Some(VERSION) => Ok(()),
        Some(version) => Err(RecordFileError::Version { file, version }),
        None => Err(RecordFileError::Field {
            file,
            line: 1,
            field: "version".to_owned(),
            problem: "a whole number is needed here".to_owned(),
        }),
    }
}
