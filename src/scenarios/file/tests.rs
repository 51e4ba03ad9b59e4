//! Files read, written and refused.

use super::{Scenario, parse, write};
use crate::physics::scene::Scene;

/// A file that says everything, with numbers that need all their digits.
const FULL: &str = r#"
(
    version: 1,
    title: "Everything",
    table: Full(
        length: 2.0, width: 1.0, nose_height: 0.03628,
        cushions: [
            Line(from: (-1, -0.5), to: (1, -0.5)),
            Arc(center: (0.1, 0.3000000000000004), radius: 0.0123),
        ],
        pockets: [(name: "end", center: (0.9999999999999999, 0.6), radius: 0.06)],
    ),
    laws: Custom(
        base: Coursework,
        motion: Coulomb(sliding: 0.21),
        ball_ball: Frictional(restitution: 0.94, friction: Constant(0.06)),
        cushion: Han2005(),
        slate: Rubbed(friction: 0.1),
        pocket: Capture,
    ),
    cue: (mass: 0.55),
    ball: (mass: 0.1700970000000001),
    balls: [
        (name: "cue", position: (-0.1, 0.1), velocity: (1e-17, 0, -0.0), spin: (0.30000000000000004, -3, 1e300)),
        (name: "heavy", diamonds: (1, 2), mass: 0.5, radius: 0.0300000000000001, spins: false),
        (name: "gone", position: (1, 0.6), height: -0.08, motion: pocketed),
    ],
    shot: (ball: "cue", heading_deg: 33.3, elevation_deg: 4, side: 0.1, height: -0.2, speed: 1.7),
    solver: Stepped(tick: 0.016666666666666666, grid: None, locate: false),
    time_limit: 12.5,
)
"#;

fn good(text: &str) -> Scene {
    match parse(text, "test.ron") {
        Ok(scenario) => scenario.scene,
        Err(error) => panic!("{error}"),
    }
}

/// Every bit of a scene: unlike `==`, the text of the debug form tells 0 from -0, and shows a number with all its
/// digits.
fn bits(scenario: &Scenario) -> String {
    format!("{scenario:?}")
}

#[test]
fn what_is_written_reads_back_bit_for_bit() {
    let mut text = FULL.replace("1e300", "1e-300");
    for _ in 0..2 {
        let scenario = parse(&text, "test.ron").expect("a good file");
        let written = write(&scenario).expect("it can be written");
        let again =
            parse(&written, "written.ron").unwrap_or_else(|error| panic!("{error}\n{written}"));
        assert_eq!(bits(&scenario), bits(&again));
        text = written;
    }
}

#[test]
fn a_number_keeps_all_its_bits() {
    let scene = good(&FULL.replace("1e300", "5e-324"));
    let state = scene.balls[0].state;
    assert_eq!(
        state.angular_velocity.x.to_bits(),
        0.300_000_000_000_000_04_f64.to_bits()
    );
    assert_eq!(state.angular_velocity.z.to_bits(), 1);
    assert_eq!(state.velocity.z.to_bits(), (-0.0_f64).to_bits());
    assert_eq!(
        scene.balls[0].ball.mass.to_bits(),
        0.170_097_000_000_000_1_f64.to_bits()
    );
}

#[test]
fn a_racked_ball_gives_way_to_a_listed_one() {
    let scene = good(
        "(table: NineFoot, rack: NineBall(gap: 1e-4), balls: [(name: \"cue\", position: (-0.9, 0.2))])",
    );
    assert_eq!(scene.balls.len(), 10);
    assert_eq!(scene.balls[0].state.position.z.to_bits(), 0.2_f64.to_bits());
}

#[test]
fn a_fill_is_the_same_every_time_and_overlaps_nothing() {
    let text = "(table: SevenFoot, laws: Ideal, fill: (count: 200, seed: 7, speed: 1.5, radii: (0.02, 0.03)))";
    let scene = good(text);
    assert_eq!(scene.balls.len(), 200);
    assert_eq!(scene, good(text));
    assert_ne!(scene, good(&text.replace("seed: 7", "seed: 8")));
    assert!(
        scene
            .balls
            .iter()
            .all(|ball| (ball.state.velocity.length() - 1.5).abs() < 1e-14)
    );
}

