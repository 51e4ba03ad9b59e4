//! Pockets: the inside of the hole, the rim, a ring of metal around it.

use bevy::math::{DVec2, DVec3};

use crate::physics::table::Pocket;
use crate::window::render::solid::Solid;
use crate::window::render::table::measures::Measures;

/// Sides of a hole.
pub(super) const SIDES: u32 = 72;

/// How far the hole reaches below the slate, m.
const DEEP: f64 = 0.16;

/// Height of the underside of the table, m.
pub(super) const BOTTOM: f64 = -DEEP - 0.01;

/// How far down the lining of a hole can be seen, m.
const LINED: f64 = 0.05;

/// The inside: the `lining` below the edge, and the dark under it, lit by next to nothing.
pub(super) fn inside(lining: &mut Solid, dark: &mut Solid, pocket: &Pocket) {
    let ring = |y: f64| -> Vec<(DVec3, DVec3)> {
        (0..=SIDES)
            .map(|i| {
                let out = direction(i);
                (place(pocket, pocket.radius, out, y), -raise(out))
            })
            .collect()
    };
    lining.band(&ring(-LINED), &ring(0.0));
    dark.band(&ring(-DEEP), &ring(-LINED));
    for i in 0..SIDES {
        let center = raise(pocket.center) - DEEP * DVec3::Y;
        let [a, b] = [i, i + 1].map(|i| place(pocket, pocket.radius, direction(i), -DEEP));
        dark.patch([center, b, a, center], [DVec3::Y; 4]);
    }
}

/// Distance from the hole, height, slope outwards and up.
type Profile = [(f64, f64, (f64, f64))];

/// The rim where the hole cuts into the wood.
pub(super) fn rim(solid: &mut Solid, pocket: &Pocket, measures: &Measures) {
    let (w, top) = (measures.rim, measures.top);
    let profile = [
        (0.0, 0.0, (-1.0, 0.0)),
        (0.0, top - 0.2 * w, (-1.0, 0.0)),
        (0.15 * w, top + 0.18 * w, (-0.7, 0.7)),
        (0.5 * w, top + 0.3 * w, (0.0, 1.0)),
        (0.85 * w, top + 0.18 * w, (0.7, 0.7)),
        (w, top - 0.1 * w, (1.0, 0.2)),
    ];
    sweep(solid, pocket, measures, &profile);
}

/// A flat ring of metal around the rim.
pub(super) fn ring(solid: &mut Solid, pocket: &Pocket, measures: &Measures) {
    let (w, top) = (measures.rim, measures.top);
    let profile = [
        (0.99 * w, top - 0.1 * w, (-1.0, 0.3)),
        (1.00 * w, top + 0.10 * w, (-0.5, 0.8)),
        (1.06 * w, top + 0.14 * w, (0.0, 1.0)),
        (1.45 * w, top + 0.12 * w, (0.2, 1.0)),
        (1.60 * w, top - 0.05 * w, (1.0, 0.3)),
    ];
    sweep(solid, pocket, measures, &profile);
}

/// Sweeps a profile around the part of a hole that lies in the wood.
fn sweep(solid: &mut Solid, pocket: &Pocket, measures: &Measures, profile: &Profile) {
    let is_rim = |i: u32| measures.is_frame(pocket.center + pocket.radius * direction(i % SIDES));
    for i in (0..SIDES).filter(|&i| is_rim(i) && is_rim(i + 1)) {
        for pair in profile.windows(2) {
            let row = |&(off, y, (out, up)): &(f64, f64, (f64, f64))| {
                [i, i + 1].map(|i| {
                    let away = direction(i);
                    let normal = (out * raise(away) + up * DVec3::Y).normalize();
                    (place(pocket, pocket.radius + off, away, y), normal)
                })
            };
            solid.band(&row(&pair[0]), &row(&pair[1]));
        }
        for (at, is_end) in [(i, !is_rim(i + SIDES - 1)), (i + 1, !is_rim(i + 2))] {
            if is_end {
                end(solid, pocket, direction(at), profile);
            }
        }
    }
}

/// The cut face of the rim where the mouth begins, seen from both sides.
fn end(solid: &mut Solid, pocket: &Pocket, away: DVec2, profile: &Profile) {
    for pair in profile[1..].windows(2) {
        let [a, b] = [pair[0], pair[1]].map(|(off, y, _)| (pocket.radius + off, y));
        let corners = [
            place(pocket, a.0, away, 0.0),
            place(pocket, b.0, away, 0.0),
            place(pocket, b.0, away, b.1),
            place(pocket, a.0, away, a.1),
        ];
        solid.face(corners);
        solid.face([corners[3], corners[2], corners[1], corners[0]]);
    }
}

fn direction(i: u32) -> DVec2 {
    DVec2::from_angle(std::f64::consts::TAU * f64::from(i) / f64::from(SIDES))
}

fn place(pocket: &Pocket, radius: f64, out: DVec2, y: f64) -> DVec3 {
    raise(pocket.center + radius * out) + y * DVec3::Y
}

fn raise(plan: DVec2) -> DVec3 {
    DVec3::new(plan.x, 0.0, plan.y)
}
