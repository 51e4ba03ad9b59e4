//! J5 to J7: where a rolling, drawing or following cue ball goes after the hit, by whole shots of the exact solver.

use crate::physics::laws::ball_ball::{BallBallLaw, Friction};
use crate::physics::record::Record;
use crate::report::judge::Row;
use crate::report::judge::stand::{Stand, cut_line, rough, smooth, turn};
use crate::sim::play::{Stopped, play};
use glam::DVec3;

const THIRTY: &str = "closed form (Alciatore, TP B.13)";
const DRAW: &str = "closed form (Alciatore, TP A.4, A.12)";

pub(super) fn rows() -> Result<Vec<Row>, Stopped> {
    let mut rows = thirty_degrees()?;
    rows.extend(draw_and_follow()?);
    rows.extend(head_on()?);
    Ok(rows)
}

/// A shot in the exact solver: the cue ball starts 1 mm before the hit with `roll` times the spin of rolling.
pub(in crate::report::judge) fn shot(
    law: &BallBallLaw,
    speed: f64,
    roll: f64,
    cut: f64,
) -> Result<Record, Stopped> {
    let stand = Stand::POOL;
    let start = stand.rolling(speed, roll);
    let way = 1e-3;
    let object = DVec3::X * way + 2.0 * stand.ball.radius * cut_line(cut);
    let mut scene = stand.room(*law);
    scene.place("cue", stand.ball, 0.0, 0.0);
    scene.place("1", stand.ball, object.x, object.z);
    scene.balls[0].state = start;
    play(&scene)
}

/// Deflection in rad and settled speed over speed at the hit of the cue ball of a shot.
fn deflection(law: &BallBallLaw, speed: f64, roll: f64, cut: f64) -> Result<(f64, f64), Stopped> {
    let record = shot(law, speed, roll, cut)?;
    let Some(hit) = record.events.iter().find(|event| event.second.is_some()) else {
        return Ok((f64::NAN, f64::NAN));
    };
    let stand = Stand::POOL;
    let cue = hit.participants().find(|participant| participant.ball == 0);
    let Some(cue) = cue else {
        return Ok((f64::NAN, f64::NAN));
    };
    let end = stand.settled(&cue.after).velocity;
    Ok((
        -turn(cue.before.velocity, end),
        end.length() / cue.before.velocity.length(),
    ))
}

fn thirty_degrees() -> Result<Vec<Row>, Stopped> {
    let mut rows = Vec::new();
    let best = libm::asin((2.0_f64 / 9.0).sqrt()).to_degrees();
    for cut_deg in [10.0, 20.0, best, 30.0, 40.0, 45.0, 60.0, 80.0] {
        let cut = f64::to_radians(cut_deg);
        let (s, c) = (libm::sin(cut), libm::cos(cut));
        for speed in [0.5, 2.0] {
            let (angle, kept) = deflection(&smooth(1.0), speed, 1.0, cut)?;
            let title = format!("J5 roll at {speed} m/s, {cut_deg:.4}° cut");
            let expected = libm::atan2(s * c, s * s + 0.4).to_degrees();
            let law = "Frictionless, e 1";
            let angle = angle.to_degrees();
            rows.push(
                Row::closed(&format!("{title}: deflection"), law, expected, angle, "°").by(THIRTY),
            );
            let expected = 5.0 / 7.0 * (s * s * c * c + (s * s + 0.4) * (s * s + 0.4)).sqrt();
            rows.push(
                Row::closed(&format!("{title}: speed kept"), law, expected, kept, "").by(THIRTY),
            );
        }
    }
    let largest = libm::asin(5.0 / 9.0).to_degrees();
    let (ours, _) = deflection(&smooth(1.0), 1.0, 1.0, best.to_radians())?;
    rows.push(
        Row::closed(
            "J5 largest deflection, asin 5/9",
            "Frictionless, e 1",
            largest,
            ours.to_degrees(),
            "°",
        )
        .by(THIRTY),
    );
    for (e, cut_deg, printed) in [(0.94, 28.996, 32.0091), (0.89, 29.686, 30.6261)] {
        let (ours, _) = deflection(&smooth(e), 1.0, 1.0, f64::to_radians(cut_deg))?;
        let (title, law) = (
            format!("J5 largest deflection, e {e}"),
            format!("Frictionless, e {e}"),
        );
        rows.push(
            Row::printed(&title, &law, (printed, 4), ours.to_degrees(), "°")
                .by("maximum of the closed form, computed apart"),
        );
    }
    Ok(rows)
}