#[test]
#[expect(
    clippy::too_many_lines,
    reason = "one line for each mistake a person can make"
)]
fn what_is_wrong_is_named() {
    let long = "(".repeat(10_000_000);
    let cases: &[(&str, &[&str])] = &[
        ("", &["bad.ron:1:1"]),
        (
            "(table: NineFoot, balls: [(name: \"cue\", pos",
            &["bad.ron:1:"],
        ),
        (&long, &["bad.ron:1:"]),
        ("()", &["table"]),
        (
            "(table: TenFoot)",
            &["bad.ron:1:", "TenFoot", "NineFoot", "Carom"],
        ),
        (
            "(table: NineFoot, colour: 3)",
            &["colour", "balls", "solver"],
        ),
        (
            "(table: NineFoot, balls: [(position: (0, 0))])",
            &["bad.ron:1:", "name"],
        ),
        ("(table: NineFoot, table: Carom)", &["table", "bad.ron:1:"]),
        (
            "(table: NineFoot,\n balls: [(name: \"cue\", position: (0, 0), mass: \"heavy\")])",
            &["bad.ron:2:", "heavy"],
        ),
        (
            "(table: NineFoot, laws: Real)",
            &["Real", "Pool", "Ideal", "Coursework", "Custom"],
        ),
        (
            "(table: NineFoot, laws: Custom(cushion: Han(friction: 1)))",
            &["`Han`", "Mirror", "Han2005"],
        ),
        (
            "(table: NineFoot, laws: Custom(cushion: Mirror(bounce: 1)))",
            &["bounce", "restitution"],
        ),
        (
            "(table: NineFoot, laws: Custom(slate: Rubbed(rub: 1)))",
            &["rub", "friction"],
        ),
        (
            "(table: NineFoot, rack: NineBall(), laws: Custom(cushion: Mirror(restitution: 1.01)))",
            &[
                "laws.cushion.restitution: 1.01",
                "between 0 and 1",
                "Alciatore",
            ],
        ),
        (
            "(table: NineFoot, rack: NineBall(), laws: Custom(motion: Coulomb(rolling: -0.01)))",
            &[
                "laws.motion.rolling: -0.01",
                "between 0 and 1",
                "0.005 to 0.015",
                "Alciatore",
            ],
        ),
        ("(table: NineFoot, version: 2)", &["bad.ron: version: 2"]),
        ("(table: NineFoot)", &["bad.ron: balls: there are 0 balls"]),
        ("(table: NineFoot, balls: [])", &["0 balls"]),
        (
            "(table: NineFoot, balls: [(name: \"cue\")])",
            &["balls[0] (`cue`)", "`position`", "`diamonds`"],
        ),
        (
            "(table: NineFoot, rack: EightBall(gap: -1))",
            &["rack.gap: -1"],
        ),
        (
            "(table: NineFoot, rack: EightBall(gap: NaN))",
            &["rack.gap: NaN"],
        ),
        (
            "(table: Box(length: 0.01, width: 0.01), balls: [(name: \"cue\", position: (0, 0))])",
            &["table", "0.01", "`cue`"],
        ),
        (
            "(table: Box(length: inf, width: 1), balls: [(name: \"cue\", position: (0, 0))])",
            &["table.length: inf"],
        ),
        (
            "(table: Box(length: 1e999, width: 1), fill: (count: 3))",
            &["table.length: inf"],
        ),
        (
            "(table: SevenFoot, fill: (count: 3000))",
            &["fill.count: 3000"],
        ),
        (
            "(table: SevenFoot, fill: (count: 3, radii: (0.02, 0.01)))",
            &["fill.radii: 0.02 is above 0.01"],
        ),
        (
            "(table: SevenFoot, fill: (count: 3, speed: NaN))",
            &["fill.speed: NaN"],
        ),
        (
            "(table: SevenFoot, rack: NineBall(), shot: (ball: \"red\", speed: 1))",
            &["shot.ball", "`red`", "`cue`"],
        ),
        (
            "(table: SevenFoot, rack: NineBall(), shot: (ball: \"cue\", aim_at: \"cue\", speed: 1))",
            &["shot.aim_at", "`cue`"],
        ),
        (
            "(table: SevenFoot, rack: NineBall(), shot: (ball: \"cue\", speed: NaN))",
            &["shot.speed: NaN"],
        ),
        (
            "(table: SevenFoot, rack: NineBall(), shot: (ball: \"cue\", heading: 1, heading_deg: 2, speed: 1))",
            &["`heading_deg`", "2 are given"],
        ),
        (
            "(table: SevenFoot, rack: NineBall(), solver: Stepped(tick: 0))",
            &["solver.tick: 0"],
        ),
        (
            "(table: SevenFoot, rack: NineBall(), solver: Stepped(grid: (100000, 100000)))",
            &["solver.grid"],
        ),
        (
            "(table: SevenFoot, rack: NineBall(), solver: Exact, laws: Coursework)",
            &["solver", "Coursework"],
        ),
        (
            "(table: SevenFoot, rack: NineBall(), time_limit: -1)",
            &["time_limit: -1"],
        ),
        (
            "(table: Full(length: 2, width: 1, nose_height: 0.03, cushions: [Line(from: (NaN, 0), to: (1, 1))]), rack: NineBall())",
            &["table.cushions[0].from.x: NaN"],
        ),
    ];
    for (text, parts) in cases {
        let shown = &text[..text.len().min(200)];
        let error = parse(text, "bad.ron").expect_err(shown).to_string();
        for part in *parts {
            assert!(
                error.contains(part),
                "{shown}\n  gives: {error}\n  which lacks: {part}"
            );
        }
        assert!(error.starts_with("bad.ron:"), "{shown}\n  gives: {error}");
    }
}

