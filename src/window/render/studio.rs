//! The light of the room as cube maps, which glossy surfaces mirror. Painted and blurred here, so that they are there with
//! the first frame.

use bevy::asset::RenderAssetUsages;
use bevy::image::{ImageFilterMode, ImageSampler, ImageSamplerDescriptor};
use bevy::light::EnvironmentMapLight;
use bevy::prelude::*;
use bevy::render::render_resource::{
    Extent3d, TextureDimension, TextureFormat, TextureViewDescriptor, TextureViewDimension,
};
use rayon::prelude::*;

use crate::window::render::room::seen_towards;

/// Side of the sharpest level of the mirror map, texels.
const SIDE: u32 = 128;

/// How bright the room is, cd/m² where its picture is 1.
pub(super) const BRIGHTNESS: f32 = 110.0;

/// The light of the room.
#[derive(Resource)]
pub(super) struct Studio {
    diffuse: Handle<Image>,
    /// With the lamps, for surfaces that follow no rays.
    whole: Handle<Image>,
    /// Without.
    beyond: Handle<Image>,
}

impl FromWorld for Studio {
    fn from_world(world: &mut World) -> Self {
        let room = levels();
        let lit = |direction: Vec3, level: u32| {
            let roughness = level as f32 / (room.len() - 1) as f32;
            room[level as usize].towards(direction) + lamps(direction, roughness)
        };
        let count = room.len() as u32;
        let mut images = world.resource_mut::<Assets<Image>>();
        Self {
            diffuse: images.add(cube(16, 1, |direction, _| soft(direction))),
            whole: images.add(cube(SIDE, count, lit)),
            beyond: images.add(cube(SIDE, count, |direction, level| {
                room[level as usize].towards(direction)
            })),
        }
    }
}

impl Studio {
    /// Light from everywhere but the lamps themselves.
    pub fn light(&self) -> EnvironmentMapLight {
        EnvironmentMapLight {
            diffuse_map: self.diffuse.clone(),
            specular_map: self.whole.clone(),
            intensity: BRIGHTNESS,
            ..default()
        }
    }

    /// The room without the lamps, as a cube map.
    pub fn beyond(&self) -> Handle<Image> {
        self.beyond.clone()
    }
}

/// What a rough white surface with this normal gathers.
pub(super) fn soft(normal: Vec3) -> Vec3 {
    let up = 0.5 + 0.5 * normal.y;
    Vec3::new(0.16, 0.145, 0.125).lerp(Vec3::new(0.44, 0.40, 0.34), up * up)
}

/// The room in all directions, at one sharpness.
struct Around {
    side: u32,
    texels: Vec<Vec3>,
}

impl Around {
    fn towards(&self, direction: Vec3) -> Vec3 {
        let (face, x, y) = place(direction);
        let at = |v: f32| (((0.5 + 0.5 * v) * self.side as f32) as u32).min(self.side - 1);
        self.texels[((face * self.side + at(y)) * self.side + at(x)) as usize]
    }

    /// Half as sharp, and a little blurred.
    fn halved(&self) -> Self {
        let side = (self.side / 2).max(1);
        let mut texels = Vec::with_capacity((6 * side * side) as usize);
        let spread = 1.5 / self.side as f32;
        for face in 0..6 {
            for y in 0..side {
                for x in 0..side {
                    let at = |i: u32| 2.0 * (i as f32 + 0.5) / side as f32 - 1.0;
                    let mut sum = Vec3::ZERO;
                    for dx in [-3.0, -1.0, 1.0, 3.0] {
                        for dy in [-3.0, -1.0, 1.0, 3.0] {
                            let (x, y) = (at(x) + 0.66 * dx * spread, at(y) + 0.66 * dy * spread);
                            sum += self.towards(direction(face, x, y));
                        }
                    }
                    texels.push(sum / 16.0);
                }
            }
        }
        Self { side, texels }
    }
}

/// The room from sharp to rough.
fn levels() -> Vec<Around> {
    let texels = (0..6 * SIDE)
        .into_par_iter()
        .flat_map_iter(|row| {
            let at = |i: u32| 2.0 * (i as f32 + 0.5) / SIDE as f32 - 1.0;
            (0..SIDE).map(move |x| {
                let towards = direction(row / SIDE, at(x), at(row % SIDE));
                // Cube maps are left-handed.
                seen_towards(towards.with_z(-towards.z))
            })
        })
        .collect();
    let mut levels = vec![Around { side: SIDE, texels }];
    while let Some(last) = levels.last().filter(|last| last.side > 2) {
        levels.push(last.halved());
    }
    levels
}

