//! The tables as text for a terminal.

use std::fmt::Write;
use std::ops::Range;

use crate::report::judge::{Judgement, Measure, Row};

/// Widest line of a sentence below a row, characters.
const LINE: usize = 116;

/// What stands above the columns.
const HEAD: [&str; 7] = ["", "law", "expected", "ours", "error", "allowed", ""];

pub(super) fn text(judgement: &Judgement) -> String {
    let mut text = String::new();
    let tables = [
        (
            "EXACT JUDGES: closed forms and published numbers",
            &judgement.exact,
        ),
        (
            "EXPERIMENTS: what others measured; a miss stays a miss",
            &judgement.experiments,
        ),
        (
            "THE COURSEWORK MODEL: its own errors, beside the exact solver and beside the experiments",
            &judgement.coursework,
        ),
    ];
    // Of one law there may be no rows of a kind.
    let tables = tables.iter().filter(|(_, rows)| !rows.is_empty());
    for (title, rows) in tables.clone() {
        table(&mut text, title, rows);
    }
    for (title, rows) in tables {
        let title = title.split(':').next().unwrap_or(title).to_lowercase();
        let passed = rows.iter().filter(|row| row.pass).count();
        let _ = writeln!(
            text,
            "{title}: {passed} of {} within what is allowed",
            rows.len()
        );
    }
    text
}

fn table(text: &mut String, title: &str, rows: &[Row]) {
    let cells: Vec<[String; 7]> = rows.iter().map(cells).collect();
    let lines = columns(&HEAD.map(str::to_owned), &cells, 2..6);
    let _ = writeln!(text, "{title}\n");
    let _ = writeln!(text, "{}", lines[0]);
    let mut family = "";
    for (i, row) in rows.iter().enumerate() {
        // A line of space before the next judge or experiment.
        let named = row.name.split_whitespace().next().unwrap_or("");
        if named != family {
            text.push('\n');
            family = named;
        }
        let _ = writeln!(text, "{}", lines[i + 1]);
        // A sentence that holds for several rows is told once, below the last of them.
        let told_later = rows.get(i + 1).is_some_and(|next| next.note == row.note);
        if let Some(note) = row.note.as_ref().filter(|_| !told_later) {
            for part in wrapped(note) {
                let _ = writeln!(text, "    {part}");
            }
        }
    }
    text.push('\n');
}

/// A head and rows as lines with columns of even width, names to the left, the columns of numbers to the right.
pub(in crate::report) fn columns<const N: usize>(
    head: &[String; N],
    rows: &[[String; N]],
    numbers: Range<usize>,
) -> Vec<String> {
    let mut widths = [0; N];
    for row in rows.iter().chain([head]) {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = cell.chars().count().max(*width);
        }
    }
    let line = |cells: &[String; N]| {
        let mut line = String::new();
        for (i, (cell, width)) in cells.iter().zip(widths).enumerate() {
            let space = " ".repeat(width - cell.chars().count());
            if numbers.contains(&i) {
                line += &space;
                line += cell;
            } else {
                line += cell;
                line += &space;
            }
            line += "  ";
        }
        line.trim_end().to_owned()
    };
    [head].into_iter().chain(rows).map(line).collect()
}

fn cells(row: &Row) -> [String; 7] {
    [
        row.name.clone(),
        row.law.clone(),
        with_unit(&figures(row.expected, 7), row.unit),
        with_unit(&figures(row.ours, 7), row.unit),
        error(row.error, row),
        error(row.tolerance, row),
        if row.pass { "pass" } else { "MISS" }.to_owned(),
    ]
}

/// An error or a tolerance: small ones as powers of ten, others in percent or in the unit of the row.
fn error(value: f64, row: &Row) -> String {
    let relative = matches!(row.measure, Measure::Relative | Measure::RelativeRms);
    if value == 0.0 {
        "0".to_owned()
    } else if value.abs() < 1e-4 {
        format!("{value:.1e}")
    } else if relative {
        with_unit(&figures(100.0 * value, 4), "%")
    } else {
        with_unit(&figures(value, 4), row.unit)
    }
}

fn with_unit(number: &str, unit: &str) -> String {
    format!("{number} {unit}").trim_end().to_owned()
}

/// A number with this many figures, without zeros that say nothing.
fn figures(value: f64, figures: i32) -> String {
    let size = value.abs();
    if value == 0.0 {
        return "0".to_owned();
    }
    if !size.is_finite() {
        return "none".to_owned();
    }
    if !(1e-4..1e7).contains(&size) {
        return format!("{value:.2e}");
    }
    let before = libm::floor(libm::log10(size)) as i32 + 1;
    let decimals = usize::try_from(figures - before).unwrap_or(0);
    let text = format!("{value:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// A sentence in lines of at most [`LINE`] characters.
fn wrapped(sentence: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in sentence.split_whitespace() {
        let last = lines.len() - 1;
        let length = lines[last].chars().count();
        if length > 0 && length + 1 + word.chars().count() > LINE {
            lines.push(word.to_owned());
        } else {
            if length > 0 {
                lines[last].push(' ');
            }
            lines[last].push_str(word);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_figures_that_say_something() {
        for (value, text) in [
            (0.0, "0"),
            (1.428_571_428, "1.428571"),
            (90.0, "90"),
            (0.000_123_456_78, "0.0001234568"),
            (-33.748_989, "-33.74899"),
            (1.0e-13, "1.00e-13"),
            (f64::NAN, "none"),
        ] {
            assert_eq!(figures(value, 7), text);
        }
    }

    #[test]
    fn sentences_wrap_between_words() {
        let lines = wrapped(&"word ".repeat(60));
        assert!(lines.len() > 2 && lines.iter().all(|line| line.chars().count() <= LINE));
        assert_eq!(lines.join(" "), "word ".repeat(60).trim());
    }
}
