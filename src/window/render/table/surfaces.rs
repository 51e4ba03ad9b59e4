//! Cloth, wood, leather, metal: the materials of the table.

use bevy::prelude::*;

use crate::game::settings::{ClothColour, TableStyle, Wood};
use crate::window::render::paint::{Noise, Paint, paint};
use crate::window::render::quality::RenderQuality;
use crate::window::render::stage::{ClothMaterial, Gloss, PolishMaterial};
use crate::window::render::table::{Surface, wear};

/// Side of the square of cloth that repeats, m.
pub(super) const CLOTH_TILE: f64 = 0.08;

/// What the materials depend on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Finish {
    pub quality: RenderQuality,
    pub cloth: ClothColour,
    pub wood: Wood,
    pub style: TableStyle,
}

/// The colours of cloth and wood, linear, as mirrors see them.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::window::render) struct Dyes {
    pub cloth: Vec3,
    pub wood: Vec3,
}

impl Finish {
    pub fn dyes(self) -> Dyes {
        let linear = |[r, g, b]: [f32; 3]| {
            let colour = Color::srgb(r, g, b).to_linear();
            Vec3::new(colour.red, colour.green, colour.blue)
        };
        let (dark, light) = tones(self.wood);
        Dyes {
            cloth: linear(dye(self.cloth)),
            wood: linear((0.5 * (dark + light)).to_array()),
        }
    }
}

/// One material for each [`Surface`].
pub(super) struct Surfaces {
    cloth: Handle<ClothMaterial>,
    wood: Handle<PolishMaterial>,
    rim: Handle<PolishMaterial>,
    metal: Handle<PolishMaterial>,
    pearl: Handle<PolishMaterial>,
    hole: Handle<StandardMaterial>,
    mark: Handle<StandardMaterial>,
    shade: Handle<StandardMaterial>,
}

/// A material of one of these kinds.
pub(super) enum Cover {
    Cloth(Handle<ClothMaterial>),
    Polished(Handle<PolishMaterial>),
    Plain(Handle<StandardMaterial>),
}

