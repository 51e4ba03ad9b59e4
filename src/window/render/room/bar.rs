//! The bar behind the foot of the table: shelves of bottles, a counter, stools, with colours that are painted on, so that
//! they cost no light.

use bevy::light::NotShadowCaster;
use bevy::math::DVec3;
use bevy::prelude::*;

use crate::sim::playfield::Playfield;
use crate::window::render::quality::RenderQuality;
use crate::window::render::room::bottles::{
    BOARD, BRASS, Bottle, CELL, LOWEST, SHELVES, STEP, WIDE, WOOD, glow,
};
use crate::window::render::room::surfaces::{Wall, growth};
use crate::window::render::room::walls::{HALF, Side, bump, smooth};
use crate::window::render::solid::Solid;
use crate::window::render::twin;

/// Depth of a shelf; from the wall to the front of the counter; depth and height of the counter, m.
const DEPTH: f32 = 0.24;
const FRONT: f32 = 1.45;
const TOP: (f32, f32) = (0.52, 1.08);
/// Everything that stands before the wall.
#[derive(Component)]
pub(super) struct Counter;

/// A point this far along the wall, above the floor and before the wall, m.
fn point(along: f32, up: f32, before: f32) -> DVec3 {
    (Side::Foot.point(along, up) - before * Vec3::X).as_dvec3()
}

/// The same three numbers of a point.
fn numbers(at: Vec3) -> (f32, f32, f32) {
    let floor = Side::Foot.point(0.0, 0.0);
    (at.z - floor.z, at.y - floor.y, floor.x - at.x)
}

/// A box from one corner to the other (along, up, before), without the side at the wall and the bottom unless asked for.
fn block(solid: &mut Solid, a: [f32; 3], b: [f32; 3], has_bottom: bool) {
    let at = |i: usize, j: usize, k: usize| {
        let pick = |n: usize, axis: usize| if n == 0 { a[axis] } else { b[axis] };
        point(pick(i, 0), pick(j, 1), pick(k, 2))
    };
    // Along is to the right for an eye at the table; the front is the far end of `before`.
    solid.face([at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)]);
    solid.face([at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0)]);
    solid.face([at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1)]);
    solid.face([at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)]);
    if has_bottom {
        solid.face([at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)]);
    }
}

/// What turns about an upright axis, as (radius, height), for this angle around the side that the table sees, rad.
fn turned(
    solid: &mut Solid,
    (along, before): (f32, f32),
    profile: &[(f32, f32)],
    (turn, segments): (f32, u8),
) {
    let ring = |radius: f32, up: f32| -> Vec<(DVec3, DVec3)> {
        (0..=segments)
            .map(|i| {
                let angle = turn * (f32::from(i) / f32::from(segments) - 0.5);
                let (sin, cos) = (libm::sinf(angle), libm::cosf(angle));
                let out = DVec3::new(f64::from(-cos), 0.0, f64::from(sin));
                (point(along + radius * sin, up, before + radius * cos), out)
            })
            .collect()
    };
    for pair in profile.windows(2) {
        solid.band(&ring(pair[0].0, pair[0].1), &ring(pair[1].0, pair[1].1));
    }
}

