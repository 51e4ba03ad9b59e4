//! The judge: every law beside its paper, beside closed forms and beside experiments.
//!
//! Three tables of [`Row`]s. *Exact* judges have one right answer, a closed form or a published number, and must pass.
//! *Experiments* are measurements by others with their scatter; a law that misses one stays in the table as a miss, with
//! the reason where it is known. The third table measures the coursework model by both. What is ours in a row is always
//! computed by the laws and the solvers that the game uses; what is expected never is.
//!
//! The names J1 to J19, H15, H16, E1 to E12 and C1 to C5 are this project's own numbers for them. No coefficient was
//! fitted to an experiment by us; where the authors of a law fitted theirs to the set, the row says so.
//!
//! A new judge is one function that returns rows and one entry in its list; a new law that is registered in the `all()`
//! of its class is judged by itself.

mod coursework;
mod exact;
mod experiments;
pub mod hard;
mod measurements;
pub mod pictures;
mod row;
pub(in crate::report) mod stand;
pub(in crate::report) mod table;

pub use experiments::Named;
pub use row::{CLOSED_FORM, Measure, Row};

use serde::Serialize;

use crate::sim::play::Stopped;

/// Everything the judge says.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Judgement {
    /// Closed forms and published numbers.
    pub exact: Vec<Row>,
    /// Measurements by others.
    pub experiments: Vec<Row>,
    /// What the model of the coursework report makes of both.
    pub coursework: Vec<Row>,
}

/// What computes something.
#[derive(Clone, Copy, Debug)]
pub enum Work<T> {
    /// By the laws alone.
    Laws(fn() -> T),
    /// By whole shots, which a solver may refuse to play.
    Shots(fn() -> Result<T, Stopped>),
}

impl<T> Work<T> {
    /// Computes it.
    ///
    /// # Errors
    /// [`Stopped`] if a solver cannot play a shot.
    pub fn run(&self) -> Result<T, Stopped> {
        match self {
            Self::Laws(compute) => Ok(compute()),
            Self::Shots(compute) => compute(),
        }
    }
}

/// A group of rows: the name it has if it cannot be computed, and what computes it.
type Family = (&'static str, Work<Vec<Row>>);

/// Judges every law, and the presets of equipment given. Tolerances of the exact judges are multiplied by `allowance`: 1 is what they are judged by, less
/// shows how much room is left.
#[must_use]
pub fn judge(allowance: f64, presets: &[Named]) -> Judgement {
    let mut exact = gather(exact::ALL);
    for row in &mut exact {
        *row = row.clone().within(allowance * row.tolerance);
    }
    let mut experiments = gather(experiments::ALL);
    experiments.extend(experiments::preset_rows(presets));
    Judgement {
        exact,
        experiments,
        coursework: gather(coursework::ALL),
    }
}

/// Runs every family on a thread of its own; rows stay in the order of the list.
fn gather(families: &[Family]) -> Vec<Row> {
    let stopped = |name: &str, why: &str| vec![Row::stopped(name, why)];
    std::thread::scope(|scope| {
        let running: Vec<_> = families
            .iter()
            .map(|(name, compute)| (name, scope.spawn(|| compute.run())))
            .collect();
        let rows = running.into_iter().map(|(name, rows)| match rows.join() {
            Ok(Ok(rows)) => rows,
            Ok(Err(why)) => stopped(name, &why.to_string()),
            Err(_) => stopped(name, "its computation panicked"),
        });
        rows.flatten().collect()
    })
}

impl Judgement {
    /// The names of the exact judges that miss.
    #[must_use]
    pub fn missed(&self) -> Vec<&str> {
        self.exact
            .iter()
            .filter(|row| !row.pass)
            .map(|row| row.name.as_str())
            .collect()
    }

    /// The tables as text.
    #[must_use]
    pub fn text(&self) -> String {
        table::text(self)
    }
}
