//! The lag: who plays nearer to the head cushion, by way of the foot cushion, begins (WPA general rules, 2025).

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::game::rules::facts::{FROZEN, Facts};
use crate::physics::record::Record;
use crate::physics::scene::Scene;
use crate::physics::table::Cushion;

/// Why a lag is bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum BadLag {
    /// The ball crossed the long line through the middle of the table.
    CrossedLongLine,
    /// The ball met the foot cushion this often instead of once.
    FootCushion {
        /// How often.
        times: usize,
    },
    /// The ball met a side cushion.
    SideCushion,
    /// The ball fell or left the table.
    Gone,
    /// The ball rests in a corner, past the nose of the head cushion.
    PastNose,
}

/// What a cushion is to a lag.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Foot,
    Head,
    Long,
}

fn side(scene: &Scene, cushion: usize) -> Side {
    let (least, most) = scene.table.cushions[cushion].bounds();
    let middle = 0.5 * (least + most);
    let half = 0.5 * DVec2::new(scene.table.length, scene.table.width);
    // The nearest side of the table; jaws and facings belong to the side on which they lie.
    let to_end = half.x - middle.x.abs();
    let to_side = half.y - middle.y.abs();
    let along = match &scene.table.cushions[cushion] {
        Cushion::Line(line) => (line.to - line.from).abs(),
        Cushion::Arc(_) => DVec2::ZERO,
    };
    if to_side < to_end || (to_side == to_end && along.x > along.y) {
        Side::Long
    } else if middle.x > 0.0 {
        Side::Foot
    } else {
        Side::Head
    }
}

/// How far in m the ball of a lag comes to rest from the head cushion.
///
/// # Errors
/// [`BadLag`] with the first thing that was wrong.
pub fn lag(scene: &Scene, record: &Record, ball: usize) -> Result<f64, BadLag> {
    let facts = Facts::new(scene, record, ball);
    let end = record.end[ball];
    if !end.motion.in_play() || facts.potted(ball).is_some() {
        return Err(BadLag::Gone);
    }
    let reached = facts.cushions_of(ball);
    let met = |wanted: Side| {
        reached
            .iter()
            .filter(|reached| side(scene, reached.cushion) == wanted)
            .count()
    };
    if met(Side::Long) > 0 {
        return Err(BadLag::SideCushion);
    }
    let times = met(Side::Foot);
    if times != 1 {
        return Err(BadLag::FootCushion { times });
    }
    let from = scene.balls[ball].state.position.z;
    let crossed = record.paths[ball]
        .iter()
        .map(|piece| piece.piece.start.position.z)
        .chain([end.position.z])
        .any(|z| z * from < 0.0);
    if crossed {
        return Err(BadLag::CrossedLongLine);
    }
    let radius = scene.balls[ball].ball.radius;
    let to_nose = end.position.x + 0.5 * scene.table.length;
    if to_nose < scene.table.reach(radius) - FROZEN {
        return Err(BadLag::PastNose);
    }
    let distance = to_nose - radius;
    Ok(distance)
}

/// Which of two lags wins: 0 or 1; `None` if both are bad or equally near, and they lag again.
#[must_use]
pub fn lag_winner(lags: [Result<f64, BadLag>; 2]) -> Option<usize> {
    match lags {
        [Ok(one), Ok(two)] if one < two => Some(0),
        [Ok(one), Ok(two)] if two < one => Some(1),
        [Ok(_), Err(_)] => Some(0),
        [Err(_), Ok(_)] => Some(1),
        _ => None,
    }
}
