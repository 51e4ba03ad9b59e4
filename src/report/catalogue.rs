//! Every law with its source, its numbers and what the judges say of it.

use serde::Serialize;

use crate::physics::cue::Cue;
use crate::physics::laws::ball_ball::BallBallLaw;
use crate::physics::laws::cushion::CushionLaw;
use crate::physics::laws::motion::MotionLaw;
use crate::physics::laws::pocket::PocketLaw;
use crate::physics::laws::slate::SlateLaw;
use crate::physics::laws::source::{SIMULTANEOUS, Source};
use crate::physics::laws::{Check, Parameter, cue_ball};
use crate::report::judge::stand::name_of;
use crate::report::judge::table::columns;
use crate::report::judge::{CLOSED_FORM, Judgement, Row};

/// A law.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Entry {
    /// The field of the laws of a scene that names it, or what it is otherwise about.
    pub class: &'static str,
    /// What a scene file calls it.
    pub name: String,
    /// Where it comes from.
    pub source: Source,
    /// Its numbers, with their defaults and ranges.
    pub numbers: Vec<Number>,
}

/// A number of a law.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Number {
    /// Its path from the scene, as in `set` of a preset and in `masse sweep`.
    pub path: String,
    /// What it is where nothing is said.
    pub default: f64,
    /// The least allowed.
    pub least: f64,
    /// The most allowed.
    pub most: f64,
    /// What the range rests on, and what has been measured.
    pub basis: &'static str,
}

fn entry(class: &'static str, name: String, source: Source, numbers: Vec<Parameter>) -> Entry {
    let within = if class == "cue" {
        class.to_owned()
    } else {
        format!("laws.{class}")
    };
    let number = |parameter: Parameter| Number {
        path: format!("{within}.{}", parameter.field),
        default: parameter.value,
        least: parameter.least,
        most: parameter.most,
        basis: parameter.basis,
    };
    Entry {
        class,
        name,
        source,
        numbers: numbers.into_iter().map(number).collect(),
    }
}

/// Every registered law, class by class; then the stroke, and impacts at one moment.
#[must_use]
pub fn all() -> Vec<Entry> {
    let mut all = Vec::new();
    for law in MotionLaw::all() {
        all.push(entry(
            "motion",
            name_of(&law),
            law.source(),
            law.parameters(),
        ));
    }
    for law in BallBallLaw::all() {
        all.push(entry(
            "ball_ball",
            name_of(&law),
            law.source(),
            law.parameters(),
        ));
    }
    for law in CushionLaw::all() {
        all.push(entry(
            "cushion",
            name_of(&law),
            law.source(),
            law.parameters(),
        ));
    }
    for law in SlateLaw::all() {
        all.push(entry(
            "slate",
            name_of(&law),
            law.source(),
            law.parameters(),
        ));
    }
    for law in PocketLaw::all() {
        all.push(entry(
            "pocket",
            name_of(&law),
            law.source(),
            law.parameters(),
        ));
    }
    let stroke = "strike".to_owned();
    all.push(entry(
        "cue",
        stroke,
        cue_ball::SOURCE,
        Cue::default().parameters(),
    ));
    let cluster = "cluster".to_owned();
    all.push(entry("simultaneous", cluster, SIMULTANEOUS, Vec::new()));
    all
}

impl Entry {
    /// Whether a row of the judges is about this law: rows name theirs first, and then its numbers.
    #[must_use]
    pub fn is_judged_by(&self, row: &Row) -> bool {
        // Two classes have a law of this name; without cloth there is nothing to judge.
        let other = self.class == "motion" && self.name == "Frictionless";
        !other && row.law.split(", ").any(|part| part == self.name)
    }

    /// What the judges say of it.
    #[must_use]
    pub fn verdict(&self, judgement: &Judgement) -> Verdict {
        let exact = || judgement.exact.iter().filter(|row| self.is_judged_by(row));
        let closed = || exact().filter(|row| row.tolerance <= CLOSED_FORM);
        let printed = || exact().filter(|row| row.tolerance > CLOSED_FORM);
        // The model of the coursework is measured in a table of its own.
        let measured = || {
            let rows = judgement.experiments.iter().chain(&judgement.coursework);
            rows.filter(|row| self.is_judged_by(row))
        };
        Verdict {
            closed_forms: Share::of(closed()),
            largest_error: closed().map(|row| row.error).reduce(f64::max),
            printed: Share::of(printed()),
            experiments: Share::of(measured()),
        }
    }
}

/// What the judges say of a law.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Verdict {
    /// Comparisons with closed forms.
    pub closed_forms: Share,
    /// The largest error of these, relative, or absolute where the value should vanish.
    pub largest_error: Option<f64>,
    /// Comparisons with numbers as printed in papers, to half their last digit.
    pub printed: Share,
    /// Comparisons with experiments; for the model of the coursework with real physics too.
    pub experiments: Share,
}

/// How many of how many pass.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Share {
    /// Within what is allowed.
    pub pass: usize,
    /// All.
    pub of: usize,
}

impl Share {
    fn of<'r>(rows: impl Iterator<Item = &'r Row>) -> Self {
        rows.fold(Self::default(), |share, row| Self {
            pass: share.pass + usize::from(row.pass),
            of: share.of + 1,
        })
    }

    fn text(self) -> String {
        match self.of {
            0 => "-".to_owned(),
            of => format!("{} of {of}", self.pass),
        }
    }
}

/// All laws as a table, a line each.
#[must_use]
pub fn table(judgement: &Judgement) -> String {
    let head = [
        "class",
        "law",
        "closed forms",
        "error",
        "printed",
        "experiments",
        "source",
    ];
    let row = |entry: &Entry| {
        let verdict = entry.verdict(judgement);
        let error = verdict.largest_error;
        [
            entry.class.to_owned(),
            entry.name.clone(),
            verdict.closed_forms.text(),
            error.map_or_else(|| "-".to_owned(), |error| format!("{error:.1e}")),
            verdict.printed.text(),
            verdict.experiments.text(),
            entry.source.paper.to_owned(),
        ]
    };
    let rows: Vec<_> = all().iter().map(row).collect();
    let mut text = columns(&head.map(str::to_owned), &rows, 2..6).join("\n");
    text.push('\n');
    text
}

/// One law in full.
#[must_use]
pub fn sheet(entry: &Entry, judgement: &Judgement) -> String {
    let Source {
        paper,
        formula,
        leaves_out,
    } = entry.source;
    let mut lines = vec![
        format!("{} ({})", entry.name, entry.class),
        format!("source      {paper}"),
        format!("formula     {formula}"),
        format!("leaves out  {leaves_out}"),
    ];
    if !entry.numbers.is_empty() {
        lines.push(String::new());
        let head = ["number", "default", "least", "most", "what is known"];
        let number = |number: &Number| {
            [
                number.path.clone(),
                number.default.to_string(),
                number.least.to_string(),
                number.most.to_string(),
                number.basis.to_owned(),
            ]
        };
        let numbers: Vec<_> = entry.numbers.iter().map(number).collect();
        lines.extend(columns(&head.map(str::to_owned), &numbers, 1..4));
    }
    let Judgement {
        exact,
        experiments,
        coursework,
    } = judgement.clone();
    let about = |rows: Vec<Row>| {
        rows.into_iter()
            .filter(|row| entry.is_judged_by(row))
            .collect()
    };
    let own = Judgement {
        exact: about(exact),
        experiments: about(experiments),
        coursework: about(coursework),
    };
    let mut text = lines.join("\n");
    text.push_str("\n\n");
    text.push_str(&own.text());
    text
}
