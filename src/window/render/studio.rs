//! The light of the room as a cube map: a dim room with long lamps overhead, which glossy balls mirror. Painted and
//! blurred here, so that it is there with the first frame.

use bevy::asset::RenderAssetUsages;
use bevy::image::{ImageFilterMode, ImageSampler, ImageSamplerDescriptor};
use bevy::light::EnvironmentMapLight;
use bevy::prelude::*;
use bevy::render::render_resource::{
    Extent3d, TextureDimension, TextureFormat, TextureViewDescriptor, TextureViewDimension,
};

/// Side of the sharpest level of the mirror map, texels.
const SIDE: u32 = 128;

/// Light from everywhere but the lamps themselves.
pub(super) fn studio(images: &mut Assets<Image>) -> EnvironmentMapLight {
    EnvironmentMapLight {
        diffuse_map: images.add(cube(16, 1, |direction, _| soft(direction))),
        specular_map: images.add(cube(SIDE, SIDE.ilog2() - 1, |direction, roughness| {
            mirrored(direction, roughness)
        })),
        intensity: 100.0,
        ..default()
    }
}

/// What a rough white surface with this normal gathers.
fn soft(normal: Vec3) -> Vec3 {
    let up = 0.5 + 0.5 * normal.y;
    Vec3::new(0.30, 0.29, 0.28).lerp(Vec3::new(1.0, 0.96, 0.9), up * up)
}

/// What a mirror of this roughness shows in this direction.
fn mirrored(direction: Vec3, roughness: f32) -> Vec3 {
    let blur = 0.015 + 0.55 * roughness * roughness;
    let up = direction.y;
    let wall = Vec3::new(0.16, 0.145, 0.13);
    let ceiling = Vec3::new(0.36, 0.34, 0.31);
    let floor = Vec3::new(0.05, 0.07, 0.065);
    let mut light = wall
        .lerp(ceiling, edge(up - 0.55, blur))
        .lerp(floor, edge(-up - 0.03, blur.max(0.12)));
    if up > 0.0 {
        // Lamps hang in one row along the table; seen on a plane one metre up.
        let (x, z) = (direction.x / up, direction.z / up);
        let width = blur / up.max(0.2);
        for lamp in [-0.85, 0.0, 0.85] {
            let along = edge(0.27 - (x - lamp).abs(), width);
            let across = edge(0.13 - z.abs(), width);
            // A blurred lamp spreads the same light wider.
            let spread = 0.27 * 0.13 / ((0.27 + width) * (0.13 + width));
            light += 26.0 * spread * along * across * Vec3::new(1.0, 0.95, 0.86);
        }
    }
    light
}

/// From 0 to 1 as `x` passes 0, within about `width` on both sides.
fn edge(x: f32, width: f32) -> f32 {
    let t = (0.5 + 0.5 * x / width).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// A cube map with this many mip levels; `light` gets a direction and the roughness of its level, 0 to 1.
fn cube(side: u32, levels: u32, light: impl Fn(Vec3, f32) -> Vec3) -> Image {
    let mut data = Vec::new();
    for face in 0..6 {
        for level in 0..levels {
            let n = (side >> level).max(1);
            let roughness = level as f32 / (levels.max(2) - 1) as f32;
            for y in 0..n {
                for x in 0..n {
                    let at = |i: u32| 2.0 * (i as f32 + 0.5) / n as f32 - 1.0;
                    let value = light(direction(face, at(x), at(y)), roughness);
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

/// A positive number as a half float, rounded towards zero.
fn half(value: f32) -> u16 {
    let bits = value.clamp(0.0, 65_000.0).to_bits() >> 13;
    u16::try_from(bits.saturating_sub(112 << 10)).unwrap_or(0)
}
