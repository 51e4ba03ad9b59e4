//! The hard cases H1 to H16: what breaks simulators of billiards, with the outcome that is right, played by both solvers
//! wherever it applies to them.
//!
//! Collapse and pressing, several contacts at once, corners, near misses, equal motions, slides of almost nothing, mass
//! ratios, fast balls, chaos, the order of a tick, energy and symmetry. Every row is computed by the same functions that
//! the game plays with; the tests call this suite, case by case.
//!
//! A new case is one function that returns rows and one entry in [`ALL`].

mod alone;
mod collapse;
mod cradle;
mod cushions;
mod grazing;
mod pairs;
mod pressed;
mod racks;
mod symmetry;
mod ticks;

use std::fmt::Write;

use glam::DVec3;
use serde::Serialize;

use crate::physics::laws::Laws;
use crate::physics::laws::cushion::{CushionLaw, Mirror};
use crate::physics::laws::motion::MotionLaw;
use crate::physics::record::Record;
use crate::physics::scene::{Scene, Solver, Stepped};
use crate::report::audit::{Audit, Worst};
use crate::report::judge::stand::{self, Stand};
use crate::report::judge::table::columns;
use crate::sim::play::{Stopped, play};

/// One row: what must happen and what happened.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Hard {
    /// Which of H1 to H16.
    pub case: &'static str,
    /// The scene.
    pub scene: String,
    /// `exact`, `stepped`, or `laws` for a law without a solver.
    pub solver: String,
    /// What must happen.
    pub must: String,
    /// What happened.
    pub happened: String,
    /// Decimal digits that agree with what must happen, where that is a number; at most 16.
    pub digits: Option<f64>,
    /// Whether it happened.
    pub pass: bool,
}

/// The rows of one case.
type Rows = Result<Vec<Hard>, Stopped>;

/// Every case, in order.
pub const ALL: &[(&str, fn() -> Rows)] = &[
    ("H1", collapse::rows),
    ("H2", pressed::rows),
    ("H3", racks::mirrored),
    ("H4", cradle::rows),
    ("H5", cushions::rows),
    ("H6", grazing::tangency),
    ("H7", pairs::equal_motions),
    ("H8", racks::audited),
    ("H9", alone::almost_rolling),
    ("H10", alone::spinning),
    ("H11", pairs::masses),
    ("H12", grazing::fast),
    ("H13", pairs::chaos),
    ("H14", ticks::rows),
    ("H15", symmetry::energy),
    ("H16", symmetry::frames),
];

/// The rows of one case; a solver that stops is a row that misses and says why.
#[must_use]
pub fn case(name: &'static str, rows: fn() -> Rows) -> Vec<Hard> {
    rows().unwrap_or_else(|stopped| {
        let claim = Claim::new(name, "whole case", "solver", "ends");
        vec![claim.fact(false, stopped.to_string())]
    })
}

/// Plays all cases, each on a thread of its own.
#[must_use]
pub fn suite() -> Vec<Hard> {
    std::thread::scope(|scope| {
        let running: Vec<_> = ALL
            .iter()
            .map(|&(name, rows)| (name, scope.spawn(move || case(name, rows))))
            .collect();
        let rows = running.into_iter().flat_map(|(name, rows)| {
            rows.join().unwrap_or_else(|_| {
                let claim = Claim::new(name, "whole case", "solver", "ends");
                vec![claim.fact(false, "its computation panicked".to_owned())]
            })
        });
        rows.collect()
    })
}

/// The suite as a table for a terminal.
#[must_use]
pub fn text(rows: &[Hard]) -> String {
    let head = ["", "scene", "solver", "must", "happened", "digits", ""].map(str::to_owned);
    let cells: Vec<[String; 7]> = rows
        .iter()
        .map(|row| {
            [
                row.case.to_owned(),
                row.scene.clone(),
                row.solver.clone(),
                row.must.clone(),
                row.happened.clone(),
                row.digits
                    .map_or(String::new(), |digits| format!("{digits:.1}")),
                if row.pass { "pass" } else { "MISS" }.to_owned(),
            ]
        })
        .collect();
    let lines = columns(&head, &cells, 5..6);
    let mut text =
        "HARD CASES: what breaks simulators, with the outcome that is right\n\n".to_owned();
    let mut last = "";
    for (i, line) in lines.iter().enumerate() {
        // A line of space before the next case.
        let case = i.checked_sub(1).map_or("", |row| rows[row].case);
        if case != last {
            text.push('\n');
            last = case;
        }
        let _ = writeln!(text, "{line}");
    }
    let passed = rows.iter().filter(|row| row.pass).count();
    let _ = writeln!(
        text,
        "\nhard cases: {passed} of {} as they must be",
        rows.len()
    );
    text
}

