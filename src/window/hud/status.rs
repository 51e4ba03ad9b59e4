//! One line below: what is aimed, or what rolls and what was potted.

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

use crate::game::aim::Aim;
use crate::game::practice::Practice;
use crate::game::volume::Volume;
use crate::physics::record::EventKind;
use crate::sim::clock::Clock;
use crate::sim::components::{BallIndex, BallName, MotionKind};
use crate::sim::recorder::Recorder;

/// What stands between the parts of the line.
const BETWEEN: &str = "  ·  ";

type Balls<'w, 's> = Query<'w, 's, (&'static BallIndex, &'static BallName, &'static MotionKind)>;

/// Lays out the line.
pub(super) fn show(
    mut contexts: EguiContexts,
    aim: Res<Aim>,
    practice: Res<Practice>,
    volume: Res<Volume>,
    clock: Res<Clock>,
    recorder: Res<Recorder>,
    balls: Balls,
) -> Result {
    let context = contexts.ctx_mut()?;
    let mut parts = Vec::new();
    if clock.moving {
        parts.push(format!("Rolling {:.1} s", clock.time()));
    } else if practice.placing {
        parts.push("Placing: drag balls; B or Esc to go on aiming".to_owned());
    } else {
        parts.push(aimed(&aim));
        if balls
            .iter()
            .any(|ball| ball.0.0 == aim.ball && !ball.2.0.in_play())
        {
            parts.push("the cue ball is in a pocket: I brings it back".to_owned());
        }
    }
    if recorder
        .events
        .iter()
        .any(|event| event.kind == (EventKind::Strike { miscue: true }))
    {
        parts.push("miscue".to_owned());
    }
    let potted = potted(&recorder, &balls);
    if !potted.is_empty() {
        parts.push(format!("potted {}", potted.join(", ")));
    }
    if volume.muted {
        parts.push("muted".to_owned());
    }
    egui::Area::new(egui::Id::new("status"))
        .anchor(egui::Align2::LEFT_BOTTOM, egui::vec2(8.0, -8.0))
        .interactable(false)
        .show(context, |ui| {
            egui::Frame::new()
                .fill(egui::Color32::from_black_alpha(150))
                .corner_radius(4.0)
                .inner_margin(egui::Margin::symmetric(8, 4))
                .show(ui, |ui| {
                    ui.add(
                        egui::Label::new(
                            egui::RichText::new(parts.join(BETWEEN)).color(egui::Color32::WHITE),
                        )
                        .extend(),
                    );
                });
        });
    Ok(())
}

fn aimed(aim: &Aim) -> String {
    let shot = &aim.shot;
    let mut parts = vec![
        format!("{:.3}°", aim.heading_deg()),
        format!("{:.2} m/s", shot.speed),
    ];
    let side = if shot.side < 0.0 { "left" } else { "right" };
    let height = if shot.height < 0.0 { "draw" } else { "follow" };
    for (offset, name) in [(shot.side, side), (shot.height, height)] {
        if offset != 0.0 {
            parts.push(format!("{:.2} R {name}", offset.abs()));
        }
    }
    if shot.elevation > 0.0 {
        let least = if shot.elevation > aim.wish {
            " (least)"
        } else {
            ""
        };
        parts.push(format!("{:.1}° up{least}", shot.elevation.to_degrees()));
    }
    parts.join(BETWEEN)
}

fn potted<'a>(recorder: &Recorder, balls: &'a Balls) -> Vec<&'a str> {
    recorder
        .events
        .iter()
        .filter(|event| matches!(event.kind, EventKind::Pocketed { .. }))
        .filter_map(|event| {
            balls
                .iter()
                .find(|ball| ball.0.0 == event.first.ball)
                .map(|ball| ball.1.0.as_str())
        })
        .collect()
}
