//! The room: lamps over the table, the floor, the dark around.

use bevy::anti_alias::smaa::{Smaa, SmaaPreset};
use bevy::asset::RenderAssetUsages;
use bevy::camera::Exposure;
use bevy::core_pipeline::tonemapping::Tonemapping;
use bevy::light::cluster::{ClusterConfig, GlobalClusterSettings};
use bevy::light::{DirectionalLightShadowMap, NotShadowCaster};
use bevy::mesh::{Indices, PrimitiveTopology};
use bevy::prelude::*;

use crate::sim::playfield::Playfield;
use crate::window::render::Drawing;
use crate::window::render::quality::RenderQuality;
use crate::window::render::studio::studio;
use crate::window::render::table::FLOOR;
use crate::window::render::twin;

/// What surrounds the lit table.
const DARK: Color = Color::srgb(0.018, 0.017, 0.018);

/// Height of the lamps above the slate, m.
const LAMP_HEIGHT: f32 = 1.35;

pub(super) fn plugin(app: &mut App) {
    let quality = *app.world().resource::<RenderQuality>();
    app.insert_resource(ClearColor(DARK))
        .insert_resource(GlobalAmbientLight::NONE)
        .insert_resource(DirectionalLightShadowMap {
            size: quality.shadow_map(),
        })
        .add_observer(equip_camera)
        .add_systems(
            Startup,
            (walls, sort_lamps_here).chain().in_set(Drawing::Room),
        )
        .add_systems(
            RunFixedMainLoop,
            (
                suit_cameras.run_if(resource_exists_and_changed::<RenderQuality>),
                hang_lamps.run_if(
                    resource_exists_and_changed::<Playfield>
                        .or_else(resource_exists_and_changed::<RenderQuality>),
                ),
                widen.run_if(resource_exists_and_changed::<Playfield>),
            )
                .chain()
                .in_set(Drawing::Room),
        );
}

/// Cameras and shadows that are there already follow another quality.
fn suit_cameras(
    mut commands: Commands,
    quality: Res<RenderQuality>,
    mut shadows: ResMut<DirectionalLightShadowMap>,
    cameras: Query<Entity, With<Camera3d>>,
) {
    if shadows.size != quality.shadow_map() {
        shadows.size = quality.shadow_map();
    }
    for camera in &cameras {
        smooth_edges(&mut commands.entity(camera), *quality);
    }
}

/// How a camera smooths edges.
fn smooth_edges(camera: &mut EntityCommands, quality: RenderQuality) {
    match quality {
        RenderQuality::Low => camera.insert((
            Msaa::Off,
            Smaa {
                preset: SmaaPreset::Low,
            },
        )),
        RenderQuality::High => camera.remove::<Smaa>().insert(Msaa::Sample4),
    };
}

/// Gives a camera its film and the light of the room.
fn equip_camera(
    added: On<Add, Camera3d>,
    mut commands: Commands,
    mut images: ResMut<Assets<Image>>,
    quality: Res<RenderQuality>,
) {
    let mut camera = commands.entity(added.entity);
    camera.insert((
        studio(&mut images),
        Tonemapping::AcesFitted,
        Exposure { ev100: 6.75 },
        // Three lamps light everything: sorting them into cells would cost more than it saves.
        ClusterConfig::Single,
    ));
    smooth_edges(&mut camera, *quality);
}

/// The processor tells the graphics card which lamps there are: it is at once, three lamps are no work, and software
/// drivers lose lamps when they do it.
fn sort_lamps_here(settings: Option<ResMut<GlobalClusterSettings>>) {
    if let Some(mut settings) = settings {
        settings.gpu_clustering = None;
    }
}

/// A lamp over the table.
#[derive(Component)]
struct Lamp;