#[test]
fn a_bad_ball_is_named_with_its_field_and_value() {
    let cases = [
        ("mass: 0", "balls[1] (`1`).mass: 0"),
        ("mass: -2.5", "balls[1] (`1`).mass: -2.5"),
        ("mass: NaN", "balls[1] (`1`).mass: NaN"),
        ("mass: inf", "balls[1] (`1`).mass: inf"),
        ("mass: 1e999", "balls[1] (`1`).mass: inf"),
        ("radius: 0", "balls[1] (`1`).radius: 0"),
        ("radius: -0.1", "balls[1] (`1`).radius: -0.1"),
        ("radius: NaN", "balls[1] (`1`).radius: NaN"),
        ("velocity: (0, 0, -inf)", "balls[1] (`1`).velocity.z: -inf"),
        ("spin: (NaN, 0, 0)", "balls[1] (`1`).spin.x: NaN"),
        ("height: 0.02", "`1`: position.y is 0.02"),
    ];
    for (field, part) in cases {
        let text = format!(
            "(table: NineFoot, balls: [(name: \"cue\", position: (-1, 0)), (name: \"1\", position: (0, 0), {field})])"
        );
        let error = parse(&text, "bad.ron").expect_err(field).to_string();
        assert!(error.contains(part), "{field} gives: {error}");
    }
    let places = [
        ("(NaN, 0)", "balls[1] (`1`).position.x: NaN"),
        ("(-0.99, 0)", "`cue` and `1` overlap by 0.047"),
        ("(0.5, 0.61)", "`1` is inside cushion"),
        ("(0, 0.65)", "`1` is over pocket `side right`"),
        ("(3, 0)", "`1` at x = 3 m"),
    ];
    for (place, part) in places {
        let text = format!(
            "(table: NineFoot, balls: [(name: \"cue\", position: (-1, 0)), (name: \"1\", position: {place})])"
        );
        let error = parse(&text, "bad.ron").expect_err(place).to_string();
        assert!(error.contains(part), "{place} gives: {error}");
    }
    let twice = "(table: NineFoot, balls: [(name: \"a\", position: (-1, 0)), (name: \"a\", position: (0, 0))])";
    let error = parse(twice, "bad.ron").expect_err("twice").to_string();
    assert!(error.contains("`a` is used twice"), "{error}");
}
