//! Charts: curves and points over two axes, in SVG.
//!
//! A [`Chart`] is one or more [`Panel`]s side by side with one legend for all of them: the same label has the same ink
//! everywhere. Drawn by the crate `plotters`; the same chart gives the same text, byte for byte.

mod draw;

pub use draw::draw;

/// One picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// What stands above it.
    pub title: String,
    /// Its panels, row by row.
    pub panels: Vec<Panel>,
    /// Panels in a row.
    pub columns: usize,
}

/// One pair of axes and what is drawn between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// What stands above it.
    pub title: String,
    /// To the right.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// Curves and points; later ones lie on top.
    pub series: Vec<Series>,
}

/// One axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What it shows, with the unit.
    pub label: String,
    /// Lower end.
    pub from: f64,
    /// Upper end.
    pub to: f64,
    /// How numbers are spread.
    pub scale: Scale,
}

impl Axis {
    /// An axis with even spacing.
    #[must_use]
    pub fn linear(label: &str, from: f64, to: f64) -> Self {
        Self {
            label: label.to_owned(),
            from,
            to,
            scale: Scale::Linear,
        }
    }

    /// An axis on which factors have the same length; both ends are above 0.
    #[must_use]
    pub fn log(label: &str, from: f64, to: f64) -> Self {
        Self {
            scale: Scale::Log,
            ..Self::linear(label, from, to)
        }
    }
}

/// How numbers are spread over an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their logarithm.
    Log,
}

/// One curve, or one set of points.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// What the legend calls it.
    pub label: String,
    /// x and y. Where a point lies outside the axes or is no number, a curve has a gap.
    pub points: Vec<(f64, f64)>,
    /// How it is drawn.
    pub ink: Ink,
}

impl Series {
    /// A curve or a set of points.
    #[must_use]
    pub fn new(label: &str, ink: Ink, points: Vec<(f64, f64)>) -> Self {
        Self {
            label: label.to_owned(),
            points,
            ink,
        }
    }

    /// A curve through the values of a function at evenly spaced points.
    #[must_use]
    pub fn curve(
        label: &str,
        ink: Ink,
        (from, to): (f64, f64),
        value: impl Fn(f64) -> f64,
    ) -> Self {
        const STEPS: u32 = 160;
        let points = (0..=STEPS)
            .map(|step| from + (to - from) * f64::from(step) / f64::from(STEPS))
            .map(|x| (x, value(x)))
            .collect();
        Self::new(label, ink, points)
    }
}

/// Colour and kind of mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ink {
    /// Place in [`PALETTE`], counted round.
    pub colour: usize,
    /// Kind of mark.
    pub stroke: Stroke,
}

impl Ink {
    /// A full line.
    #[must_use]
    pub const fn line(colour: usize) -> Self {
        Self {
            colour,
            stroke: Stroke::Line,
        }
    }

    /// A dashed line.
    #[must_use]
    pub const fn dashed(colour: usize) -> Self {
        Self {
            colour,
            stroke: Stroke::Dashed,
        }
    }

    /// A dotted line: over a full one both can be seen.
    #[must_use]
    pub const fn dotted(colour: usize) -> Self {
        Self {
            colour,
            stroke: Stroke::Dotted,
        }
    }

    /// Points.
    #[must_use]
    pub const fn dots(colour: usize) -> Self {
        Self {
            colour,
            stroke: Stroke::Dots,
        }
    }

    /// Circles around points of another series.
    #[must_use]
    pub const fn rings(colour: usize) -> Self {
        Self {
            colour,
            stroke: Stroke::Rings,
        }
    }
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stroke {
    /// A line through all points.
    Line,
    /// A dashed line through all points.
    Dashed,
    /// A dotted line through all points.
    Dotted,
    /// A dot at each point.
    Dots,
    /// A circle around each point.
    Rings,
}

/// Black for what was measured, then colours that can be told apart with any kind of colour vision, red, green, blue.
/// Source: Okabe & Ito, "Color universal design" (2008); its yellow is too faint for a line and left out.
pub const PALETTE: [(u8, u8, u8); 7] = [
    (0, 0, 0),
    (213, 94, 0),
    (0, 114, 178),
    (0, 158, 115),
    (204, 121, 167),
    (86, 180, 233),
    (230, 159, 0),
];
