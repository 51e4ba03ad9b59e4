//! Numbers that stand upright over the balls, for whoever cannot tell balls by their colours. Solids have a round frame,
//! stripes a square one with bars, other balls the letters their names begin with.

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

use crate::game::settings::Settings;
use crate::game::view::{Beside, FirstEye, View};
use crate::sim::components::{BallName, MotionKind, Radius};

/// What a label says and whether it is that of a stripe.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Label {
    text: String,
    is_stripe: bool,
    is_number: bool,
}

/// The label of a ball; the cue ball has none.
fn label(name: &str) -> Option<Label> {
    if name == "cue" {
        return None;
    }
    let number = name.parse::<u8>().ok();
    Some(Label {
        text: match number {
            Some(number) => number.to_string(),
            None => name.chars().take(2).collect(),
        },
        is_stripe: number.is_some_and(|number| (9..=15).contains(&number)),
        is_number: number.is_some(),
    })
}

/// Paints the labels below the panels.
pub(super) fn show(
    mut contexts: EguiContexts,
    settings: Res<Settings>,
    view: Res<View>,
    cameras: Query<(&Camera, &GlobalTransform, Has<FirstEye>), With<Camera3d>>,
    balls: Query<(&GlobalTransform, &BallName, &Radius, &MotionKind)>,
) -> Result {
    if !settings.marks.labels {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    // The picture is measured in pixels of the window, panels in points of the player's size.
    let zoom = context.zoom_factor();
    let point = |at: Vec2| egui::pos2(at.x / zoom, at.y / zoom);
    let pairs = cameras
        .iter()
        .flat_map(|eye| balls.iter().map(move |ball| (eye, ball)));
    for ((camera, eye, is_first), (place, name, radius, motion)) in pairs {
        // The balls of other laws lie elsewhere.
        if !camera.is_active || (!is_first && view.beside == Beside::Laws) {
            continue;
        }
        let Some(half) = camera.logical_viewport_rect() else {
            continue;
        };
        let Some(label) = label(&name.0).filter(|_| motion.0.in_play()) else {
            continue;
        };
        let center = place.translation();
        let up = center + radius.0 as f32 * eye.up();
        let (Ok(at), Ok(edge)) = (
            camera.world_to_viewport(eye, center),
            camera.world_to_viewport(eye, up),
        ) else {
            continue;
        };
        // The colour of the ball stays to be seen around it where the ball is large enough.
        let size = (0.5 * at.distance(edge) / zoom).clamp(5.0, 16.0);
        let half = egui::Rect::from_min_max(point(half.min), point(half.max));
        let painter = context.layer_painter(egui::LayerId::background());
        paint(&painter.with_clip_rect(half), point(at), size, &label);
    }
    Ok(())
}

/// Paints a label around a point, with half its height.
fn paint(painter: &egui::Painter, at: egui::Pos2, half: f32, label: &Label) {
    use egui::{Align2, Color32, CornerRadius, FontId, Rect, Stroke, StrokeKind, vec2};
    let line = Stroke::new(1.5, Color32::BLACK);
    if label.is_stripe {
        let frame = Rect::from_center_size(at, vec2(2.3 * half, 2.0 * half));
        painter.rect(
            frame,
            CornerRadius::ZERO,
            Color32::WHITE,
            line,
            StrokeKind::Outside,
        );
        for y in [frame.top() - 2.5, frame.bottom() + 2.5] {
            painter.hline(frame.x_range(), y, Stroke::new(2.5, Color32::WHITE));
        }
    } else if label.is_number {
        painter.circle(at, 1.15 * half, Color32::WHITE, line);
    } else {
        let frame = Rect::from_center_size(at, vec2(2.6 * half, 2.0 * half));
        painter.rect(
            frame,
            CornerRadius::same(3),
            Color32::BLACK,
            Stroke::new(1.0, Color32::WHITE),
            StrokeKind::Outside,
        );
    }
    let ink = if label.is_number {
        Color32::BLACK
    } else {
        Color32::WHITE
    };
    let font = FontId::proportional(1.6 * half);
    painter.text(at, Align2::CENTER_CENTER, &label.text, font, ink);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solids_stripes_and_others_are_told_apart_without_colours() {
        let of = |name: &str| label(name).expect("it has a label");
        assert_eq!(label("cue"), None);
        assert!(!of("8").is_stripe && of("9").is_stripe && of("15").is_stripe);
        assert_eq!(of("red 3").text, "re");
        assert!(!of("red 3").is_number && of("10").is_number);
        assert_eq!(of("10").text, "10");
    }
}
