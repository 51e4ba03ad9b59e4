//! Buttons of the panels that can be heard.

use bevy::audio::{AudioPlayer, PlaybackSettings};
use bevy::prelude::*;
use bevy_egui::egui::output::OutputEvent;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass};

use super::synthesis::{self, Sound};
use super::{Sounds, Voice};
use crate::game::settings::Settings;
use crate::game::volume::SoundKind;
use crate::window::WindowSystems;

/// Loudness beside the sounds of the table.
const LOUDNESS: f32 = 0.25;

pub(super) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, hear.after(WindowSystems::Menu));
}

/// Clicks when something was chosen.
fn hear(
    mut contexts: EguiContexts,
    mut commands: Commands,
    sounds: Res<Sounds>,
    settings: Res<Settings>,
    time: Res<Time<Real>>,
) -> Result {
    let level = settings.volume.audible(SoundKind::Interface);
    let chosen = contexts.ctx_mut()?.output(|output| {
        let is_choice = |event: &OutputEvent| matches!(event, OutputEvent::Clicked(_));
        output.events.iter().any(is_choice)
    });
    let click = sounds.handles.iter().find(|(one, _)| *one == Sound::Click);
    if let Some((_, handles)) = click.filter(|_| chosen && level > 0.0) {
        commands.spawn((
            AudioPlayer(handles[1].clone()),
            PlaybackSettings::ONCE.with_volume(bevy::audio::Volume::Linear(LOUDNESS * level)),
            Voice {
                until: time.elapsed() + 2 * synthesis::LENGTH,
            },
        ));
    }
    Ok(())
}