/// Shelves, bottles, counter and stools; bottles have so many faces around.
fn furnish(segments: u8) -> Solid {
    let mut solid = Solid::new(DVec3::Z, 1.0);
    for number in 0..SHELVES {
        let (row, low) = (f32::from(number), LOWEST + STEP * f32::from(number));
        let from = solid.count();
        block(
            &mut solid,
            [-WIDE, low, 0.0],
            [WIDE, low + BOARD, DEPTH],
            true,
        );
        solid.paint(from, |at| {
            let (along, up, before) = numbers(at);
            let edge = smooth(WIDE + 0.05 - along.abs(), 0.35);
            let light = if before > 0.5 * DEPTH { 0.35 } else { 1.0 };
            let side = if up > low + 0.5 * BOARD { 1.0 } else { 0.45 };
            Vec3::new(0.36, 0.18, 0.06) * ((0.25 + 0.75 * edge) * light * side)
        });
        let cells = (WIDE / CELL).floor();
        let mut cell = -cells;
        while cell < cells {
            if let Some(bottle) = Bottle::of(row, cell) {
                stand(&mut solid, &bottle, low + BOARD, segments);
            }
            cell += 1.0;
        }
    }
    // Posts at both ends and a board above, that hold the light back.
    let from = solid.count();
    for along in [-WIDE - 0.12, WIDE] {
        block(
            &mut solid,
            [along, 0.0, 0.0],
            [along + 0.12, 2.46, DEPTH + 0.03],
            false,
        );
    }
    block(
        &mut solid,
        [-WIDE - 0.16, 2.42, 0.0],
        [WIDE + 0.16, 2.58, DEPTH + 0.08],
        true,
    );
    solid.paint(from, |at| {
        let (along, up, before) = numbers(at);
        let inner = smooth(WIDE + 0.02 - along.abs(), 0.04);
        let deep = 1.0 - 0.6 * (before / DEPTH).min(1.0);
        WOOD * (1.1 + 0.25 * up) + Vec3::new(0.20, 0.09, 0.025) * (inner * deep)
    });
    counter(&mut solid);
    for along in [-1.35, -0.45, 0.45, 1.35] {
        stool(&mut solid, along);
    }
    solid
}

/// Puts a bottle down.
fn stand(solid: &mut Solid, bottle: &Bottle, low: f32, segments: u8) {
    let shares = [
        0.0, 0.135, 0.15, 0.41, 0.425, 0.60, 0.66, 0.74, 0.925, 0.935, 0.995,
    ];
    let profile = shares.map(|share| (bottle.radius(share), low + share * bottle.tall));
    let before = 0.11 + 0.35 * bottle.half;
    let from = solid.count();
    turned(solid, (bottle.along, before), &profile, (4.4, segments));
    solid.paint(from, |at| {
        let (along, up, _) = numbers(at);
        let share = (up - low) / bottle.tall;
        let across = ((along - bottle.along) / bottle.radius(share).max(1e-3)).clamp(-1.0, 1.0);
        let (back, edge) = glow(along, up - low + BOARD);
        bottle.colour(share, across, back, edge)
    });
}

/// The counter: panels of wood, a rail of brass, a lacquered top that mirrors the shelves.
fn counter(solid: &mut Solid) {
    let (wide, behind) = (WIDE + 0.25, FRONT - TOP.0);
    let from = solid.count();
    let mut panels = -2.0;
    while panels < 2.5 {
        let (a, b) = (0.43 * 2.0 * (panels - 0.5), 0.43 * 2.0 * (panels + 0.5));
        let low = [a, 0.0, behind];
        block(solid, low, [b, TOP.1 - 0.05, FRONT - 0.06], false);
        block(
            solid,
            [a + 0.09, 0.16, behind],
            [b - 0.09, TOP.1 - 0.17, FRONT - 0.045],
            false,
        );
        panels += 1.0;
    }
    solid.paint(from, |at| {
        let (_, up, before) = numbers(at);
        let raised = if before > FRONT - 0.05 { 1.5 } else { 0.75 };
        // The lamp over the table reaches its upper part.
        WOOD * (raised * (0.25 + 0.95 * up))
    });
    let from = solid.count();
    block(
        solid,
        [-wide, TOP.1 - 0.05, behind],
        [wide, TOP.1, FRONT],
        true,
    );
    solid.paint(from, |at| {
        let (along, up, before) = numbers(at);
        let near = if before > FRONT - 0.01 { 0.10 } else { 0.9 };
        let high = if up > TOP.1 - 0.01 { 1.0 } else { 0.25 };
        let edge = smooth(WIDE - along.abs(), 0.5);
        WOOD * 1.6 + Vec3::new(0.42, 0.20, 0.06) * (near * high * (0.2 + 0.8 * edge))
    });
    for (up, before, thick) in [
        (TOP.1 - 0.075, FRONT - 0.05, 0.012),
        (0.2, FRONT + 0.10, 0.02),
    ] {
        let from = solid.count();
        let ring = |along: f32| -> Vec<(DVec3, DVec3)> {
            (0..=6_u8)
                .map(|i| {
                    let angle = std::f32::consts::PI * (f32::from(i) / 6.0 - 0.5);
                    let (sin, cos) = (libm::sinf(angle), libm::cosf(angle));
                    let out = DVec3::new(f64::from(-cos), f64::from(sin), 0.0);
                    (point(along, up + thick * sin, before + thick * cos), out)
                })
                .collect()
        };
        solid.band(&ring(-wide), &ring(wide));
        solid.paint(from, |at| {
            let (_, y, _) = numbers(at);
            let high = (y - up) / thick;
            BRASS * (0.06 + 0.5 * bump(high, 0.55, 0.3))
        });
    }
}

