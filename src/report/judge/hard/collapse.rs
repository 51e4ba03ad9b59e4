//! H1: rows that collapse. Inelastic balls in a row against a wall would meet infinitely often in finite time: N balls
//! do so below e = tan²[(π/4)(1 − 1/N)] (after `McNamara` and Young 1992), 5 of them at 0.5.

use glam::DVec3;

use crate::physics::laws::Laws;
use crate::physics::record::EndReason;
use crate::physics::scene::Scene;
use crate::report::judge::hard::{By, Claim, Rows, smooth, worst};
use crate::report::judge::stand::{Stand, room};

/// Most events of a row of up to 16 balls.
const EVENTS: usize = 20_000;

/// A row that moves at 1 m/s into a wall, 3 mm apart.
fn row(laws: Laws, count: u32) -> Scene {
    let ball = Stand::POOL.ball;
    let mut scene = room(laws);
    let reach = scene.table.reach(ball.radius);
    for i in 0..count {
        let x = 100.0 - reach - 0.01 - f64::from(i) * (2.0 * ball.radius + 0.003);
        let index = scene.place(&i.to_string(), ball, x, 0.0);
        scene.balls[index].state.velocity = DVec3::X;
    }
    scene.time_limit = 30.0;
    scene
}

pub(super) fn rows() -> Rows {
    let mut rows = Vec::new();
    for by in By::BOTH {
        for e in [0.05, 0.5, 0.95] {
            let (mut events, mut rise, mut overlap) = (0, Vec::new(), Vec::new());
            for count in [3, 8, 16] {
                let scene = row(smooth(e, e), count);
                let (record, seen) = by.audit(&scene)?;
                events = events.max(record.events.len());
                rise.push(seen.energy);
                overlap.push(seen.overlap.max(seen.cushion));
            }
            let (rise, overlap) = (worst(rise), worst(overlap));
            let must = format!("at most {EVENTS} events, no energy won");
            rows.push(
                Claim::new(
                    "H1",
                    format!("3, 8, 16 balls into a wall, e {e}"),
                    by.name(),
                    must,
                )
                .fact(
                    events < EVENTS && rise <= 1e-14 && overlap <= 1e-9,
                    format!("{events} events, energy +{rise:.0e}, overlap {overlap:.0e} m"),
                ),
            );
            let laws = Laws {
                ball_ball: smooth(e, e).ball_ball,
                cushion: smooth(e, e).cushion,
                ..Laws::default()
            };
            let scene = row(laws, 10);
            let (record, seen) = by.audit(&scene)?;
            let rested = record.reason == Some(EndReason::Rest);
            rows.push(
                Claim::new(
                    "H1",
                    format!("10 balls into a wall on cloth, e {e}"),
                    by.name(),
                    format!("all rest, at most {EVENTS} events"),
                )
                .fact(
                    rested
                        && record.events.len() < EVENTS
                        && seen.energy <= 1e-6
                        && seen.overlap.max(seen.cushion) <= 1e-9,
                    format!(
                        "{} after {:.2} s, {} events, energy +{:.0e}",
                        if rested { "rest" } else { "no rest" },
                        record.end_time,
                        record.events.len(),
                        seen.energy,
                    ),
                ),
            );
        }
    }
    Ok(rows)
}
