//! Pockets: the cloth over the edge of the slate, the leather around the hole, and what hangs below it: a net, or a boot.

use std::f64::consts::{FRAC_PI_2, TAU};

use bevy::math::{DVec2, DVec3};
use bevy::prelude::Color;

use crate::game::settings::TableStyle;
use crate::physics::laws::pocket::Rim;
use crate::physics::table::Pocket;
use crate::window::render::solid::Solid;
use crate::window::render::table::measures::Measures;

/// Sides of a hole.
pub(super) const SIDES: u32 = 72;

/// How far the hole reaches below the slate, m.
const DEEP: f64 = 0.16;

/// Height of the underside of the table, m.
pub(super) const BOTTOM: f64 = -DEEP - 0.01;

/// How far down the cloth is drawn over the edge of the slate, m.
const TUCKED: f64 = 0.016;

/// Thickness of the slate, m.
const SLATE: f64 = 0.025;

const STONE: Color = Color::srgb(0.30, 0.31, 0.32);
const PIT: Color = Color::srgb(0.03, 0.027, 0.025);

/// The colours of a kind of pocket: leather, the cords or ribs in it, the thread it is sewn with.
struct Hide {
    leather: Color,
    cord: Color,
    thread: Color,
}

impl Hide {
    fn of(style: TableStyle) -> Self {
        match style {
            TableStyle::Classic => Self {
                leather: Color::srgb(0.30, 0.155, 0.085),
                cord: Color::srgb(0.62, 0.45, 0.27),
                thread: Color::srgb(0.66, 0.53, 0.34),
            },
            TableStyle::Modern => Self {
                leather: Color::srgb(0.065, 0.065, 0.068),
                cord: Color::srgb(0.13, 0.13, 0.135),
                thread: Color::srgb(0.36, 0.36, 0.37),
            },
            TableStyle::BarBox => Self {
                leather: Color::srgb(0.045, 0.045, 0.048),
                cord: Color::srgb(0.105, 0.105, 0.11),
                thread: Color::srgb(0.045, 0.045, 0.048),
            },
        }
    }
}

/// Distance from the hole, height, slope outwards and up.
type Profile = [(f64, f64, (f64, f64))];

/// The cloth that is drawn over the rounded edge of the slate and down into the hole.
pub(super) fn lip(cloth: &mut Solid, pocket: &Pocket, measures: &Measures) {
    let edge = Rim::default().edge;
    let round = |turn: f64| {
        let (sin, cos) = libm::sincos(turn * FRAC_PI_2);
        (-edge * sin, edge * (cos - 1.0), (-sin, cos))
    };
    let profile = [
        round(0.0),
        round(0.33),
        round(0.67),
        round(1.0),
        (-edge, -TUCKED, (-1.0, 0.0)),
    ];
    sweep(cloth, pocket, &profile, |i| !is_wood(pocket, measures, i));
}

/// Everything of leather: the collar on the wood with its seam, the lining, what hangs below.
pub(super) fn leather(solid: &mut Solid, pocket: &Pocket, measures: &Measures, style: TableStyle) {
    let hide = Hide::of(style);
    let in_wood = |i: u32| is_wood(pocket, measures, i);
    let first = solid.count();
    let edge = Rim::default().edge;
    solid.dye(STONE, 1.0);
    let slate = [(-edge, -SLATE, (-1.0, 0.0)), (-edge, -TUCKED, (-1.0, 0.0))];
    sweep(solid, pocket, &slate, |i| !in_wood(i));

    collar(solid, pocket, measures, &hide);
    // Below the slate the lining goes all around.
    solid.dye(hide.leather, 0.9);
    sweep(solid, pocket, &[(0.0, -LINED, IN), (0.0, 0.0, IN)], |_| {
        true
    });
    if style == TableStyle::Classic {
        net(solid, pocket, &hide);
    } else {
        boot(solid, pocket, measures, &hide);
    }
    // Less light comes down the deeper it is.
    let top = measures.top as f32;
    solid.shade(first, |[_, y, _]| {
        let down = ((top - y) / (top + DEEP as f32)).clamp(0.0, 1.0);
        (1.0 - down) * (1.0 - down) * (1.0 - 0.4 * down)
    });
}

