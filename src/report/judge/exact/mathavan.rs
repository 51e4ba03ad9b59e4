//! J14 and J15: the impacts of Mathavan, Jackson & Parkin, which have no closed form, beside converged and published
//! values.

use glam::DVec3;

use crate::physics::laws::ball_ball::{BallBallLaw, Mathavan2014};
use crate::physics::laws::cushion::{CushionLaw, Mathavan2010};
use crate::report::judge::Row;
use crate::report::judge::exact::components;
use crate::report::judge::stand::{Stand, turn};

const CONVERGED: &str = "Mathavan et al. 2010, integrated apart until converged";
const PUBLISHED: &str = "Mathavan et al. 2014, as printed in a test of pooltool; stepped by its authors, so three figures are taken";

/// J14: a snooker ball with 1 m/s.
pub(super) fn cushion() -> Vec<Row> {
    let stand = Stand::SNOOKER;
    let law = CushionLaw::Mathavan2010(Mathavan2010::default());
    let mut rows = Vec::new();
    let mut add = |title: String, expected: (f64, i32), ours: f64, unit| {
        rows.push(Row::printed(&title, "Mathavan2010", expected, ours, unit).by(CONVERGED));
    };
    for (angle, roll, leaves, goes) in [
        (90.0, 1.0, (0.91066, 90.0), (0.5833, 90.0)),
        (60.0, 1.0, (0.86716, 68.824), (0.6068, 58.919)),
        (45.0, 1.0, (0.84761, 52.678), (0.6696, 39.876)),
        (90.0, 0.0, (0.83732, 90.0), (0.5757, 90.0)),
    ] {
        let how = if roll == 0.0 { "stun" } else { "roll" };
        let incidence = f64::to_radians(90.0 - angle);
        let after = stand.rebound(&law, &stand.rolling(1.0, roll), incidence);
        let rolling = stand.settled(&after);
        for (when, (speed, degrees), decimals, state) in
            [("leaves", leaves, 5, after), ("settles", goes, 4, rolling)]
        {
            let title = format!("J14 {how} at {angle}° to the cushion: {when}");
            let (out, along) = components(state.velocity, incidence);
            let ours = libm::atan2(out, along).to_degrees();
            add(
                format!("{title} with"),
                (speed, decimals),
                state.velocity.length(),
                "m/s",
            );
            add(format!("{title} at"), (degrees, 3), ours, "°");
        }
    }
    let incidence = f64::to_radians(45.0);
    let after = stand.rebound(&law, &stand.rolling(1.0, 1.0), incidence);
    let (out, along) = components(after.velocity, incidence);
    let spin = stand.ball.radius * after.angular_velocity;
    // The paper's axes: x along the cushion, y into it, z up.
    let (about_along, about_into) = (
        components(spin, incidence).1,
        -components(spin, incidence).0,
    );
    for (what, expected, ours) in [
        ("v_x", (0.513902, 6), along),
        ("v_y", (-0.674058, 6), -out),
        ("R ω_x", (-0.18251, 5), about_along),
        ("R ω_y", (0.51390, 5), about_into),
        ("R ω_z", (0.44269, 5), spin.y),
    ] {
        add(
            format!("J14 roll at 45° to the cushion: {what}"),
            expected,
            ours,
            "m/s",
        );
    }
    for side in [1.0, -1.0] {
        let roll = stand.rolling(1.0, 1.0);
        let spin = roll.angular_velocity + side / stand.ball.radius * DVec3::Y;
        let after = stand.rebound(&law, &stand.moving(DVec3::X, spin), 0.0);
        let off = |velocity: DVec3| side * turn(-DVec3::X, velocity).to_degrees();
        let title = format!("J14 square roll, R ω = {side} v of side: off the normal");
        let (leaves, goes) = (off(after.velocity), off(stand.settled(&after).velocity));
        add(format!("{title}, leaves"), (13.94, 2), leaves.abs(), "°");
        add(format!("{title}, settles"), (21.08, 2), goes.abs(), "°");
    }
    rows
}

/// J15: a rolling snooker ball cuts another; speeds and deviations once both roll.
pub(super) fn ball_ball() -> Vec<Row> {
    let stand = Stand::SNOOKER;
    let law = BallBallLaw::Mathavan2014(Mathavan2014::default());
    let mut rows = Vec::new();
    for (speed, cut_deg, expected) in [
        (1.539, 33.83, [0.914, 0.831, 31.93, 32.20]),
        (1.032, 26.36, [0.520, 0.599, 32.45, 25.07]),
    ] {
        let after = stand.hit(&law, &stand.rolling(speed, 1.0), f64::to_radians(cut_deg));
        let [cue, object] = [after.first, after.second].map(|state| stand.settled(&state).velocity);
        let off = |velocity: DVec3| turn(DVec3::X, velocity).abs().to_degrees();
        for (what, expected, ours, unit) in [
            ("cue ball's speed", (expected[0], 3), cue.length(), "m/s"),
            (
                "object ball's speed",
                (expected[1], 3),
                object.length(),
                "m/s",
            ),
            ("cue ball's deviation", (expected[2], 1), off(cue), "°"),
            (
                "object ball's deviation",
                (expected[3], 1),
                off(object),
                "°",
            ),
        ] {
            let title = format!("J15 roll at {speed} m/s, {cut_deg}° cut: {what}");
            rows.push(Row::printed(&title, "Mathavan2014", expected, ours, unit).by(PUBLISHED));
        }
    }
    rows
}
