//! The shades of a crowd on the cloth: a second draw of the same triangles, where there are few enough.

use bevy::asset::embedded_asset;
use bevy::light::{NotShadowCaster, NotShadowReceiver};
use bevy::prelude::*;
use bevy::reflect::TypePath;
use bevy::render::render_resource::AsBindGroup;
use bevy::render::storage::ShaderBuffer;
use bevy::shader::ShaderRef;

use crate::window::RenderQuality;

/// The material of all shades.
#[derive(Asset, TypePath, AsBindGroup, Clone, Debug)]
pub(super) struct Shades {
    /// Radius of a ball, m.
    #[uniform(0)]
    pub radius: f32,
    #[storage(1, read_only)]
    pub balls: Handle<ShaderBuffer>,
}

impl Material for Shades {
    fn vertex_shader() -> ShaderRef {
        "embedded://masse/window/crowd/shades.wgsl".into()
    }

    fn fragment_shader() -> ShaderRef {
        "embedded://masse/window/crowd/shades.wgsl".into()
    }

    fn alpha_mode(&self) -> AlphaMode {
        AlphaMode::Blend
    }

    fn depth_bias(&self) -> f32 {
        10.0
    }

    fn enable_prepass() -> bool {
        false
    }

    fn enable_shadows() -> bool {
        false
    }
}

pub(super) fn plugin(app: &mut App) {
    embedded_asset!(app, "shades.wgsl");
    app.add_plugins(MaterialPlugin::<Shades>::default());
}

/// Most balls that have shades: of more, nobody sees them, and they take as long to draw as the balls.
fn most(quality: RenderQuality) -> usize {
    match quality {
        RenderQuality::Low => 20_000,
        RenderQuality::Medium => 100_000,
        RenderQuality::High | RenderQuality::Ultra => 200_000,
    }
}

/// The entity of the shades, for so many balls.
pub(super) fn of(
    quality: RenderQuality,
    count: usize,
    mesh: Handle<Mesh>,
    material: impl FnOnce() -> Handle<Shades>,
) -> Option<impl Bundle> {
    (count <= most(quality)).then(|| {
        (
            Name::new("shades of the crowd"),
            Mesh3d(mesh),
            MeshMaterial3d(material()),
            Transform::default(),
            bevy::camera::visibility::NoFrustumCulling,
            NotShadowCaster,
            NotShadowReceiver,
        )
    })
}
