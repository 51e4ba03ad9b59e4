//! Deflection of the cue ball against cut angle: the 30° rule, draw, and the frozen pair.

use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::{BallBallLaw, Friction};
use crate::report::chart::{Axis, Chart, Ink, Panel, Series};
use crate::report::judge::coursework::when_it_should_roll;
use crate::report::judge::exact::frozen_pair;
use crate::report::judge::measurements::FROZEN_PAIR;
use crate::report::judge::pictures::{COURSEWORK, MEASURED, curve_ink};
use crate::report::judge::stand::{Stand, cut_line, rough, smooth, turn};
use crate::sim::play::Stopped;
use glam::DVec3;

/// Spin of the cue ball at the hit as a multiple of that of rolling.
const SPINS: [(f64, &str); 5] = [
    (1.0, "roll"),
    (0.5, "half roll"),
    (0.0, "stun"),
    (-0.625, "draw, R ω = −0.625 v"),
    (-1.0, "draw, R ω = −v"),
];

/// Deflection in degrees of a rolling cue ball by the coursework model, when it should roll again.
fn pushed(cut_deg: f64) -> f64 {
    let stand = Stand::POOL;
    let law = Laws::coursework().ball_ball;
    let hit = stand.hit(&law, &stand.rolling(2.0, 1.0), cut_deg.to_radians());
    -turn(DVec3::X, when_it_should_roll(&hit.first).velocity).to_degrees()
}

pub(super) fn chart() -> Result<Chart, Stopped> {
    let stand = Stand::POOL;
    let deflected = |law: &BallBallLaw, roll: f64, cut_deg: f64| {
        let after = stand.hit(law, &stand.rolling(2.0, roll), cut_deg.to_radians());
        let end = stand.settled(&after.first).velocity;
        -turn(DVec3::X, end).to_degrees()
    };
    let range = (0.5, 89.5);
    let panel = |title: &str, law: BallBallLaw| {
        let mut series = vec![Series::curve("coursework, roll", COURSEWORK, range, pushed)];
        for (i, (roll, label)) in SPINS.into_iter().enumerate() {
            series.push(Series::curve(label, curve_ink(i), range, |cut| {
                deflected(&law, roll, cut)
            }));
        }
        Panel {
            title: title.to_owned(),
            x: Axis::linear("cut angle, °", 0.0, 90.0),
            y: Axis::linear("deflection of the cue ball once it rolls, °", 0.0, 180.0),
            series,
        }
    };
    let frozen = |label: &str, ink: Ink, law: BallBallLaw| -> Result<Series, Stopped> {
        let points: Result<Vec<_>, Stopped> = (1..89)
            .step_by(2)
            .map(f64::from)
            .map(|cut| Ok((cut, frozen_pair(&law, cut)?)))
            .collect();
        Ok(Series::new(label, ink, points?))
    };
    let pair = Panel {
        title: "frozen pair, struck by the cue".to_owned(),
        x: Axis::linear("cue to line of centres, °", 0.0, 90.0),
        y: Axis::linear("cue ball leaves at, °", 0.0, 100.0),
        series: vec![
            Series::curve("coursework frozen pair", COURSEWORK, range, |cut| {
                // The cue sends the ball along its own line; then the two collide.
                let cut = cut.to_radians();
                let hit = stand.hit(&Laws::coursework().ball_ball, &stand.stunned(1.0), cut);
                turn(cut_line(cut), hit.first.velocity).abs().to_degrees()
            }),
            frozen("frozen pair, frictionless", curve_ink(1), smooth(0.95))?,
            frozen(
                "frozen pair, Marlow",
                Ink::dotted(2),
                rough(0.95, Friction::MARLOW),
            )?,
            Series::new("E7 Alciatore, TP A.15", MEASURED, FROZEN_PAIR.to_vec()),
        ],
    };
    Ok(Chart {
        title: "Deflection of the cue ball against cut angle".to_owned(),
        panels: vec![
            panel("e 1, no friction between balls", smooth(1.0)),
            panel(
                "e 0.95, Marlow's friction, 2 m/s",
                rough(0.95, Friction::MARLOW),
            ),
            pair,
        ],
        columns: 3,
    })
}
