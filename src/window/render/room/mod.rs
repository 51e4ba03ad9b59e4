//! The room: the lamp over the table, walls and floor, and the film in the camera.

mod bar;
mod bottles;
mod lamps;
mod surfaces;
mod walls;

pub(in crate::window::render) use lamps::Fixture;
pub(in crate::window::render) use walls::seen_towards;

use bevy::anti_alias::smaa::{Smaa, SmaaPreset};
use bevy::camera::{Exposure, Hdr};
use bevy::core_pipeline::tonemapping::Tonemapping;
use bevy::light::cluster::{ClusterConfig, GlobalClusterSettings};
use bevy::light::{DirectionalLightShadowMap, PointLightShadowMap};
use bevy::pbr::{ScreenSpaceAmbientOcclusion, ScreenSpaceAmbientOcclusionQualityLevel};
use bevy::post_process::bloom::Bloom;
use bevy::prelude::*;
use bevy::render::renderer::RenderDevice;

use crate::game::settings::Settings;
use crate::sim::playfield::Playfield;
use crate::window::render::Drawing;
use crate::window::render::quality::RenderQuality;
use crate::window::render::studio::Studio;

/// What surrounds the lit table.
const DARK: Color = Color::srgb(0.018, 0.017, 0.018);

pub(super) fn plugin(app: &mut App) {
    let quality = *app.world().resource::<RenderQuality>();
    app.init_resource::<Fixture>()
        .init_resource::<Studio>()
        .insert_resource(ClearColor(DARK))
        .insert_resource(GlobalAmbientLight::NONE)
        .insert_resource(DirectionalLightShadowMap {
            size: quality.shadow_map(),
        })
        // No lamp of ours shines all around; Bevy would keep six large faces for it.
        .insert_resource(PointLightShadowMap { size: 16 })
        .add_observer(equip_camera)
        .add_systems(
            Startup,
            (surfaces::build, bar::build, sort_lamps_here)
                .chain()
                .in_set(Drawing::Room),
        )
        .add_systems(
            RunFixedMainLoop,
            (
                suit_cameras.run_if(resource_exists_and_changed::<RenderQuality>),
                lamps::hang.run_if(
                    resource_exists_and_changed::<Playfield>
                        .or_else(resource_exists_and_changed::<Settings>)
                        .or_else(resource_exists_and_changed::<RenderQuality>),
                ),
                surfaces::widen.run_if(resource_exists_and_changed::<Playfield>),
                lamps::step_aside,
                bar::step_aside,
            )
                .chain()
                .in_set(Drawing::Room),
        );
}

/// Cameras and shadows that are there already follow another quality.
fn suit_cameras(
    mut commands: Commands,
    quality: Res<RenderQuality>,
    device: Option<Res<RenderDevice>>,
    mut shadows: ResMut<DirectionalLightShadowMap>,
    cameras: Query<Entity, With<Camera3d>>,
) {
    if shadows.size != quality.shadow_map() {
        shadows.size = quality.shadow_map();
    }
    for camera in &cameras {
        let occludes = occludes(*quality, device.as_deref());
        load_film(&mut commands.entity(camera), *quality, occludes);
    }
}

/// Whether this device can find out which surfaces shade each other.
fn occludes(quality: RenderQuality, device: Option<&RenderDevice>) -> bool {
    if quality < RenderQuality::Ultra {
        return false;
    }
    let textures = device.map_or(0, |device| {
        device.limits().max_storage_textures_per_shader_stage
    });
    if textures < 5 {
        warn!(
            "no ambient occlusion: it writes 5 textures at a time, this adapter {textures}; \
             the picture is that of High"
        );
    }
    textures >= 5
}

/// How a camera smooths edges, and what it does with light that is brighter than the screen.
fn load_film(camera: &mut EntityCommands, quality: RenderQuality, occludes: bool) {
    camera.remove::<(Smaa, ScreenSpaceAmbientOcclusion)>();
    if quality == RenderQuality::Low {
        camera.remove::<(Hdr, Bloom)>().insert((
            Msaa::Off,
            Smaa {
                preset: SmaaPreset::Low,
            },
        ));
        return;
    }
    camera.insert((
        Hdr,
        Bloom {
            intensity: 0.07,
            ..Bloom::NATURAL
        },
    ));
    if occludes {
        // Ambient occlusion works on single samples.
        camera.insert((
            Msaa::Off,
            Smaa {
                preset: SmaaPreset::Ultra,
            },
            ScreenSpaceAmbientOcclusion {
                quality_level: ScreenSpaceAmbientOcclusionQualityLevel::High,
                constant_object_thickness: 0.05,
            },
        ));
    } else {
        camera.insert(Msaa::Sample4);
    }
}

/// Gives a camera its film and the light of the room.
fn equip_camera(
    added: On<Add, Camera3d>,
    mut commands: Commands,
    studio: Res<Studio>,
    device: Option<Res<RenderDevice>>,
    quality: Res<RenderQuality>,
) {
    let mut camera = commands.entity(added.entity);
    camera.insert((
        studio.light(),
        Tonemapping::AcesFitted,
        Exposure { ev100: 6.5 },
        // Three lamps light everything: sorting them into cells would cost more than it saves.
        ClusterConfig::Single,
    ));
    let occludes = occludes(*quality, device.as_deref());
    load_film(&mut camera, *quality, occludes);
}

/// The processor tells the graphics card which lamps there are: it is at once, three lamps are no work, and software
/// drivers lose lamps when they do it.
fn sort_lamps_here(settings: Option<ResMut<GlobalClusterSettings>>) {
    if let Some(mut settings) = settings {
        settings.gpu_clustering = None;
    }
}
