//! The bar of the replay: time to scrub, pace, events, loop.

use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

use crate::game::replay::{Playback, Replay, ReplayCommand};
use crate::game::view::{Beside, CameraMode, SceneCameras, View};
use crate::sim::clock::Clock;
use crate::sim::recorder::Recorder;
use crate::window::action::Action;
use crate::window::language::Language;
use crate::window::page::panel_id;

/// Paces the viewer can choose from.
const RATES: [f64; 6] = [-1.0, -0.25, 0.1, 0.25, 1.0, 4.0];

/// Lays out the bar while a replay runs, and else the button that starts one.
#[expect(
    clippy::too_many_arguments,
    reason = "a system names everything it reads"
)]
pub(super) fn show(
    mut contexts: EguiContexts,
    replay: Res<Replay>,
    recorder: Res<Recorder>,
    clock: Res<Clock>,
    language: Res<Language>,
    cameras: Res<SceneCameras>,
    mut view: ResMut<View>,
    mut commands: MessageWriter<ReplayCommand>,
) -> Result {
    let has_shot = !clock.moving && !recorder.events.is_empty();
    if !replay.is_active() && !has_shot {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    egui::Area::new(panel_id(context, "replay"))
        .anchor(egui::Align2::RIGHT_BOTTOM, egui::vec2(-8.0, -8.0))
        .show(context, |ui| {
            egui::Frame::new()
                .fill(egui::Color32::from_black_alpha(170))
                .corner_radius(4.0)
                .inner_margin(egui::Margin::symmetric(8, 4))
                .show(ui, |ui| match &replay.0 {
                    Some(playback) => {
                        bar(ui, &language, playback, &mut commands);
                        let mut seen = *view;
                        looks(ui, &language, &cameras, &mut seen);
                        view.set_if_neq(seen);
                    }
                    None => {
                        if ui.button(language.text("replay-start")).clicked() {
                            commands.write(ReplayCommand::Start);
                        }
                    }
                });
        });
    Ok(())
}

fn bar(
    ui: &mut egui::Ui,
    language: &Language,
    playback: &Playback,
    commands: &mut MessageWriter<ReplayCommand>,
) {
    let mut send = |command| {
        commands.write(command);
    };
    ui.horizontal(|ui| {
        let hold = language.text(if playback.playing {
            "replay-hold"
        } else {
            "replay-go-on"
        });
        for (name, action, command) in [
            ("<", Action::ReplayPrevious, ReplayCommand::StepEvent(false)),
            (hold, Action::ReplayHold, ReplayCommand::TogglePlay),
            (">", Action::ReplayNext, ReplayCommand::StepEvent(true)),
        ] {
            let hint = action.key();
            if ui
                .button(name)
                .on_hover_text(language.text(&hint))
                .clicked()
            {
                send(command);
            }
        }
        let mut time = playback.time;
        let end = playback.record.end_time.max(1e-9);
        ui.spacing_mut().slider_width = 220.0;
        let slider = egui::Slider::new(&mut time, 0.0..=end)
            .suffix(" s")
            .fixed_decimals(3);
        if ui.add(slider).changed() {
            send(ReplayCommand::Seek(time));
        }
    });
    ui.horizontal(|ui| {
        for rate in RATES {
            let chosen = (playback.rate - rate).abs() < 1e-9;
            if ui.selectable_label(chosen, format!("{rate}x")).clicked() {
                send(ReplayCommand::Rate(rate));
            }
        }
        let mut looping = playback.looping;
        if ui
            .checkbox(&mut looping, language.text("replay-loop"))
            .changed()
        {
            send(ReplayCommand::ToggleLoop);
        }
        if ui.button(language.text("replay-stop")).clicked() {
            send(ReplayCommand::Stop);
        }
    });
}

/// From where the replay is seen, and what stands beside it.
fn looks(ui: &mut egui::Ui, language: &Language, cameras: &SceneCameras, view: &mut View) {
    ui.horizontal(|ui| {
        for (mode, key) in [
            (CameraMode::Overhead, "camera-overhead"),
            (CameraMode::Follow, "camera-follow"),
        ] {
            ui.selectable_value(&mut view.camera, mode, language.text(key));
        }
        let two = matches!(view.beside, Beside::Camera(_));
        if ui
            .selectable_label(two, language.text("view-second"))
            .clicked()
        {
            view.toggle_second(cameras);
        }
        let laws = view.beside == Beside::Laws;
        if ui
            .selectable_label(laws, language.text("view-laws"))
            .clicked()
        {
            view.toggle_laws();
        }
    });
}
