//! Throw against cut angle.

use crate::physics::laws::ball_ball::{BallBallLaw, Friction};
use crate::report::chart::{Axis, Chart, Panel, Series};
use crate::report::judge::exact::SPEEDS;
use crate::report::judge::experiments::throw_points;
use crate::report::judge::measurements::{DOMENECH_2023, DOMENECH_SPEED};
use crate::report::judge::pictures::{COURSEWORK, MEASURED, curve_ink};
use crate::report::judge::stand::{Stand, rough, smooth};

pub(super) fn chart() -> Chart {
    let stand = Stand::POOL;
    let thrown = |law: &BallBallLaw, speed: f64, roll: f64, cut_deg: f64| {
        let state = stand.rolling(speed, roll);
        stand.throw(law, &state, cut_deg.to_radians()).to_degrees()
    };
    let panel = |title: &str, roll: f64| {
        let range = (0.0, 89.0);
        let mut series = vec![Series::curve(
            "coursework: none",
            COURSEWORK,
            range,
            |cut| thrown(&smooth(1.0), 1.0, roll, cut),
        )];
        let marlow = rough(1.0, Friction::MARLOW);
        for (i, speed) in SPEEDS.into_iter().enumerate() {
            let label = format!("Marlow, {speed} m/s");
            series.push(Series::curve(&label, curve_ink(i), range, |cut| {
                thrown(&marlow, speed, roll, cut)
            }));
        }
        let constant = rough(1.0, Friction::Constant(0.06));
        series.push(Series::curve(
            "constant μ 0.06, any speed",
            curve_ink(3),
            range,
            |cut| thrown(&constant, 1.0, roll, cut),
        ));
        Panel {
            title: title.to_owned(),
            x: Axis::linear("cut angle, °", 0.0, 90.0),
            y: Axis::linear("throw, °", 0.0, 7.0),
            series,
        }
    };
    let stun = panel("stun", 0.0);
    let mut roll = panel("roll", 1.0);
    // The balls of the experiment by Marlow's friction at their own speed.
    let cuts = DOMENECH_2023.map(|(cut_deg, _)| cut_deg);
    let ours = throw_points(&rough(0.95, Friction::MARLOW));
    let points = cuts
        .into_iter()
        .zip(ours)
        .map(|(cut, (_, ours))| (cut, ours))
        .collect();
    let label = format!("Marlow, {DOMENECH_SPEED} m/s, as measured");
    roll.series.push(Series::new(&label, curve_ink(4), points));
    roll.series.push(Series::new(
        "E5 Domenech 2023, 0.8 m/s",
        MEASURED,
        DOMENECH_2023.to_vec(),
    ));
    Chart {
        title: "Throw of the object ball against cut angle".to_owned(),
        panels: vec![stun, roll],
        columns: 2,
    }
}
