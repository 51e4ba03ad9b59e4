//! E7 and E12: balls that touch when the cue strikes.

use crate::physics::cue::Shot;
use crate::physics::laws::ball_ball::BallBallLaw;
use crate::physics::scene::PlannedShot;
use crate::report::judge::exact::frozen_pair;
use crate::report::judge::measurements::FROZEN_PAIR;
use crate::report::judge::stand::{Stand, ball_ball_laws};
use crate::report::judge::{Measure, Row};
use crate::sim::play::{Stopped, play};

/// Measured and computed angles of E7 in degrees.
pub(in crate::report::judge) fn frozen_angles(
    law: &BallBallLaw,
) -> Result<Vec<(f64, f64)>, Stopped> {
    FROZEN_PAIR
        .into_iter()
        .map(|(cut_deg, measured)| Ok((measured, frozen_pair(law, cut_deg)?)))
        .collect()
}

pub(super) fn pair() -> Result<Vec<Row>, Stopped> {
    let mut rows = Vec::new();
    for (name, law) in ball_ball_laws() {
        rows.push(
            Row::points(
                "E7 frozen pair: cue ball leaves at",
                &format!("{name}, cluster"),
                &frozen_angles(&law)?,
                "°",
                (Measure::Rms, 3.0),
            )
            .by("Alciatore, TP A.15, high-speed video, ±0.5°; pass line 3°"),
        );
    }
    Ok(rows)
}

pub(super) fn straight() -> Result<Vec<Row>, Stopped> {
    let stand = Stand::POOL;
    let mut rows = Vec::new();
    for (name, law) in ball_ball_laws() {
        let mut scene = stand.room(law);
        scene.place("cue", stand.ball, 0.0, 0.0);
        scene.place("1", stand.ball, 2.0 * stand.ball.radius, 0.0);
        scene.shot = Some(PlannedShot {
            ball: 0,
            shot: Shot::default(),
        });
        let record = play(&scene)?;
        let speed = |ball: usize| record.state_at(ball, 0.0).velocity.x;
        rows.push(
            Row::measured(
                "E12 cue straight into a frozen pair: back speed / front speed",
                &format!("{name}, cluster"),
                1.0,
                speed(0) / speed(1),
                "",
                (Measure::Absolute, 0.026),
            )
            .by("Cross 2016, video of a cradle"),
        );
    }
    Ok(rows)
}
