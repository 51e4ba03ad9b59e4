//! Whether there is anything to draw on and to draw with, and apps for either case.

pub mod film;
pub mod snapshot;

use std::panic::{self, AssertUnwindSafe};

use bevy::app::{PluginGroupBuilder, TerminalCtrlCHandlerPlugin};
use bevy::audio::AudioPlugin;
use bevy::log::LogPlugin;
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::pipelined_rendering::PipelinedRenderingPlugin;
use bevy::render::renderer::initialize_renderer;
use bevy::render::settings::WgpuSettings;
use bevy::tasks::block_on;
use bevy::window::ExitCondition;
use bevy::winit::WinitPlugin;
use thiserror::Error;

use crate::game::GamePlugin;
use crate::sim::SimPlugin;
use crate::window::{RenderQuality, engine};

/// Why no window can be opened.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum NoDisplay {
    /// No display server, or it does not answer.
    #[error("no display was found to open a window on")]
    Display,
    /// No graphics adapter, not even a software driver.
    #[error("no graphics adapter was found to draw with")]
    Adapter,
}

/// Builds an app with a window, or says why it cannot be.
pub(super) fn on_screen(build: impl FnOnce(RenderQuality) -> App) -> Result<App, NoDisplay> {
    if cfg!(target_os = "linux") && !["DISPLAY", "WAYLAND_DISPLAY"].into_iter().any(is_set) {
        return Err(NoDisplay::Display);
    }
    let quality = quietly(find_adapter).ok_or(NoDisplay::Adapter)?;
    quietly(|| build(quality)).ok_or(NoDisplay::Display)
}

/// An app that draws without a window: the picture and the cameras, but nothing to touch or to hear.
pub(super) fn off_screen() -> Result<App, NoDisplay> {
    let quality = quietly(find_adapter).ok_or(NoDisplay::Adapter)?;
    let mut app = App::new();
    app.insert_resource(quality)
        .add_plugins(
            engine()
                .set(bevy::window::WindowPlugin {
                    primary_window: None,
                    exit_condition: ExitCondition::DontExit,
                    ..default()
                })
                .set(RenderPlugin {
                    synchronous_pipeline_compilation: true,
                    ..default()
                })
                .disable::<WinitPlugin>()
                .disable::<PipelinedRenderingPlugin>()
                .disable::<AudioPlugin>()
                .disable::<LogPlugin>()
                .disable::<TerminalCtrlCHandlerPlugin>(),
        )
        .add_plugins((SimPlugin, GamePlugin, super::picture));
    Ok(app)
}

/// Bevy's plugins without a window, a graphics adapter, a loudspeaker and a log: with [`windowed`](crate::window::windowed)
/// the whole program runs, but nothing is seen or heard of it. For tests, and to measure what a frame costs.
#[must_use]
pub fn unseen() -> PluginGroupBuilder {
    DefaultPlugins
        .set(bevy::window::WindowPlugin {
            primary_window: None,
            exit_condition: ExitCondition::DontExit,
            ..default()
        })
        .set(RenderPlugin {
            render_creation: WgpuSettings {
                backends: None,
                ..default()
            }
            .into(),
            ..default()
        })
        .disable::<WinitPlugin>()
        .disable::<LogPlugin>()
        .disable::<AudioPlugin>()
}

fn is_set(variable: &str) -> bool {
    std::env::var_os(variable).is_some_and(|value| !value.is_empty())
}

/// Asks for an adapter and a device the way Bevy will, lets go of them, and says what suits them.
fn find_adapter() -> RenderQuality {
    let settings = WgpuSettings::default();
    let backends = settings.backends.unwrap_or_default();
    let found = block_on(initialize_renderer(backends, None, &settings));
    RenderQuality::for_adapter(&found.2)
}

/// Bevy knows no other answer to a missing display or adapter than a panic; here it is an expected one.
fn quietly<T>(work: impl FnOnce() -> T) -> Option<T> {
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let outcome = panic::catch_unwind(AssertUnwindSafe(work));
    panic::set_hook(hook);
    outcome.ok()
}
