//! The lamp over the table: what it looks like, and the light that it gives.

use bevy::light::{NotShadowCaster, NotShadowReceiver};
use bevy::math::DVec3;
use bevy::prelude::*;

use crate::game::settings::{Settings, TableStyle};
use crate::sim::playfield::Playfield;
use crate::window::render::quality::RenderQuality;
use crate::window::render::solid::{Solid, lathe};
use crate::window::render::twin;

/// Height of the lamps above the slate, m.
pub(super) const LAMP_HEIGHT: f32 = 1.08;

/// Light of one of three lamps over a nine-foot table, cd.
const CANDELA: f32 = 460.0;

/// Their colour: warm white, linear.
const WARM: Vec3 = Vec3::new(1.0, 0.875, 0.68);

/// The lamp, as mirrors see it.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::window::render) struct Fixture {
    /// Half the length and width of each glowing part, m.
    pub half: Vec2,
    /// From the middle of one part to the next, m.
    pub apart: f32,
    /// How many parts hang in a row along the table.
    pub count: u32,
    /// Whether they are round.
    pub is_round: bool,
    /// Height above the slate, m.
    pub height: f32,
    /// Their luminance.
    pub light: Vec3,
}

impl Fixture {
    /// The lamp of a table of this length and width in m.
    fn of(style: TableStyle, length: f32, width: f32) -> Self {
        let reach = (0.5 * length.max(width)).max(1.2);
        let scale = (reach / 1.27).max(1.0);
        let long = (length / 2.54).max(0.45);
        let (half, apart, count, is_round) = match style {
            TableStyle::Classic => (Vec2::splat(0.20 * scale), 0.72 * long, 3, true),
            TableStyle::Modern => (Vec2::new(0.92 * long, 0.11 * scale), 0.0, 1, false),
            TableStyle::BarBox => (Vec2::new(0.60 * long, 0.15 * scale), 0.0, 1, false),
        };
        // All light of three lamps comes out of the glowing parts; mirrored, it is shown brighter than it is, as film does.
        let area = 4.0 * half.x * half.y * count as f32;
        Self {
            half,
            apart,
            count,
            is_round,
            height: LAMP_HEIGHT * scale,
            light: 5.0 * CANDELA * scale * scale / area * WARM,
        }
    }
}

/// A lamp over the table.
#[derive(Component)]
pub(super) struct Lamp;

/// The body of the lamp.
#[derive(Component)]
pub(super) struct Body;

/// Hangs a row of lamps that suits the length of the table.
#[expect(
    clippy::too_many_arguments,
    reason = "two stores of assets, three sources"
)]
pub(super) fn hang(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
    mut fixture: ResMut<Fixture>,
    playfield: Res<Playfield>,
    quality: Res<RenderQuality>,
    settings: Res<Settings>,
    old: Query<Entity, Or<(With<Lamp>, With<Body>)>>,
    mut hung: Local<Option<(f64, f64, RenderQuality, TableStyle)>>,
) {
    let size = (
        playfield.table.length,
        playfield.table.width,
        *quality,
        settings.table,
    );
    if hung.replace(size) == Some(size) {
        return;
    }
    for lamp in &old {
        commands.entity(lamp).despawn();
    }
    let (length, width) = (size.0.max(0.3) as f32, size.1.max(0.15) as f32);
    *fixture = Fixture::of(settings.table, length, width);
    let height = fixture.height;
    // The middle lamp comes first: with one shadow, it is the one below the middle lamp.
    for (i, place) in [0.0, -0.36, 0.36].into_iter().enumerate() {
        // With painted shades and one shadow, that shadow has to do more.
        let share = match (quality.traces(), i) {
            (false, 0) => 2.0,
            (false, _) => 0.5,
            (true, _) => 1.0,
        };
        let scale = height / LAMP_HEIGHT;
        let colour = Color::linear_rgb(WARM.x, WARM.y, WARM.z);
        commands.spawn((
            Lamp,
            SpotLight {
                color: colour,
                intensity: 4.0 * std::f32::consts::PI * CANDELA * share * scale * scale,
                range: 5.0 * height,
                radius: 0.06,
                shadow_maps_enabled: i < quality.shadows(),
                shadow_depth_bias: 0.004,
                shadow_normal_bias: 1.2,
                shadow_map_near_z: 0.3 * height,
                outer_angle: 1.12,
                inner_angle: 0.80,
                ..default()
            },
            Transform::from_xyz(place * length, height, 0.0)
                .looking_at(Vec3::new(place * length, 0.0, 0.0), Vec3::X),
        ));
    }
    if playfield.solver.is_crowd() {
        return;
    }
    for (solid, material) in body(settings.table, &fixture) {
        commands.spawn((
            Body,
            Mesh3d(meshes.add(solid.mesh())),
            MeshMaterial3d(materials.add(material)),
            NotShadowCaster,
            NotShadowReceiver,
            twin::both(),
        ));
    }
}

/// Nothing hangs between the table and an eye that looks down past the lamp, be it that of either half.
pub(super) fn step_aside(
    fixture: Res<Fixture>,
    cameras: Query<(&Transform, &Camera), With<Camera3d>>,
    mut bodies: Query<&mut Visibility, With<Body>>,
) {
    let is_past = |eye: Vec3| {
        let above = eye.y - fixture.height;
        above > -0.1 && above > 0.45 * eye.with_y(0.0).length()
    };
    let mut eyes = cameras.iter().filter(|(_, camera)| camera.is_active);
    let wanted = if eyes.any(|(place, _)| is_past(place.translation)) {
        Visibility::Hidden
    } else {
        Visibility::Inherited
    };
    for mut visibility in &mut bodies {
        visibility.set_if_neq(wanted);
    }
}

