//! What each half of a shared picture shows, in words below it.

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

use crate::game::twin::{Twin, TwinLaws};
use crate::game::view::{Beside, CameraMode, FirstEye, SceneCamera, SceneCameras, View};
use crate::window::language::Language;

/// Points between the words and the lower edge.
const ABOVE: f32 = 104.0;

/// Paints the words below the panels.
pub(super) fn show(
    mut contexts: EguiContexts,
    view: Res<View>,
    cameras: Res<SceneCameras>,
    twin: Res<Twin>,
    language: Res<Language>,
    eyes: Query<(&Camera, Has<FirstEye>), With<Camera3d>>,
) -> Result {
    let awake = || eyes.iter().filter(|(camera, _)| camera.is_active);
    if view.beside == Beside::Nothing || awake().count() < 2 {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let zoom = context.zoom_factor();
    let painter = context.layer_painter(egui::LayerId::background());
    for (camera, is_first) in awake() {
        let Some(half) = camera.logical_viewport_rect() else {
            continue;
        };
        let words = match view.beside {
            Beside::Camera(mode) if !is_first => seen_from(mode, &cameras, &language),
            Beside::Laws => by_laws(&twin, is_first, &language),
            _ => seen_from(view.camera, &cameras, &language),
        };
        // Above the line of status and the bar of the replay.
        let middle = egui::pos2(half.center().x / zoom, half.max.y / zoom - ABOVE);
        let font = egui::FontId::proportional(15.0);
        let text = painter.layout_no_wrap(words, font, egui::Color32::WHITE);
        let frame =
            egui::Align2::CENTER_BOTTOM.anchor_size(middle, text.size() + egui::vec2(16.0, 8.0));
        painter.rect_filled(frame, 4.0, egui::Color32::from_black_alpha(170));
        painter.galley(frame.min + egui::vec2(8.0, 4.0), text, egui::Color32::WHITE);
    }
    Ok(())
}

fn seen_from(mode: CameraMode, cameras: &SceneCameras, language: &Language) -> String {
    let key = match mode {
        CameraMode::BehindCue => "camera-behind",
        CameraMode::Overhead => "camera-overhead",
        CameraMode::Orbit => "camera-free",
        CameraMode::Follow => "camera-follow",
        CameraMode::Scene(place) => match cameras.0.get(place) {
            Some(SceneCamera::Follow(ball)) => {
                return language.with("camera-of-ball", &[("ball", ball.as_str().into())]);
            }
            _ => "camera-of-scene",
        },
    };
    language.text(key).to_owned()
}

fn by_laws(twin: &Twin, is_first: bool, language: &Language) -> String {
    if !is_first && let Some(reason) = &twin.failed {
        return language.with("half-failed", &[("reason", reason.as_str().into())]);
    }
    let is_coursework = (twin.laws == TwinLaws::Coursework) != is_first;
    let key = if is_coursework {
        "half-coursework"
    } else {
        "half-real"
    };
    language.text(key).to_owned()
}
