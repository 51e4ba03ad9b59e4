//! J10 and J17: several contacts at one instant, by the exact solver.

use glam::DVec3;

use crate::physics::cue::Shot;
use crate::physics::laws::ball_ball::BallBallLaw;
use crate::physics::scene::PlannedShot;
use crate::report::judge::Row;
use crate::report::judge::stand::{Stand, smooth};
use crate::sim::play::{Stopped, play};

pub(super) fn rows() -> Result<Vec<Row>, Stopped> {
    let mut rows = Vec::new();
    for degrees in [10.0_f64, 20.0, 46.0, 70.0] {
        let ours = frozen_pair(&smooth(0.95), degrees)?;
        let expected = libm::atan(2.0 * libm::tan(degrees.to_radians())).to_degrees();
        let title = format!("J10 frozen pair, cue at {degrees}°: cue ball leaves at");
        rows.push(
            Row::closed(&title, "Frictionless, cluster", expected, ours, "°")
                .by("closed form tan θ = 2 tan φ (Alciatore, TP A.15)"),
        );
    }
    for e in [1.0, 0.95, 0.5] {
        for before in [0.0, 0.3] {
            rows.extend(three_balls(e, before)?);
        }
    }
    Ok(rows)
}

/// Angle in degrees to the line of centres at which a cue ball leaves that is struck at this angle while it touches
/// another ball.
pub(in crate::report::judge) fn frozen_pair(
    law: &BallBallLaw,
    degrees: f64,
) -> Result<f64, Stopped> {
    let stand = Stand::POOL;
    let mut scene = stand.room(*law);
    scene.place("cue", stand.ball, 0.0, 0.0);
    scene.place("1", stand.ball, 2.0 * stand.ball.radius, 0.0);
    let shot = Shot {
        heading: degrees.to_radians(),
        ..Shot::default()
    };
    scene.shot = Some(PlannedShot { ball: 0, shot });
    let velocity = play(&scene)?.state_at(0, 0.0).velocity;
    Ok(libm::atan2(velocity.z.abs(), velocity.x).to_degrees())
}

/// A cue ball between two balls that touch each other, after a run-up of this length in m.
fn three_balls(e: f64, before: f64) -> Result<Vec<Row>, Stopped> {
    let stand = Stand::POOL;
    let r = stand.ball.radius;
    let mut scene = stand.room(smooth(e));
    scene.laws.motion = crate::physics::laws::motion::MotionLaw::Frictionless;
    scene.place("cue", stand.ball, -(3.0_f64.sqrt()) * r - before, 0.0);
    scene.place("1", stand.ball, 0.0, r);
    scene.place("2", stand.ball, 0.0, -r);
    scene.balls[0].state.velocity = DVec3::X;
    scene.time_limit = before + 0.2;
    let record = play(&scene)?;
    let [cue, one, two] = [0, 1, 2].map(|ball| record.end[ball].velocity);
    let title = format!("J17 one ball into two, e {e}, run-up {before} m");
    let (law, source) = ("Frictionless, cluster", "closed form by symmetry");
    let object = 0.4 * 0.75_f64.sqrt() * (1.0 + e);
    Ok(vec![
        Row::closed(
            &format!("{title}: object ball"),
            law,
            object,
            one.length(),
            "v",
        )
        .by(source),
        Row::closed(
            &format!("{title}: cue ball"),
            law,
            1.0 - 0.6 * (1.0 + e),
            cue.x,
            "v",
        )
        .by(source),
        Row::zero(
            &format!("{title}: left and right differ by"),
            law,
            (one - DVec3::new(two.x, two.y, -two.z)).length(),
            1e-12,
            "v",
        )
        .by(source),
    ])
}
