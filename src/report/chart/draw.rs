//! From a chart to SVG.

use plotters::chart::{ChartBuilder, ChartContext};
use plotters::coord::Shift;
use plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use plotters::element::{Circle, PathElement};
use plotters::prelude::{
    Cartesian2d, Color, DrawingArea, DrawingAreaErrorKind, IntoDrawingArea, IntoFont, IntoLogRange,
    RGBColor, SVGBackend, Text,
};
use plotters::series::{DashedLineSeries, LineSeries};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{ShapeStyle, TextStyle};

use crate::report::chart::{Axis, Chart, Ink, PALETTE, Panel, Scale, Series, Stroke};

/// Units in a pixel: the library rounds to whole units, and a quarter of a pixel nobody sees.
const FINE: i32 = 4;
/// Size of a panel in pixels.
const PANEL: (i32, i32) = (520, 400);
/// Height of the title in pixels.
const TITLE: i32 = 46;
/// Width in pixels that a character of the legend may need.
const LETTER: i32 = 7;
/// Height of a line of the legend in pixels.
const ENTRY: i32 = 22;
/// Width in pixels of the sample of ink before each entry, margins included.
const SAMPLE: i32 = 56;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Fault = DrawingAreaErrorKind<std::io::Error>;

/// The chart as the text of an SVG file.
///
/// # Errors
/// A sentence of the drawing library; axes from the same number to the same number are the only known cause.
pub fn draw(chart: &Chart) -> Result<String, String> {
    let rows = chart.panels.len().div_ceil(chart.columns.max(1)).max(1) as i32;
    let columns = chart.columns.max(1) as i32;
    let entries = legend(chart);
    let longest = entries.iter().map(|(label, _)| label.chars().count()).max();
    let beside = SAMPLE + LETTER * longest.unwrap_or(0) as i32;
    let size = (columns * PANEL.0 + beside, TITLE + rows * PANEL.1);
    let mut text = String::new();
    paint(chart, &entries, (columns, rows), size, &mut text).map_err(|fault| fault.to_string())?;
    let drawn = format!(
        "<svg width=\"{}\" height=\"{}\"",
        FINE * size.0,
        FINE * size.1
    );
    Ok(text.replacen(
        &drawn,
        &format!("<svg width=\"{}\" height=\"{}\"", size.0, size.1),
        1,
    ))
}

fn paint(
    chart: &Chart,
    entries: &[(String, Ink)],
    (columns, rows): (i32, i32),
    size: (i32, i32),
    text: &mut String,
) -> Result<(), Fault> {
    let backend = SVGBackend::with_string(text, ((FINE * size.0) as u32, (FINE * size.1) as u32));
    let root = backend.into_drawing_area();
    root.fill(&RGBColor(255, 255, 255))?;
    root.draw(&Text::new(
        chart.title.clone(),
        (FINE * 18, FINE * 14),
        font(19),
    ))?;
    let (panels, beside) = root
        .margin(FINE * TITLE, 0, 0, 0)
        .split_horizontally(FINE * columns * PANEL.0);
    let areas = panels.split_evenly((rows as usize, columns as usize));
    for (panel, area) in chart.panels.iter().zip(&areas) {
        match (panel.x.scale, panel.y.scale) {
            (Scale::Linear, Scale::Linear) => fill(panel, area, linear(&panel.x), linear(&panel.y)),
            (Scale::Linear, Scale::Log) => fill(panel, area, linear(&panel.x), log(&panel.y)),
            (Scale::Log, Scale::Linear) => fill(panel, area, log(&panel.x), linear(&panel.y)),
            (Scale::Log, Scale::Log) => fill(panel, area, log(&panel.x), log(&panel.y)),
        }?;
    }
    for (place, (label, ink)) in entries.iter().enumerate() {
        let y = FINE * (40 + ENTRY * place as i32);
        sample(&beside, *ink, y)?;
        let style = font(13).pos(Pos::new(HPos::Left, VPos::Center));
        beside.draw(&Text::new(label.clone(), (FINE * (SAMPLE - 12), y), style))?;
    }
    root.present()
}

fn linear(axis: &Axis) -> std::ops::Range<f64> {
    axis.from..axis.to
}

fn log(
    axis: &Axis,
) -> impl AsRangedCoord<Value = f64, CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>> {
    (axis.from..axis.to).log_scale()
}

/// Every label once, in the order of its first appearance.
fn legend(chart: &Chart) -> Vec<(String, Ink)> {
    let mut entries: Vec<(String, Ink)> = Vec::new();
    for series in chart.panels.iter().flat_map(|panel| &panel.series) {
        if !series.label.is_empty() && entries.iter().all(|(label, _)| *label != series.label) {
            entries.push((series.label.clone(), series.ink));
        }
    }
    entries
}

