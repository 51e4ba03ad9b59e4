//! Textures, painted by functions: nothing is loaded.

mod noise;

pub(super) use noise::Noise;

use bevy::asset::RenderAssetUsages;
use bevy::image::{ImageAddressMode, ImageFilterMode, ImageSampler, ImageSamplerDescriptor};
use bevy::prelude::*;
use bevy::render::render_resource::{Extent3d, TextureDimension, TextureFormat};
use rayon::prelude::*;

/// What the numbers of a painted texture mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Paint {
    /// sRGB colour, 0 to 1.
    Colour,
    /// A direction: x, y, z from −1 to 1.
    Normal,
    /// Numbers from 0 to 1.
    Shares,
}

/// Paints a texture with all its mip levels. `texel` gets the place from 0 to 1 across and down. Width and height are
/// powers of two.
pub(super) fn paint(
    paint: Paint,
    (width, height): (u32, u32),
    anisotropy: u16,
    texel: impl Fn(f32, f32) -> [f32; 3] + Sync,
) -> Image {
    let place = |i: u32, n: u32| (i as f32 + 0.5) / n as f32;
    let texel = &texel;
    // The window waits for this: all cores paint.
    let mut level: Vec<[f32; 3]> = (0..height)
        .into_par_iter()
        .flat_map_iter(|y| (0..width).map(move |x| texel(place(x, width), place(y, height))))
        .collect();
    let mut data = Vec::with_capacity(level.len() * 6);
    let (mut w, mut h, mut levels) = (width, height, 0);
    loop {
        data.extend(level.iter().flat_map(|value| bytes(paint, *value)));
        levels += 1;
        if w == 1 && h == 1 {
            break;
        }
        level = halve(&level, (w, h));
        (w, h) = ((w / 2).max(1), (h / 2).max(1));
    }
    let mut image = Image::new_uninit(
        Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        },
        TextureDimension::D2,
        match paint {
            Paint::Colour => TextureFormat::Rgba8UnormSrgb,
            Paint::Normal | Paint::Shares => TextureFormat::Rgba8Unorm,
        },
        RenderAssetUsages::RENDER_WORLD,
    );
    image.texture_descriptor.mip_level_count = levels;
    image.data = Some(data);
    image.sampler = ImageSampler::Descriptor(ImageSamplerDescriptor {
        address_mode_u: ImageAddressMode::Repeat,
        address_mode_v: ImageAddressMode::Repeat,
        mag_filter: ImageFilterMode::Linear,
        min_filter: ImageFilterMode::Linear,
        mipmap_filter: ImageFilterMode::Linear,
        anisotropy_clamp: anisotropy,
        ..default()
    });
    image
}

fn bytes(paint: Paint, value: [f32; 3]) -> [u8; 4] {
    let byte = |x: f32| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    let [r, g, b] = match paint {
        Paint::Colour | Paint::Shares => value,
        Paint::Normal => value.map(|x| 0.5 * x + 0.5),
    };
    [byte(r), byte(g), byte(b), 255]
}

/// Half the size in each direction, by the mean of four.
fn halve(level: &[[f32; 3]], (w, h): (u32, u32)) -> Vec<[f32; 3]> {
    let (half_w, half_h) = ((w / 2).max(1), (h / 2).max(1));
    let at = |x: u32, y: u32| Vec3::from(level[(y.min(h - 1) * w + x.min(w - 1)) as usize]);
    let mut half = Vec::with_capacity((half_w * half_h) as usize);
    for y in 0..half_h {
        for x in 0..half_w {
            let sum = at(2 * x, 2 * y)
                + at(2 * x + 1, 2 * y)
                + at(2 * x, 2 * y + 1)
                + at(2 * x + 1, 2 * y + 1);
            half.push((0.25 * sum).to_array());
        }
    }
    half
}