/// The lamps in a mirror of this roughness.
fn lamps(direction: Vec3, roughness: f32) -> Vec3 {
    let blur = 0.015 + 0.55 * roughness * roughness;
    let up = direction.y;
    let mut light = Vec3::ZERO;
    if up > 0.0 {
        // Lamps hang in one row along the table; seen on a plane one metre up.
        let (x, z) = (direction.x / up, direction.z / up);
        let width = blur / up.max(0.2);
        for lamp in [-0.72, 0.0, 0.72] {
            let along = edge(0.22 - (x - lamp).abs(), width);
            let across = edge(0.15 - z.abs(), width);
            // A blurred lamp spreads the same light wider.
            let spread = 0.22 * 0.15 / ((0.22 + width) * (0.15 + width));
            light += 10.0 * spread * along * across * Vec3::new(1.0, 0.95, 0.86);
        }
    }
    light
}

/// From 0 to 1 as `x` passes 0, within about `width` on both sides.
fn edge(x: f32, width: f32) -> f32 {
    let t = (0.5 + 0.5 * x / width).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// A cube map with this many mip levels; `light` gets a direction and the level.
fn cube(side: u32, levels: u32, light: impl Fn(Vec3, u32) -> Vec3) -> Image {
    let mut data = Vec::new();
    for face in 0..6 {
        for level in 0..levels {
            let n = (side >> level).max(1);
            for y in 0..n {
                for x in 0..n {
                    let at = |i: u32| 2.0 * (i as f32 + 0.5) / n as f32 - 1.0;
                    let value = light(direction(face, at(x), at(y)), level);
                    let texel = [value.x, value.y, value.z, 1.0];
                    data.extend(texel.into_iter().flat_map(|v| half(v).to_le_bytes()));
                }
            }
        }
    }
    let mut image = Image::new_uninit(
        Extent3d {
            width: side,
            height: side,
            depth_or_array_layers: 6,
        },
        TextureDimension::D2,
        TextureFormat::Rgba16Float,
        RenderAssetUsages::RENDER_WORLD,
    );
    image.data = Some(data);
    image.texture_descriptor.mip_level_count = levels;
    image.texture_view_descriptor = Some(TextureViewDescriptor {
        dimension: Some(TextureViewDimension::Cube),
        ..default()
    });
    image.sampler = ImageSampler::Descriptor(ImageSamplerDescriptor {
        mag_filter: ImageFilterMode::Linear,
        min_filter: ImageFilterMode::Linear,
        mipmap_filter: ImageFilterMode::Linear,
        ..default()
    });
    image
}

/// Direction of a texel of a cube face, in Bevy's order +X −X +Y −Y +Z −Z with z mirrored as its cube maps are.
fn direction(face: u32, x: f32, y: f32) -> Vec3 {
    match face {
        0 => Vec3::new(1.0, -y, -x),
        1 => Vec3::new(-1.0, -y, x),
        2 => Vec3::new(x, 1.0, y),
        3 => Vec3::new(x, -1.0, -y),
        4 => Vec3::new(x, -y, 1.0),
        _ => Vec3::new(-x, -y, -1.0),
    }
    .normalize()
}

/// The face and the place on it, −1 to 1, that [`direction`] leads from.
fn place(direction: Vec3) -> (u32, f32, f32) {
    let size = direction.abs();
    let Vec3 { x, y, z } = direction;
    if size.x >= size.y.max(size.z) {
        let face = u32::from(x < 0.0);
        (face, -z / size.x * x.signum(), -y / size.x)
    } else if size.y >= size.z {
        let face = 2 + u32::from(y < 0.0);
        (face, x / size.y, z / size.y * y.signum())
    } else {
        let face = 4 + u32::from(z < 0.0);
        (face, x / size.z * z.signum(), -y / size.z)
    }
}

/// A positive number as a half float, rounded towards zero.
fn half(value: f32) -> u16 {
    let bits = value.clamp(0.0, 65_000.0).to_bits() >> 13;
    u16::try_from(bits.saturating_sub(112 << 10)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_place_on_a_cube_is_found_again() {
        for face in 0..6 {
            for (x, y) in [(0.3, -0.7), (-0.9, 0.1), (0.0, 0.95)] {
                let (f, u, v) = place(direction(face, x, y));
                assert_eq!(f, face);
                assert!(
                    (u - x).abs() < 1e-5 && (v - y).abs() < 1e-5,
                    "{face} {u} {v}"
                );
            }
        }
    }
}
