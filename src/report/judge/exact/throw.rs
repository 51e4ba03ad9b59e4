//! J8 and J9: throw, spin transfer, gearing.

use glam::DVec3;

use crate::physics::ball::State;
use crate::physics::laws::ball_ball::Friction;
use crate::report::judge::Row;
use crate::report::judge::stand::{Stand, ball_ball_laws, rough};

/// Speeds of TP A.14 in m/s: slow, medium, fast.
pub(in crate::report::judge) const SPEEDS: [f64; 3] = [0.447, 1.341, 3.129];

const SOURCE: &str = "closed form (Alciatore, TP A.14)";

/// The formula of TP A.14 with the numbers printed there.
fn marlow(slip: f64) -> f64 {
    9.951e-3 + 0.108 * libm::exp(-1.088 * slip)
}

/// A stun ball with english whose surface speed is `share` of its speed.
fn with_side(speed: f64, share: f64) -> State {
    let stand = Stand::POOL;
    stand.moving(
        DVec3::X * speed,
        DVec3::Y * (share * speed / stand.ball.radius),
    )
}

/// J8.
pub(super) fn throw() -> Vec<Row> {
    let stand = Stand::POOL;
    let law = rough(1.0, Friction::MARLOW);
    let name = "Frictional, Marlow";
    let mut rows = Vec::new();
    let mut add = |what: String, law: &str, expected: f64, ours: f64| {
        let row = Row::closed(&what, law, expected.to_degrees(), ours.to_degrees(), "°");
        rows.push(row.by(SOURCE));
    };
    for (speed, roll) in [(SPEEDS[0], false), (SPEEDS[1], true)] {
        for cut_deg in [10.0, 20.0, 25.0, 30.0, 35.0, 40.0, 50.0, 60.0, 70.0] {
            let cut = f64::to_radians(cut_deg);
            let (state, expected, how) = if roll {
                let thrown = marlow(speed) * libm::sin(cut);
                (stand.rolling(speed, 1.0), libm::atan(thrown), "roll")
            } else {
                let thrown = marlow(speed * libm::sin(cut)).min(libm::tan(cut) / 7.0);
                (stand.stunned(speed), libm::atan(thrown), "stun")
            };
            let ours = stand.throw(&law, &state, cut);
            add(
                format!("J8 {how} at {speed} m/s, {cut_deg}° cut: throw"),
                name,
                expected,
                ours,
            );
        }
    }
    for speed in [SPEEDS[0], SPEEDS[1]] {
        for share in [0.25, 0.5, 0.75, 1.0, 1.25] {
            let ours = -stand.throw(&law, &with_side(speed, share), 0.0);
            let expected = libm::atan(marlow(share * speed).min(share / 7.0));
            add(
                format!("J8 straight at {speed} m/s, R ω = {share} v: throw"),
                name,
                expected,
                ours,
            );
        }
    }
    let constant = rough(1.0, Friction::Constant(0.06));
    for cut_deg in [15.0, 20.0, 40.0, 60.0] {
        let cut = f64::to_radians(cut_deg);
        let ours = stand.throw(&constant, &stand.stunned(SPEEDS[1]), cut);
        let expected = libm::atan(0.06_f64.min(libm::tan(cut) / 7.0));
        add(
            format!("J8 stun, {cut_deg}° cut: throw"),
            "Frictional, μ 0.06",
            expected,
            ours,
        );
        let ours = stand.throw(&constant, &stand.rolling(SPEEDS[1], 1.0), cut);
        let expected = libm::atan((0.06 * libm::sin(cut)).min(libm::tan(cut) / 7.0));
        add(
            format!("J8 roll, {cut_deg}° cut: throw"),
            "Frictional, μ 0.06",
            expected,
            ours,
        );
    }
    let (peak, at) = peak();
    rows.push(
        Row::printed(
            "J8 stun at 0.447 m/s: largest throw",
            name,
            (5.301, 3),
            peak,
            "°",
        )
        .by("TP A.14 evaluated apart on a grid of 0.05°"),
    );
    rows.push(
        Row::printed(
            "J8 stun at 0.447 m/s: cut of the largest throw",
            name,
            (33.05, 2),
            at,
            "°",
        )
        .by("TP A.14 evaluated apart on a grid of 0.05°"),
    );
    let half = -stand.throw(&law, &with_side(SPEEDS[0], 0.625), 0.0);
    rows.push(
        Row::printed(
            "J8 straight at 0.447 m/s, half english: throw",
            name,
            (5.102, 3),
            half.to_degrees(),
            "°",
        )
        .by("TP A.14 evaluated apart"),
    );
    rows
}

/// The largest throw in degrees of a slow stun shot, and its cut angle, on a grid of 0.05°.
fn peak() -> (f64, f64) {
    let stand = Stand::POOL;
    let law = rough(1.0, Friction::MARLOW);
    (0..1800)
        .map(|step| {
            let cut_deg = f64::from(step) * 0.05;
            let thrown = stand.throw(&law, &stand.stunned(SPEEDS[0]), cut_deg.to_radians());
            (thrown.to_degrees(), cut_deg)
        })
        .fold(
            (0.0, 0.0),
            |best, new| if new.0 > best.0 { new } else { best },
        )
}

/// J9.
pub(super) fn transfer() -> Vec<Row> {
    let stand = Stand::POOL;
    let mut rows = Vec::new();
    for (name, law) in ball_ball_laws() {
        // R ω = v sin c on the outside: the surfaces roll on each other.
        let (mut thrown, mut passed) = (0.0_f64, 0.0_f64);
        for speed in SPEEDS {
            for cut_deg in [5.0, 20.0, 40.0, 75.0] {
                let cut = f64::to_radians(cut_deg);
                let state = with_side(speed, libm::sin(cut));
                let after = stand.hit(&law, &state, cut);
                thrown = thrown.max(stand.throw(&law, &state, cut).abs());
                passed = passed
                    .max(after.second.angular_velocity.length() / state.angular_velocity.length());
            }
        }
        let source = "closed form (Alciatore, TP A.14, gearing)";
        rows.push(
            Row::zero(
                "J9 gearing: largest throw of 12 shots",
                &name,
                thrown.to_degrees(),
                1e-12,
                "°",
            )
            .by(source),
        );
        rows.push(
            Row::zero(
                "J9 gearing: largest spin passed on",
                &name,
                passed,
                1e-12,
                "",
            )
            .by(source),
        );
    }
    let law = rough(1.0, Friction::MARLOW);
    for speed in SPEEDS {
        for (share, english) in [(0.625, 50), (1.25, 100)] {
            let before = with_side(speed, share);
            let after = stand.hit(&law, &before, 0.0);
            let ours = -after.second.angular_velocity.y / before.angular_velocity.y;
            // Δω = (5/2) Jₜ / (m R): sticking passes 5/14 of the spin on.
            let expected = (2.5 * marlow(share * speed) / share).min(5.0 / 14.0);
            let title = format!("J9 straight at {speed} m/s, {english} % english: spin passed on");
            rows.push(Row::closed(&title, "Frictional, Marlow", expected, ours, "").by(SOURCE));
        }
    }
    rows
}
