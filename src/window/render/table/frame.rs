//! The frame: rails, apron, legs, plates on the corners.

use bevy::math::{DVec2, DVec3};

use crate::game::settings::TableStyle;
use crate::window::render::plan::{area, circle};
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
    let (low, deep) = (measures.top - 0.055 * s, measures.apron);
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
    let back = STEP * s;
    rows.push(row(measures, 0.0, low, (0.0, -1.0)));
    rows.push(row(measures, back, low, (0.0, -1.0)));
    solid.band(&rows[1], &rows[0]);
    let apron = [
        row(measures, back, deep, (1.0, 0.0)),
        row(measures, back, low, (1.0, 0.0)),
    ];
    solid.band(&apron[0], &apron[1]);
}

/// How far the apron stands back behind the rails, m.
pub(super) const STEP: f64 = 0.03;

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

/// What a table stands on.
pub(super) fn legs(solid: &mut Solid, measures: &Measures, style: TableStyle) {
    match style {
        TableStyle::Classic => turned_legs(solid, measures),
        TableStyle::Modern => straight_legs(solid, measures, 0.085, 0.02),
        TableStyle::BarBox => {
            // A cabinet on four stout feet.
            let (low, high) = (measures.apron - 0.20, measures.apron + 0.001);
            let inset = STEP * measures.scale + 0.012;
            let rows = [low, high].map(|y| row(measures, inset, y, (1.0, 0.0)));
            solid.band(&rows[0], &rows[1]);
            straight_legs(solid, measures, 0.075, 0.0);
        }
    }
}

/// How thick legs are beside those of a nine-foot table: they are as long under a small one, and must not look like stilts.
fn stout(measures: &Measures) -> f64 {
    libm::pow(measures.scale, 0.6)
}

/// Four turned legs.
fn turned_legs(solid: &mut Solid, measures: &Measures) {
    let s = stout(measures);
    let deep = measures.apron;
    let place = measures.outer() - 0.07 * measures.scale - 0.1 * s;
    let profile = [
        (0.055, -FLOOR),
        (0.06, 0.03 - FLOOR),
        (0.04, 0.06 - FLOOR),
        (0.05, 0.5 * (deep - FLOOR)),
        (0.085, deep - 0.12),
        (0.095, deep - 0.04),
        (0.095, deep),
        (0.1, deep + 0.01),
    ]
    .map(|(r, y)| (r * s, y));
    for (x, z) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let at = place * DVec2::new(x, z);
        lathe(solid, DVec3::new(at.x, 0.0, at.y), &profile, 24);
    }
}

/// Four square legs, this many metres thick on each side of their middle, leaning outwards by this share.
fn straight_legs(solid: &mut Solid, measures: &Measures, half: f64, taper: f64) {
    let s = stout(measures);
    let (low, high) = (-FLOOR, measures.apron + 0.01);
    let place = measures.outer() - 0.06 * measures.scale - half * s;
    for (x, z) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let at = place * DVec2::new(x, z);
        let ring = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)];
        for i in 0..4 {
            let corner = |(u, v): (f64, f64), y: f64, half: f64| {
                DVec3::new(at.x + u * half * s, y, at.y + v * half * s)
            };
            let (a, b) = (ring[i], ring[(i + 1) % 4]);
            solid.face([
                corner(a, low, half - taper),
                corner(b, low, half - taper),
                corner(b, high, half),
                corner(a, high, half),
            ]);
        }
    }
}

/// Plates of metal over the corners, around the holes there.
pub(super) fn corners(solid: &mut Solid, measures: &Measures, pockets: &[Vec<DVec2>]) {
    const LIFT: f64 = 8e-4;
    let edge = outline(measures, BEVEL * measures.rail);
    let steps = CORNER_STEPS as usize + 1;
    let (inner, outer) = (measures.inner(), measures.outer());
    let reach = 1.7 * measures.rail;
    for quarter in 0..4 {
        let round = &edge[quarter * steps..(quarter + 1) * steps];
        let (first, last) = (round[0].0, round[steps - 1].0);
        let sign = DVec2::new(round[steps / 2].0.x.signum(), round[steps / 2].0.y.signum());
        // Back along the rail from each end of the rounded corner.
        let back = |point: DVec2, out: DVec2| {
            if out.x.abs() > 0.5 {
                (
                    DVec2::new(point.x, sign.y * (outer.y - reach)),
                    DVec2::new(sign.x * inner.x, sign.y * (outer.y - reach)),
                )
            } else {
                (
                    DVec2::new(sign.x * (outer.x - reach), point.y),
                    DVec2::new(sign.x * (outer.x - reach), sign.y * inner.y),
                )
            }
        };
        let (start, start_inside) = back(first, round[0].1);
        let (end, end_inside) = back(last, round[steps - 1].1);
        let mut polygon = vec![start];
        polygon.extend(round.iter().map(|(at, _)| *at));
        polygon.extend([end, end_inside, inner * sign, start_inside]);
        for part in area(&polygon, pockets) {
            solid.lid(part, measures.top + LIFT);
        }
        // Over the rounded edge and down the side.
        let low = measures.top - 0.055 * measures.scale;
        let bevel = BEVEL * measures.rail;
        let profile = [
            (bevel, measures.top + LIFT, (0.0, 1.0)),
            (
                0.3 * bevel - LIFT,
                measures.top - 0.3 * bevel + LIFT,
                (0.7, 0.7),
            ),
            (-LIFT, measures.top - bevel, (1.0, 0.0)),
            (-LIFT, low, (1.0, 0.0)),
        ];
        let rows = profile.map(|(inset, y, (out, up))| {
            let lift = |at: DVec2, away: DVec2| {
                let at = at + (bevel - inset) * away;
                let normal = DVec3::new(out * away.x, up, out * away.y);
                (DVec3::new(at.x, y, at.y), normal)
            };
            let mut row = vec![lift(start, round[0].1)];
            row.extend(round.iter().map(|&(at, away)| lift(at, away)));
            row.push(lift(end, round[steps - 1].1));
            row
        });
        for pair in rows.windows(2) {
            solid.band(&pair[1], &pair[0]);
        }
    }
}

/// A strip of metal along the rails, below their rounded edge.
pub(super) fn strip(solid: &mut Solid, measures: &Measures) {
    let s = measures.scale;
    let rows = [
        (-6e-4, measures.top - 0.050 * s, (1.0, 0.0)),
        (-6e-4, measures.top - 0.036 * s, (1.0, 0.0)),
        (0.001, measures.top - 0.0355 * s, (0.0, 1.0)),
    ]
    .map(|(inset, y, slope)| row(measures, inset, y, slope));
    for pair in rows.windows(2) {
        solid.band(&pair[0], &pair[1]);
    }
}

/// The marks inlaid in the rails, one in eight of the length and one in four of the width: diamonds, or dots.
pub(super) fn diamonds(
    solid: &mut Solid,
    measures: &Measures,
    pockets: &[Vec<DVec2>],
    style: TableStyle,
) {
    let reach = measures.depth + 0.5 * measures.rail;
    let mut mark = |at: DVec2, long: DVec2| {
        let near = |p: &DVec2| p.distance(at) < 0.03 * measures.scale;
        if pockets.iter().flatten().any(near) {
            return;
        }
        if style == TableStyle::Modern {
            for part in area(&circle(at, 0.0065 * measures.scale, 24), &[]) {
                solid.lid(part, measures.top + 3e-4);
            }
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
