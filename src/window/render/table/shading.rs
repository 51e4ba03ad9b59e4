//! The dark line below the noses, where the cushion keeps the light of the room from the cloth.

use bevy::asset::RenderAssetUsages;
use bevy::mesh::{Indices, PrimitiveTopology};
use bevy::prelude::*;

use crate::physics::table::Table;
use crate::window::render::table::measures::Measures;
use crate::window::render::table::noses::Noses;

/// Distance from the nose line towards the middle in nose heights, and how dark the cloth is there.
const PROFILE: [(f64, f32); 6] = [
    (-0.5, 0.85),
    (0.0, 0.6),
    (0.3, 0.34),
    (0.7, 0.16),
    (1.2, 0.06),
    (2.0, 0.0),
];

/// Bands of shade along every cushion.
pub(super) fn below_noses(table: &Table) -> Mesh {
    let measures = Measures::of(table);
    let (mut points, mut colours, mut indices) = (Vec::new(), Vec::new(), Vec::<u32>::new());
    for nose in Noses::of(table, &measures).rails {
        let first = points.len() as u32;
        for point in &nose {
            for (away, dark) in PROFILE {
                let at = point.at + (away * measures.nose).max(-point.room) * point.normal;
                points.push([at.x as f32, 3e-4, at.y as f32]);
                colours.push([1.0, 1.0, 1.0, dark]);
            }
        }
        let row = PROFILE.len() as u32;
        for i in 1..nose.len() as u32 {
            for j in 1..row {
                let c = first + i * row + j;
                indices.extend([c, c - 1, c - row - 1, c, c - row - 1, c - row]);
            }
        }
    }
    Mesh::new(
        PrimitiveTopology::TriangleList,
        RenderAssetUsages::RENDER_WORLD,
    )
    .with_inserted_attribute(Mesh::ATTRIBUTE_NORMAL, vec![[0.0, 1.0, 0.0]; points.len()])
    .with_inserted_attribute(Mesh::ATTRIBUTE_POSITION, points)
    .with_inserted_attribute(Mesh::ATTRIBUTE_COLOR, colours)
    .with_inserted_indices(Indices::U32(indices))
}
