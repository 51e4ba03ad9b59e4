//! Rebound angle and speed against incidence and speed, for every registered cushion law.

use crate::physics::laws::Laws;
use crate::physics::laws::cushion::CushionLaw;
use crate::report::chart::Ink;
use crate::report::chart::{Axis, Chart, Panel, Series};
use crate::report::judge::coursework::when_it_should_roll;
use crate::report::judge::exact::components;
use crate::report::judge::experiments::{settled_normal, square_ratio};
use crate::report::judge::measurements::{
    MATHAVAN_2010, Sudo, THREE_CUSHION_FAST, THREE_CUSHION_SETTLED,
};
use crate::report::judge::pictures::{COURSEWORK, MEASURED, law_ink};
use crate::report::judge::stand::{Stand, Stopped, cushion_laws};

/// What a panel shows of one law at one x.
type Value = fn(&CushionLaw, f64) -> f64;

/// Angle in degrees and share of the speed of a ball that rolls in at this many degrees off the normal with 1 m/s.
fn after(law: &CushionLaw, degrees: f64, settled: bool) -> (f64, f64) {
    let stand = Stand::POOL;
    let incidence = degrees.to_radians();
    let mut state = stand.rebound(law, &stand.rolling(1.0, 1.0), incidence);
    if settled {
        state = stand.settled(&state);
    }
    let (out, along) = components(state.velocity, incidence);
    (
        libm::atan2(along, out).to_degrees(),
        state.velocity.length(),
    )
}

/// The same for the coursework model, when it should roll again.
fn pushed(degrees: f64) -> (f64, f64) {
    let stand = Stand::POOL;
    let incidence = degrees.to_radians();
    let bounced = stand.rebound(
        &Laws::coursework().cushion,
        &stand.rolling(1.0, 1.0),
        incidence,
    );
    let velocity = when_it_should_roll(&bounced).velocity;
    let (out, along) = components(velocity, incidence);
    (libm::atan2(along, out).to_degrees(), velocity.length())
}

pub(super) fn chart() -> Result<Chart, Stopped> {
    let angle = || Axis::linear("incidence off the normal, °", 0.0, 90.0);
    let laws = cushion_laws();
    let panel = |title: &str,
                 x: Axis,
                 y: Axis,
                 range: (f64, f64),
                 value: Value,
                 pushed: Option<fn(f64) -> f64>| {
        let own = Laws::coursework().cushion;
        let mut series = vec![Series::curve("coursework", COURSEWORK, range, |x| {
            if let Some(pushed) = pushed {
                pushed(x)
            } else {
                value(&own, x)
            }
        })];
        for (i, (name, law)) in laws.iter().enumerate() {
            series.push(Series::curve(name, law_ink(i), range, |x| value(law, x)));
        }
        Panel {
            title: title.to_owned(),
            x,
            y,
            series,
        }
    };
    let range = (0.0, 89.0);
    let mut square = panel(
        "square roll, snooker: speed ratio",
        Axis::linear("speed before, m/s", 0.0, 3.5),
        Axis::linear("speed after / before", 0.5, 1.05),
        (0.1, 3.5),
        |law, speed| square_ratio(&Stand::SNOOKER, law, speed),
        None,
    );
    let ratios = MATHAVAN_2010
        .map(|(speed, after)| (speed, after / speed))
        .to_vec();
    square
        .series
        .push(Series::new("E3 Mathavan et al. 2010", MEASURED, ratios));
    let sudo = vec![(1.0, Sudo::CUSHION_SLOW)];
    square.series.push(Series::new(
        "E4 Sudo & Shibata 2002, below 1.8 m/s",
        Ink::dots(2),
        sudo,
    ));
    let mut normal = panel(
        "roll at 20°, carom: normal speed ratio once it rolls",
        Axis::linear("normal speed before, m/s", 0.0, 2.5),
        Axis::linear("normal speed after / before", 0.2, 1.05),
        (0.1, 2.5),
        |law, speed| settled_normal(&Stand::CAROM, law, speed, f64::to_radians(20.0)),
        None,
    );
    let settled = vec![THREE_CUSHION_SETTLED];
    normal
        .series
        .push(Series::new("E10 three-cushion, settled", MEASURED, settled));
    let early = THREE_CUSHION_FAST.to_vec();
    normal.series.push(Series::new(
        "E10, seen before settling",
        Ink::dots(3),
        early,
    ));
    Ok(Chart {
        title: "Rebound from a cushion of a rolling ball".to_owned(),
        panels: vec![
            panel(
                "just after the bounce",
                angle(),
                Axis::linear("leaves off the normal, °", 0.0, 90.0),
                range,
                |law, degrees| after(law, degrees, false).0,
                None,
            ),
            panel(
                "once it rolls again",
                angle(),
                Axis::linear("goes off the normal, °", 0.0, 90.0),
                range,
                |law, degrees| after(law, degrees, true).0,
                Some(|degrees| pushed(degrees).0),
            ),
            square,
            panel(
                "just after the bounce",
                angle(),
                Axis::linear("speed after / before", 0.0, 1.05),
                range,
                |law, degrees| after(law, degrees, false).1,
                None,
            ),
            panel(
                "once it rolls again",
                angle(),
                Axis::linear("speed after / before", 0.0, 1.05),
                range,
                |law, degrees| after(law, degrees, true).1,
                Some(|degrees| pushed(degrees).1),
            ),
            normal,
        ],
        columns: 3,
    })
}
