//! What balls share: the sphere, the shade, a material for each look.

use std::collections::HashMap;

use bevy::asset::RenderAssetUsages;
use bevy::mesh::{Indices, PrimitiveTopology};
use bevy::prelude::*;

use crate::window::render::balls::palette::{Marking, look, pattern};
use crate::window::render::balls::skin::{direction, skin};
use crate::window::render::quality::RenderQuality;
use crate::window::render::stage::{BallMaterial, Gloss};

/// Meshes and materials of balls, made when the first ball needs them.
#[derive(Resource)]
pub(super) struct Looks {
    globe: Handle<Mesh>,
    shade: Handle<Mesh>,
    shade_material: Handle<StandardMaterial>,
    quality: RenderQuality,
    made: HashMap<(Marking, [u32; 3], (u32, u32)), Handle<BallMaterial>>,
}

impl FromWorld for Looks {
    fn from_world(world: &mut World) -> Self {
        let quality = *world.resource::<RenderQuality>();
        let mut meshes = world.resource_mut::<Assets<Mesh>>();
        let globe = meshes.add(sphere(quality.segments()));
        let shade = meshes.add(shade());
        let shade_material =
            world
                .resource_mut::<Assets<StandardMaterial>>()
                .add(StandardMaterial {
                    base_color: Color::BLACK,
                    unlit: true,
                    alpha_mode: AlphaMode::Blend,
                    depth_bias: 10.0,
                    ..default()
                });
        Self {
            globe,
            shade,
            shade_material,
            quality,
            made: HashMap::new(),
        }
    }
}

impl Looks {
    /// Makes balls as fine as this quality wants them. What was made before goes when the last ball has let go of it.
    pub fn suit(&mut self, quality: RenderQuality, meshes: &mut Assets<Mesh>) {
        if quality != self.quality {
            self.quality = quality;
            self.globe = meshes.add(sphere(quality.segments()));
            self.made.clear();
        }
    }

    pub fn quality(&self) -> RenderQuality {
        self.quality
    }

    pub fn globe(&self) -> Handle<Mesh> {
        self.globe.clone()
    }

    pub fn shade(&self) -> Handle<Mesh> {
        self.shade.clone()
    }

    pub fn shade_material(&self) -> Handle<StandardMaterial> {
        self.shade_material.clone()
    }

    /// The material of a ball with this name, with a pattern or without.
    pub fn material(
        &mut self,
        name: &str,
        patterned: bool,
        gloss: &Gloss,
        images: &mut Assets<Image>,
        materials: &mut Assets<BallMaterial>,
    ) -> Handle<BallMaterial> {
        let (colour, marking) = look(name);
        let quality = self.quality;
        let pattern = if patterned { pattern(name) } else { (0, 0) };
        self.made
            .entry((marking, colour.map(f32::to_bits), pattern))
            .or_insert_with(|| {
                let paint = skin(
                    colour,
                    marking,
                    pattern,
                    quality.finer(),
                    quality.anisotropy(),
                );
                materials.add(BallMaterial {
                    base: StandardMaterial {
                        base_color_texture: Some(images.add(paint)),
                        // Phenolic resin, polished.
                        perceptual_roughness: 0.13,
                        reflectance: 0.55,
                        ..default()
                    },
                    extension: gloss.clone(),
                })
            })
            .clone()
    }
}

/// A unit sphere whose texture coordinates are those of [`skin`].
fn sphere(segments: u32) -> Mesh {
    let rings = segments / 2;
    let (mut points, mut uvs, mut indices) = (Vec::new(), Vec::new(), Vec::new());
    for ring in 0..=rings {
        for i in 0..=segments {
            let (u, v) = (i as f32 / segments as f32, ring as f32 / rings as f32);
            points.push(direction(u, v).to_array());
            uvs.push([u, v]);
            if ring > 0 && i > 0 {
                let row = segments + 1;
                let c = ring * row + i;
                indices.extend([c, c - 1, c - row - 1, c, c - row - 1, c - row]);
            }
        }
    }
    mesh(points.clone(), points, indices).with_inserted_attribute(Mesh::ATTRIBUTE_UV_0, uvs)
}

/// A disc on the cloth, in R, as dark as the cloth below a ball is: a sphere that touches a plane hides the share
/// (1 + r²)^(−3/2) of a cosine-weighted sky from the plane at distance r from the point of touch.
fn shade() -> Mesh {
    const SIDES: u32 = 40;
    let rings = [0.0_f32, 0.15, 0.3, 0.45, 0.6, 0.8, 1.0, 1.3, 1.7, 2.2];
    let (mut points, mut colours, mut indices) = (Vec::new(), Vec::new(), Vec::new());
    let end = rings[rings.len() - 1];
    for (ring, &radius) in rings.iter().enumerate() {
        let hidden = libm::powf(1.0 + radius * radius, -1.5);
        let fade = 1.0 - (radius * radius) / (end * end);
        for i in 0..=SIDES {
            let at = Vec2::from_angle(std::f32::consts::TAU * i as f32 / SIDES as f32) * radius;
            points.push([at.x, 0.0, at.y]);
            colours.push([1.0, 1.0, 1.0, 0.75 * hidden * fade]);
            if ring > 0 && i > 0 {
                let row = SIDES + 1;
                let c = ring as u32 * row + i;
                indices.extend([c, c - 1, c - row - 1, c, c - row - 1, c - row]);
            }
        }
    }
    let up = vec![[0.0, 1.0, 0.0]; points.len()];
    mesh(points, up, indices).with_inserted_attribute(Mesh::ATTRIBUTE_COLOR, colours)
}

fn mesh(points: Vec<[f32; 3]>, normals: Vec<[f32; 3]>, indices: Vec<u32>) -> Mesh {
    Mesh::new(
        PrimitiveTopology::TriangleList,
        RenderAssetUsages::RENDER_WORLD,
    )
    .with_inserted_attribute(Mesh::ATTRIBUTE_POSITION, points)
    .with_inserted_attribute(Mesh::ATTRIBUTE_NORMAL, normals)
    .with_inserted_indices(Indices::U32(indices))
}
