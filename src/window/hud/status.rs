//! One line below: what is aimed, or what rolls and what was potted.

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

use crate::game::aim::Aim;
use crate::game::practice::Practice;
use crate::game::settings::Settings;
use crate::game::turns::Turns;
use crate::physics::record::EventKind;
use crate::sim::clock::Clock;
use crate::sim::components::{BallIndex, BallName, MotionKind};
use crate::sim::recorder::Recorder;
use crate::window::action::{Action, Bindings, Latched};
use crate::window::language::Language;
use crate::window::page::panel_id;

/// What stands between the parts of the line.
const BETWEEN: &str = "  ·  ";

type Balls<'w, 's> = Query<'w, 's, (&'static BallIndex, &'static BallName, &'static MotionKind)>;

/// Lays out the line.
#[expect(clippy::too_many_arguments, reason = "everything the line tells of")]
pub(super) fn show(
    mut contexts: EguiContexts,
    aim: Res<Aim>,
    practice: Res<Practice>,
    turns: Res<Turns>,
    settings: Res<Settings>,
    language: Res<Language>,
    bindings: Res<Bindings>,
    latched: Res<Latched>,
    clock: Res<Clock>,
    recorder: Res<Recorder>,
    balls: Balls,
) -> Result {
    let context = contexts.ctx_mut()?;
    let first = |action| bindings.name(action, &language);
    let mut parts = Vec::new();
    if clock.moving {
        let time = format!("{:.1}", clock.time());
        parts.push(language.with("status-rolling", &[("time", time.into())]));
    } else if practice.placing && turns.places_cue_ball() {
        let keys = [
            Action::AimLeft,
            Action::AimRight,
            Action::PowerUp,
            Action::PowerDown,
        ];
        let keys = keys.map(first).join(" ");
        let key = first(Action::Strike);
        let values = [("keys", keys.into()), ("key", key.into())];
        parts.push(language.with("status-in-hand", &values));
    } else if practice.placing {
        let key = first(Action::Place);
        parts.push(language.with("status-placing", &[("key", key.into())]));
    } else {
        parts.push(aimed(&aim, &language));
        if balls
            .iter()
            .any(|ball| ball.0.0 == aim.ball && !ball.2.0.in_play())
        {
            let key = first(Action::InHand);
            parts.push(language.with("status-pocketed-cue-ball", &[("key", key.into())]));
        }
    }
    if recorder
        .events
        .iter()
        .any(|event| event.kind == (EventKind::Strike { miscue: true }))
    {
        parts.push(language.text("status-miscue").to_owned());
    }
    let potted = potted(&recorder, &balls, settings.marks.labels);
    if !potted.is_empty() {
        let balls = potted.join(", ");
        parts.push(language.with("status-potted", &[("balls", balls.into())]));
    }
    if settings.volume.muted {
        parts.push(language.text("status-muted").to_owned());
    }
    for action in latched.iter() {
        let key = format!("status-{}", action.key());
        parts.push(language.text(&key).to_owned());
    }
    egui::Area::new(panel_id(context, "status"))
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

fn aimed(aim: &Aim, language: &Language) -> String {
    let shot = &aim.shot;
    let mut parts = vec![
        format!("{:.3}°", aim.heading_deg()),
        format!("{:.2} m/s", shot.speed),
    ];
    let side = if shot.side < 0.0 {
        "status-left"
    } else {
        "status-right"
    };
    let height = if shot.height < 0.0 {
        "status-draw"
    } else {
        "status-follow"
    };
    for (offset, name) in [(shot.side, side), (shot.height, height)] {
        if offset != 0.0 {
            let offset = format!("{:.2} R", offset.abs());
            parts.push(language.with(name, &[("offset", offset.into())]));
        }
    }
    if shot.elevation > 0.0 {
        let key = if shot.elevation > aim.wish {
            "status-raised"
        } else {
            "status-elevation"
        };
        let angle = format!("{:.1}°", shot.elevation.to_degrees());
        parts.push(language.with(key, &[("angle", angle.into())]));
    }
    parts.join(BETWEEN)
}

/// The balls potted in the last shot; with marks for solids and stripes where the player wants labels.
fn potted(recorder: &Recorder, balls: &Balls, marked: bool) -> Vec<String> {
    recorder
        .events
        .iter()
        .filter(|event| matches!(event.kind, EventKind::Pocketed { .. }))
        .filter_map(|event| balls.iter().find(|ball| ball.0.0 == event.first.ball))
        .map(|(_, name, _)| match name.0.parse::<u8>() {
            Ok(number @ 1..=8) if marked => format!("({number})"),
            Ok(number @ 9..=15) if marked => format!("=[{number}]="),
            _ => name.0.clone(),
        })
        .collect()
}
