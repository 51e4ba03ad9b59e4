//! The points through which a path is drawn.

use glam::DVec3;

use crate::physics::ball::State;
use crate::physics::record::Record;

/// Seconds between the points of a bent piece.
const SAMPLE: f64 = 1.0 / 240.0;

/// Most points of one bent piece; a slide of a second takes 240.
const MOST_SAMPLES: f64 = 1e5;

/// For each ball the states at both ends of every piece of its path, and between them where the piece is bent.
pub(super) fn of(record: &Record) -> Vec<Vec<State>> {
    record
        .paths
        .iter()
        .map(|path| {
            let mut trail = Vec::new();
            for (i, turn) in path.iter().enumerate() {
                let piece = &turn.piece;
                trail.push(piece.start);
                if !piece.start.motion.translates() {
                    continue;
                }
                let until = path.get(i + 1).map_or(record.end_time, |next| next.time);
                let time = (until - turn.time).clamp(0.0, piece.duration);
                if piece.acceleration.cross(piece.start.velocity) != DVec3::ZERO {
                    let samples = (time / SAMPLE).min(MOST_SAMPLES) as u32;
                    trail.extend((1..=samples).map(|sample| piece.at(f64::from(sample) * SAMPLE)));
                }
                trail.push(piece.at(time));
            }
            trail
        })
        .collect()
}
