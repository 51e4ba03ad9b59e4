//! Whether there is anything to draw on and to draw with.

use std::panic::{self, AssertUnwindSafe};

use bevy::prelude::*;
use bevy::render::renderer::initialize_renderer;
use bevy::render::settings::WgpuSettings;
use bevy::tasks::block_on;
use thiserror::Error;

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
pub(super) fn on_screen(build: impl FnOnce() -> App) -> Result<App, NoDisplay> {
    if cfg!(target_os = "linux") && !["DISPLAY", "WAYLAND_DISPLAY"].into_iter().any(is_set) {
        return Err(NoDisplay::Display);
    }
    quietly(find_adapter).ok_or(NoDisplay::Adapter)?;
    quietly(build).ok_or(NoDisplay::Display)
}

fn is_set(variable: &str) -> bool {
    std::env::var_os(variable).is_some_and(|value| !value.is_empty())
}

/// Asks for an adapter and a device the way Bevy will, and lets go of them.
fn find_adapter() {
    let settings = WgpuSettings::default();
    if let Some(backends) = settings.backends {
        block_on(initialize_renderer(backends, None, &settings));
    }
}

/// Bevy knows no other answer to a missing display or adapter than a panic; here it is an expected one.
fn quietly<T>(work: impl FnOnce() -> T) -> Option<T> {
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let outcome = panic::catch_unwind(AssertUnwindSafe(work));
    panic::set_hook(hook);
    outcome.ok()
}
