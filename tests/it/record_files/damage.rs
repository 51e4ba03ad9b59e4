//! Damaged record files.

use masse::physics::ball::Ball;
use masse::physics::cue::Shot;
use masse::physics::laws::Laws;
use masse::physics::record::PathPiece;
use masse::physics::scene::{PlannedShot, Scene};
use masse::physics::table::Preset;
use masse::report::record_file::{self, RecordFileError};

use super::{played, text};

/// A short record with an event of every kind and a line for a path.
fn sample() -> String {
    let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
    scene.place("cue", Ball::POOL, -0.5, 0.0);
    scene.place("1", Ball::POOL, 0.3, 0.01);
    let pocket = scene.table.pockets[0].center;
    let corner = glam::DVec2::new(-1.1, -0.465);
    let third = scene.place("2", Ball::POOL, corner.x, corner.y);
    let away = (pocket - corner).normalize();
    scene.balls[third].state.velocity = 1.5 * glam::DVec3::new(away.x, 0.0, away.y);
    scene.shot = Some(PlannedShot {
        ball: 0,
        shot: Shot {
            speed: 3.0,
            ..Shot::default()
        },
    });
    let mut record = played(&scene);
    for kind in ["Strike", "BallBall", "Cushion", "Pocketed", "Motion"] {
        let there = record
            .events
            .iter()
            .any(|event| format!("{:?}", event.kind).starts_with(kind));
        assert!(there, "{kind} does not happen in the sample");
    }
    // A piece that no event tells, so that there is a line for a path.
    let middle = PathPiece {
        time: record.end_time,
        ..record.paths[1][0]
    };
    record.paths[1].push(middle);
    text("sample", "Sample", &scene, &record)
}

/// The place of the first line that has this text in it, from 1.
fn place(text: &str, part: &str) -> usize {
    let found = text.lines().position(|line| line.contains(part));
    1 + found.unwrap_or_else(|| panic!("no line has {part}"))
}

/// Of the line with the first text (the first line if that is empty) the second text becomes the third; the message then has
/// the number of the line and the last text.
const DAMAGE: &[(&str, &str, &str, &str)] = &[
    ("", "\"version\":1", "\"version\":2", "version: 2"),
    ("", "\"version\":1", "\"version\":\"1\"", "version: "),
    ("", "masse record", "my record", "not a record"),
    ("", "\"title\":\"Sample\"", "\"title\":7", "title: "),
    (
        "",
        "\"title\":\"Sample\",",
        "",
        "title: the field is missing",
    ),
    (
        "",
        "\"time_limit\":60.0",
        "\"time_limit\":\"long\"",
        "scene.time_limit: ",
    ),
    (
        "",
        "\"time_limit\":60.0",
        "\"time_limit\":-1.0",
        "time_limit: -1",
    ),
    (
        "",
        "\"mass\":0.170097",
        "\"mass\":null",
        "scene.balls[0].ball: ",
    ),
    ("", "\"mass\":0.170097", "\"mass\":0.0", "mass: 0"),
    (
        "",
        "\"name\":\"1\"",
        "\"name\":\"cue\"",
        "`cue` is used twice",
    ),
    (
        "",
        "\"name\":\"side left\"",
        "\"name\":\"foot left\"",
        "`foot left` is used twice",
    ),
    (
        "",
        "\"slate\":",
        "\"plate\":",
        "scene.laws: unknown field `plate`",
    ),
    (
        "",
        "\"solver\":\"Exact\"",
        "\"solver\":\"Guess\"",
        "scene.solver: ",
    ),
    (
        "",
        "\"scene\":{",
        "\"scene\":{\"wind\":1,",
        "scene.wind: no such field",
    ),
    (
        "\"kind\":\"ball_ball\"",
        "\"time\":",
        "\"tim\":",
        "time: the field is missing",
    ),
    (
        "\"kind\":\"ball_ball\"",
        "\"time\":",
        "\"time\":-",
        "time: ",
    ),
    (
        "\"kind\":\"ball_ball\"",
        "\"time\":0",
        "\"time\":1e999",
        ":",
    ),
    (
        "\"kind\":\"ball_ball\"",
        "\"ball_ball\"",
        "\"ball_bull\"",
        "kind: `ball_bull`",
    ),
    (
        "\"kind\":\"ball_ball\"",
        "[\"cue\",\"1\"]",
        "[\"cue\",\"17\"]",
        "who[1]: there is no ball `17`",
    ),
    (
        "\"kind\":\"ball_ball\"",
        "[\"cue\",\"1\"]",
        "[\"cue\"]",
        "who: two balls",
    ),
    (
        "\"kind\":\"ball_ball\"",
        "[\"cue\",\"1\"]",
        "\"cue\"",
        "who: ",
    ),
    (
        "\"kind\":\"ball_ball\"",
        "\"impulse\":",
        "\"impulse\":true,\"force\":",
        "impulse: ",
    ),
    (
        "\"kind\":\"ball_ball\"",
        "\"impulse\":",
        "\"force\":1,\"impulse\":",
        "force: no such field",
    ),
    (
        "\"kind\":\"ball_ball\"",
        "\"velocity\":[",
        "\"velocity\":[\"fast\",",
        "before[0].velocity: ",
    ),
    (
        "\"kind\":\"ball_ball\"",
        "\"motion\":\"",
        "\"motion\":\"s",
        "before[0].motion: ",
    ),
    (
        "\"kind\":\"cushion\"",
        "\"cushion\":",
        "\"cushion\":99",
        "cushion: there is no cushion 99",
    ),
    (
        "\"kind\":\"cushion\"",
        "\"cushion\":",
        "\"miscue\":true,\"cushion\":",
        "miscue: no such",
    ),
    (
        "\"kind\":\"pocketed\"",
        "\"pocket\":\"",
        "\"pocket\":\"x",
        "pocket: there is no pocket `x",
    ),
    (
        "\"path\":",
        "\"path\":\"1\"",
        "\"path\":\"17\"",
        "path: there is no ball `17`",
    ),
    (
        "\"path\":",
        "\"time\":0.0",
        "\"time\":1e9",
        "pieces[1].time: ",
    ),
    (
        "\"path\":",
        "\"state\":",
        "\"stat\":",
        "pieces[0].state: the field is missing",
    ),
    (
        "\"summary\":",
        "\"reason\":\"rest\"",
        "\"reason\":\"tired\"",
        "summary.reason: ",
    ),
    (
        "\"summary\":",
        "\"ball_ball\":1",
        "\"ball_ball\":2",
        "summary.events.ball_ball: 2",
    ),
    (
        "\"summary\":",
        "\"ball\":\"1\"",
        "\"ball\":\"2\"",
        "summary.",
    ),
    (
        "\"summary\":",
        "\"summary\":{",
        "\"summary\":{\"mood\":1,",
        "summary.mood: no such field",
    ),
    ("\"summary\":", "\"summary\"", "\"end\"", "kind: "),
];

