//! The table of judges: what `masse judge` prints and draws.

use std::sync::LazyLock;

use masse::report::chart::{Axis, Chart, Ink, Panel, Series, draw};
use masse::report::judge::pictures;
use masse::report::judge::{Judgement, Measure, Row};
use serde_json::Value;

use crate::cli::{err, folder, masse, out, output};

/// Everything, with the built-in presets.
fn judge(allowance: f64) -> Judgement {
    let presets: Vec<_> = masse::scenarios::preset::BUILT_IN
        .iter()
        .map(|preset| {
            let equipment = preset.preset().expect("a built-in preset").equipment;
            (preset.name.to_owned(), equipment)
        })
        .collect();
    masse::report::judge::judge(allowance, &presets)
}

/// The same as it is judged always, computed once for all tests.
pub(crate) fn judged() -> &'static Judgement {
    static JUDGED: LazyLock<Judgement> = LazyLock::new(|| judge(1.0));
    &JUDGED
}

#[test]
fn every_exact_judge_passes() {
    let judgement = judged();
    assert!(
        judgement.exact.len() > 300,
        "{} rows",
        judgement.exact.len()
    );
    for row in &judgement.exact {
        assert!(
            row.pass,
            "{} | {}: {} instead of {}",
            row.name, row.law, row.ours, row.expected
        );
        assert!(
            row.tolerance > 0.0 && !row.source.is_empty(),
            "{}",
            row.name
        );
    }
}

#[test]
fn a_tolerance_of_nothing_is_missed() {
    let judgement = judge(0.0);
    let missed = judgement.missed();
    // What is exact to the last bit passes even then; closed forms with a sine in them do not.
    assert!(
        missed.len() > 50 && missed.len() < judgement.exact.len(),
        "{}",
        missed.len()
    );
    // Experiments have the scatter of others: they are not scaled.
    assert_eq!(judgement.experiments, judged().experiments);
}

#[test]
fn every_registered_law_has_rows_in_both_tables() {
    use masse::physics::laws::{ball_ball::BallBallLaw, cushion::CushionLaw};
    let judgement = judged();
    let names = BallBallLaw::all()
        .into_iter()
        .map(|law| format!("{law:?}"))
        .chain(CushionLaw::all().into_iter().map(|law| format!("{law:?}")));
    for name in names {
        let name = name.split('(').next().expect("a name");
        for table in [&judgement.exact, &judgement.experiments] {
            let rows = table.iter().filter(|row| row.law.starts_with(name)).count();
            assert!(rows >= 3, "{name}: {rows} rows");
        }
    }
}

#[test]
fn a_missed_experiment_tells_why() {
    let judgement = judged();
    for preset in ["preset snooker", "preset heated_carom"] {
        assert!(judgement.experiments.iter().any(|row| row.law == preset));
    }
    assert!(judgement.experiments.iter().any(|row| row.pass));
    for row in judgement.experiments.iter().filter(|row| !row.pass) {
        assert!(row.note.is_some(), "{} | {}", row.name, row.law);
    }
}

#[test]
fn the_errors_of_the_coursework_are_those_that_were_found_before() {
    // Computed by another program from the formulas of the report.
    let judgement = judged();
    for (name, ours, tolerance) in [
        (
            "C1 drag fitted to the whole path of a 2 m/s shot: speed after 0.291 s",
            1.896,
            1e-3,
        ),
        (
            "C1 drag fitted to the whole path of a 2 m/s shot: speed when it should rest",
            0.131,
            1e-3,
        ),
        ("C3 square stun at 2 m/s: object ball", 2.0, 1e-12),
        (
            "C4 half-ball at 2 m/s, tick 1/60 s, normal at the overlap: direction out by",
            12.4,
            0.3,
        ),
        (
            "C4 half-ball at 2 m/s, tick 1/120 s, normal at the overlap: direction out by",
            5.0,
            0.2,
        ),
    ] {
        let row = judgement
            .coursework
            .iter()
            .find(|row| row.name == name)
            .expect(name);
        assert!((row.ours - ours).abs() <= tolerance, "{name}: {}", row.ours);
        assert!(!row.pass, "{name}");
    }
}

#[test]
fn rows_measure_what_they_say() {
    let row = Row::closed("a", "law", 2.0, 2.0 + 1e-6, "m");
    assert!(!row.pass && row.measure == Measure::Relative);
    assert!((row.error - 0.5e-6).abs() < 1e-15);
    assert!(row.clone().within(1e-6).pass);
    assert!(
        !Row::closed("a", "law", 2.0, f64::NAN, "m")
            .within(f64::INFINITY)
            .pass
    );
    assert!(Row::printed("a", "law", (1.23, 2), 1.2349, "m").pass);
    assert!(!Row::printed("a", "law", (1.23, 2), 1.2351, "m").pass);
    let points = [(1.0, 1.3), (2.0, 2.0), (4.0, 4.0)];
    let row = Row::points("a", "law", &points, "m", (Measure::Rms, 0.1));
    assert!((row.error - 0.3 / 3.0_f64.sqrt()).abs() < 1e-15 && !row.pass);
    assert!(Row::points("a", "law", &points, "m", (Measure::RelativeRms, 0.18)).pass);
    assert!(row.because("why").note.is_some());
    assert!(
        Row::zero("a", "law", 0.0, 0.0, "")
            .because("why")
            .note
            .is_none()
    );
}