fn fill<X, Y>(panel: &Panel, area: &Area, x: X, y: Y) -> Result<(), Fault>
where
    X: AsRangedCoord<Value = f64, CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>>,
    Y: AsRangedCoord<Value = f64, CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>>,
{
    let mut context = ChartBuilder::on(area)
        .margin(FINE * 12)
        .caption(&panel.title, font(15))
        .x_label_area_size(FINE * 42)
        .y_label_area_size(FINE * 58)
        .build_cartesian_2d(x, y)?;
    let [x_scale, y_scale] = [panel.x.scale, panel.y.scale];
    context
        .configure_mesh()
        .x_desc(&panel.x.label)
        .y_desc(&panel.y.label)
        .axis_desc_style(font(14))
        .label_style(font(12))
        .x_labels(8)
        .y_labels(8)
        .x_label_formatter(&move |value| tick(*value, x_scale))
        .y_label_formatter(&move |value| tick(*value, y_scale))
        .axis_style(stroke(RGBColor(80, 80, 80), 1))
        .bold_line_style(stroke(RGBColor(222, 222, 222), 1))
        .light_line_style(RGBColor(255, 255, 255).mix(0.0))
        .draw()?;
    for series in &panel.series {
        ink_in(panel, series, &mut context)?;
    }
    Ok(())
}

fn ink_in<X, Y>(
    panel: &Panel,
    series: &Series,
    context: &mut ChartContext<SVGBackend, Cartesian2d<X, Y>>,
) -> Result<(), Fault>
where
    X: Ranged<ValueType = f64>,
    Y: Ranged<ValueType = f64>,
{
    let colour = colour(series.ink);
    for run in inside(panel, &series.points) {
        match series.ink.stroke {
            Stroke::Line => {
                context.draw_series(LineSeries::new(run, stroke(colour, 2)))?;
            }
            Stroke::Dashed | Stroke::Dotted => {
                let (dash, gap) = dashes(series.ink.stroke);
                let line = DashedLineSeries::new(run, dash, gap, stroke(colour, 2));
                context.draw_series(line)?;
            }
            Stroke::Dots => {
                let dots = run
                    .into_iter()
                    .map(|point| Circle::new(point, FINE * 4, colour.filled()));
                context.draw_series(dots)?;
            }
            Stroke::Rings => {
                let ring = stroke(colour, 2);
                let rings = run
                    .into_iter()
                    .map(|point| Circle::new(point, FINE * 8, ring));
                context.draw_series(rings)?;
            }
        }
    }
    Ok(())
}

/// The stretches of a curve that lie inside the axes: the library would draw beyond them.
fn inside(panel: &Panel, points: &[(f64, f64)]) -> Vec<Vec<(f64, f64)>> {
    // A curve that runs along an edge is inside, whatever its last bit says.
    let holds = |axis: &Axis, value: f64| {
        let rounding = 1e-9 * (axis.to - axis.from);
        value >= axis.from - rounding && value <= axis.to + rounding
    };
    points
        .split(|(x, y)| !(holds(&panel.x, *x) && holds(&panel.y, *y)))
        .filter(|run| !run.is_empty())
        .map(<[(f64, f64)]>::to_vec)
        .collect()
}

/// The ink of an entry of the legend, at this height.
fn sample(area: &Area, ink: Ink, y: i32) -> Result<(), Fault> {
    let colour = colour(ink);
    let (from, to) = (FINE * 8, FINE * 36);
    match ink.stroke {
        Stroke::Line => area.draw(&PathElement::new([(from, y), (to, y)], stroke(colour, 2))),
        Stroke::Dashed | Stroke::Dotted => {
            let (dash, gap) = dashes(ink.stroke);
            for start in (from..to).step_by((dash + gap) as usize) {
                let end = (start + dash).min(to);
                area.draw(&PathElement::new([(start, y), (end, y)], stroke(colour, 2)))?;
            }
            Ok(())
        }
        Stroke::Dots => area.draw(&Circle::new(
            (i32::midpoint(from, to), y),
            FINE * 4,
            colour.filled(),
        )),
        Stroke::Rings => area.draw(&Circle::new(
            (i32::midpoint(from, to), y),
            FINE * 8,
            stroke(colour, 2),
        )),
    }
}

/// Lengths of the strokes of a broken line and of the gaps between them.
fn dashes(stroke: Stroke) -> (i32, i32) {
    match stroke {
        Stroke::Dotted => (FINE * 2, FINE * 4),
        _ => (FINE * 7, FINE * 5),
    }
}

fn colour(ink: Ink) -> RGBColor {
    let (red, green, blue) = PALETTE[ink.colour % PALETTE.len()];
    RGBColor(red, green, blue)
}

fn stroke(colour: RGBColor, pixels: i32) -> ShapeStyle {
    colour.stroke_width((FINE * pixels) as u32)
}

fn font(pixels: i32) -> TextStyle<'static> {
    ("sans-serif", FINE * pixels)
        .into_font()
        .color(&RGBColor(30, 30, 30))
}

/// A number below or beside an axis.
fn tick(value: f64, scale: Scale) -> String {
    match scale {
        Scale::Log => {
            let text = format!("{value:.2e}");
            let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
            let digits = digits.trim_end_matches('0').trim_end_matches('.');
            let plain = match (digits, power) {
                ("1", "-2") => "0.01",
                ("1", "-1") => "0.1",
                ("1", "0") => "1",
                ("1", "1") => "10",
                ("1", "2") => "100",
                _ => return format!("{digits}e{power}"),
            };
            plain.to_owned()
        }
        Scale::Linear => {
            // Ticks are round in the decimal system; what is beyond six decimals is rounding.
            let text = format!("{value:.6}");
            let text = text.trim_end_matches('0').trim_end_matches('.');
            if text == "-0" {
                "0".to_owned()
            } else {
                text.to_owned()
            }
        }
    }
}
