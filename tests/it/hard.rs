//! The hard cases H1 to H16, as `masse judge --hard` prints them: every row must be as it must be.

use std::sync::LazyLock;

use masse::report::judge::hard::ALL;
use serde_json::Value;

use crate::cli::{err, masse, out, output};

/// What `masse judge --hard --json` prints, played once for all tests.
fn printed() -> &'static [Value] {
    static PRINTED: LazyLock<Value> = LazyLock::new(|| {
        let run = output(masse().args(["judge", "--hard", "--json"]));
        assert_eq!(run.status.code(), Some(0), "{}\n{}", err(&run), out(&run));
        serde_json::from_str(&out(&run)).expect("JSON")
    });
    PRINTED["hard"].as_array().expect("hard")
}

/// Both solvers play the case, and everything is as it must be.
#[track_caller]
fn by_both(name: &str) {
    let rows: Vec<_> = printed().iter().filter(|row| row["case"] == name).collect();
    for row in &rows {
        assert_eq!(row["pass"], Value::Bool(true), "{row:#}");
    }
    for solver in ["exact", "stepped"] {
        let plays = |row: &&Value| {
            row["solver"]
                .as_str()
                .is_some_and(|by| by.starts_with(solver))
        };
        assert!(
            rows.iter().copied().any(|row| plays(&row)),
            "{name} by {solver}"
        );
    }
}

#[test]
fn h1_rows_collapse_in_bounded_events() {
    by_both("H1");
}

#[test]
fn h2_what_is_pressed_comes_to_rest() {
    by_both("H2");
}

#[test]
fn h3_racks_mirror_and_permute() {
    by_both("H3");
}

#[test]
fn h4_newtons_cradle() {
    by_both("H4");
}

#[test]
fn h5_balls_at_cushions_and_in_corners_stay_in() {
    by_both("H5");
}

#[test]
fn h6_grazing_hits_are_a_square_root_and_end_at_tangency() {
    by_both("H6");
}

#[test]
fn h7_equal_motions_never_meet() {
    by_both("H7");
}

#[test]
fn h8_momentum_energy_and_room_after_every_event() {
    by_both("H8");
}

#[test]
fn h9_a_slide_of_almost_nothing() {
    by_both("H9");
}

#[test]
fn h10_a_spinning_ball_stays_and_a_slow_one_stops_in_time() {
    by_both("H10");
}

#[test]
fn h11_mass_ratio_of_a_million() {
    by_both("H11");
}

#[test]
fn h12_fast_balls_miss_nothing() {
    by_both("H12");
}

#[test]
fn h13_a_nudge_grows_as_geometry_says() {
    by_both("H13");
}

#[test]
fn h14_ticks_and_frames() {
    by_both("H14");
}

#[test]
fn h15_no_impact_wins_energy() {
    by_both("H15");
}

#[test]
fn h16_mirrors_turns_units_trains_and_time() {
    by_both("H16");
}

#[test]
fn judge_prints_the_hard_cases() {
    let run = output(masse().args(["judge", "--hard"]));
    assert_eq!(run.status.code(), Some(0), "{}", err(&run));
    for (name, _) in ALL {
        assert!(
            out(&run).lines().any(|line| line.starts_with(name)),
            "{name}"
        );
    }
    let rows = printed();
    assert!(rows.len() > 100, "{} rows", rows.len());
    for row in rows {
        for text in ["case", "scene", "solver", "must", "happened"] {
            assert!(row[text].is_string(), "{text}: {row}");
        }
        assert_eq!(row["pass"], Value::Bool(true), "{row}");
    }
    for bad in ["--no-pictures", "--out=x", "--allow=2"] {
        let run = output(masse().args(["judge", "--hard", bad]));
        assert_eq!(run.status.code(), Some(2), "{bad}");
    }
}
