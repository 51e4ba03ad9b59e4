//! The wood: rails, apron and legs.

use bevy::math::{DVec2, DVec3};

use crate::window::render::plan::area;
use crate::window::render::solid::{Solid, lathe};
use crate::window::render::table::measures::{FLOOR, Measures};

/// Points around the corner of the frame.
const CORNER_STEPS: u32 = 8;

/// The outline of a rectangle with rounded corners, `inset` inside the frame, counter-clockwise in (x, z), with the way
/// out at each point.
fn outline(measures: &Measures, inset: f64) -> Vec<(DVec2, DVec2)> {
    let radius = 0.5 * measures.rail;
    let middle = measures.outer() - radius;
    let mut points = Vec::new();
    for (quarter, sign) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)]
        .into_iter()
        .enumerate()
    {
        for step in 0..=CORNER_STEPS {
            let share = quarter as f64 + f64::from(step) / f64::from(CORNER_STEPS);
            let out = DVec2::from_angle(share * std::f64::consts::FRAC_PI_2);
            let center = middle * DVec2::new(sign.0, sign.1);
            points.push((center + (radius - inset) * out, out));
        }
    }
    points
}

/// The upper side of the rails that run along x (`long`) or along z, without the pockets.
pub(super) fn rails(solid: &mut Solid, measures: &Measures, pockets: &[Vec<DVec2>], long: bool) {
    let edge = outline(measures, BEVEL * measures.rail);
    let inner = measures.inner();
    let count = edge.len();
    let corner = CORNER_STEPS as usize + 1;
    // The outline starts at the foot end; the middle of a corner parts two rails.
    for side in 0..4 {
        if (side % 2 == 0) != long {
            continue;
        }
        let from = side * corner + corner / 2;
        let to = (side + 1) * corner + corner / 2;
        let mut polygon: Vec<DVec2> = (from..=to).map(|i| edge[i % count].0).collect();
        let sign = |p: DVec2| DVec2::new(p.x.signum(), p.y.signum());
        polygon.push(inner * sign(edge[to % count].0));
        polygon.push(inner * sign(edge[from % count].0));
        for part in area(&polygon, pockets) {
            solid.lid(part, measures.top);
        }
    }
}

/// Width of the rounded edge, in rail widths.
const BEVEL: f64 = 0.08;

/// The outer side: a rounded edge, the face of the rail, a step back, the apron.
pub(super) fn skirt(solid: &mut Solid, measures: &Measures) {
    let bevel = BEVEL * measures.rail;
    let s = measures.scale;
    let (low, deep) = (measures.top - 0.055 * s, measures.top - 0.19 * s);
    // Inset, height, slope outwards and up.
    let profile = [
        (bevel, measures.top, (0.0, 1.0)),
        (0.3 * bevel, measures.top - 0.3 * bevel, (0.7, 0.7)),
        (0.0, measures.top - bevel, (1.0, 0.0)),
        (0.0, low, (1.0, 0.0)),
    ];
    let mut rows: Vec<_> = profile
        .iter()
        .map(|&(inset, y, slope)| row(measures, inset, y, slope))
        .collect();
    for pair in rows.windows(2) {
        solid.band(&pair[1], &pair[0]);
    }
    rows.clear();
    let back = 0.03 * s;
    rows.push(row(measures, 0.0, low, (0.0, -1.0)));
    rows.push(row(measures, back, low, (0.0, -1.0)));
    solid.band(&rows[1], &rows[0]);
    let apron = [
        row(measures, back, deep, (1.0, 0.0)),
        row(measures, back, low, (1.0, 0.0)),
    ];
    solid.band(&apron[0], &apron[1]);
}

fn row(measures: &Measures, inset: f64, y: f64, (out, up): (f64, f64)) -> Vec<(DVec3, DVec3)> {
    let mut row: Vec<_> = outline(measures, inset)
        .into_iter()
        .map(|(at, away)| {
            let normal = DVec3::new(out * away.x, up, out * away.y);
            (DVec3::new(at.x, y, at.y), normal)
        })
        .collect();
    row.push(row[0]);
    row
}

/// Four turned legs.
pub(super) fn legs(solid: &mut Solid, measures: &Measures) {
    let s = measures.scale;
    let deep = measures.top - 0.19 * s;
    let place = measures.outer() - 0.17 * s;
    let profile = [
        (0.055, -FLOOR),
        (0.06, 0.03 - FLOOR),
        (0.04, 0.06 - FLOOR),
        (0.05, 0.5 * (deep - FLOOR)),
        (0.085, deep - 0.12),
        (0.095, deep - 0.04),
        (0.095, deep),
        (0.1, deep + 0.05),
    ]
    .map(|(r, y)| (r * s, y));
    for (x, z) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let at = place * DVec2::new(x, z);
        lathe(solid, DVec3::new(at.x, 0.0, at.y), &profile, 24);
    }
}

/// The mother-of-pearl marks on the rails, one in eight of the length and one in four of the width.
pub(super) fn diamonds(solid: &mut Solid, measures: &Measures, pockets: &[Vec<DVec2>]) {
    let reach = measures.depth + 0.5 * measures.rail;
    let mut mark = |at: DVec2, long: DVec2| {
        let near = |p: &DVec2| p.distance(at) < 0.03 * measures.scale;
        if pockets.iter().flatten().any(near) {
            return;
        }
        let (a, b) = (
            0.0135 * measures.scale * long,
            0.008 * measures.scale * long.perp(),
        );
        solid.lid([at - a, at - b, at + a, at + b], measures.top + 3e-4);
    };
    for sign in [-1.0, 1.0] {
        for i in -3..=3 {
            let x = measures.half.x * f64::from(i) / 4.0;
            mark(DVec2::new(x, sign * (measures.half.y + reach)), DVec2::Y);
        }
        for i in -1..=1 {
            let z = measures.half.y * f64::from(i) / 2.0;
            mark(DVec2::new(sign * (measures.half.x + reach), z), DVec2::X);
        }
    }
}
