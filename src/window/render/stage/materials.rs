//! The materials of balls, cloth and frame: Bevy's own, with shaders that know the stage.

use bevy::mesh::MeshVertexBufferLayoutRef;
use bevy::pbr::{
    ExtendedMaterial, MaterialExtension, MaterialExtensionKey, MaterialExtensionPipeline,
};
use bevy::prelude::*;
use bevy::reflect::TypePath;
use bevy::render::render_resource::{
    AsBindGroup, RenderPipelineDescriptor, SpecializedMeshPipelineError,
};
use bevy::render::storage::ShaderBuffer;
use bevy::shader::ShaderRef;

/// Polished resin.
pub(in crate::window::render) type BallMaterial = ExtendedMaterial<StandardMaterial, Gloss>;

/// Cloth.
pub(in crate::window::render) type ClothMaterial = ExtendedMaterial<StandardMaterial, Felt>;

/// Lacquered wood, leather, metal.
pub(in crate::window::render) type PolishMaterial = ExtendedMaterial<StandardMaterial, Polish>;

/// Whether shaders follow rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::window::render) struct Traced(bool);

/// What a ball knows of what is around it.
#[derive(Asset, TypePath, AsBindGroup, Clone, Debug)]
#[bind_group_data(Traced)]
pub(in crate::window::render) struct Gloss {
    #[storage(100, read_only)]
    pub stage: Handle<ShaderBuffer>,
    #[texture(101, dimension = "cube")]
    #[sampler(102)]
    pub room: Handle<Image>,
    pub traced: bool,
}

/// What the cloth knows of what is around it.
#[derive(Asset, TypePath, AsBindGroup, Clone, Debug)]
#[bind_group_data(Traced)]
pub(in crate::window::render) struct Felt {
    #[storage(100, read_only)]
    pub stage: Handle<ShaderBuffer>,
    #[texture(101, dimension = "cube")]
    #[sampler(102)]
    pub room: Handle<Image>,
    /// How light the cloth is, and how much chalk lies there.
    #[texture(103)]
    #[sampler(104)]
    pub wear: Handle<Image>,
    pub traced: bool,
}

/// What wood, leather and metal know of what is around them.
#[derive(Asset, TypePath, AsBindGroup, Clone, Debug)]
#[bind_group_data(Traced)]
pub(in crate::window::render) struct Polish {
    #[storage(100, read_only)]
    pub stage: Handle<ShaderBuffer>,
    #[texture(101, dimension = "cube")]
    #[sampler(102)]
    pub room: Handle<Image>,
    pub traced: bool,
}

impl From<&Polish> for Traced {
    fn from(polish: &Polish) -> Self {
        Self(polish.traced)
    }
}

impl From<&Gloss> for Traced {
    fn from(gloss: &Gloss) -> Self {
        Self(gloss.traced)
    }
}

impl From<&Felt> for Traced {
    fn from(felt: &Felt) -> Self {
        Self(felt.traced)
    }
}

impl Gloss {
    /// The same for what the frame is made of.
    pub fn polish(&self) -> Polish {
        Polish {
            stage: self.stage.clone(),
            room: self.room.clone(),
            traced: self.traced,
        }
    }

    /// The same for cloth, with this wear.
    pub fn felt(self, wear: Handle<Image>) -> Felt {
        Felt {
            stage: self.stage,
            room: self.room,
            wear,
            traced: self.traced,
        }
    }
}

impl MaterialExtension for Gloss {
    fn fragment_shader() -> ShaderRef {
        "embedded://masse/window/render/stage/ball.wgsl".into()
    }

    fn specialize(
        _: &MaterialExtensionPipeline,
        descriptor: &mut RenderPipelineDescriptor,
        _: &MeshVertexBufferLayoutRef,
        key: MaterialExtensionKey<Self>,
    ) -> Result<(), SpecializedMeshPipelineError> {
        define(descriptor, key.bind_group_data);
        Ok(())
    }
}

impl MaterialExtension for Polish {
    fn fragment_shader() -> ShaderRef {
        "embedded://masse/window/render/stage/polish.wgsl".into()
    }

    fn specialize(
        _: &MaterialExtensionPipeline,
        descriptor: &mut RenderPipelineDescriptor,
        _: &MeshVertexBufferLayoutRef,
        key: MaterialExtensionKey<Self>,
    ) -> Result<(), SpecializedMeshPipelineError> {
        define(descriptor, key.bind_group_data);
        Ok(())
    }
}

impl MaterialExtension for Felt {
    fn fragment_shader() -> ShaderRef {
        "embedded://masse/window/render/stage/cloth.wgsl".into()
    }

    fn specialize(
        _: &MaterialExtensionPipeline,
        descriptor: &mut RenderPipelineDescriptor,
        _: &MeshVertexBufferLayoutRef,
        key: MaterialExtensionKey<Self>,
    ) -> Result<(), SpecializedMeshPipelineError> {
        define(descriptor, key.bind_group_data);
        Ok(())
    }
}

fn define(descriptor: &mut RenderPipelineDescriptor, Traced(traced): Traced) {
    if let Some(fragment) = descriptor.fragment.as_mut().filter(|_| traced) {
        fragment.shader_defs.push("TRACED".into());
    }
}
