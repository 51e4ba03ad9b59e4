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
use crate::report::judge::stand::{Stand, cushion_laws};

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

/// The curves of every law and of the coursework model; `model` where its curve is not that of its cushion alone.
fn curves(range: (f64, f64), value: Value, model: Option<fn(f64) -> f64>) -> Vec<Series> {
    let own = Laws::coursework().cushion;
    let mut series = vec![Series::curve(
        "coursework",
        COURSEWORK,
        range,
        |x| match model {
            Some(model) => model(x),
            None => value(&own, x),
        },
    )];
    for (i, (name, law)) in cushion_laws().iter().enumerate() {
        series.push(Series::curve(name, law_ink(i), range, |x| value(law, x)));
    }
    // Full lines below broken ones.
    series.sort_by_key(|series| series.ink.stroke);
    series
}

/// Four panels over the angle of incidence: direction and speed, just after the bounce and once the ball rolls again.
fn by_incidence() -> [Panel; 4] {
    let range = (0.0, 89.0);
    let panel = |title: &str, y: Axis, series: Vec<Series>| Panel {
        title: title.to_owned(),
        x: Axis::linear("incidence off the normal, °", 0.0, 90.0),
        y,
        series,
    };
    let angle = |label: &str| Axis::linear(label, 0.0, 90.0);
    let share = || Axis::linear("speed after / before", 0.0, 1.05);
    let (bounce, roll) = ("just after the bounce", "once it rolls again");
    [
        panel(
            bounce,
            angle("leaves off the normal, °"),
            curves(range, |law, degrees| after(law, degrees, false).0, None),
        ),
        panel(
            roll,
            angle("goes off the normal, °"),
            curves(
                range,
                |law, degrees| after(law, degrees, true).0,
                Some(|degrees| pushed(degrees).0),
            ),
        ),
        panel(
            bounce,
            share(),
            curves(range, |law, degrees| after(law, degrees, false).1, None),
        ),
        panel(
            roll,
            share(),
            curves(
                range,
                |law, degrees| after(law, degrees, true).1,
                Some(|degrees| pushed(degrees).1),
            ),
        ),
    ]
}

/// Square rebounds against speed, beside E3 and E4.
fn square() -> Panel {
    let value: Value = |law, speed| square_ratio(&Stand::SNOOKER, law, speed);
    let mut series = curves((0.1, 3.5), value, None);
    let ratios = MATHAVAN_2010
        .map(|(speed, after)| (speed, after / speed))
        .to_vec();
    series.push(Series::new("E3 Mathavan et al. 2010", MEASURED, ratios));
    let sudo = vec![(1.0, Sudo::CUSHION_SLOW)];
    series.push(Series::new(
        "E4 Sudo & Shibata 2002, below 1.8 m/s",
        Ink::dots(6),
        sudo,
    ));
    Panel {
        title: "square roll, snooker: speed ratio".to_owned(),
        x: Axis::linear("speed before, m/s", 0.0, 3.5),
        y: Axis::linear("speed after / before", 0.5, 1.05),
        series,
    }
}

/// Settled rebounds against speed, beside E10.
fn settled() -> Panel {
    let value: Value =
        |law, speed| settled_normal(&Stand::CAROM, law, speed, f64::to_radians(20.0));
    let mut series = curves((0.1, 2.5), value, None);
    let settled = vec![THREE_CUSHION_SETTLED];
    series.push(Series::new(
        "E10 three-cushion, settled",
        Ink::dots(2),
        settled,
    ));
    let early = THREE_CUSHION_FAST.to_vec();
    series.push(Series::new(
        "E10, seen before settling",
        Ink::dots(3),
        early,
    ));
    Panel {
        title: "roll at 20°, carom: normal speed ratio once it rolls".to_owned(),
        x: Axis::linear("normal speed before, m/s", 0.0, 2.5),
        y: Axis::linear("normal speed after / before", 0.2, 1.05),
        series,
    }
}

pub(super) fn chart() -> Chart {
    let [leaves, goes, kept, settles] = by_incidence();
    Chart {
        title: "Rebound from a cushion of a rolling ball".to_owned(),
        panels: vec![leaves, goes, square(), kept, settles, settled()],
        columns: 3,
    }
}
