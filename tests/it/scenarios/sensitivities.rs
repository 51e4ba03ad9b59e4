//! Sensitivity: just inside the edges a shot succeeds, just outside it fails.

use super::{command_line, played, scenario};
use masse::scenarios::dial::Dial;
use masse::scenarios::file::Scenario;
use masse::scenarios::library;
use masse::scenarios::sensitivity::{SensitivityError, map, sensitivity};

fn meets(of: &Scenario, dial: Dial, value: f64) -> bool {
    let mut turned = of.clone();
    if let Some(planned) = &mut turned.scene.shot {
        dial.set(&mut planned.shot, value);
    }
    turned
        .judge(&played(&turned))
        .iter()
        .all(|outcome| outcome.met)
}

#[test]
fn edges_lie_between_success_and_failure() {
    for name in ["stop-shot", "draw-back", "kick-two-rails", "masse"] {
        let shot = library::open(name).unwrap_or_else(|error| panic!("{error}"));
        let rooms = sensitivity(&shot).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(rooms.len(), 5);
        for room in rooms {
            for (edge, sign) in [(room.below, -1.0), (room.above, 1.0)] {
                let at = |by: f64| room.value + sign * by;
                let what = format!("{name} {} {edge:?}", room.dial.name());
                assert!(meets(&shot, room.dial, at(0.999_99 * edge.by)), "{what}");
                if let Some(fails) = edge.fails {
                    assert!(
                        !meets(&shot, room.dial, at(1.000_01 * edge.by + 1e-9)),
                        "{what}"
                    );
                    assert!(fails < shot.expect.len());
                }
            }
        }
    }
}

#[test]
fn a_symmetric_shot_has_symmetric_edges_and_a_straight_line_its_closed_form() {
    // A ball that rolls to the foot rail 2 m away, and must come within a hand of its middle.
    let shot = scenario(
        r#"(table: NineFoot, balls: [(name: "cue", position: (-0.757514, 0))], shot: (ball: "cue", speed: 3),
            expect: [Near(ball: "cue", at: Position(1.2, 0), within: 0.1, when: Rail("cue", 1))])"#,
    );
    let rooms = sensitivity(&shot).unwrap_or_else(|error| panic!("{error}"));
    let heading = rooms
        .iter()
        .find(|room| room.dial == Dial::Heading)
        .expect("heading");
    assert!(
        (heading.below.by - heading.above.by).abs() < 1e-5,
        "{heading:?}"
    );
    // It meets the rail at x = 1.2424863, 2 m on; the chord of the circle around the mark there is 90.5 mm.
    let aside = (0.1f64 * 0.1 - 0.042_486_3 * 0.042_486_3).sqrt();
    let angle = libm::atan2(aside, 2.0).to_degrees();
    assert!(
        (heading.above.by - angle).abs() < 1e-3,
        "{heading:?} and not {angle}"
    );
}

#[test]
fn a_map_shows_the_shot_and_what_surrounds_it() {
    let shot = library::open("stop-shot").unwrap_or_else(|error| panic!("{error}"));
    let map =
        map(&shot, (Dial::Heading, Dial::Speed), 21).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(
        (map.columns.len(), map.rows.len(), map.misses.len()),
        (21, 21, 441)
    );
    assert!(map.met() > 0.05 && map.met() < 0.95, "{}", map.met());
    // The shot itself is in it, and a cell is what the shot is there.
    for (row, speed) in map.rows.iter().enumerate().step_by(7) {
        for (column, heading) in map.columns.iter().enumerate().step_by(7) {
            let mut turned = shot.clone();
            if let Some(planned) = &mut turned.scene.shot {
                Dial::Heading.set(&mut planned.shot, *heading);
                Dial::Speed.set(&mut planned.shot, *speed);
            }
            let met = turned
                .judge(&played(&turned))
                .iter()
                .all(|outcome| outcome.met);
            assert_eq!(map.misses[row * 21 + column] == 0.0, met);
        }
    }
}

#[test]
fn what_has_no_sensitivity_says_why() {
    let of = |text: &str| sensitivity(&scenario(text)).expect_err(text);
    let rolling = r#"(table: NineFoot, balls: [(name: "cue", position: (0, 0), velocity: (1, 0, 0))], expect: [Stays(ball: "cue")])"#;
    assert_eq!(of(rolling), SensitivityError::NoShot);
    let shot = r#"(table: NineFoot, balls: [(name: "cue", position: (0, 0))], shot: (ball: "cue", speed: 1) EXPECT)"#;
    assert_eq!(
        of(&shot.replace("EXPECT", "")),
        SensitivityError::NothingExpected
    );
    let missing = shot.replace(
        "EXPECT",
        r#", expect: [Stays(ball: "cue"), Never(Rail("cue"))]"#,
    );
    assert_eq!(
        of(&missing.replace("speed: 1", "speed: 4")),
        SensitivityError::Misses { expectation: 1 }
    );
}

#[test]
fn the_command_draws_the_map() {
    let out = command_line::file("sensitivity", "x", "").with_file_name("map.svg");
    let file = out.display().to_string();
    let told = command_line::masse(&[
        "sensitivity",
        "stop-shot",
        "--over",
        "side,height",
        "--out",
        &file,
    ]);
    assert_eq!(
        told.status.code(),
        Some(0),
        "{}",
        command_line::text(&told.stderr)
    );
    let table = command_line::text(&told.stdout);
    for dial in Dial::ALL {
        assert!(table.contains(dial.name()), "{table}");
    }
    let picture = std::fs::read_to_string(&out).expect("a picture");
    assert!(picture.contains("side, R") && picture.contains("height, R"));
    let wrong = command_line::masse(&["sensitivity", "stop-shot", "--over", "side,side"]);
    assert_eq!(wrong.status.code(), Some(2));
}