#[test]
fn judge_prints_tables_and_draws_pictures() {
    let folder = folder("judge-text");
    let run = output(masse().arg("judge").current_dir(&folder));
    assert_eq!(run.status.code(), Some(0), "{}", err(&run));
    let text = out(&run);
    for part in [
        "EXACT JUDGES",
        "EXPERIMENTS",
        "THE COURSEWORK MODEL",
        "MISS",
        "J5 largest deflection",
    ] {
        assert!(text.contains(part), "{part}");
    }
    for (name, _) in pictures::ALL {
        let picture = std::fs::read_to_string(folder.join("judge").join(name)).expect(name);
        assert!(
            picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"),
            "{name}"
        );
        assert!(
            picture.contains("coursework") && !picture.contains("NaN"),
            "{name}"
        );
    }
}

#[test]
fn judge_writes_json_and_no_file() {
    let folder = folder("judge-json");
    let run = output(masse().args(["judge", "--json"]).current_dir(&folder));
    assert_eq!(run.status.code(), Some(0), "{}", err(&run));
    let tables: Value = serde_json::from_str(&out(&run)).expect("JSON");
    for (table, most) in [("exact", 10_000), ("experiments", 10_000)] {
        let rows = tables[table].as_array().expect(table);
        assert!(rows.len() > 20 && rows.len() < most);
        for row in rows {
            for text in ["name", "law", "unit", "measure", "source"] {
                assert!(row[text].is_string(), "{text}: {row}");
            }
            for number in ["expected", "ours", "error", "tolerance"] {
                assert!(row[number].is_f64(), "{number}: {row}");
            }
            let within = row["error"].as_f64() <= row["tolerance"].as_f64();
            assert_eq!(row["pass"], Value::Bool(within), "{row}");
        }
    }
    let files = std::fs::read_dir(&folder).expect("a folder").count();
    assert_eq!(files, 0, "JSON alone writes no pictures");
}

#[test]
fn exit_codes_of_judge() {
    let folder = folder("judge-codes");
    let code = |arguments: &[&str]| {
        let run = output(masse().arg("judge").args(arguments).current_dir(&folder));
        (run.status.code(), err(&run))
    };
    let (missed, says) = code(&["--allow", "0", "--no-pictures"]);
    assert_eq!(missed, Some(1));
    assert!(says.contains("exact judges miss"), "{says}");
    assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 0);
    for bad in [
        &["--allow", "-1"][..],
        &["--allow", "nan"],
        &["--out", "x", "--no-pictures"],
        &["J5"],
    ] {
        assert_eq!(code(bad).0, Some(2), "{bad:?}");
    }
    std::fs::write(folder.join("file"), "").expect("a file");
    let (unwritable, says) = code(&["--json", "--out", "file/pictures"]);
    assert_eq!(unwritable, Some(3));
    assert!(says.contains("file/pictures"), "{says}");
}

#[test]
fn a_chart_has_axes_a_legend_and_gaps() {
    let chart = |x: Axis, y: Axis| Chart {
        title: "a < b".to_owned(),
        panels: vec![Panel {
            title: "panel".to_owned(),
            x,
            y,
            series: vec![
                Series::new(
                    "curve",
                    Ink::line(1),
                    vec![
                        (1.0, 1.0),
                        (2.0, 4.0),
                        (3.0, f64::NAN),
                        (4.0, 16.0),
                        (5.0, 25.0),
                    ],
                ),
                Series::new("points", Ink::dots(0), vec![(1.0, 2.0), (9.0, 2.0)]),
            ],
        }],
        columns: 1,
    };
    let text = draw(&chart(
        Axis::linear("x, m", 0.5, 6.0),
        Axis::linear("y, m", 0.0, 30.0),
    ))
    .expect("a chart");
    for part in ["a &lt; b", "panel", "x, m", "y, m", "curve", "points"] {
        assert!(text.contains(part), "{part}");
    }
    // A gap cuts the curve in two, a point beyond the axes is left out, and the legend has a sample of each.
    let red = "stroke=\"#D55E00\"";
    assert_eq!(text.matches(red).count(), 3, "{text}");
    assert_eq!(text.matches("<circle").count(), 2, "{text}");
    let log = draw(&chart(
        Axis::log("x, m", 0.5, 6.0),
        Axis::log("y, m", 0.5, 30.0),
    ))
    .expect("a chart");
    assert!(log != text && log.contains("<polyline"));
}
