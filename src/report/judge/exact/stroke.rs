//! J11 to J13: the stroke, squirt, and the massé.

use glam::DVec3;

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::cue::{Cue, Shot};
use crate::physics::laws::cue_ball::{Struck, squirt_angle, strike};
use crate::physics::laws::slate::SlateLaw;
use crate::physics::scene::PlannedShot;
use crate::report::judge::Row;
use crate::report::judge::exact::slide::begins;
use crate::report::judge::stand::{Stand, name_of, smooth};
use crate::sim::play::{Stopped, play};

const BALL: Ball = Ball::POOL;
const LAW: &str = "strike";

/// A cue of 567 g without squirt.
fn cue(tip_restitution: f64) -> Cue {
    Cue {
        mass: 0.567,
        tip_restitution,
        end_mass: 0.0,
        ..Cue::default()
    }
}

fn struck(cue: &Cue, side: f64, height: f64) -> Struck {
    let shot = Shot {
        side,
        height,
        speed: 3.0,
        ..Shot::default()
    };
    let rest = State::at_rest(DVec3::Y * BALL.radius);
    strike(cue, &SlateLaw::Held, &BALL, &rest, &shot)
}

pub(super) fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    let source = "closed form (Alciatore, TP A.30)";
    for restitution in [1.0, 0.73] {
        for b in [0.0, 0.1, 0.2, 0.25, 0.3, 0.4, 0.5] {
            let state = struck(&cue(restitution), 0.0, b).state;
            let expected = (1.0 + restitution) / (1.0 + BALL.mass / 0.567 + 2.5 * b * b);
            let title = format!("J11 level cue, tip e {restitution}, height {b} R: speed");
            rows.push(Row::closed(&title, LAW, expected, state.velocity.x / 3.0, "V₀").by(source));
        }
    }
    let state = struck(&cue(0.73), 0.3, 0.0).state;
    let spin = BALL.radius * state.angular_velocity.y / state.velocity.x;
    rows.push(Row::closed("J11 right english 0.3 R: R ω / v", LAW, 0.75, spin, "").by(source));
    let state = struck(&cue(0.73), 0.0, 0.4).state;
    let slip = BALL.slip(state.velocity, state.angular_velocity).length() / state.velocity.x;
    rows.push(
        Row::zero(
            "J11 height 0.4 R rolls at once: slip",
            LAW,
            slip,
            1e-13,
            "v",
        )
        .by(source),
    );
    let best = -1.0 + (1.0 + 0.4 * (1.0 + BALL.mass / 0.567)).sqrt();
    rows.push(
        Row::closed(
            "J11 height of the fastest roll",
            LAW,
            best,
            fastest_roll(),
            "R",
        )
        .within(1e-6)
        .by("closed form; ours by a search, so to the root of rounding"),
    );
    rows.extend(squirt());
    rows
}

/// The tip height in R whose shot rolls fastest, by golden section.
fn fastest_roll() -> f64 {
    let stand = Stand::POOL;
    let speed = |b: f64| stand.settled(&struck(&cue(1.0), 0.0, b).state).velocity.x;
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (0.0, 0.5);
    while high - low > 1e-9 {
        let (one, two) = (high - ratio * (high - low), low + ratio * (high - low));
        if speed(one) < speed(two) {
            low = one;
        } else {
            high = two;
        }
    }
    0.5 * (low + high)
}

/// J12.
fn squirt() -> Vec<Row> {
    let mut rows = Vec::new();
    for ratio in [20.0, 30.0] {
        let cue = Cue {
            end_mass: BALL.mass / ratio,
            ..cue(1.0)
        };
        for b in [0.1, 0.2, 0.3, 0.4, 0.5] {
            let velocity = struck(&cue, b, 0.0).state.velocity;
            let ours = libm::atan2(-velocity.z, velocity.x).to_degrees();
            let square = 1.0_f64 - b * b;
            let expected = libm::atan(2.5 * b * square.sqrt() / (1.0 + ratio + 2.5 * square));
            let title = format!("J12 squirt, m/mₑ {ratio}, english {b} R");
            rows.push(
                Row::closed(&title, LAW, expected.to_degrees(), ours, "°")
                    .by("closed form (Alciatore, TP A.31)"),
            );
        }
        if ratio == 20.0 {
            let ours = squirt_angle(&cue, &BALL, 0.2).to_degrees();
            rows.push(
                Row::printed(
                    "J12 squirt, m/mₑ 20, english 0.2 R",
                    LAW,
                    (1.199_358_331_3, 10),
                    ours,
                    "°",
                )
                .by("printed in a test of pooltool"),
            );
        }
    }
    rows
}

/// J13: an elevated cue with english. Where the ball ends up rolling does not depend on the friction of the cloth, nor on
/// how the slate throws it back.
pub(super) fn masse() -> Result<Vec<Row>, Stopped> {
    let stand = Stand::POOL;
    let (elevation, side) = (f64::to_radians(60.0), 0.3);
    let (sin, cos) = (libm::sin(elevation), libm::cos(elevation));
    // The impulse is 2 m/s times the mass.
    let cue = cue(0.73);
    let lever = 2.5 * side * side;
    let speed = 2.0 * (BALL.mass / cue.mass + 1.0 + lever) / (1.0 + cue.tip_restitution);
    // From the lowest point of the ball to where the line of the cue meets the cloth, in R.
    let depth = (1.0_f64 - side * side).sqrt();
    let ahead = (1.0 + depth * sin) * cos / sin - depth * cos;
    let source = "closed form (Coriolis; Alciatore, TP A.19)";
    let mut rows = Vec::new();
    for slate in SlateLaw::all() {
        for sliding in [0.2, 0.35] {
            let mut stand = stand;
            stand.cloth.sliding = sliding;
            let mut scene = stand.room(smooth(1.0));
            scene.laws.slate = slate;
            scene.cue = cue;
            scene.place("cue", BALL, 0.0, 0.0);
            let shot = Shot {
                elevation,
                side,
                speed,
                ..Shot::default()
            };
            scene.shot = Some(PlannedShot { ball: 0, shot });
            let record = play(&scene)?;
            let Some((when, state)) = begins(&record, Motion::Rolling) else {
                rows.push(Row::stopped("J13 massé", "the ball never rolls"));
                continue;
            };
            let name = format!("{}, μₛ {sliding}", name_of(&slate));
            let scale = 5.0 / 7.0 * 2.0 * sin;
            let mut add = |what: &str, expected: f64, ours: f64, unit| {
                let title = format!("J13 massé, cue at 60°, side 0.3 R: {what}");
                rows.push(Row::closed(&title, &name, expected, ours, unit).by(source));
            };
            let direction = libm::atan2(ahead, side).to_degrees();
            let ours = libm::atan2(state.velocity.x, state.velocity.z).to_degrees();
            add(
                "direction, ahead of square to the side",
                direction,
                ours,
                "°",
            );
            let expected = scale * (ahead * ahead + side * side).sqrt();
            add(
                "speed when it rolls",
                expected,
                state.velocity.length(),
                "m/s",
            );
            if matches!(slate, SlateLaw::Held) {
                // Slip at the start: the ball moves ahead with 1 m/s and turns about the line of its motion.
                let slip = (1.0_f64 + (2.5 * side * 2.0 * sin) * (2.5 * side * 2.0 * sin)).sqrt();
                let time = 2.0 * slip / (7.0 * sliding * stand.cloth.gravity);
                add("time of slide", time, when, "s");
            }
        }
    }
    Ok(rows)
}