#[test]
fn damage_is_named_with_line_and_field() {
    let whole = sample();
    assert!(record_file::parse(&whole, "r").is_ok());
    let lines: Vec<&str> = whole.lines().collect();
    for &(line, from, to, part) in DAMAGE {
        let line = if line.is_empty() {
            1
        } else {
            place(&whole, line)
        };
        let mut damaged: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
        assert!(damaged[line - 1].contains(from), "line {line} lacks {from}");
        damaged[line - 1] = damaged[line - 1].replacen(from, to, 1);
        let error = record_file::parse(&damaged.join("\n"), "r.jsonl")
            .expect_err(to)
            .to_string();
        assert!(
            error.starts_with(&format!("r.jsonl:{line}:")),
            "{to}: {error}"
        );
        assert!(error.contains(part), "{to} lacks {part}: {error}");
    }
}

#[test]
fn no_line_may_be_lost_or_added() {
    let whole = sample();
    let lines: Vec<&str> = whole.lines().collect();
    let (hit, last) = (place(&whole, "\"kind\":\"ball_ball\""), lines.len());
    let error = |text: &str| record_file::parse(text, "r").expect_err("it is damaged");
    for lost in 0..last {
        let mut rest = lines.clone();
        rest.remove(lost);
        error(&rest.join("\n"));
    }
    assert!(matches!(
        error(&lines[..hit].join("\n")),
        RecordFileError::CutOff { line, .. } if line == hit
    ));
    assert!(matches!(
        error(&whole[..whole.len() - 9]),
        RecordFileError::Syntax { line, .. } if line == last
    ));
    assert!(matches!(
        error(&format!("{whole}{{}}\n")),
        RecordFileError::AfterTheEnd { line, .. } if line == last + 1
    ));
    let mut swapped = lines.clone();
    swapped.swap(hit - 1, last - 2);
    assert!(matches!(
        error(&swapped.join("\n")),
        RecordFileError::Field { .. }
    ));
    let deep = format!("{}\n{}", lines[0], "[".repeat(1_000_000));
    assert!(matches!(
        error(&deep),
        RecordFileError::Syntax { line: 2, .. }
    ));
}