fn draw_and_follow() -> Result<Vec<Row>, Stopped> {
    let law = smooth(1.0);
    let mut rows = Vec::new();
    for (roll, printed) in [
        (-1.0, None),
        (-0.625, Some([58.0, 90.0, 128.0])),
        (0.5, None),
        (1.8, None),
    ] {
        for (i, fraction) in [0.25, 0.5, 0.75].into_iter().enumerate() {
            let cut = libm::asin(1.0 - fraction);
            let (s, c) = (libm::sin(cut), libm::cos(cut));
            let (angle, _) = deflection(&law, 2.0, roll, cut)?;
            let title = format!("J6 spin {roll} of rolling, {fraction} ball: deflection");
            let angle = angle.to_degrees();
            // Over the last millimetre before the hit the cloth changes the spin a little.
            let at_hit = spin_at_hit(&law, roll, cut)?;
            let expected = libm::atan2(s * c, s * s + 0.4 * at_hit).to_degrees();
            rows.push(Row::closed(&title, "Frictionless, e 1", expected, angle, "°").by(DRAW));
            if let Some(printed) = printed {
                rows.push(
                    Row::printed(&title, "Frictionless, e 1", (printed[i], 0), angle, "°")
                        .by("printed by Alciatore, whole degrees, for typical draw"),
                );
            }
        }
    }
    Ok(rows)
}

/// Spin of the cue ball at the hit as a multiple of that of rolling.
fn spin_at_hit(law: &BallBallLaw, roll: f64, cut: f64) -> Result<f64, Stopped> {
    let record = shot(law, 2.0, roll, cut)?;
    let hit = record.events.iter().find(|event| event.second.is_some());
    let cue = hit.and_then(|hit| {
        hit.participants()
            .find(|participant| participant.ball == 0)
            .copied()
    });
    Ok(cue.map_or(f64::NAN, |cue| {
        let rolls = Stand::POOL.ball.rolling_spin(cue.before.velocity);
        cue.before.angular_velocity.dot(rolls) / rolls.length_squared()
    }))
}

/// J7: straight on, with the friction of topspin against the object ball.
fn head_on() -> Result<Vec<Row>, Stopped> {
    let stand = Stand::POOL;
    let mut rows = Vec::new();
    for (e, mu, printed) in [
        (1.0, 0.0, Some(6.238)),
        (1.0, 0.05, Some(7.428)),
        (0.94, 0.05, Some(5.886)),
        (0.9, 0.1, None),
    ] {
        let law = rough(e, Friction::Constant(mu));
        let name = format!("Frictional, e {e}, μ {mu}");
        let after = stand.hit(&law, &stand.rolling(2.0, 1.0), 0.0);
        let half = 0.5 * (1.0 + e);
        let expected = [
            5.0 / 7.0 * 0.5 * (1.0 - e) + 2.0 / 7.0 * (1.0 - 2.5 * mu * half),
            5.0 / 7.0 * half * (1.0 - mu),
        ];
        for (i, (ball, state)) in [("cue ball", after.first), ("object ball", after.second)]
            .into_iter()
            .enumerate()
        {
            let ours = stand.settled(&state).velocity.x / 2.0;
            let title = format!("J7 roll head-on: {ball} settles at");
            rows.push(
                Row::closed(&title, &name, expected[i], ours, "v")
                    .by("closed form (Alciatore, TP A.16)"),
            );
        }
        if let Some(printed) = printed {
            let record = shot(&law, 2.0, 1.0, 0.0)?;
            let path =
                |ball: usize| (record.end[ball].position - hit_place(&record, ball)).length();
            let title = "J7 roll head-on: object path / cue path";
            rows.push(
                Row::printed(title, &name, (printed, 3), path(1) / path(0), "")
                    .by("closed form, computed apart; Alciatore: about 7 to 8"),
            );
        }
    }
    Ok(rows)
}

/// Where a ball was at the hit.
fn hit_place(record: &Record, ball: usize) -> DVec3 {
    let hit = record.events.iter().find(|event| event.second.is_some());
    hit.map_or(DVec3::NAN, |hit| record.state_at(ball, hit.time).position)
}
