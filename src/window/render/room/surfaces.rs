//! Walls, ceiling and floor.

use bevy::asset::RenderAssetUsages;
use bevy::light::NotShadowCaster;
use bevy::mesh::{Indices, PrimitiveTopology};
use bevy::prelude::*;

use crate::physics::table::Table;
use crate::sim::playfield::Playfield;
use crate::window::render::paint::{Noise, Paint, paint};
use crate::window::render::quality::RenderQuality;
use crate::window::render::room::bottles;
use crate::window::render::room::walls::{HALF, HIGH, Side, wall};
use crate::window::render::table::FLOOR;
use crate::window::render::twin;

/// A part of the room.
#[derive(Component)]
pub(super) struct Wall;

/// Metres of floor after which its boards repeat.
const BOARDS: f32 = 2.4;

/// Builds the room. Its walls are seen from inside only: an eye outside looks through them.
pub(super) fn build(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut images: ResMut<Assets<Image>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
    quality: Res<RenderQuality>,
) {
    let mut put = |mesh: Mesh, material: StandardMaterial| {
        commands.spawn((
            Wall,
            Mesh3d(meshes.add(mesh)),
            MeshMaterial3d(materials.add(material)),
            NotShadowCaster,
            twin::both(),
        ));
    };
    for side in Side::ALL {
        let half = side.half();
        let size = (512 << quality.finer(), 256 << quality.finer());
        let picture = paint(Paint::Colour, size, 1, |u, v| {
            let (along, up) = (half * (2.0 * u - 1.0), HIGH * (1.0 - v));
            // The bottles stand before the wall.
            let bare = (side == Side::Foot)
                .then(|| bottles::bare(along, up))
                .flatten();
            screen(bare.unwrap_or_else(|| wall(side, along, up)))
        });
        let corner = |along, up| side.point(along, up);
        let corners = [
            corner(-half, 0.0),
            corner(half, 0.0),
            corner(half, HIGH),
            corner(-half, HIGH),
        ];
        put(
            quad(corners, 1.0),
            StandardMaterial {
                base_color_texture: Some(images.add(picture)),
                unlit: true,
                ..default()
            },
        );
    }
    let level = |y: f32, turn: f32| {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, z)| Vec3::new(turn * x * HALF.x, y, z * HALF.y))
    };
    let floor = -FLOOR as f32;
    put(
        quad(level(floor, -1.0), 1.0),
        StandardMaterial {
            base_color_texture: Some(images.add(boards(quality.anisotropy()))),
            uv_transform: bevy::math::Affine2::from_scale(2.0 * HALF / BOARDS),
            perceptual_roughness: 0.55,
            reflectance: 0.25,
            ..default()
        },
    );
    put(
        quad(level(floor + HIGH, 1.0), 1.0),
        StandardMaterial {
            base_color: Color::linear_rgb(0.018, 0.014, 0.011),
            unlit: true,
            ..default()
        },
    );
}

/// By how much the room of this table is larger than that of a nine-foot one.
pub(super) fn growth(table: &Table) -> f32 {
    let reach = 0.5 * table.length.max(table.width) as f32;
    // The ceiling stays above the eye that sees the whole table from overhead.
    (1.2 * reach - 1.4).max(1.0)
}

/// Makes the room as large as a table that would not fit into it asks; the floor stays where it is.
pub(super) fn widen(playfield: Res<Playfield>, mut walls: Query<&mut Transform, With<Wall>>) {
    let scale = growth(&playfield.table);
    for mut wall in &mut walls {
        *wall = Transform::from_xyz(0.0, FLOOR as f32 * (scale - 1.0), 0.0)
            .with_scale(Vec3::splat(scale));
    }
}

/// Boards of dark oak, along x.
fn boards(anisotropy: u16) -> Image {
    const ROWS: u32 = 16;
    let noise = Noise::new(41);
    paint(Paint::Colour, (512, 512), anisotropy, |u, v| {
        let row = (v * ROWS as f32).floor();
        let across = v * ROWS as f32 - row;
        let shift = (row * 0.618).fract();
        let along = ((u + shift) * 3.0).fract();
        // The board that runs on into the next tile is the same there.
        let board = ((u + shift) * 3.0).floor().rem_euclid(3.0);
        let tone = noise.octave(
            ((row + 0.5) / ROWS as f32, ((board + 0.5) / 7.0).fract()),
            (64, 64),
        );
        let grain = noise.sum((u, v), (6, 160), 3);
        let gap = across.min(1.0 - across) < 0.03 || along.min(1.0 - along) < 0.004;
        let light = if gap {
            0.25
        } else {
            1.0 + 0.22 * tone + 0.20 * grain
        };
        screen(Vec3::new(0.075, 0.040, 0.020) * light)
    })
}

/// Linear light as the screen counts it.
fn screen(light: Vec3) -> [f32; 3] {
    let light = light.clamp(Vec3::ZERO, Vec3::ONE);
    light.to_array().map(|x| {
        if x <= 0.003_130_8 {
            12.92 * x
        } else {
            1.055 * libm::powf(x, 1.0 / 2.4) - 0.055
        }
    })
}

/// A rectangle with a picture on it; corners from the lower left, counter-clockwise seen from its front.
fn quad(corners: [Vec3; 4], repeats: f32) -> Mesh {
    let normal = (corners[1] - corners[0])
        .cross(corners[2] - corners[1])
        .normalize_or(Vec3::Y);
    Mesh::new(
        PrimitiveTopology::TriangleList,
        RenderAssetUsages::RENDER_WORLD,
    )
    .with_inserted_attribute(Mesh::ATTRIBUTE_NORMAL, vec![normal.to_array(); 4])
    .with_inserted_attribute(
        Mesh::ATTRIBUTE_POSITION,
        corners.map(|c| c.to_array()).to_vec(),
    )
    .with_inserted_attribute(
        Mesh::ATTRIBUTE_UV_0,
        vec![
            [0.0, repeats],
            [repeats, repeats],
            [repeats, 0.0],
            [0.0, 0.0],
        ],
    )
    .with_inserted_indices(Indices::U32(vec![0, 1, 2, 0, 2, 3]))
}
