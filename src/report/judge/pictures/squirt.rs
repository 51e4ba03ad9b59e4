//! Squirt against the offset of the tip.

use crate::physics::ball::State;
use crate::physics::cue::{Cue, Shot};
use crate::physics::laws::cue_ball::strike;
use crate::physics::laws::slate::SlateLaw;
use crate::report::chart::{Axis, Chart, Panel, Series};
use crate::report::judge::pictures::{COURSEWORK, MEASURED, curve_ink};
use crate::report::judge::stand::{Stand, turn};
use glam::DVec3;

/// Ball mass over end mass: a heavy shaft, the one of pooltool's test, its default, a low-deflection shaft.
const RATIOS: [f64; 4] = [10.0, 20.0, 30.0, 60.0];

pub(super) fn chart() -> Chart {
    let ball = Stand::POOL.ball;
    let squirt = |ratio: f64, side: f64| {
        let cue = Cue {
            end_mass: ball.mass / ratio,
            ..Cue::default()
        };
        let shot = Shot {
            side,
            ..Shot::default()
        };
        let rest = State::at_rest(DVec3::Y * ball.radius);
        let struck = strike(&cue, &SlateLaw::Held, &ball, &rest, &shot);
        turn(DVec3::X, struck.state.velocity).to_degrees()
    };
    let range = (0.0, 0.5);
    let mut series = vec![Series::curve("coursework: none", COURSEWORK, range, |_| {
        0.0
    })];
    for (i, ratio) in RATIOS.into_iter().enumerate() {
        let label = format!("ball mass / end mass {ratio}");
        series.push(Series::curve(&label, curve_ink(i), range, |side| {
            squirt(ratio, side)
        }));
    }
    series.push(Series::new(
        "printed by pooltool",
        MEASURED,
        vec![(0.2, 1.199_358_331_3)],
    ));
    Chart {
        title: "Squirt against english: the ball leaves away from the tip, at any speed".to_owned(),
        panels: vec![Panel {
            title: "level cue; no measured table could be had".to_owned(),
            x: Axis::linear("tip offset, R", 0.0, 0.5),
            y: Axis::linear("squirt, °", 0.0, 5.0),
            series,
        }],
        columns: 1,
    }
}