/// Inwards.
const IN: (f64, f64) = (-1.0, 0.0);

/// How far down the lining reaches, m.
const LINED: f64 = 0.035;

/// The leather where the hole cuts into the wood: its inside, a bead at the edge, a groove with a seam, a flat brim.
fn collar(solid: &mut Solid, pocket: &Pocket, measures: &Measures, hide: &Hide) {
    let (w, top) = (measures.rim, measures.top);
    let in_wood = |i: u32| is_wood(pocket, measures, i);
    solid.dye(hide.leather, 1.0);
    let profile = [
        (0.0, 0.0, IN),
        (0.0, top - 0.22 * w, IN),
        (0.06 * w, top + 0.08 * w, (-0.8, 0.6)),
        (0.22 * w, top + 0.26 * w, (-0.25, 1.0)),
        (0.38 * w, top + 0.20 * w, (0.6, 0.8)),
        (0.48 * w, top + 0.12 * w, (0.0, 1.0)),
        (0.66 * w, top + 0.12 * w, (-0.1, 1.0)),
        (0.88 * w, top + 0.10 * w, (0.4, 0.9)),
        (w, top - 0.1 * w, (1.0, 0.2)),
    ];
    sweep(solid, pocket, &profile, in_wood);
    for i in (0..SIDES).filter(|&i| in_wood(i) && in_wood(i + 1)) {
        for (at, is_end) in [(i, !in_wood(i + SIDES - 1)), (i + 1, !in_wood(i + 2))] {
            if is_end {
                end(solid, pocket, direction(at), &profile);
            }
        }
    }
    // Two seams: one on the brim, one inside below the bead.
    solid.dye(hide.thread, 1.0);
    let lift = 4e-4;
    for i in (0..SIDES).filter(|&i| in_wood(i) && in_wood(i + 1)) {
        for share in [0.08, 0.58] {
            let way = |along: f64| {
                let angle = TAU * (f64::from(i) + along) / f64::from(SIDES);
                DVec2::from_angle(angle)
            };
            let (a, b) = (way(share), way(share + 0.34));
            let on_brim = |out: DVec2, off: f64| {
                place(pocket, pocket.radius + off * w, out, top + 0.12 * w + lift)
            };
            stitch(
                solid,
                [on_brim(a, 0.52), on_brim(b, 0.52)],
                DVec3::Y,
                raise(a),
                w,
            );
            let inside = |out: DVec2| place(pocket, pocket.radius - lift, out, top - 0.55 * w);
            stitch(solid, [inside(a), inside(b)], -raise(a), DVec3::Y, w);
        }
    }
}

/// One stitch of the seam between two points of a surface with this normal; `across` is the way across the seam.
fn stitch(solid: &mut Solid, [a, b]: [DVec3; 2], normal: DVec3, across: DVec3, rim: f64) {
    let half = 0.045 * rim * across;
    let row = |at: DVec3| [(at - half, normal), (at + half, normal)];
    solid.band(&row(a), &row(b));
}

/// Cords of a net that lean either way, and the straight pieces of each.
const CORDS: u32 = 14;
const STEPS: u32 = 7;

/// A net of cords that narrows to the bottom, before the dark.
fn net(solid: &mut Solid, pocket: &Pocket, hide: &Hide) {
    let bag = |deep: f64| pocket.radius * (1.0 - 0.3 * deep * deep);
    let height = |deep: f64| -LINED - deep * (DEEP - LINED);
    solid.dye(PIT, 1.0);
    let rows: Vec<_> = (0..=4)
        .map(|i| f64::from(4 - i) / 4.0)
        .map(|deep| (bag(deep) - pocket.radius + 0.002, height(deep), (-1.0, 0.4)))
        .collect();
    sweep(solid, pocket, &rows, |_| true);
    floor(solid, pocket, bag(1.0) + 0.002);
    solid.dye(hide.cord, 0.9);
    for cord in 0..CORDS {
        for lean in [-1.0, 1.0] {
            let at = |step: u32, side: f64| {
                let deep = f64::from(step) / f64::from(STEPS);
                // A cord is as thick as 4 mm on the edge of the hole.
                let turn = f64::from(cord) / f64::from(CORDS) + lean * 0.16 * deep;
                let out = DVec2::from_angle(TAU * turn + side * 0.002 / pocket.radius);
                let off = bag(deep) - if lean < 0.0 { 0.001 } else { 0.0 };
                (
                    place(pocket, off, out, height(deep)),
                    -raise(out) + 0.3 * DVec3::Y,
                )
            };
            for step in 0..STEPS {
                let row = |step| [at(step, -1.0), at(step, 1.0)];
                solid.band(&row(step + 1), &row(step));
            }
        }
    }
}

