//! The report as CSV.

use crate::report::speed_and_error::{Method, Report};

/// One table: its file, its columns, its rows.
type Sheet = (&'static str, &'static [&'static str], Vec<Vec<String>>);

/// Every table as a CSV file: name and text.
///
/// # Errors
/// What the writer of CSV says.
pub fn csv(report: &Report) -> Result<Vec<(&'static str, String)>, csv::Error> {
    let sheets = [
        errors(report),
        statistics(report),
        crowds(report),
        grids(report),
        drifts(report),
    ];
    let text = |(name, columns, rows): Sheet| Ok((name, text(columns, rows)?));
    sheets.into_iter().map(text).collect()
}

fn text(columns: &[&str], rows: Vec<Vec<String>>) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(columns)?;
    for row in rows {
        writer.write_record(&row)?;
    }
    let bytes = writer
        .into_inner()
        .map_err(csv::IntoInnerError::into_error)?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn number(value: f64) -> String {
    format!("{value:e}")
}

fn tick(method: Method) -> String {
    method
        .rate()
        .map_or(String::new(), |rate| number(1.0 / f64::from(rate)))
}

fn errors(report: &Report) -> Sheet {
    let mut rows = Vec::new();
    for scene in &report.scenes {
        let front = scene.front();
        for (place, measured) in scene.measured.iter().enumerate() {
            let errors = &measured.errors;
            let differing = errors.differing;
            let first = errors.agreed.filter(|_| differing > 0);
            rows.push(vec![
                scene.rung.name.clone(),
                measured.method.family().to_owned(),
                tick(measured.method),
                number(measured.cost),
                number(errors.rms),
                number(errors.most),
                number(errors.energy),
                first.map_or(String::new(), |agreed| agreed.to_string()),
                errors
                    .agreed
                    .map_or(String::new(), |_| differing.to_string()),
                scene.truths.len().to_string(),
                number(scene.until().0),
                number(scene.floor()),
                front.contains(&place).to_string(),
            ]);
        }
    }
    let columns = &[
        "scene",
        "method",
        "tick_s",
        "cost_s_per_s",
        "error_rms_m",
        "error_most_m",
        "energy_error",
        "first_differing_contact",
        "starts_differing",
        "starts",
        "compared_until_s",
        "floor_m",
        "on_front",
    ];
    ("errors.csv", columns, rows)
}

fn statistics(report: &Report) -> Sheet {
    let mut rows = Vec::new();
    for ensemble in &report.ensembles {
        for (i, quantity) in ensemble.quantities.iter().enumerate() {
            let (mean, spread) = ensemble.values[i];
            rows.push(vec![
                ensemble.scene.clone(),
                ensemble.method.family().to_owned(),
                tick(ensemble.method),
                (*quantity).to_owned(),
                ensemble.shots.to_string(),
                number(mean),
                number(spread),
                number(ensemble.off[i]),
            ]);
        }
    }
    let columns = &[
        "scene",
        "method",
        "tick_s",
        "quantity",
        "shots",
        "mean",
        "standard_deviation",
        "standard_errors_off",
    ];
    ("statistics.csv", columns, rows)
}

fn crowds(report: &Report) -> Sheet {
    let row = |cost: &super::CrowdCost| {
        vec![
            cost.what.clone(),
            cost.balls.to_string(),
            number(cost.nanoseconds),
        ]
    };
    let columns = &["what", "balls", "nanoseconds_per_ball_and_120th_s"];
    (
        "cost-per-ball.csv",
        columns,
        report.crowds.iter().map(row).collect(),
    )
}

fn grids(report: &Report) -> Sheet {
    let row = |cost: &super::GridCost| {
        vec![
            cost.what.to_owned(),
            cost.cells.to_string(),
            number(cost.side),
            number(cost.diameters),
            number(cost.milliseconds),
        ]
    };
    let columns = &[
        "way",
        "cells_along_a_side",
        "cell_m",
        "cell_diameters",
        "milliseconds_per_tick",
    ];
    ("grid.csv", columns, report.grids.iter().map(row).collect())
}

fn drifts(report: &Report) -> Sheet {
    let mut rows = Vec::new();
    for drift in &report.drifts {
        for (time, off) in &drift.points {
            rows.push(vec![
                drift.scene.clone(),
                drift.method.family().to_owned(),
                tick(drift.method),
                number(*time),
                number(*off),
            ]);
        }
    }
    let columns = &["scene", "method", "tick_s", "time_s", "energy_off"];
    ("energy.csv", columns, rows)
}
