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
    rows.extend(converged());
    rows
}

/// J15 once more: just after the impact, against the equations of motion of two rigid bodies stepped by Runge-Kutta in
/// 20,000, 80,000 and 320,000 steps, which agree in all digits given. Cue ball with `roll` of the spin of rolling and R ω
/// of `side` v.
fn converged() -> Vec<Row> {
    let stand = Stand::SNOOKER;
    let law = BallBallLaw::Mathavan2014(Mathavan2014::default());
    let mut rows = Vec::new();
    // Velocity of the cue ball and of the object ball along x and z, then R ω of each along x, y and z.
    for (speed, cut_deg, roll, side, expected) in CONVERGED_IMPACTS {
        let mut start = stand.rolling(speed, roll);
        start.angular_velocity.y = side * speed / stand.ball.radius;
        let after = stand.hit(&law, &start, f64::to_radians(cut_deg));
        let (first, second) = (after.first, after.second);
        let [w_1, w_2] = [first, second].map(|state| stand.ball.radius * state.angular_velocity);
        let (v_1, v_2) = (first.velocity, second.velocity);
        let ours = [
            v_1.x, v_1.z, v_2.x, v_2.z, w_1.x, w_1.y, w_1.z, w_2.x, w_2.y, w_2.z,
        ];
        let names = [
            "v_x",
            "v_z",
            "object ball's v_x",
            "v_z",
            "R ω_x",
            "R ω_y",
            "R ω_z",
            "object ball's R ω_x",
            "R ω_y",
            "R ω_z",
        ];
        for ((name, expected), ours) in names.into_iter().zip(expected).zip(ours) {
            let title =
                format!("J15 at {speed} m/s, {cut_deg}° cut, roll {roll}, side {side}: {name}");
            rows.push(
                Row::near(&title, "Mathavan2014", expected, ours, "m/s", 1e-5 * speed)
                    .by("Mathavan et al. 2014, integrated apart until converged"),
            );
        }
    }
    rows
}

/// Speed, cut in degrees, share of rolling, side; and what is left after the impact.
const CONVERGED_IMPACTS: [(f64, f64, f64, f64, [f64; 10]); 7] = [
    (
        1.539,
        33.83,
        1.0,
        0.0,
        [
            0.5128634, 0.6485467, 1.0170591, -0.6427831, 0.0712658, 0.0813459, -1.4326648,
            0.0568568, 0.0813459, 0.0836415,
        ],
    ),
    (
        1.032,
        26.36,
        1.0,
        0.0,
        [
            0.2370358, 0.3731694, 0.7874121, -0.3696088, 0.0441331, 0.0465095, -0.9429384,
            0.0352315, 0.0465095, 0.0701815,
        ],
    ),
    (
        1.0,
        45.0,
        0.0,
        0.0,
        [
            0.503875, 0.448875, 0.496125, -0.448875, 0.0, 0.083527, 0.0, 0.0, 0.083527, 0.0,
        ],
    ),
    (
        1.0,
        30.0,
        -1.0,
        0.0,
        [
            0.2766207, 0.3894456, 0.7160137, -0.3905508, -0.0417941, 0.0494498, 0.9044108,
            -0.044557, 0.0494498, -0.0771751,
        ],
    ),
    (
        1.0,
        60.0,
        1.0,
        0.0,
        [
            0.7454961, 0.400116, 0.2531424, -0.3979643, 0.0262512, 0.0508721, -0.9848438, 0.020872,
            0.0508721, 0.0117525,
        ],
    ),
    (
        2.0,
        20.0,
        1.0,
        1.0,
        [
            0.3406795, 0.6564628, 1.6448037, -0.6507553, 0.0635119, 1.8766194, -1.8255024,
            0.0492432, -0.1233806, 0.1382056,
        ],
    ),
    (
        1.0,
        50.0,
        0.5,
        -1.0,
        [
            0.5862813, 0.4465541, 0.4129259, -0.4456965, 0.0106516, -0.9252813, -0.4910622,
            0.0085075, 0.0747187, 0.0069556,
        ],
    ),
];
