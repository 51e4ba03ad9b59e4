//! Cushions where a law has a closed form.

use glam::DVec3;

use crate::physics::ball::State;
use crate::physics::laws::cushion::{CushionLaw, Han2005, Mirror};
use crate::report::judge::Row;
use crate::report::judge::stand::{Stand, cushion_laws};

const HAN: &str = "closed form (Han 2005, eqs 14 to 20, nose at centre height)";

pub(super) fn rows() -> Vec<Row> {
    let mut rows = square();
    rows.extend(mirror());
    rows.extend(han_2005());
    rows
}

/// The rebound of a ball that comes along x, nose at the height of its centre.
fn rebound(law: &CushionLaw, state: &State, incidence: f64) -> State {
    let stand = Stand::POOL;
    stand.rebound_at(law, state, incidence, stand.ball.radius)
}

/// Every law: without spin, square on, at the height of the centre only restitution is left.
fn square() -> Vec<Row> {
    let mut rows = Vec::new();
    for (name, law) in cushion_laws() {
        let ours = -rebound(&law, &Stand::POOL.stunned(2.0), 0.0).velocity.x;
        let title = "cushion, nose at centre height, square stun at 2 m/s: rebound";
        let expected = 2.0 * law.restitution(2.0);
        rows.push(
            Row::closed(title, &name, expected, ours, "m/s").by("closed form, restitution alone"),
        );
    }
    rows
}

fn mirror() -> Vec<Row> {
    let law = CushionLaw::Mirror(Mirror {
        restitution: 0.85.into(),
    });
    let stand = Stand::POOL;
    [20.0, 45.0, 70.0]
        .into_iter()
        .map(|degrees| {
            let incidence = f64::to_radians(degrees);
            let after = stand
                .rebound(&law, &stand.rolling(2.0, 1.0), incidence)
                .velocity;
            let (out, along) = components(after, incidence);
            let expected = libm::atan(libm::tan(incidence) / 0.85).to_degrees();
            let title = format!("cushion, {degrees}° off the normal: leaves at");
            Row::closed(
                &title,
                "Mirror",
                expected,
                libm::atan2(along, out).to_degrees(),
                "°",
            )
            .by("closed form")
        })
        .collect()
}

fn han_2005() -> Vec<Row> {
    let (e, v) = (0.8, 2.0);
    let incidence = f64::to_radians(10.0);
    let (into, across) = (v * libm::cos(incidence), v * libm::sin(incidence));
    let han = |friction: f64| {
        CushionLaw::Han2005(Han2005 {
            restitution: e.into(),
            friction: friction.into(),
        })
    };
    let stand = Stand::POOL;
    let mut rows = Vec::new();
    let mut add = |title: &str, expected: f64, ours: f64| {
        rows.push(Row::closed(title, "Han2005", expected, ours, "m/s").by(HAN));
    };
    for (mu, what, expected) in [
        (1.0, "sticking", 5.0 / 7.0 * across),
        (0.02, "slipping", across - 0.02 * (1.0 + e) * into),
    ] {
        let after = rebound(&han(mu), &stand.stunned(v), incidence).velocity;
        let (out, along) = components(after, incidence);
        add(
            &format!("cushion, stun, {what}: normal speed"),
            e * into,
            out,
        );
        add(
            &format!("cushion, stun, {what}: speed along"),
            expected,
            along,
        );
    }
    let spin = 12.0;
    let state = stand.moving(DVec3::X * v, DVec3::Y * spin);
    let along = rebound(&han(1.0), &state, 0.0).velocity.z.abs();
    add(
        "cushion, english 12 rad/s: speed along",
        2.0 / 7.0 * stand.ball.radius * spin,
        along,
    );
    rows
}

/// Speeds away from and along a cushion whose normal is turned by this angle.
pub(in crate::report::judge) fn components(velocity: DVec3, incidence: f64) -> (f64, f64) {
    let (sin, cos) = (libm::sin(incidence), libm::cos(incidence));
    (
        velocity.dot(DVec3::new(-cos, 0.0, sin)),
        velocity.dot(DVec3::new(sin, 0.0, cos)),
    )
}
