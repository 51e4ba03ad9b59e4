//! The panels have a camera of their own, over those that look at the table: it always draws into the whole window, however
//! the picture is shared. What they cover is noted, so that the table can be shown beside them.

use bevy::camera::CameraOutputMode;
use bevy::camera::visibility::RenderLayers;
use bevy::prelude::*;
use bevy::render::render_resource::BlendState;
use bevy_egui::{
    EguiContexts, EguiGlobalSettings, EguiPrimaryContextPass, EguiStartupSet, PrimaryEguiContext,
    egui,
};

use crate::window::{WindowSystems, at_table};

/// After both eyes.
const ORDER: isize = 10;

/// What panels cover, in shares of the window from its upper left corner. It stays as it was while the menu is open.
#[derive(Resource, Debug, Default)]
pub(super) struct Covered(pub Vec<Rect>);

pub(in crate::window) fn plugin(app: &mut App) {
    if let Some(mut settings) = app.world_mut().get_resource_mut::<EguiGlobalSettings>() {
        settings.auto_create_primary_context = false;
    }
    app.add_systems(PreStartup, spawn.before(EguiStartupSet::InitContexts))
        .add_systems(
            EguiPrimaryContextPass,
            note.after(WindowSystems::Overlay)
                .before(WindowSystems::Photo)
                .run_if(at_table()),
        );
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

/// What lies over the picture of one camera, in shares of that picture.
pub(super) fn over(covered: &Covered, camera: &Camera) -> Vec<Rect> {
    let Some(half) = &camera.viewport else {
        return covered.0.clone();
    };
    let Some(window) = camera.physical_target_size() else {
        return Vec::new();
    };
    let window = window.as_vec2();
    let (corner, size) = (
        half.physical_position.as_vec2(),
        half.physical_size.as_vec2(),
    );
    let within = |at: Vec2| (at * window - corner) / size;
    covered
        .0
        .iter()
        .map(|panel| Rect::from_corners(within(panel.min), within(panel.max)))
        .collect()
}

/// Notes where the panels lie. What is told for a while, hints and lists that hang from a button lie over them and pass.
fn note(mut contexts: EguiContexts, mut covered: ResMut<Covered>) -> Result {
    let context = contexts.ctx_mut()?;
    let window = context.content_rect();
    let share = |at: egui::Pos2| {
        let at = (at - window.min) / window.size();
        Vec2::new(at.x, at.y)
    };
    let mut now: Vec<Rect> = context.memory(|memory| {
        let areas = memory.areas();
        let panels = areas.visible_layer_ids().into_iter();
        panels
            .filter(|layer| layer.order == egui::Order::Middle)
            .filter_map(|layer| memory.area_rect(layer.id))
            .filter(|panel| panel.is_finite() && panel.is_positive())
            .map(|panel| Rect::from_corners(share(panel.min), share(panel.max)))
            .collect()
    });
    // They come in no order.
    now.sort_by(|a, b| {
        let key = |rect: &Rect| [rect.min.x, rect.min.y, rect.max.x, rect.max.y];
        let pairs = key(a).into_iter().zip(key(b));
        pairs
            .map(|(a, b)| a.total_cmp(&b))
            .fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
    });
    if covered.0 != now {
        covered.0 = now;
    }
    Ok(())
}
