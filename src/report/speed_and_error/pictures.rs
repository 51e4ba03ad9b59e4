//! The charts of the report.

use crate::report::chart::{Axis, Chart, Ink, Panel, Series};
use crate::report::speed_and_error::fit::Convergence;
use crate::report::speed_and_error::tables::{best_grids, families};
use crate::report::speed_and_error::{Comparison, Method, Report};

/// Errors below this are drawn at it: an axis of powers of ten has no zero.
const LEAST: f64 = 1e-16;

/// A file name and the chart that it holds.
type Picture = (&'static str, Chart);

/// Every picture that there is something for.
#[must_use]
pub fn pictures(report: &Report) -> Vec<Picture> {
    let mut pictures = Vec::new();
    if !report.scenes.is_empty() {
        pictures.push(("speed-against-error.svg", speed_against_error(report)));
        pictures.push(("error-against-tick.svg", error_against_tick(report)));
    }
    pictures.push(("cost-per-ball.svg", cost_per_ball(report)));
    pictures.push(("grid.svg", grid(report)));
    pictures.push(("energy.svg", energy(report)));
    pictures
}

/// Ink of the families of methods.
fn ink(method: Method) -> usize {
    match method {
        Method::Exact => 3,
        Method::Located(_) => 2,
        Method::Crowd(_) => 5,
        Method::Single(_) => 4,
        Method::Plain(_) => 6,
        Method::Coursework(_) => 1,
    }
}

/// The powers of ten around some values above 0.
fn decades(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for value in values.filter(|value| value.is_finite() && *value > 0.0) {
        (least, most) = (least.min(value), most.max(value));
    }
    if most == 0.0 {
        return (0.1, 1.0);
    }
    let from = (libm::log10(least) + 1e-6).floor();
    let to = (libm::log10(most) - 1e-6).ceil().max(from + 1.0);
    (libm::pow(10.0, from), libm::pow(10.0, to))
}

/// A line and a dot at each of its points.
fn marked(label: &str, colour: usize, points: Vec<(f64, f64)>) -> [Series; 2] {
    [
        Series::new(label, Ink::line(colour), points.clone()),
        Series::new("", Ink::dots(colour), points),
    ]
}

fn speed_against_error(report: &Report) -> Chart {
    let panel = |scene: &Comparison| {
        let point = |place: usize| {
            let measured = &scene.measured[place];
            (1e3 * measured.cost, measured.errors.rms.max(LEAST))
        };
        let all: Vec<(f64, f64)> = (0..scene.measured.len()).map(point).collect();
        let front: Vec<(f64, f64)> = scene.front().into_iter().map(point).collect();
        let mut series = vec![
            Series::new("", Ink::dashed(0), front.clone()),
            Series::new("nothing is better in both", Ink::rings(0), front),
        ];
        for family in families(scene) {
            let points = scene
                .measured
                .iter()
                .zip(&all)
                .filter(|(m, _)| m.method.family() == family.family());
            series.extend(marked(
                family.family(),
                ink(family),
                points.map(|(_, point)| *point).collect(),
            ));
        }
        let (from, to) = decades(all.iter().map(|point| point.0));
        Panel {
            title: scene.rung.name.clone(),
            x: Axis::log("processor time, ms for a second", from, to),
            y: Axis::log("error rms, m", LEAST / 10.0, 10.0),
            series,
        }
    };
    Chart {
        title: "Error against cost; an error of 0 is drawn at 1e-16, and each line is one method at several ticks".to_owned(),
        panels: report.scenes.iter().map(panel).collect(),
        columns: report.scenes.len().min(3),
    }
}

fn error_against_tick(report: &Report) -> Chart {
    let rates = &report.effort.rates;
    let (from, to) = decades(rates.iter().map(|rate| 1.0 / f64::from(*rate)));
    let panel = |scene: &Comparison| {
        let mut series = Vec::new();
        let mut orders = Vec::new();
        for family in families(scene) {
            let points: Vec<(f64, f64)> = scene
                .family(family)
                .filter_map(|m| Some((1.0 / f64::from(m.method.rate()?), m.errors.rms.max(LEAST))))
                .collect();
            if points.is_empty() {
                continue;
            }
            if let (Method::Located(_) | Method::Plain(_), order) =
                (family, scene.convergence(family))
            {
                let how = if matches!(family, Method::Located(_)) {
                    "located"
                } else {
                    "not"
                };
                match order {
                    Convergence::Rounding => orders.push(format!("{how}: exact to rounding")),
                    Convergence::Order { order, .. } => {
                        orders.push(format!("{how}: order {order:.2}"));
                    }
                    Convergence::Unknown => {}
                }
            }
            series.extend(marked(family.family(), ink(family), points));
        }
        let floor = scene.floor().max(LEAST);
        series.push(Series::new(
            "turned by 1e-13 rad",
            Ink::dotted(0),
            vec![(from, floor), (to, floor)],
        ));
        Panel {
            title: format!("{} ({})", scene.rung.name, orders.join(", ")),
            x: Axis::log("tick, s", from, to),
            y: Axis::log("error rms, m", LEAST / 10.0, 10.0),
            series,
        }
    };
    Chart {
        title: "Error against the length of a tick, and the order of the fit".to_owned(),
        panels: report.scenes.iter().map(panel).collect(),
        columns: report.scenes.len().min(3),
    }
}

fn cost_per_ball(report: &Report) -> Chart {
    let mut series: Vec<Series> = Vec::new();
    let mut labels: Vec<&str> = Vec::new();
    for cost in &report.crowds {
        if !labels.contains(&cost.what.as_str()) {
            labels.push(&cost.what);
        }
    }
    for label in labels {
        let points = report.crowds.iter().filter(|cost| cost.what == label);
        let points: Vec<(f64, f64)> = points
            .map(|cost| (f64::from(cost.balls), cost.nanoseconds))
            .collect();
        // One colour for each way, with cloth dashed.
        let colour = match label {
            _ if label.contains("at rest") => 6,
            _ if label.starts_with("exact") => ink(Method::Exact),
            _ if label.contains("f32") => ink(Method::Single(60)),
            _ if label.contains("crowd") => ink(Method::Crowd(60)),
            _ => ink(Method::Located(60)),
        };
        let line = if label.contains("cloth") {
            Ink::dashed(colour)
        } else {
            Ink::line(colour)
        };
        series.push(Series::new(label, line, points.clone()));
        series.push(Series::new("", Ink::dots(colour), points));
    }
    let (x_from, x_to) = decades(report.crowds.iter().map(|cost| f64::from(cost.balls)));
    let (y_from, y_to) = decades(report.crowds.iter().map(|cost| cost.nanoseconds));
    Chart {
        title: "What a ball costs: balls that cover 0.4 of the floor at 1 m/s".to_owned(),
        panels: vec![Panel {
            title: "one thread".to_owned(),
            x: Axis::log("balls", x_from, x_to.max(1e3)),
            y: Axis::log("processor time, ns a ball and 1/120 s", y_from, y_to),
            series,
        }],
        columns: 1,
    }
}

fn grid(report: &Report) -> Chart {
    let mut series = Vec::new();
    let best = best_grids(report);
    for (place, best) in best.iter().enumerate() {
        let points = report.grids.iter().filter(|cost| cost.what == best.what);
        let points = points
            .map(|cost| (f64::from(cost.cells), cost.milliseconds))
            .collect();
        let label = format!("{}; best {} x {}", best.what, best.cells, best.cells);
        series.extend(marked(&label, 1 + place, points));
    }
    let (x_from, x_to) = decades(report.grids.iter().map(|cost| f64::from(cost.cells)));
    let (y_from, y_to) = decades(report.grids.iter().map(|cost| cost.milliseconds));
    Chart {
        title: format!(
            "Time of a tick against the grid, {} balls",
            report.grid_balls
        ),
        panels: vec![Panel {
            title: "one thread; dot lowest: the best grid".to_owned(),
            x: Axis::log("cells along each side", x_from, x_to),
            y: Axis::log("processor time, ms a tick", y_from, y_to),
            series,
        }],
        columns: 1,
    }
}

fn energy(report: &Report) -> Chart {
    let mut panels: Vec<Panel> = Vec::new();
    for drift in &report.drifts {
        let points: Vec<(f64, f64)> = drift
            .points
            .iter()
            .map(|(time, off)| (*time, off.abs().max(LEAST)))
            .collect();
        let end = points.last().map_or(1.0, |point| point.0);
        let place = panels
            .iter()
            .position(|panel| panel.title == drift.scene)
            .unwrap_or_else(|| {
                panels.push(Panel {
                    title: drift.scene.clone(),
                    x: Axis::linear("time, s", 0.0, end),
                    y: Axis::log("energy off, of that at the start", LEAST / 10.0, 10.0),
                    series: Vec::new(),
                });
                panels.len() - 1
            });
        let ink = match drift.method.rate() {
            Some(rate) if rate > 60 => Ink::dashed(ink(drift.method)),
            _ => Ink::line(ink(drift.method)),
        };
        panels[place]
            .series
            .push(Series::new(&drift.method.to_string(), ink, points));
    }
    Chart {
        title: "How far the energy is off; 0 is drawn at 1e-16".to_owned(),
        columns: panels.len().max(1),
        panels,
    }
}
