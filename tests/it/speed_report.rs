//! `masse report`, run as a person runs it, and what its numbers must say whatever the machine.

use std::collections::HashMap;
use std::path::Path;

use crate::cli::{err, folder, masse, out, output};

/// The rows of a CSV file by the names of their columns.
fn sheet(folder: &Path, name: &str) -> Vec<HashMap<String, String>> {
    let mut reader = csv::Reader::from_path(folder.join(name)).expect("the report writes it");
    reader
        .deserialize()
        .collect::<Result<_, _>>()
        .expect("every row has its columns")
}

fn number(row: &HashMap<String, String>, column: &str) -> f64 {
    row[column].parse().expect(column)
}

#[test]
fn a_small_report_says_what_is_true() {
    let folder = folder("speed-report");
    let report = output(
        masse()
            .args(["report", "--quick", "--balls", "100", "--out", "here"])
            .args(["--scene", "two-ball-cuts", "--scene", "gas"])
            .current_dir(&folder),
    );
    assert_eq!(report.status.code(), Some(0), "{}", err(&report));
    assert!(!err(&report).contains('\r'), "no bar without a terminal");
    let text = std::fs::read_to_string(folder.join("here/report.md")).expect("the table");
    assert_eq!(out(&report), text);
    for part in [
        "## two-ball-cuts",
        "exact to rounding | 2: pass",
        "best are",
        "single precision",
        "all but one at rest, with cloth and spin\" costs",
    ] {
        assert!(text.contains(part), "{part}");
    }
    let folder = folder.join("here");
    let rows = sheet(&folder, "errors.csv");
    assert_eq!(rows.len(), (1 + 3 * 5) + (1 + 4 * 5));
    for row in &rows {
        assert!(number(row, "cost_s_per_s") > 0.0, "{row:?}");
        let [rms, most] = ["error_rms_m", "error_most_m"].map(|column| number(row, column));
        assert!(rms >= 0.0 && rms <= most && most < 100.0, "{row:?}");
        let energy = number(row, "energy_error");
        match row["method"].as_str() {
            "exact" => assert!(rms == 0.0 && energy == 0.0, "{row:?}"),
            "stepped" | "stepped, as a crowd" => {
                assert!(rms < 1e-9 && energy < 1e-12, "{row:?}");
            }
            // Off by rounding from the first contact on, and by as much as you like at the horizon.
            "stepped, as a crowd in f32" => {
                assert!(rms > 1e-9 && energy > 1e-12 && energy < 1e-5, "{row:?}");
            }
            _ => assert!(rms > 1e-4, "{row:?}"),
        }
        if row["method"].starts_with("stepped, contacts") && row["scene"] == "gas" {
            assert!(
                energy < 1e-12,
                "elastic impacts keep it wherever they happen: {row:?}"
            );
        }
    }
    // The front always holds the exact solver: nothing has less error.
    let exact = rows.iter().filter(|row| row["method"] == "exact");
    assert!(exact.clone().count() == 2 && exact.clone().all(|row| row["on_front"] == "true"));
    let plain: Vec<f64> = rows
        .iter()
        .filter(|row| row["scene"] == "two-ball-cuts" && row["method"].contains("not located"))
        .map(|row| number(row, "error_rms_m"))
        .collect();
    assert!(
        plain[0] > 3.0 * plain[4],
        "it falls with the tick: {plain:?}"
    );

    let energy = sheet(&folder, "energy.csv");
    let at_start = |row: &&HashMap<String, String>| number(row, "time_s") == 0.0;
    assert!(energy.len() > 100 && energy.iter().filter(at_start).count() == 7);
    for row in &energy {
        let most = if row["method"].ends_with("f32") {
            1e-5
        } else {
            1e-12
        };
        assert!(number(row, "energy_off").abs() < most, "{row:?}");
    }
    grid_is_told(&folder);
    // Three solvers with cloth and without, a crowd in f32, and one at rest.
    let costs = sheet(&folder, "cost-per-ball.csv");
    assert_eq!(costs.len(), 8);
    for part in ["in f32", "at rest"] {
        assert!(
            costs.iter().any(|row| row["what"].contains(part)),
            "{part}: {costs:?}"
        );
    }
    gas_is_counted(&folder);
    for name in [
        "speed-against-error",
        "error-against-tick",
        "cost-per-ball",
        "grid",
        "energy",
    ] {
        let picture = std::fs::read_to_string(folder.join(format!("{name}.svg"))).expect(name);
        assert!(
            picture.starts_with("<svg") && !picture.contains("NaN"),
            "{name}"
        );
    }
}

/// What is counted of a gas of 100 balls, three times by each of seven methods.
fn gas_is_counted(folder: &Path) {
    let rows = sheet(folder, "statistics.csv");
    assert_eq!(rows.len(), 7 * 2);
    let (rates, spreads): (Vec<_>, Vec<_>) = rows
        .iter()
        .partition(|row| row["quantity"].starts_with("contacts"));
    for row in rates {
        // A gas of so few is mostly walls: a tenth above the 51.2 of an endless one.
        let rate = number(row, "mean");
        let plain = row["method"].contains("not located");
        assert!(
            (if plain { 35.0 } else { 51.0 }..60.0).contains(&rate),
            "{row:?}"
        );
    }
    for row in spreads {
        assert!((1.5..2.5).contains(&number(row, "mean")), "{row:?}");
    }
}

/// The experiment with cells, for 100 balls.
fn grid_is_told(folder: &Path) {
    let grid = sheet(folder, "grid.csv");
    assert_eq!(grid.len(), 3 * 12);
    for row in &grid {
        let cells = number(row, "cells_along_a_side");
        let [metres, diameters] = ["cell_m", "cell_diameters"].map(|column| number(row, column));
        assert!((metres / diameters - 0.05715).abs() < 1e-12);
        // 100 balls that cover 0.4 of the floor.
        assert!((metres * cells - 0.8008).abs() < 1e-3, "{row:?}");
        assert!(number(row, "milliseconds_per_tick") > 0.0);
    }
}

#[test]
fn bad_wishes_are_refused_before_anything_is_measured() {
    let folder = folder("bad-report");
    std::fs::write(folder.join("file"), "").expect("a file");
    for (arguments, code, says) in [
        (&["--scene", "nonsense"][..], 2, "two-ball-cuts"),
        (&["--balls", "7"], 2, "100"),
        (&["--balls", "many"], 2, "--balls"),
        (&["--tick", "1"], 2, "--tick"),
        (&["--out", "file/below"], 3, "cannot be written"),
        (&["--out", "file"], 3, "cannot be written"),
    ] {
        let report = output(masse().arg("report").args(arguments).current_dir(&folder));
        assert_eq!(
            report.status.code(),
            Some(code),
            "{arguments:?}: {}",
            err(&report)
        );
        assert!(
            err(&report).contains(says),
            "{arguments:?}: {}",
            err(&report)
        );
        assert!(out(&report).is_empty());
    }
    assert_eq!(
        std::fs::read_dir(&folder).expect("a folder").count(),
        1,
        "nothing is written"
    );
}