/// A stool: a seat of leather with a band of brass, on one foot.
fn stool(solid: &mut Solid, along: f32) {
    let before = FRONT + 0.42;
    let from = solid.count();
    let seat = [
        (0.165, 0.70),
        (0.18, 0.73),
        (0.18, 0.76),
        (0.15, 0.79),
        (0.0, 0.80),
    ];
    turned(solid, (along, before), &seat, (std::f32::consts::TAU, 20));
    let foot = [
        (0.20, 0.0),
        (0.20, 0.015),
        (0.05, 0.04),
        (0.028, 0.08),
        (0.028, 0.70),
    ];
    turned(solid, (along, before), &foot, (std::f32::consts::TAU, 12));
    solid.paint(from, |at| {
        let (x, up, _) = numbers(at);
        let off = (x - along) / 0.19;
        let round = 1.0 - off * off;
        if up < 0.695 {
            return BRASS * (0.03 + 0.16 * up * bump((x - along) / 0.028, -0.4, 0.4));
        }
        if up < 0.735 {
            return BRASS * (0.10 + 0.25 * round);
        }
        Vec3::new(0.10, 0.014, 0.010) * ((0.35 + 0.65 * round) * if up > 0.78 { 1.5 } else { 0.8 })
    });
}

/// Builds it. As with the walls, an eye outside looks through.
pub(super) fn build(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
    quality: Res<RenderQuality>,
) {
    let segments = if quality.traces() { 10 } else { 6 };
    commands.spawn((
        Wall,
        Counter,
        Mesh3d(meshes.add(furnish(segments).mesh())),
        MeshMaterial3d(materials.add(StandardMaterial {
            unlit: true,
            ..default()
        })),
        NotShadowCaster,
        twin::both(),
    ));
}

/// It does not stand between an eye behind it, or above it, and the table.
pub(super) fn step_aside(
    playfield: Res<Playfield>,
    cameras: Query<(&Transform, &Camera), With<Camera3d>>,
    mut counters: Query<&mut Visibility, With<Counter>>,
) {
    let front = (HALF.x - FRONT - 0.7) * growth(&playfield.table);
    let mut eyes = cameras.iter().filter(|(_, camera)| camera.is_active);
    let wanted = if eyes.any(|(place, _)| place.translation.x > front) {
        Visibility::Hidden
    } else {
        Visibility::Inherited
    };
    for mut visibility in &mut counters {
        visibility.set_if_neq(wanted);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_stays_between_the_wall_and_the_way_around_the_table() {
        let solid = furnish(6);
        for at in solid.points() {
            let (along, up, before) = numbers(Vec3::from_array(at));
            assert!(along.abs() < HALF.y && up > -1e-3, "{along} {up}");
            assert!((-1e-3..2.1).contains(&before), "{before}");
        }
    }
}
