//! Meshes, built face by face.

use bevy::asset::RenderAssetUsages;
use bevy::math::{DVec2, DVec3};
use bevy::mesh::{Indices, PrimitiveTopology};
use bevy::prelude::*;

/// A mesh in the making. Texture coordinates are metres over `tile`, measured along the surface, with u as near to the
/// grain as the surface allows, so that a pattern has one scale everywhere.
pub(super) struct Solid {
    grain: DVec3,
    tile: f64,
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    tangents: Vec<[f32; 4]>,
    indices: Vec<u32>,
    /// The colour of each point, and that of the next one. Every solid has them, so that one shader draws all.
    colours: Vec<[f32; 4]>,
    dye: [f32; 4],
}

impl Solid {
    pub fn new(grain: DVec3, tile: f64) -> Self {
        Self {
            grain,
            tile,
            positions: Vec::new(),
            normals: Vec::new(),
            uvs: Vec::new(),
            tangents: Vec::new(),
            indices: Vec::new(),
            colours: Vec::new(),
            dye: [1.0; 4],
        }
    }

    /// Gives all faces from now on a colour, this much lighter than it is; its material is multiplied by it.
    pub fn dye(&mut self, colour: Color, light: f64) {
        let LinearRgba {
            red, green, blue, ..
        } = colour.to_linear();
        let light = light as f32;
        self.dye = [red * light, green * light, blue * light, 1.0];
    }

    /// How many points there are so far.
    pub fn count(&self) -> usize {
        self.positions.len()
    }

    /// Lets only a share of the light come to the points from this one on, depending on where they are.
    pub fn shade(&mut self, from: usize, light: impl Fn([f32; 3]) -> f32) {
        for (colour, at) in self.colours.iter_mut().zip(&self.positions).skip(from) {
            let light = light(*at);
            for channel in &mut colour[..3] {
                *channel *= light;
            }
        }
    }

    /// Gives the points from this one on the linear colour that belongs to their places.
    pub fn paint(&mut self, from: usize, look: impl Fn(Vec3) -> Vec3) {
        for (colour, at) in self.colours.iter_mut().zip(&self.positions).skip(from) {
            *colour = look(Vec3::from_array(*at)).extend(1.0).to_array();
        }
    }

    /// Every point.
    #[cfg(test)]
    pub fn points(&self) -> impl Iterator<Item = [f32; 3]> {
        self.positions.iter().copied()
    }

    /// A flat face; its corners run counter-clockwise seen from its front.
    pub fn face(&mut self, corners: [DVec3; 4]) {
        let normal = (corners[2] - corners[0])
            .cross(corners[3] - corners[1])
            .normalize_or(DVec3::Y);
        self.patch(corners, [normal; 4]);
    }

    /// A face with a normal at each corner.
    pub fn patch(&mut self, corners: [DVec3; 4], normals: [DVec3; 4]) {
        let first = self.positions.len() as u32;
        for (corner, normal) in corners.into_iter().zip(normals) {
            let mut along = self.grain - normal * normal.dot(self.grain);
            if along.length_squared() < 1e-6 {
                along = DVec3::Y.cross(normal);
            }
            let along = along.normalize_or(DVec3::X);
            let across = normal.cross(along);
            self.positions.push(corner.as_vec3().to_array());
            self.normals.push(normal.as_vec3().to_array());
            let uv = DVec2::new(corner.dot(along), corner.dot(across)) / self.tile;
            self.uvs.push(uv.as_vec2().to_array());
            self.tangents.push(along.as_vec3().extend(1.0).to_array());
            self.colours.push(self.dye);
        }
        self.indices
            .extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
    }

    /// A horizontal face at height `y` over a quadrilateral in plan, seen from above.
    pub fn lid(&mut self, plan: [DVec2; 4], y: f64) {
        let mut corners = plan.map(|p| DVec3::new(p.x, y, p.y));
        let up = (corners[2] - corners[0]).cross(corners[3] - corners[1]).y;
        if up < 0.0 {
            corners.reverse();
        }
        self.patch(corners, [DVec3::Y; 4]);
    }

    /// A band between two lines of points, `lower` and `upper`, each with its normals, seen from the side to which the
    /// normals point.
    pub fn band(&mut self, lower: &[(DVec3, DVec3)], upper: &[(DVec3, DVec3)]) {
        for (a, b) in lower.windows(2).zip(upper.windows(2)) {
            let mut corners = [a[0], a[1], b[1], b[0]];
            let facing = (corners[2].0 - corners[0].0).cross(corners[3].0 - corners[1].0);
            if facing.dot(corners.iter().map(|c| c.1).sum()) < 0.0 {
                corners.reverse();
            }
            self.patch(corners.map(|c| c.0), corners.map(|c| c.1));
        }
    }

    pub fn is_empty(&self) -> bool {
        self.indices.is_empty()
    }

    pub fn mesh(self) -> Mesh {
        Mesh::new(
            PrimitiveTopology::TriangleList,
            RenderAssetUsages::RENDER_WORLD,
        )
        .with_inserted_attribute(Mesh::ATTRIBUTE_POSITION, self.positions)
        .with_inserted_attribute(Mesh::ATTRIBUTE_NORMAL, self.normals)
        .with_inserted_attribute(Mesh::ATTRIBUTE_UV_0, self.uvs)
        .with_inserted_attribute(Mesh::ATTRIBUTE_TANGENT, self.tangents)
        .with_inserted_attribute(Mesh::ATTRIBUTE_COLOR, self.colours)
        .with_inserted_indices(Indices::U32(self.indices))
    }
}

/// The surface that a profile of (radius, height) sweeps around the y axis, seen from outside where the profile runs
/// upwards. `segments` around.
pub(super) fn lathe(solid: &mut Solid, center: DVec3, profile: &[(f64, f64)], segments: u32) {
    let turn = |i: u32| {
        let angle = std::f64::consts::TAU * f64::from(i) / f64::from(segments);
        DVec3::new(libm::cos(angle), 0.0, libm::sin(angle))
    };
    for pair in profile.windows(2) {
        let ((r0, y0), (r1, y1)) = (pair[0], pair[1]);
        let slope = DVec2::new(y1 - y0, r0 - r1).normalize_or(DVec2::X);
        let ring = |radius: f64, y: f64| -> Vec<(DVec3, DVec3)> {
            (0..=segments)
                .map(|i| {
                    let out = turn(i);
                    (
                        center + radius * out + y * DVec3::Y,
                        slope.x * out + slope.y * DVec3::Y,
                    )
                })
                .collect()
        };
        solid.band(&ring(r0, y0), &ring(r1, y1));
    }
}