impl Surfaces {
    pub fn new(
        finish: Finish,
        gloss: Gloss,
        images: &mut Assets<Image>,
        materials: &mut Assets<StandardMaterial>,
        cloths: &mut Assets<ClothMaterial>,
        polishes: &mut Assets<PolishMaterial>,
    ) -> Self {
        let quality = finish.quality;
        let anisotropy = quality.anisotropy();
        let plain = |colour: Color, roughness: f32| StandardMaterial {
            base_color: colour,
            perceptual_roughness: roughness,
            reflectance: 0.3,
            ..default()
        };
        let polish = gloss.polish();
        let mut polished = |base| {
            polishes.add(PolishMaterial {
                base,
                extension: polish.clone(),
            })
        };
        let cloth = ClothMaterial {
            base: StandardMaterial {
                base_color_texture: Some(images.add(cloth_colour(finish.cloth, quality))),
                normal_map_texture: Some(images.add(weave(quality))),
                perceptual_roughness: 0.92,
                reflectance: 0.18,
                ..default()
            },
            extension: gloss.felt(images.add(wear::map(quality))),
        };
        let lacquer = if quality.traces() { 1.0 } else { 0.0 };
        let wood = StandardMaterial {
            base_color_texture: Some(images.add(wood_colour(finish.wood, quality))),
            perceptual_roughness: if lacquer > 0.0 { 0.5 } else { 0.32 },
            reflectance: 0.45,
            clearcoat: lacquer,
            clearcoat_perceptual_roughness: match finish.style {
                TableStyle::Modern => 0.35,
                TableStyle::Classic => 0.12,
                TableStyle::BarBox => 0.22,
            },
            ..default()
        };
        let rim = StandardMaterial {
            normal_map_texture: Some(images.add(hide(anisotropy))),
            // The colours are in the leather itself.
            ..plain(
                Color::WHITE,
                match finish.style {
                    TableStyle::Classic => 0.52,
                    TableStyle::Modern => 0.42,
                    TableStyle::BarBox => 0.65,
                },
            )
        };
        let metal = StandardMaterial {
            metallic: 1.0,
            ..match finish.style {
                TableStyle::Classic => plain(Color::srgb(0.88, 0.69, 0.36), 0.24),
                TableStyle::Modern => plain(Color::srgb(0.62, 0.62, 0.64), 0.34),
                TableStyle::BarBox => plain(Color::srgb(0.86, 0.87, 0.88), 0.10),
            }
        };
        let inlay = match finish.style {
            TableStyle::Classic => Color::srgb(0.90, 0.86, 0.74),
            TableStyle::Modern | TableStyle::BarBox => Color::srgb(0.86, 0.87, 0.88),
        };
        Self {
            cloth: cloths.add(cloth),
            wood: polished(wood),
            rim: polished(rim),
            metal: polished(metal),
            pearl: polished(plain(inlay, 0.22)),
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

    pub fn get(&self, surface: Surface) -> Cover {
        let polished = match surface {
            Surface::Cloth => return Cover::Cloth(self.cloth.clone()),
            Surface::Hole => return Cover::Plain(self.hole.clone()),
            Surface::Mark => return Cover::Plain(self.mark.clone()),
            Surface::Wood => &self.wood,
            Surface::Rim => &self.rim,
            Surface::Metal => &self.metal,
            Surface::Pearl => &self.pearl,
        };
        Cover::Polished(polished.clone())
    }
}

/// The colour that a cloth is dyed, sRGB.
fn dye(cloth: ClothColour) -> [f32; 3] {
    match cloth {
        ClothColour::Tournament => [0.03, 0.44, 0.41],
        ClothColour::Green => [0.045, 0.34, 0.135],
        ClothColour::Blue => [0.06, 0.22, 0.49],
        ClothColour::Burgundy => [0.30, 0.05, 0.09],
        ClothColour::Grey => [0.30, 0.31, 0.32],
        ClothColour::Red => [0.56, 0.06, 0.05],
        ClothColour::Camel => [0.53, 0.39, 0.22],
    }
}

/// Dyed wool, not quite even: it takes the dye thread by thread.
fn cloth_colour(cloth: ClothColour, quality: RenderQuality) -> Image {
    let dye = dye(cloth);
    let noise = Noise::new(11);
    let size = 512 << quality.finer();
    paint(Paint::Colour, (size, size), quality.anisotropy(), |u, v| {
        let thread = noise.octave((u, v), (256, 64)) + noise.octave((v, u), (256, 64));
        let light = 1.0 + 0.05 * thread;
        dye.map(|c: f32| c * light)
    })
}

/// Plain weave: warp over weft over warp.
fn weave(quality: RenderQuality) -> Image {
    let threads = 88.0_f32;
    let size = 512 << quality.finer();
    let noise = Noise::new(5);
    let bump = |u: f32, v: f32| {
        let (x, y) = (u * threads, v * threads);
        let over = ((x.floor() + y.floor()) as i32).rem_euclid(2) == 0;
        let arch = |t: f32| libm::sinf(std::f32::consts::PI * t.fract());
        let wool = noise.octave((u, v), (256, 256));
        (if over { arch(x) } else { arch(y) }) + 0.5 * wool
    };
    paint(Paint::Normal, (size, size), quality.anisotropy(), |u, v| {
        let step = 1.0 / 512.0;
        let slope = |a: f32, b: f32| 0.20 * (a - b);
        let normal = Vec3::new(
            slope(bump(u - step, v), bump(u + step, v)),
            slope(bump(u, v - step), bump(u, v + step)),
            1.0,
        );
        normal.normalize().to_array()
    })
}

/// Grain of leather.
fn hide(anisotropy: u16) -> Image {
    let noise = Noise::new(71);
    let bump = |u: f32, v: f32| noise.sum((u, v), (48, 48), 3);
    paint(Paint::Normal, (256, 256), anisotropy, |u, v| {
        let step = 1.0 / 256.0;
        Vec3::new(
            0.35 * (bump(u - step, v) - bump(u + step, v)),
            0.35 * (bump(u, v - step) - bump(u, v + step)),
            1.0,
        )
        .normalize()
        .to_array()
    })
}

/// The darkest and the lightest tone of a wood, sRGB.
fn tones(wood: Wood) -> (Vec3, Vec3) {
    match wood {
        Wood::Mahogany => (Vec3::new(0.20, 0.075, 0.035), Vec3::new(0.50, 0.24, 0.12)),
        Wood::Oak => (Vec3::new(0.45, 0.30, 0.16), Vec3::new(0.72, 0.54, 0.34)),
        Wood::Ebony => (Vec3::new(0.035, 0.03, 0.028), Vec3::new(0.13, 0.11, 0.10)),
    }
}

/// Wood, grain along u.
fn wood_colour(wood: Wood, quality: RenderQuality) -> Image {
    let noise = Noise::new(23);
    let (dark, light) = tones(wood);
    let finer = quality.finer();
    let size = (1024 << finer, 512 << finer);
    paint(Paint::Colour, size, quality.anisotropy(), |u, v| {
        let bend = 0.06 * noise.sum((u, v), (2, 3), 2);
        let ring = noise.sum((u, (v + bend).rem_euclid(1.0)), (2, 28), 3);
        let fibre = noise.octave((u, v), (24, 256));
        // Short dark pores along the grain.
        let pore = (noise.octave((u, v), (48, 512)) - 0.55).max(0.0);
        let share = (0.5 + 0.45 * ring + 0.13 * fibre - 0.9 * pore).clamp(0.0, 1.0);
        dark.lerp(light, share).to_array()
    })
}