/// Hangs a row of lamps that suits the length of the table.
fn hang_lamps(
    mut commands: Commands,
    playfield: Res<Playfield>,
    quality: Res<RenderQuality>,
    old: Query<Entity, With<Lamp>>,
    mut hung: Local<Option<(f64, f64, RenderQuality)>>,
) {
    let size = (playfield.table.length, playfield.table.width, *quality);
    if hung.replace(size) == Some(size) {
        return;
    }
    for lamp in &old {
        commands.entity(lamp).despawn();
    }
    let length = size.0.max(0.3) as f32;
    // The middle lamp comes first: with one shadow, it is the one below the middle lamp.
    let places = [0.0, -0.36, 0.36];
    let reach = (0.5 * size.0.max(size.1) as f32).max(1.2);
    let height = LAMP_HEIGHT * (reach / 1.27).max(1.0);
    for (i, place) in places.into_iter().enumerate() {
        let share = match (*quality, i) {
            (RenderQuality::Low, 0) => 2.0,
            (RenderQuality::Low, _) => 0.5,
            (RenderQuality::High, _) => 1.0,
        };
        commands.spawn((
            Lamp,
            SpotLight {
                color: Color::srgb(1.0, 0.94, 0.84),
                intensity: 5_200.0 * share * (height * height) / (LAMP_HEIGHT * LAMP_HEIGHT),
                range: 4.0 * height,
                radius: 0.06,
                shadow_maps_enabled: i < quality.shadows(),
                shadow_depth_bias: 0.004,
                shadow_normal_bias: 1.2,
                shadow_map_near_z: 0.3 * height,
                outer_angle: 0.95,
                inner_angle: 0.75,
                ..default()
            },
            Transform::from_xyz(place * length, height, 0.0)
                .looking_at(Vec3::new(place * length, 0.0, 0.0), Vec3::X),
        ));
    }
}

/// A dark floor that fades into the room, and the walls behind.
fn walls(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
) {
    // Radius, height and light of each ring.
    let floor = [
        (0.0, -FLOOR, 1.0),
        (1.5, -FLOOR, 0.8),
        (2.5, -FLOOR, 0.4),
        (4.0, -FLOOR, 0.12),
        (7.0, -FLOOR, 0.0),
    ];
    let wall = [
        (7.0, -FLOOR, 0.10),
        (7.0, 0.1, 0.55),
        (7.0, 1.0, 1.0),
        (7.0, 2.2, 0.75),
        (7.0, 4.0, 0.12),
        (0.0, 8.0, 0.0),
    ];
    let rough = StandardMaterial {
        perceptual_roughness: 0.95,
        reflectance: 0.0,
        cull_mode: None,
        ..default()
    };
    let glow = StandardMaterial {
        unlit: true,
        cull_mode: None,
        ..default()
    };
    for (mesh, material) in [
        (rings(&floor, Vec3::new(0.10, 0.075, 0.06)), rough),
        (rings(&wall, Vec3::new(0.022, 0.0185, 0.016)), glow),
    ] {
        commands.spawn((
            Wall,
            Mesh3d(meshes.add(mesh)),
            MeshMaterial3d(materials.add(material)),
            NotShadowCaster,
            twin::both(),
        ));
    }
}

/// The floor or the walls.
#[derive(Component)]
struct Wall;

/// Makes the room as large as a table that would not fit into it asks; the floor stays where it is.
fn widen(playfield: Res<Playfield>, mut walls: Query<&mut Transform, With<Wall>>) {
    let reach = 0.5 * playfield.table.length.max(playfield.table.width) as f32;
    // The ceiling stays above the eye that sees the whole table from overhead.
    let scale = (1.2 * reach - 1.4).max(1.0);
    for mut wall in &mut walls {
        *wall = Transform::from_xyz(0.0, FLOOR as f32 * (scale - 1.0), 0.0)
            .with_scale(Vec3::splat(scale));
    }
}

/// Rings around the y axis, joined, each with its share of a colour.
fn rings(rings: &[(f64, f64, f32)], colour: Vec3) -> Mesh {
    const SIDES: u32 = 48;
    let (mut positions, mut colours, mut indices) = (Vec::new(), Vec::new(), Vec::new());
    for (ring, &(radius, y, light)) in rings.iter().enumerate() {
        for i in 0..=SIDES {
            let turn = std::f32::consts::TAU * i as f32 / SIDES as f32;
            let at = Vec2::from_angle(turn) * radius as f32;
            positions.push([at.x, y as f32, at.y]);
            colours.push((light * colour).extend(1.0).to_array());
            if ring > 0 && i > 0 {
                let row = SIDES + 1;
                let c = ring as u32 * row + i;
                indices.extend([c, c - 1, c - row - 1, c, c - row - 1, c - row]);
            }
        }
    }
    Mesh::new(
        PrimitiveTopology::TriangleList,
        RenderAssetUsages::RENDER_WORLD,
    )
    .with_inserted_attribute(
        Mesh::ATTRIBUTE_NORMAL,
        vec![[0.0, 1.0, 0.0]; positions.len()],
    )
    .with_inserted_attribute(Mesh::ATTRIBUTE_POSITION, positions)
    .with_inserted_attribute(Mesh::ATTRIBUTE_COLOR, colours)
    .with_inserted_indices(Indices::U32(indices))
}
