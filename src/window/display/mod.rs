//! Whether there is anything to draw on and to draw with, and apps for either case.

pub mod film;
pub mod snapshot;

use std::io::{self, Write};
use std::panic::{self, AssertUnwindSafe};

use bevy::app::{PluginGroupBuilder, TerminalCtrlCHandlerPlugin};
use bevy::audio::AudioPlugin;
use bevy::log::LogPlugin;
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::error_handler::{RenderError, RenderErrorHandler, RenderErrorPolicy};
use bevy::render::pipelined_rendering::PipelinedRenderingPlugin;
use bevy::render::renderer::initialize_renderer;
use bevy::render::settings::{WgpuLimits, WgpuSettings};
use bevy::tasks::block_on;
use bevy::window::ExitCondition;
use bevy::winit::WinitPlugin;
use thiserror::Error;

use crate::game::GamePlugin;
use crate::sim::SimPlugin;
use crate::window::{RenderQuality, engine};

/// The exit code of a program that can no longer draw, as of one that never could.
const NO_DISPLAY: u8 = 5;

/// Why no window can be opened.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum NoDisplay {
    /// No display server, or it does not answer.
    #[error("no display was found to open a window on")]
    Display,
    /// No graphics adapter, not even a software driver.
    #[error("no graphics adapter was found to draw with")]
    Adapter,
    /// The best graphics adapter cannot do what everything here is drawn with.
    #[error("the graphics adapter `{adapter}` has {found} {what}, and {needed} are needed")]
    Weak {
        /// What it is called.
        adapter: String,
        /// What it has too little of.
        what: &'static str,
        /// How many it has.
        found: u32,
        /// How many are needed.
        needed: u32,
    },
}

/// Builds an app with a window, or says why it cannot be.
pub(super) fn on_screen(build: impl FnOnce(RenderQuality) -> App) -> Result<App, NoDisplay> {
    if cfg!(target_os = "linux") && !["DISPLAY", "WAYLAND_DISPLAY"].into_iter().any(is_set) {
        return Err(NoDisplay::Display);
    }
    let quality = find_adapter()?;
    let mut app = quietly(|| build(quality)).ok_or(NoDisplay::Display)?;
    app.insert_resource(RenderErrorHandler(give_up));
    Ok(app)
}

/// Where the driver fails while the game runs, nothing more can be drawn: what is saved stays, and the player is told.
fn give_up(error: &RenderError, world: &mut World, _: &mut World) -> RenderErrorPolicy {
    let reason = error.description.lines().next().unwrap_or_default();
    let kind = &error.ty;
    // Nobody listening is no error.
    let _ = writeln!(
        io::stderr(),
        "masse: the graphics driver failed ({kind:?}: {reason}). A match is saved up to its last shot and can be gone on with."
    );
    world.write_message(AppExit::from_code(NO_DISPLAY));
    RenderErrorPolicy::StopRendering
}

/// An app that draws without a window: the picture and the cameras, but nothing to touch or to hear.
pub(super) fn off_screen() -> Result<App, NoDisplay> {
    let quality = find_adapter()?;
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
fn find_adapter() -> Result<RenderQuality, NoDisplay> {
    quietly(|| {
        let settings = WgpuSettings::default();
        let backends = settings.backends.unwrap_or_default();
        let found = block_on(initialize_renderer(backends, None, &settings));
        check(&found.2.name, &found.0.limits())?;
        Ok(RenderQuality::for_adapter(&found.2))
    })
    .unwrap_or(Err(NoDisplay::Adapter))
}

/// Buffers that a shader reads balls and lamps from, beside those of Bevy's own lights. Every Vulkan driver has them.
const STORAGE_BUFFERS: u32 = 4;

/// Refuses a device that would fail at the first frame.
fn check(adapter: &str, limits: &WgpuLimits) -> Result<(), NoDisplay> {
    let found = limits.max_storage_buffers_per_shader_stage;
    if found >= STORAGE_BUFFERS {
        return Ok(());
    }
    Err(NoDisplay::Weak {
        adapter: adapter.to_owned(),
        what: "storage buffers a shader",
        found,
        needed: STORAGE_BUFFERS,
    })
}

/// Bevy knows no other answer to a missing display or adapter than a panic; here it is an expected one.
fn quietly<T>(work: impl FnOnce() -> T) -> Option<T> {
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let outcome = panic::catch_unwind(AssertUnwindSafe(work));
    panic::set_hook(hook);
    outcome.ok()
}

#[cfg(test)]
mod tests {
    use bevy::render::error_handler::ErrorType;

    use super::*;

    #[test]
    fn an_adapter_that_lacks_what_is_drawn_with_is_refused_by_name() {
        assert_eq!(check("any", &WgpuLimits::default()), Ok(()));
        assert_eq!(check("any", &WgpuLimits::downlevel_defaults()), Ok(()));
        let weak = check("Old Chip", &WgpuLimits::downlevel_webgl2_defaults());
        let said = weak.expect_err("it has no storage buffers").to_string();
        assert!(said.contains("`Old Chip` has 0 storage buffers"), "{said}");
    }

    #[test]
    fn a_driver_that_fails_ends_the_program_with_the_code_of_nothing_to_draw_with() {
        let mut app = App::new();
        app.add_message::<AppExit>();
        let error = RenderError {
            ty: ErrorType::DeviceLost,
            description: "it hung".to_owned(),
            source: None,
        };
        let world = app.world_mut();
        let policy = give_up(&error, world, &mut World::new());
        assert!(matches!(policy, RenderErrorPolicy::StopRendering));
        let mut exits = world.resource_mut::<Messages<AppExit>>();
        let exits: Vec<AppExit> = exits.drain().collect();
        assert_eq!(exits, [AppExit::from_code(NO_DISPLAY)]);
    }
}
