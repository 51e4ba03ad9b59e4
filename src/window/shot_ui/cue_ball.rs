//! The cue ball as the shooter sees it, with the tip on it.

use bevy_egui::egui::{self, Color32, Sense, Stroke, pos2, vec2};

use crate::game::aim::Aim;
use crate::physics::cue::{Cue, Shot};

/// Radius of the picture in points.
const RADIUS: f32 = 62.0;
/// How much slower the tip follows a drag with Shift.
const FINE: f32 = 0.1;

/// Paints the ball of this radius in m with the tip where this shot holds it, the circle beyond which the tip slips, and the
/// reach of a player. The tip is round, so its middle lies farther out than the contact. A click or a drag gives a new
/// contact to the side and up, in R; a double click the centre.
#[expect(
    clippy::cast_possible_truncation,
    reason = "pixels begin here: f32 is enough for a picture"
)]
pub(super) fn show(ui: &mut egui::Ui, shot: &Shot, cue: &Cue, radius: f64) -> Option<(f64, f64)> {
    // From contacts to places of the tip.
    let out = 1.0 + cue.tip_radius / radius;
    let (side, height) = (out * shot.side, out * shot.height);
    let (response, painter) = ui.allocate_painter(
        egui::Vec2::splat(2.0 * RADIUS + 4.0),
        Sense::click_and_drag(),
    );
    let center = response.rect.center();
    let thin = Stroke::new(1.0, Color32::from_gray(150));
    painter.circle(center, RADIUS, Color32::from_rgb(244, 240, 226), thin);
    let cross = Stroke::new(1.0, Color32::from_gray(200));
    painter.line_segment(
        [center - vec2(RADIUS, 0.0), center + vec2(RADIUS, 0.0)],
        cross,
    );
    painter.line_segment(
        [center - vec2(0.0, RADIUS), center + vec2(0.0, RADIUS)],
        cross,
    );
    painter.circle_stroke(center, RADIUS * (out * Aim::TOP_OFFSET) as f32, thin);
    let limit = Stroke::new(1.5, Color32::from_rgb(200, 60, 50));
    painter.circle_stroke(center, RADIUS * (out * cue.miscue_offset) as f32, limit);

    let tip = center + RADIUS * vec2(side as f32, -(height as f32));
    let slips = shot.offset() > cue.miscue_offset;
    let fill = if slips {
        Color32::from_rgb(200, 60, 50)
    } else {
        Color32::from_rgb(40, 90, 170)
    };
    painter.circle(
        tip,
        RADIUS * (0.5 * cue.stick.tip_width / radius) as f32,
        fill.gamma_multiply(0.7),
        Stroke::new(1.0, Color32::BLACK),
    );
    painter.circle_filled(tip, 1.5, Color32::WHITE);

    if response.double_clicked() {
        return Some((0.0, 0.0));
    }
    let fine = ui.input(|input| input.modifiers.shift);
    let wish = if response.dragged() && fine {
        tip + FINE * response.drag_delta()
    } else if response.clicked() || response.dragged() {
        response.interact_pointer_pos()?
    } else {
        return None;
    };
    let offset = (wish - center) / RADIUS;
    let new = (f64::from(offset.x) / out, f64::from(-offset.y) / out);
    (pos2(offset.x, offset.y).is_finite()
        && (response.drag_delta() != egui::Vec2::ZERO || response.clicked()))
    .then_some(new)
}