/// Who plays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum By {
    Exact,
    Stepped,
}

impl By {
    const BOTH: [Self; 2] = [Self::Exact, Self::Stepped];

    fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Stepped => "stepped",
        }
    }

    /// Plays a scene to its end.
    fn play(self, scene: &Scene) -> Result<Record, Stopped> {
        let mut scene = scene.clone();
        scene.solver = match (self, scene.solver) {
            (Self::Exact, _) => Solver::Exact,
            (Self::Stepped, Solver::Stepped(stepped)) => Solver::Stepped(stepped),
            (Self::Stepped, Solver::Exact) => Solver::Stepped(Stepped::default()),
        };
        play(&scene)
    }

    /// The same with its audit.
    fn audit(self, scene: &Scene) -> Result<(Record, Worst), Stopped> {
        let record = self.play(scene)?;
        let worst = Audit::of(scene, &record);
        Ok((record, worst))
    }
}

/// What must happen in a scene.
struct Claim(Hard);

impl Claim {
    fn new(
        case: &'static str,
        scene: impl Into<String>,
        solver: impl Into<String>,
        must: impl Into<String>,
    ) -> Self {
        Self(Hard {
            case,
            scene: scene.into(),
            solver: solver.into(),
            must: must.into(),
            happened: String::new(),
            digits: None,
            pass: false,
        })
    }

    /// It happened, or it did not.
    fn fact(mut self, pass: bool, happened: impl Into<String>) -> Hard {
        self.0.pass = pass;
        self.0.happened = happened.into();
        self.0
    }

    /// It happened but for this relative error, which passes up to a tolerance.
    fn error(mut self, error: f64, tolerance: f64, happened: impl Into<String>) -> Hard {
        self.0.digits = Some((-libm::log10(error.max(1e-16))).clamp(0.0, 16.0));
        if error.is_nan() {
            self.0.digits = None;
        }
        self.fact(error <= tolerance, happened)
    }
}

/// No cloth, no friction, this restitution of balls and of cushions.
fn smooth(balls: f64, cushions: f64) -> Laws {
    Laws {
        motion: MotionLaw::Frictionless,
        ball_ball: stand::smooth(balls),
        cushion: CushionLaw::Mirror(Mirror {
            restitution: cushions.into(),
        }),
        ..Laws::ideal()
    }
}

/// Adds a pool ball that moves and spins.
fn put(scene: &mut Scene, name: &str, x: f64, z: f64, velocity: DVec3, spin: DVec3) -> usize {
    let index = scene.place(name, Stand::POOL.ball, x, z);
    scene.balls[index].state.velocity = velocity;
    scene.balls[index].state.angular_velocity = spin;
    index
}

/// The largest of many numbers, NaN if one is no number.
fn worst(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(0.0, |worst, number| {
        if number.is_nan() || worst.is_nan() {
            f64::NAN
        } else {
            worst.max(number)
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_miss_is_told() {
        let claim = || Claim::new("H1", "scene", "exact", "must");
        assert!(claim().error(1e-12, 1e-11, "").pass);
        assert!((claim().error(1e-12, 1e-11, "").digits.expect("a number") - 12.0).abs() < 1e-9);
        assert!(!claim().error(1e-10, 1e-11, "").pass);
        assert!(!claim().error(f64::NAN, 1.0, "").pass);
        assert!(worst([1.0, f64::NAN, 2.0]).is_nan());
        let rows = [claim().fact(true, "yes"), claim().fact(false, "no")];
        let text = text(&rows);
        assert!(text.contains("MISS") && text.contains("1 of 2"), "{text}");
    }
}