/// What the lamp is made of.
fn body(style: TableStyle, fixture: &Fixture) -> Vec<(Solid, StandardMaterial)> {
    let glow = |strength: f32| StandardMaterial {
        base_color: Color::BLACK,
        emissive: LinearRgba::rgb(strength * WARM.x, strength * WARM.y, strength * WARM.z),
        cull_mode: None,
        ..default()
    };
    let metal = |colour: Color, roughness: f32| StandardMaterial {
        base_color: colour,
        metallic: 1.0,
        perceptual_roughness: roughness,
        cull_mode: None,
        ..default()
    };
    let brass = metal(Color::srgb(0.86, 0.66, 0.32), 0.28);
    let (x, z, y) = (
        f64::from(fixture.half.x),
        f64::from(fixture.half.y),
        f64::from(fixture.height),
    );
    let solid = || Solid::new(DVec3::X, 1.0);
    let (mut light, mut shell, mut rods) = (solid(), solid(), solid());
    match style {
        TableStyle::Classic => {
            let glass = StandardMaterial {
                base_color: Color::srgb(0.02, 0.16, 0.08),
                perceptual_roughness: 0.12,
                reflectance: 0.6,
                emissive: LinearRgba::rgb(0.004, 0.03, 0.012),
                cull_mode: None,
                ..default()
            };
            let middle = 0.5 * f64::from(fixture.count - 1);
            let spread = f64::from(fixture.apart);
            for i in 0..fixture.count {
                let at = DVec3::new((f64::from(i) - middle) * spread, y, 0.0);
                let inside = [(0.98 * x, 0.004), (0.5 * x, 0.075), (0.0, 0.08)];
                lathe(&mut light, at, &inside, 40);
                let outside = [
                    (1.0 * x, 0.0),
                    (0.93 * x, 0.035),
                    (0.62 * x, 0.10),
                    (0.26 * x, 0.135),
                    (0.16 * x, 0.15),
                ];
                lathe(&mut shell, at, &outside, 40);
                let neck = [(0.028, 0.15), (0.028, 0.19), (0.012, 0.20), (0.012, 0.31)];
                lathe(&mut rods, at, &neck, 20);
            }
            bar(&mut rods, (middle * spread + 0.1, 0.014), y + 0.30, 0.028);
            hangers(&mut rods, 0.5 * middle * spread + 0.1, y + 0.32);
            vec![(light, glow(5.0)), (shell, glass), (rods, brass)]
        }
        TableStyle::Modern => {
            plate(&mut light, (x, z), y);
            frame(
                &mut shell,
                (x + 0.02, z + 0.02),
                (y - 0.012, y + 0.045),
                1.0,
            );
            hangers(&mut rods, 0.8 * x, y + 0.045);
            let black = StandardMaterial {
                base_color: Color::srgb(0.03, 0.03, 0.032),
                perceptual_roughness: 0.4,
                cull_mode: None,
                ..default()
            };
            let steel = metal(Color::srgb(0.6, 0.6, 0.6), 0.3);
            vec![(light, glow(6.0)), (shell, black), (rods, steel)]
        }
        TableStyle::BarBox => {
            plate(&mut light, (x, z), y);
            frame(&mut shell, (x + 0.03, z + 0.03), (y - 0.01, y + 0.20), 0.55);
            bar(&mut rods, (0.6 * x, 0.02), y + 0.20, 0.03);
            frame(
                &mut rods,
                (x + 0.034, z + 0.034),
                (y - 0.014, y + 0.004),
                1.0,
            );
            hangers(&mut rods, 0.5 * x, y + 0.22);
            let glass = StandardMaterial {
                base_color: Color::srgb(0.45, 0.05, 0.03),
                emissive: LinearRgba::rgb(0.34, 0.045, 0.012),
                perceptual_roughness: 0.2,
                cull_mode: None,
                ..default()
            };
            vec![(light, glow(5.0)), (shell, glass), (rods, brass)]
        }
    }
}

/// A bar along the table.
fn bar(solid: &mut Solid, (half, thick): (f64, f64), y: f64, high: f64) {
    frame(solid, (half, thick), (y, y + high), 1.0);
    plate(solid, (half, thick), y + high);
    plate(solid, (half, thick), y);
}

/// Two cables up into the dark.
fn hangers(solid: &mut Solid, apart: f64, from: f64) {
    for x in [-apart, apart] {
        lathe(
            solid,
            DVec3::new(x, 0.0, 0.0),
            &[(0.005, from), (0.005, from + 3.0)],
            8,
        );
    }
}

/// A level rectangle.
fn plate(solid: &mut Solid, (x, z): (f64, f64), y: f64) {
    let corners = [(-x, -z), (-x, z), (x, z), (x, -z)].map(|(x, z)| DVec3::new(x, y, z));
    solid.patch(corners, [DVec3::NEG_Y; 4]);
}

/// Four walls around a rectangle, that are this share of it above.
fn frame(solid: &mut Solid, (x, z): (f64, f64), (low, high): (f64, f64), share: f64) {
    let ring = [(-x, -z), (-x, z), (x, z), (x, -z)];
    for i in 0..4 {
        let (a, b) = (ring[i], ring[(i + 1) % 4]);
        let lower = [a, b].map(|(x, z)| DVec3::new(x, low, z));
        let upper = [b, a].map(|(x, z)| DVec3::new(share * x, high, share * z));
        solid.face([lower[0], lower[1], upper[0], upper[1]]);
    }
}
