//! Cloth, wood, leather: the materials of the table.

use bevy::prelude::*;

use crate::game::settings::{ClothColour, Wood};
use crate::window::render::paint::{Noise, Paint, paint};
use crate::window::render::quality::RenderQuality;
use crate::window::render::table::Surface;

/// Side of the square of cloth that repeats, m.
pub(super) const CLOTH_TILE: f64 = 0.16;

/// What the materials depend on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Finish {
    pub quality: RenderQuality,
    pub cloth: ClothColour,
    pub wood: Wood,
}

/// One material for each [`Surface`].
pub(super) struct Surfaces {
    cloth: Handle<StandardMaterial>,
    wood: Handle<StandardMaterial>,
    leather: Handle<StandardMaterial>,
    pearl: Handle<StandardMaterial>,
    hole: Handle<StandardMaterial>,
    mark: Handle<StandardMaterial>,
    shade: Handle<StandardMaterial>,
}

impl Surfaces {
    pub fn new(
        finish: Finish,
        images: &mut Assets<Image>,
        materials: &mut Assets<StandardMaterial>,
    ) -> Self {
        let anisotropy = finish.quality.anisotropy();
        let plain = |colour: Color, roughness: f32| StandardMaterial {
            base_color: colour,
            perceptual_roughness: roughness,
            reflectance: 0.3,
            ..default()
        };
        let cloth = StandardMaterial {
            base_color_texture: Some(images.add(cloth_colour(finish.cloth, anisotropy))),
            normal_map_texture: Some(images.add(weave(anisotropy))),
            perceptual_roughness: 0.92,
            reflectance: 0.18,
            ..default()
        };
        let wood = StandardMaterial {
            base_color_texture: Some(images.add(wood_colour(finish.wood, anisotropy))),
            perceptual_roughness: 0.32,
            reflectance: 0.45,
            ..default()
        };
        Self {
            cloth: materials.add(cloth),
            wood: materials.add(wood),
            leather: materials.add(plain(Color::srgb(0.055, 0.045, 0.04), 0.5)),
            pearl: materials.add(plain(Color::srgb(0.86, 0.84, 0.78), 0.25)),
            hole: materials.add(StandardMaterial {
                reflectance: 0.0,
                ..plain(Color::srgb(0.02, 0.018, 0.016), 1.0)
            }),
            mark: materials.add(plain(Color::srgb(0.75, 0.78, 0.74), 0.9)),
            shade: materials.add(StandardMaterial {
                base_color: Color::BLACK,
                unlit: true,
                alpha_mode: AlphaMode::Blend,
                cull_mode: None,
                ..default()
            }),
        }
    }

    /// What darkens the cloth where little light comes; its alpha is in the vertices.
    pub fn shade(&self) -> Handle<StandardMaterial> {
        self.shade.clone()
    }

    pub fn get(&self, surface: Surface) -> Handle<StandardMaterial> {
        match surface {
            Surface::Cloth => &self.cloth,
            Surface::Wood => &self.wood,
            Surface::Leather => &self.leather,
            Surface::Pearl => &self.pearl,
            Surface::Hole => &self.hole,
            Surface::Mark => &self.mark,
        }
        .clone()
    }
}

/// Dyed wool, not quite even: it takes the dye thread by thread.
fn cloth_colour(cloth: ClothColour, anisotropy: u16) -> Image {
    let dye = match cloth {
        ClothColour::Tournament => [0.03, 0.44, 0.41],
        ClothColour::Green => [0.03, 0.38, 0.12],
        ClothColour::Blue => [0.04, 0.20, 0.52],
        ClothColour::Burgundy => [0.30, 0.05, 0.09],
        ClothColour::Grey => [0.30, 0.31, 0.32],
    };
    let noise = Noise::new(11);
    paint(Paint::Colour, (512, 512), anisotropy, |u, v| {
        let blotch = noise.sum((u, v), (4, 4), 4);
        let thread = noise.octave((u, v), (256, 64)) + noise.octave((v, u), (256, 64));
        let light = 1.0 + 0.012 * blotch + 0.05 * thread;
        dye.map(|c: f32| c * light)
    })
}

/// Plain weave: warp over weft over warp.
fn weave(anisotropy: u16) -> Image {
    let threads = 96.0_f32;
    let noise = Noise::new(5);
    let bump = |u: f32, v: f32| {
        let (x, y) = (u * threads, v * threads);
        let over = ((x.floor() + y.floor()) as i32).rem_euclid(2) == 0;
        let arch = |t: f32| libm::sinf(std::f32::consts::PI * t.fract());
        let wool = noise.octave((u, v), (256, 256));
        (if over { arch(x) } else { arch(y) }) + 0.5 * wool
    };
    paint(Paint::Normal, (512, 512), anisotropy, |u, v| {
        let step = 1.0 / 512.0;
        let slope = |a: f32, b: f32| 0.22 * (a - b);
        let normal = Vec3::new(
            slope(bump(u - step, v), bump(u + step, v)),
            slope(bump(u, v - step), bump(u, v + step)),
            1.0,
        );
        normal.normalize().to_array()
    })
}

/// Wood, grain along u.
fn wood_colour(wood: Wood, anisotropy: u16) -> Image {
    let noise = Noise::new(23);
    let (dark, light) = match wood {
        Wood::Mahogany => (Vec3::new(0.20, 0.075, 0.035), Vec3::new(0.50, 0.24, 0.12)),
        Wood::Oak => (Vec3::new(0.45, 0.30, 0.16), Vec3::new(0.72, 0.54, 0.34)),
        Wood::Ebony => (Vec3::new(0.035, 0.03, 0.028), Vec3::new(0.13, 0.11, 0.10)),
    };
    paint(Paint::Colour, (1024, 512), anisotropy, |u, v| {
        let bend = 0.06 * noise.sum((u, v), (2, 3), 2);
        let ring = noise.sum((u, (v + bend).rem_euclid(1.0)), (2, 28), 3);
        let fibre = noise.octave((u, v), (24, 256));
        let share = (0.5 + 0.45 * ring + 0.13 * fibre).clamp(0.0, 1.0);
        dark.lerp(light, share).to_array()
    })
}
