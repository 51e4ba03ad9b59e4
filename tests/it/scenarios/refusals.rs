//! Expectations that can never be tested, and cameras that see nothing, are errors that name field and value.

use masse::scenarios::file;

#[test]
fn what_can_never_be_tested_is_refused() {
    let cases: &[(&str, &[&str])] = &[
        (
            r#"Potted(ball: "9")"#,
            &["expect[0].ball", "`9`", "`cue`", "`1`"],
        ),
        (
            r#"Stays(ball: "cue"), Potted(ball: "1", pocket: "middle")"#,
            &["expect[1].pocket", "`middle`", "`foot left`"],
        ),
        (r#"Stays(ball: "")"#, &["expect[0].ball", "``"]),
        (
            r#"Stays(ball: "2")"#,
            &["expect[0].ball", "`2`", "not in play"],
        ),
        ("Order([])", &["expect[0].Order", "one contact"]),
        (
            r#"Order([Rail("cue"), Hit("cue", "cue")])"#,
            &["expect[0].Order[1]", "meet itself"],
        ),
        (
            r#"Near(ball: "cue", at: Position(2, 0), within: 0.1)"#,
            &["expect[0].at", "Position(2.0, 0.0)", "2.54"],
        ),
        (
            r#"Near(ball: "cue", at: Diamonds(5, 0), within: 0.1)"#,
            &["expect[0].at", "not on the table"],
        ),
        (
            r#"Near(ball: "cue", at: Start("7"), within: 0.1)"#,
            &["expect[0].at", "`7`"],
        ),
        (
            r#"Near(ball: "cue", at: Position(0, 0), within: 0)"#,
            &["expect[0].within", "0", "never be met"],
        ),
        (
            r#"Speed(ball: "cue", when: End)"#,
            &["expect[0].least", "one of"],
        ),
        (
            r#"Speed(ball: "cue", least: 2, most: 1, when: End)"#,
            &["expect[0].least: 2", "above `most`, 1"],
        ),
        (
            r#"Speed(ball: "cue", least: NaN, when: End)"#,
            &["expect[0].least: NaN"],
        ),
        (
            r#"Speed(ball: "cue", least: 1, when: At(61))"#,
            &["expect[0].when: 61", "60 s"],
        ),
        (
            r#"Speed(ball: "cue", least: 1, when: Rail("cue", 0))"#,
            &["expect[0].when: 0", "from 1"],
        ),
        (
            r#"Count(of: Rail("cue"), least: 3, most: 2)"#,
            &["expect[0].least: 3"],
        ),
        (
            r#"Potted(ball: "1", hole: "foot left")"#,
            &["bad.ron:", "hole", "pocket"],
        ),
        (
            r#"Sinks(ball: "1")"#,
            &["bad.ron:", "Sinks", "Potted", "Order"],
        ),
    ];
    for (expect, parts) in cases {
        let text = format!(
            r#"(table: NineFoot, balls: [(name: "cue", position: (-1, 0)), (name: "1", position: (0, 0)),
                (name: "2", position: (0, 0.2), height: -0.08, motion: pocketed)],
                shot: (ball: "cue", speed: 1), expect: [{expect}])"#
        );
        let error = file::parse(&text, "bad.ron").expect_err(expect).to_string();
        assert!(error.starts_with("bad.ron:"), "{error}");
        for part in *parts {
            assert!(
                error.contains(part),
                "{expect}\n  gives: {error}\n  which lacks: {part}"
            );
        }
    }
}

#[test]
fn a_scene_in_which_it_cannot_happen_is_refused() {
    let cases = [
        // Nothing moves.
        (
            r#"table: NineFoot, balls: [(name: "cue", position: (-1, 0))], expect: [Stays(ball: "cue")]"#,
            "nothing moves",
        ),
        // No pockets.
        (
            r#"table: Carom, balls: [(name: "cue", position: (-1, 0))], shot: (ball: "cue", speed: 1),
               expect: [Potted(ball: "cue")]"#,
            "no pockets",
        ),
        // A slate from which nothing bounces.
        (
            r#"table: NineFoot, laws: Custom(slate: Held), balls: [(name: "cue", position: (-1, 0))],
               shot: (ball: "cue", speed: 1), expect: [Height(ball: "cue", least: 0.01)]"#,
            "laws.slate",
        ),
        // Cameras.
        (
            r#"table: NineFoot, balls: [(name: "cue", position: (-1, 0))], cameras: [Overhead, Follow("3")]"#,
            "cameras[1].Follow: `3`",
        ),
        (
            r#"table: NineFoot, balls: [(name: "cue", position: (-1, 0))], cameras: [BehindCue]"#,
            "no shot",
        ),
        (
            r#"table: NineFoot, balls: [(name: "cue", position: (-1, 0))],
               cameras: [Fixed(eye: (0, 1, 0), target: (0, 1, 0))]"#,
            "cameras[0].target",
        ),
        (
            r#"table: NineFoot, balls: [(name: "cue", position: (-1, 0))],
               cameras: [Fixed(eye: (0, inf, 0), target: (0, 1, 0))]"#,
            "cameras[0].eye.y: inf",
        ),
    ];
    for (fields, part) in cases {
        let error = file::parse(&format!("({fields})"), "bad.ron")
            .expect_err(fields)
            .to_string();
        assert!(error.contains(part), "{fields}\n  gives: {error}");
    }
}

#[test]
fn expectations_and_cameras_survive_being_written() {
    let text = r#"(table: NineFoot, title: "T", look_for: "the 1",
        balls: [(name: "cue", position: (-1, 0)), (name: "1", position: (0, 0))],
        shot: (ball: "cue", speed: 1),
        expect: [
            Potted(ball: "1"), Potted(ball: "1", pocket: "foot left"), Stays(ball: "cue"), Never(Leaves("1")),
            Order([Hit("cue", "1"), RailAt("1", Foot), FallsInto("1", "side left"), Lands("cue")]),
            Count(of: Rail("cue"), most: 3, until: Falls("1")),
            Near(ball: "cue", at: Diamonds(1, 2), within: 0.30000000000000004),
            Inside(ball: "cue", least: (-1, 0), most: (0, 0.5), when: Rests("cue")),
            Passes(ball: "cue", at: Start("1"), within: 0.1, from: At(0.5), until: Rail("cue", 2)),
            Gap(ball: "cue", of: "1", least: 0.01), Height(ball: "cue", most: 0.01),
            Over(ball: "cue", of: "1", least: 0), Speed(ball: "1", least: 1, when: After("cue", "1")),
            Heading(ball: "1", deg: 3, within_deg: 1, when: AfterRail("1", 1)),
            Turns(ball: "cue", least: 3, from: Start, to: Rolls("cue")), Travels(ball: "cue", least: 1),
            Advances(ball: "cue", most: -1, from: Hit("cue", "1")), Time(of: Lands("cue"), most: 1),
        ],
        cameras: [Overhead, BehindCue, Follow("1"), Fixed(eye: (0, 1, 2), target: (0, 0, 0))])"#;
    let first = file::parse(text, "test.ron").unwrap_or_else(|error| panic!("{error}"));
    let written = file::write(&first).unwrap_or_else(|error| panic!("{error}"));
    let again = file::parse(&written, "w.ron").unwrap_or_else(|error| panic!("{error}\n{written}"));
    assert_eq!(format!("{first:?}"), format!("{again:?}"));
}