/// A boot of rubber with upright ribs where balls strike it.
fn boot(solid: &mut Solid, pocket: &Pocket, measures: &Measures, hide: &Hide) {
    solid.dye(PIT, 1.0);
    let narrow = -0.25 * pocket.radius;
    sweep(
        solid,
        pocket,
        &[(narrow, -DEEP, IN), (0.0, -LINED, (-1.0, 0.3))],
        |_| true,
    );
    floor(solid, pocket, pocket.radius + narrow);
    solid.dye(hide.cord, 2.6);
    let (low, high) = (-LINED, measures.top - 0.9 * measures.rim);
    for i in (0..SIDES).step_by(2) {
        if !(is_wood(pocket, measures, i) && is_wood(pocket, measures, i + 1)) {
            continue;
        }
        // A rib stands out by less than can be seen from the side: the wall is where balls meet it.
        let wall = |side: f64, y: f64| {
            let angle = TAU * (f64::from(i) + 0.5 + 0.28 * side) / f64::from(SIDES);
            let out = DVec2::from_angle(angle);
            let turned = DVec2::from_angle(angle - 0.9 * side);
            (place(pocket, pocket.radius - 3e-4, out, y), -raise(turned))
        };
        let row = |y: f64| [-1.0, 0.0, 1.0].map(|side| wall(side, y));
        solid.band(&row(low), &row(high));
    }
}

/// The bottom of a pocket.
fn floor(solid: &mut Solid, pocket: &Pocket, radius: f64) {
    for i in 0..SIDES {
        let center = raise(pocket.center) - DEEP * DVec3::Y;
        let [a, b] = [i, i + 1].map(|i| place(pocket, radius, direction(i), -DEEP));
        solid.patch([center, b, a, center], [DVec3::Y; 4]);
    }
}

/// A flat ring of metal around the leather.
pub(super) fn ring(solid: &mut Solid, pocket: &Pocket, measures: &Measures) {
    let (w, top) = (measures.rim, measures.top);
    let profile = [
        (0.99 * w, top - 0.1 * w, (-1.0, 0.3)),
        (1.00 * w, top + 0.10 * w, (-0.5, 0.8)),
        (1.06 * w, top + 0.14 * w, (0.0, 1.0)),
        (1.45 * w, top + 0.12 * w, (0.2, 1.0)),
        (1.60 * w, top - 0.05 * w, (1.0, 0.3)),
    ];
    sweep(solid, pocket, &profile, |i| is_wood(pocket, measures, i));
}

/// Whether a side of the hole begins in the wood.
fn is_wood(pocket: &Pocket, measures: &Measures, i: u32) -> bool {
    measures.is_frame(pocket.center + pocket.radius * direction(i % SIDES))
}

/// Sweeps a profile around the part of a hole whose sides begin and end where `there` says.
fn sweep(solid: &mut Solid, pocket: &Pocket, profile: &Profile, there: impl Fn(u32) -> bool) {
    for i in (0..SIDES).filter(|&i| there(i) && there(i + 1)) {
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
    }
}

/// The cut face of the collar where the mouth begins, seen from both sides.
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
    DVec2::from_angle(TAU * f64::from(i) / f64::from(SIDES))
}

fn place(pocket: &Pocket, radius: f64, out: DVec2, y: f64) -> DVec3 {
    raise(pocket.center + radius * out) + y * DVec3::Y
}

fn raise(plan: DVec2) -> DVec3 {
    DVec3::new(plan.x, 0.0, plan.y)
}
