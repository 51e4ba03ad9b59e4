//! Every kind of expectation is met by a shot of which it is true and missed by the same shot where it is not; the value
//! found is that of the closed form where there is one.

use super::{played, scenario};
use masse::scenarios::expect::Outcome;

/// The stop shot of the library with other expectations.
fn stop_shot(expect: &str) -> String {
    format!(
        r#"(table: NineFoot,
            balls: [(name: "cue", position: (0.3745, -0.0576)), (name: "1", position: (0.8134, 0.2853))],
            shot: (ball: "cue", aim_at: "1", speed: 1.763000, height: -0.3),
            expect: [{expect}])"#
    )
}

/// A cue ball alone, under a level cue without spin: 2 m/s of the ball along x, then into the foot rail.
fn alone(expect: &str) -> String {
    format!(
        r#"(table: NineFoot,
            balls: [(name: "cue", position: (-0.6, 0.1), velocity: (2, 0, 0))],
            expect: [{expect}])"#
    )
}

/// The jump over the 8 onto the 1.
fn jump(expect: &str) -> String {
    format!(
        r#"(table: NineFoot,
            balls: [(name: "cue", position: (-0.635, 0)), (name: "8", position: (-0.335, 0)), (name: "1", position: (0.7, 0))],
            shot: (ball: "cue", heading_deg: 0, elevation_deg: 45, speed: 3),
            expect: [{expect}])"#
    )
}

fn outcome(text: &str) -> Outcome {
    let scenario = scenario(text);
    let mut outcomes = scenario.judge(&played(&scenario));
    assert_eq!(outcomes.len(), 1);
    outcomes.remove(0)
}

