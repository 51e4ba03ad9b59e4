//! The panels have a camera of their own, over those that look at the table: it always draws into the whole window, however
//! the picture is shared.

use bevy::camera::CameraOutputMode;
use bevy::camera::visibility::RenderLayers;
use bevy::prelude::*;
use bevy::render::render_resource::BlendState;
use bevy_egui::{EguiGlobalSettings, EguiStartupSet, PrimaryEguiContext};

/// After both eyes.
const ORDER: isize = 10;

pub(in crate::window) fn plugin(app: &mut App) {
    if let Some(mut settings) = app.world_mut().get_resource_mut::<EguiGlobalSettings>() {
        settings.auto_create_primary_context = false;
    }
    app.add_systems(PreStartup, spawn.before(EguiStartupSet::InitContexts));
}

fn spawn(mut commands: Commands) {
    commands.spawn((
        Name::new("panels"),
        Camera2d,
        Camera {
            order: ORDER,
            clear_color: ClearColorConfig::Custom(Color::NONE),
            output_mode: CameraOutputMode::Write {
                // The panels are drawn onto nothing, which leaves their colours multiplied by how much they cover.
                blend_state: Some(BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                clear_color: ClearColorConfig::None,
            },
            ..default()
        },
        Msaa::Off,
        RenderLayers::none(),
        PrimaryEguiContext,
    ));
}
