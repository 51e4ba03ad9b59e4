//! H4: Newton's cradle.

use glam::DVec3;

use crate::report::judge::hard::{By, Claim, Rows, put, smooth, worst};
use crate::report::judge::stand::{Stand, room};
use crate::sim::play::Stopped;

/// Speeds of five balls in a row that a sixth of their kind, the first of them, hits at 1 m/s with e = 0.95: ten pair hits.
const LOSSY: [f64; 5] = [0.02326, 0.02380, 0.02435, 0.02491, 0.90369];

/// Speeds of five balls that touch, the first `moving` of which come at 1 m/s from this distance; and the energy won.
fn cradle(by: By, e: f64, moving: usize, gap: f64) -> Result<(Vec<f64>, f64), Stopped> {
    let r = Stand::POOL.ball.radius;
    let mut scene = room(smooth(e, 1.0));
    for i in 0..5 {
        let comes = i < moving;
        let x = 2.0 * r * i as f64 - if comes { gap } else { 0.0 };
        let velocity = if comes { DVec3::X } else { DVec3::ZERO };
        put(&mut scene, &i.to_string(), x, 0.0, velocity, DVec3::ZERO);
    }
    scene.time_limit = 0.5;
    let (record, seen) = by.audit(&scene)?;
    let speeds = record.end.iter().map(|state| state.velocity.x).collect();
    Ok((speeds, seen.energy))
}

pub(super) fn rows() -> Rows {
    let mut rows = Vec::new();
    let cases: [(f64, usize, [f64; 5], f64); 3] = [
        (1.0, 1, [0.0, 0.0, 0.0, 0.0, 1.0], 1e-12),
        (1.0, 2, [0.0, 0.0, 0.0, 1.0, 1.0], 1e-12),
        (0.95, 1, LOSSY, 6e-6),
    ];
    for by in By::BOTH {
        for gap in [0.0, 0.1] {
            for (e, moving, must, tolerance) in cases {
                let (speeds, energy) = cradle(by, e, moving, gap)?;
                let errors = speeds.iter().zip(must).map(|(is, must)| (is - must).abs());
                let error = worst(errors.chain([energy]));
                let told: Vec<String> = speeds.iter().map(|v| format!("{v:.4}")).collect();
                let wanted: Vec<String> = must.iter().map(|v| format!("{v}")).collect();
                let claim = Claim::new(
                    "H4",
                    format!("cradle of 5, e {e}, {moving} at 1 m/s from {gap} m"),
                    by.name(),
                    wanted.join(" "),
                );
                rows.push(claim.error(error, tolerance, told.join(" ")));
            }
        }
    }
    Ok(rows)
}
