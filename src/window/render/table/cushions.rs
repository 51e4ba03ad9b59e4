//! Cushions, walls and pegs as solids.

use bevy::math::{DVec2, DVec3};

use crate::physics::table::{Arc, Line};
use crate::window::render::solid::{Solid, lathe};
use crate::window::render::table::measures::Measures;
use crate::window::render::table::noses::NosePoint;

/// How far the cloth of a cushion runs on below the wood, m.
const SEAM: f64 = 0.004;

/// The cloth over one cushion: from the wood over the nose down to the slate.
pub(super) fn cushion(solid: &mut Solid, points: &[NosePoint], measures: &Measures) {
    let middle = points[points.len() / 2];
    let across = (points[points.len() - 1].back - points[0].back)
        .perp()
        .normalize_or_zero();
    let outward = across * (middle.back - middle.at).dot(across).signum();
    let lift = (measures.top - measures.nose).max(0.0);
    // Height above the slate, how far back from the nose, and the slope of the surface: (towards the player, up).
    let profile = [
        (0.0, 0.5 * measures.nose, (0.9, -0.4)),
        (measures.nose - 0.55 * lift, 0.12 * lift, (1.0, -0.2)),
        (measures.nose, 0.0, (1.0, 0.1)),
        (measures.nose + 0.45 * lift, 0.35 * lift, (0.7, 0.7)),
        (measures.nose + 0.6 * lift, lift, (0.15, 1.0)),
    ];
    let mut rows: Vec<Vec<(DVec3, DVec3)>> = profile
        .iter()
        .map(|&(height, back, (out, up))| {
            let place = |point: &NosePoint| {
                let at = point.at - back.min(point.room) * point.normal;
                let normal = raise(out * point.normal, up).normalize();
                (raise(at, height), normal)
            };
            points.iter().map(place).collect()
        })
        .collect();
    // The cloth runs on below the wood a little, so that no light comes through the seam.
    for (under, y) in [(0.0, measures.top), (SEAM, measures.top - 0.3 * SEAM)] {
        let place = |point: &NosePoint| {
            let back = point.back + under * outward;
            (raise(back, y), DVec3::Y)
        };
        rows.push(points.iter().map(place).collect());
    }
    for pair in rows.windows(2) {
        solid.band(&pair[0], &pair[1]);
    }
    for end in [0, points.len() - 1] {
        let back = raise(points[end].back, 0.0);
        for pair in rows.windows(2) {
            // The end is not quite flat, so it is drawn from both sides.
            solid.face([back, pair[0][end].0, pair[1][end].0, back]);
            solid.face([back, pair[1][end].0, pair[0][end].0, back]);
        }
    }
}

/// A wall that balls meet from both sides. Its noses are where the line is: the wall itself is as thin as can be seen.
pub(super) fn wall(solid: &mut Solid, line: &Line, measures: &Measures) {
    let along = (line.to - line.from).normalize_or(DVec2::X);
    let side = WALL * along.perp();
    let corners = [
        line.from - side,
        line.to - side,
        line.to + side,
        line.from + side,
    ];
    for i in 0..4 {
        let (a, b) = (corners[i], corners[(i + 1) % 4]);
        let out = -(b - a).perp().normalize_or(DVec2::X);
        let normal = raise(out, 0.0);
        solid.band(
            &[(raise(a, 0.0), normal), (raise(b, 0.0), normal)],
            &[
                (raise(a, measures.top), normal),
                (raise(b, measures.top), normal),
            ],
        );
    }
    solid.lid(corners, measures.top);
}

/// Half the thickness of a wall in the open, m.
const WALL: f64 = 0.002;

/// A peg.
pub(super) fn peg(solid: &mut Solid, arc: &Arc, measures: &Measures) {
    let (r, top) = (arc.radius, measures.top * 1.4);
    let profile = [(r, 0.0), (r, top - 0.2 * r), (0.8 * r, top), (0.0, top)];
    lathe(solid, raise(arc.center, 0.0), &profile, 48);
}

fn raise(plan: DVec2, y: f64) -> DVec3 {
    DVec3::new(plan.x, y, plan.y)
}