#[test]
#[expect(clippy::too_many_lines, reason = "two lines for each kind")]
fn what_is_true_is_met_and_what_is_not_is_missed() {
    let shots: [(fn(&str) -> String, &[(&str, &str)]); 3] = [
        (
            stop_shot,
            &[
                (r#"Potted(ball: "1")"#, r#"Potted(ball: "cue")"#),
                (
                    r#"Potted(ball: "1", pocket: "foot right")"#,
                    r#"Potted(ball: "1", pocket: "foot left")"#,
                ),
                (r#"Stays(ball: "cue")"#, r#"Stays(ball: "1")"#),
                (
                    r#"Order([Hit("1", "cue"), Falls("1")])"#,
                    r#"Order([Falls("1"), Hit("1", "cue")])"#,
                ),
                (
                    r#"Order([FallsInto("1", "foot right")])"#,
                    r#"Order([FallsInto("1", "side left")])"#,
                ),
                (r#"Never(Rail("cue"))"#, r#"Never(Hit("cue", "1"))"#),
                (
                    r#"Count(of: Hit("cue", "1"), least: 1, most: 1)"#,
                    r#"Count(of: Hit("cue", "1"), least: 2)"#,
                ),
                (
                    r#"Count(of: Hit("cue", "1"), most: 0, until: Hit("cue", "1"))"#,
                    r#"Count(of: Hit("cue", "1"), most: 0, until: Falls("1"))"#,
                ),
                (
                    r#"Near(ball: "1", at: Start("1"), within: 1e-9, when: Hit("cue", "1"))"#,
                    r#"Near(ball: "1", at: Start("1"), within: 0.1)"#,
                ),
                (
                    r#"Inside(ball: "cue", least: (0.7, 0.1), most: (0.9, 0.4))"#,
                    r#"Inside(ball: "cue", least: (0.7, 0.1), most: (0.9, 0.4), when: Start)"#,
                ),
                (
                    r#"Passes(ball: "cue", at: Position(0.594, 0.1138), within: 0.001)"#,
                    r#"Passes(ball: "cue", at: Position(0.594, 0.1138), within: 0.001, from: After("cue", "1"))"#,
                ),
                (
                    r#"Gap(ball: "cue", of: "1", most: 1e-9)"#,
                    r#"Gap(ball: "cue", of: "1", least: 0.01)"#,
                ),
                (
                    r#"Advances(ball: "cue", least: -0.005, most: 0.005, from: Hit("cue", "1"))"#,
                    r#"Advances(ball: "cue", least: -0.005, most: 0.005)"#,
                ),
                (
                    r#"Speed(ball: "cue", most: 0.05, when: After("cue", "1"))"#,
                    r#"Speed(ball: "cue", most: 0.05, when: Hit("cue", "1"))"#,
                ),
            ],
        ),
        (
            alone,
            &[
                (
                    r#"Order([RailAt("cue", Foot)])"#,
                    r#"Order([RailAt("cue", Left)])"#,
                ),
                (
                    r#"Heading(ball: "cue", deg: 360, within_deg: 0.001, when: Rail("cue", 1))"#,
                    r#"Heading(ball: "cue", deg: 3, within_deg: 2.9, when: Rail("cue", 1))"#,
                ),
                (
                    r#"Heading(ball: "cue", deg: -180, within_deg: 0.001, when: AfterRail("cue", 1))"#,
                    r#"Heading(ball: "cue", deg: -180, within_deg: 0.001, when: End)"#,
                ),
                (
                    r#"Travels(ball: "cue", least: 2.2)"#,
                    r#"Travels(ball: "cue", least: 2.2, to: Rail("cue", 1))"#,
                ),
                (
                    r#"Time(of: Rolls("cue"), least: 0.29, most: 0.292)"#,
                    r#"Time(of: Rests("cue"), most: 0.292)"#,
                ),
                (
                    r#"Near(ball: "cue", at: Position(-0.6, 0.1), within: 1e-12, when: Start)"#,
                    r#"Near(ball: "cue", at: Position(-0.6, 0.1), within: 0.1, when: Rail("cue", 2))"#,
                ),
            ],
        ),
        (
            jump,
            &[
                (
                    r#"Over(ball: "cue", of: "8", least: 0)"#,
                    r#"Over(ball: "cue", of: "1", least: 0)"#,
                ),
                (
                    r#"Height(ball: "cue", least: 0.057)"#,
                    r#"Height(ball: "cue", least: 0.057, from: Hit("cue", "1"))"#,
                ),
                (
                    r#"Order([Lands("cue"), Hit("cue", "1")])"#,
                    r#"Order([Leaves("cue")])"#,
                ),
                (
                    r#"Gap(ball: "cue", of: "8", least: 1e-4, until: Lands("cue"))"#,
                    r#"Gap(ball: "cue", of: "8", least: 0.1, until: Lands("cue"))"#,
                ),
                (
                    r#"Turns(ball: "cue", least: -0.01, most: 0.01, from: Start, to: Lands("cue"))"#,
                    r#"Turns(ball: "cue", least: 10, from: Start, to: Lands("cue"))"#,
                ),
            ],
        ),
    ];
    for (shot, cases) in shots {
        for (right, wrong) in cases {
            let met = outcome(&shot(right));
            assert!(met.met && met.miss == 0.0, "{right}: {}", met.sentence());
            let missed = outcome(&shot(wrong));
            assert!(!missed.met, "{wrong}: {}", missed.sentence());
            assert!(
                missed.miss > 0.0 && missed.miss.is_finite(),
                "{wrong}: {missed:?}"
            );
            assert!(missed.sentence().contains("MISSED"), "{missed:?}");
        }
    }
}

#[test]
fn values_are_those_of_the_closed_forms() {
    // A sliding ball of 2 m/s rolls after 2 v / 7 μ g, at 5/7 of its speed; it has gone 12 v² / 49 μ g by then.
    let slides = 2.0 * 2.0 / (7.0 * 0.2 * 9.81);
    let way = 12.0 * 4.0 / (49.0 * 0.2 * 9.81);
    let cases = [
        (r#"Time(of: Rolls("cue"), least: 0)"#, slides, "s"),
        (
            r#"Travels(ball: "cue", least: 0, to: Rolls("cue"))"#,
            way,
            "m",
        ),
        (
            r#"Advances(ball: "cue", least: 0, to: Rolls("cue"))"#,
            way,
            "m",
        ),
        (
            r#"Speed(ball: "cue", least: 0, when: Rolls("cue"))"#,
            10.0 / 7.0,
            "m/s",
        ),
        (
            r#"Passes(ball: "cue", at: Position(0, 0.13), within: 1, until: Rolls("cue"))"#,
            0.6 - way,
            "m away",
        ),
    ];
    for (expect, value, unit) in cases {
        let outcome = outcome(&alone(expect));
        let found = outcome.found.expect("a value");
        let value = if unit == "m away" {
            libm::hypot(value, 0.03)
        } else {
            value
        };
        assert!(
            (found - value).abs() < 2e-3 * value,
            "{expect}: {found} and not {value}"
        );
        assert_eq!(outcome.unit, unit);
    }
}

#[test]
fn the_nearer_the_smaller_the_miss() {
    // A cue ball that passes the 1 ever farther off.
    let mut last = 0.0;
    for z in [0.06, 0.1, 0.2, 0.3] {
        let text = format!(
            r#"(table: NineFoot, balls: [(name: "cue", position: (-0.6, 0)), (name: "1", position: (0, {z}))],
                shot: (ball: "cue", speed: 1), expect: [Order([Hit("cue", "1"), Falls("1")])])"#
        );
        let miss = outcome(&text).miss;
        assert!(miss > last, "{z}: {miss} is not above {last}");
        last = miss;
    }
    let mut last = 0.0;
    for off in [1.0, 3.0, 9.0, 40.0] {
        let expect =
            format!(r#"Heading(ball: "cue", deg: {off}, within_deg: 0.5, when: Rail("cue", 1))"#);
        let miss = outcome(&alone(&expect)).miss;
        assert!(miss > last, "{off}: {miss} is not above {last}");
        last = miss;
    }
}

#[test]
fn a_record_of_another_scene_meets_nothing() {
    let one = scenario(&stop_shot(r#"Stays(ball: "cue"), Never(Rail("cue"))"#));
    let other = played(&scenario(&alone(r#"Stays(ball: "cue")"#)));
    assert!(one.judge(&other).iter().all(|outcome| !outcome.met));
}
