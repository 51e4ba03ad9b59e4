//! One line of the tables: what should come out, what comes out, and how far apart they may be.

use serde::Serialize;

/// Relative error that is allowed where a closed form is compared.
pub const CLOSED_FORM: f64 = 1e-9;

/// What the error of a row is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Measure {
    /// |ours − expected| in the unit of the row.
    Absolute,
    /// |ours − expected| / |expected|.
    Relative,
    /// Root of the mean square of ours − measured over a set of points, in the unit of the row.
    Rms,
    /// Root of the mean square of ours/measured − 1 over a set of points.
    RelativeRms,
}

/// One comparison.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// Which judge or experiment, and what of it.
    pub name: String,
    /// The law, or the solver.
    pub law: String,
    /// What a closed form, a publication or a measurement says; of a set of points the mean.
    pub expected: f64,
    /// What our functions say; of a set of points the mean.
    pub ours: f64,
    /// How far apart they are, as `measure` says.
    pub error: f64,
    /// Largest error that passes.
    pub tolerance: f64,
    /// Whether the error is within the tolerance; never for an error that is no number.
    pub pass: bool,
    /// Unit of `expected` and `ours`; empty for a pure number.
    pub unit: &'static str,
    /// What `error` and `tolerance` are.
    pub measure: Measure,
    /// Where the expected value and the tolerance come from.
    pub source: &'static str,
    /// Why the row misses, or what to know about it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
}

impl Row {
    /// A value with a closed form, to [`CLOSED_FORM`] of it.
    #[must_use]
    pub fn closed(name: &str, law: &str, expected: f64, ours: f64, unit: &'static str) -> Self {
        Self::new(name, law, expected, ours, unit)
            .judged(Measure::Relative, CLOSED_FORM)
            .by("closed form")
    }

    /// A value that should vanish, to an absolute tolerance.
    #[must_use]
    pub fn zero(name: &str, law: &str, ours: f64, tolerance: f64, unit: &'static str) -> Self {
        Self::new(name, law, 0.0, ours, unit)
            .judged(Measure::Absolute, tolerance)
            .by("closed form")
    }

    /// A value to an absolute tolerance.
    #[must_use]
    pub fn near(
        name: &str,
        law: &str,
        expected: f64,
        ours: f64,
        unit: &'static str,
        tolerance: f64,
    ) -> Self {
        Self::new(name, law, expected, ours, unit).judged(Measure::Absolute, tolerance)
    }

    /// A value that is printed with this many decimals: to half a unit of the last one, and a hundredth of it for a tie.
    #[must_use]
    pub fn printed(
        name: &str,
        law: &str,
        (expected, decimals): (f64, i32),
        ours: f64,
        unit: &'static str,
    ) -> Self {
        let last = libm::pow(10.0, f64::from(-decimals));
        Self::new(name, law, expected, ours, unit).judged(Measure::Absolute, 0.51 * last)
    }

    /// A measured value with its tolerance.
    #[must_use]
    pub fn measured(
        name: &str,
        law: &str,
        expected: f64,
        ours: f64,
        unit: &'static str,
        (measure, tolerance): (Measure, f64),
    ) -> Self {
        Self::new(name, law, expected, ours, unit).judged(measure, tolerance)
    }

    /// A set of measured points, each with ours beside it, judged by the root of the mean square of their distances.
    #[must_use]
    pub fn points(
        name: &str,
        law: &str,
        points: &[(f64, f64)],
        unit: &'static str,
        (measure, tolerance): (Measure, f64),
    ) -> Self {
        let count = points.len() as f64;
        let mean =
            |value: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(value).sum::<f64>() / count;
        let square = match measure {
            Measure::Relative | Measure::RelativeRms => {
                mean(&|(measured, ours)| (ours / measured - 1.0) * (ours / measured - 1.0))
            }
            Measure::Absolute | Measure::Rms => {
                mean(&|(measured, ours)| (ours - measured) * (ours - measured))
            }
        };
        let mut row = Self::new(
            name,
            law,
            mean(&|point| point.0),
            mean(&|point| point.1),
            unit,
        );
        row.error = square.sqrt();
        row.measure = measure;
        row.allow(tolerance);
        row
    }

    /// What a part of the judge that could not be computed leaves behind: a miss that tells why.
    #[must_use]
    pub fn stopped(name: &str, why: &str) -> Self {
        let mut row = Self::new(name, "solver", f64::NAN, f64::NAN, "");
        row.note = Some(why.to_owned());
        row
    }

    fn new(name: &str, law: &str, expected: f64, ours: f64, unit: &'static str) -> Self {
        Self {
            name: name.to_owned(),
            law: law.to_owned(),
            expected,
            ours,
            error: f64::NAN,
            tolerance: 0.0,
            pass: false,
            unit,
            measure: Measure::Absolute,
            source: "",
            note: None,
        }
    }

    fn judged(mut self, measure: Measure, tolerance: f64) -> Self {
        let distance = (self.ours - self.expected).abs();
        self.measure = measure;
        self.error = match measure {
            Measure::Relative | Measure::RelativeRms => distance / self.expected.abs(),
            Measure::Absolute | Measure::Rms => distance,
        };
        self.allow(tolerance);
        self
    }

    fn allow(&mut self, tolerance: f64) {
        self.tolerance = tolerance;
        self.pass = self.error <= tolerance;
    }

    /// The same row with another tolerance.
    #[must_use]
    pub fn within(mut self, tolerance: f64) -> Self {
        self.allow(tolerance);
        self
    }

    /// The same row with the source of its expected value.
    #[must_use]
    pub fn by(mut self, source: &'static str) -> Self {
        self.source = source;
        self
    }

    /// The same row with a sentence that is kept only if it misses.
    #[must_use]
    pub fn because(mut self, why: &str) -> Self {
        if !self.pass && !why.is_empty() {
            self.note = Some(why.to_owned());
        }
        self
    }

    /// The same row with a remark.
    #[must_use]
    pub fn remark(mut self, remark: &str) -> Self {
        self.note = Some(remark.to_owned());
        self
    }
}
