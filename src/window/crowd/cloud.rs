//! One draw for all balls: a triangle each, on which the shader finds the sphere. What differs from ball to ball lies in
//! one buffer on the graphics card.

use std::time::Instant;

use bevy::asset::{RenderAssetUsages, embedded_asset};
use bevy::camera::visibility::NoFrustumCulling;
use bevy::light::NotShadowCaster;
use bevy::mesh::PrimitiveTopology;
use bevy::prelude::*;
use bevy::reflect::TypePath;
use bevy::render::render_asset::RenderAssets;
use bevy::render::render_resource::{AsBindGroup, ShaderType};
use bevy::render::renderer::RenderQueue;
use bevy::render::storage::{GpuShaderBuffer, ShaderBuffer};
use bevy::render::{Extract, ExtractSchedule, RenderApp};
use bevy::shader::ShaderRef;

use crate::game::watch::{Colouring, Watch};
use crate::window::RenderQuality;
use crate::window::crowd::pack::Packed;
use crate::window::crowd::shade::{self, Shades};

/// What all balls share in the shader.
#[derive(ShaderType, Clone, Copy, Debug, Default, PartialEq)]
struct Paint {
    radius: f32,
    colouring: u32,
    chosen: u32,
    marked: u32,
}

/// The material of a crowd.
#[derive(Asset, TypePath, AsBindGroup, Clone, Debug)]
pub(super) struct Spheres {
    #[uniform(0)]
    paint: Paint,
    #[storage(1, read_only)]
    balls: Handle<ShaderBuffer>,
}

impl Material for Spheres {
    fn vertex_shader() -> ShaderRef {
        "embedded://masse/window/crowd/spheres.wgsl".into()
    }

    fn fragment_shader() -> ShaderRef {
        "embedded://masse/window/crowd/spheres.wgsl".into()
    }

    fn enable_prepass() -> bool {
        false
    }

    fn enable_shadows() -> bool {
        false
    }
}

/// The crowd as it is drawn.
#[derive(Component)]
pub(super) struct Cloud {
    count: usize,
    radius: f32,
    material: Handle<Spheres>,
}

/// Adds the material and the way of its data to the graphics card.
pub(super) fn plugin(app: &mut App) {
    embedded_asset!(app, "spheres.wgsl");
    app.add_plugins(MaterialPlugin::<Spheres>::default());
    // Where nothing is drawn there is no such app.
    if let Some(render) = app.get_sub_app_mut(RenderApp) {
        render.add_systems(ExtractSchedule, upload);
    }
}

/// Copies the sheet of this frame into the buffer, as it is: no memory is taken for it.
fn upload(
    packed: Extract<Res<Packed>>,
    buffers: Res<RenderAssets<GpuShaderBuffer>>,
    queue: Res<RenderQueue>,
) {
    let Some(id) = packed.buffer else { return };
    if !packed.fresh {
        return;
    }
    // A new buffer is made with its contents.
    let Some(buffer) = buffers.get(id) else {
        return;
    };
    if buffer.buffer.size() == packed.sheet.bytes().len() as u64 {
        let start = Instant::now();
        queue.write_buffer(&buffer.buffer, 0, packed.sheet.bytes());
        packed.upload.set(start.elapsed());
    }
}

/// Makes the draws anew if the number of balls has changed, and takes it away with the crowd.
#[expect(clippy::too_many_arguments, reason = "four stores of assets")]
pub(super) fn assemble(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<Spheres>>,
    mut shades: ResMut<Assets<Shades>>,
    mut buffers: ResMut<Assets<ShaderBuffer>>,
    mut packed: ResMut<Packed>,
    watch: Res<Watch>,
    quality: Res<RenderQuality>,
    clouds: Query<(Entity, &Cloud)>,
) {
    let count = packed.sheet.count();
    let old = clouds.iter().next();
    let paint = Paint::of(&packed, &watch);
    if let Some((entity, cloud)) = old {
        if cloud.count == count && cloud.radius == paint.radius {
            // Only a real change binds the material again.
            if materials
                .get(&cloud.material)
                .is_some_and(|known| known.paint != paint)
                && let Some(mut material) = materials.get_mut(&cloud.material)
            {
                material.paint = paint;
            }
            return;
        }
        commands.entity(entity).despawn();
        packed.buffer = None;
    }
    if count == 0 {
        return;
    }
    let contents = ShaderBuffer::new(packed.sheet.bytes(), RenderAssetUsages::RENDER_WORLD);
    let balls = buffers.add(contents);
    packed.buffer = Some(balls.id());
    let mesh = meshes.add(triangles(count));
    let shade = shade::of(*quality, count, mesh.clone(), || {
        shades.add(Shades {
            radius: paint.radius,
            balls: balls.clone(),
        })
    });
    let material = materials.add(Spheres { paint, balls });
    let mut cloud = commands.spawn((
        Name::new("crowd"),
        Cloud {
            count,
            radius: paint.radius,
            material: material.clone(),
        },
        Mesh3d(mesh),
        MeshMaterial3d(material),
        Transform::default(),
        NoFrustumCulling,
        NotShadowCaster,
    ));
    if let Some(shade) = shade {
        cloud.with_child(shade);
    }
}

impl Paint {
    fn of(packed: &Packed, watch: &Watch) -> Self {
        Self {
            radius: packed.radius,
            colouring: match watch.colouring {
                Colouring::Speed => 0,
                Colouring::Spin => 1,
                Colouring::Number => 2,
            },
            chosen: watch
                .chosen
                .and_then(|number| u32::try_from(number).ok())
                .unwrap_or(u32::MAX),
            marked: u32::from(packed.spins),
        }
    }
}

/// A triangle around the unit circle for each ball: x and y of the corner, and the number of the ball, which is exact in
/// f32 up to 16 million.
fn triangles(count: usize) -> Mesh {
    let wide = 3.0_f32.sqrt();
    let corners = [(0.0, 2.0), (-wide, -1.0), (wide, -1.0)];
    let positions: Vec<[f32; 3]> = (0..count)
        .flat_map(|number| corners.map(|(x, y)| [x, y, number as f32]))
        .collect();
    Mesh::new(
        PrimitiveTopology::TriangleList,
        RenderAssetUsages::RENDER_WORLD,
    )
    .with_inserted_attribute(Mesh::ATTRIBUTE_POSITION, positions)
}
