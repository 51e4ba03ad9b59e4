//! `masse` and `masse play`: the window, and what is done where there is none.

use std::path::Path;
use std::process::ExitCode;

use crate::cli::simulate::simulate;
use crate::cli::{CommandError, say, to_file, to_stdout};
use crate::report::{picture, record_file};
use crate::scenarios::file::Scenario;
use crate::scenarios::library;

/// The scene that is run where there is no window.
const BREAK: &str = "break-eight";

/// Plays from this scene, or from a racked table.
pub(super) fn play(scene: Option<&str>) -> Result<ExitCode, CommandError> {
    let scenario = scene.map(library::open).transpose()?;
    match window(scenario.as_ref()) {
        Ok(code) => Ok(code),
        Err(reason) => fall_back(&reason, scene.unwrap_or(BREAK)).map(|()| ExitCode::SUCCESS),
    }
}

/// Opens the window; the error is why there is none.
#[cfg(feature = "window")]
fn window(scenario: Option<&Scenario>) -> Result<ExitCode, String> {
    let exit = crate::window::play(scenario.map(|scenario| scenario.scene.clone()))
        .map_err(|error| error.to_string())?;
    Ok(match exit {
        bevy::app::AppExit::Success => ExitCode::SUCCESS,
        bevy::app::AppExit::Error(code) => ExitCode::from(code.get()),
    })
}

/// A build without a window never opens one.
#[cfg(not(feature = "window"))]
fn window(_: Option<&Scenario>) -> Result<ExitCode, String> {
    Err("this is a build without a window".to_owned())
}

/// Says why there is no window, runs the break without one, draws `masse-break.svg` in the current folder and tells
/// what happened.
#[must_use]
pub fn fallback(reason: &str) -> ExitCode {
    match fall_back(reason, BREAK) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            say(&format!("masse: {error}"));
            ExitCode::from(error.code())
        }
    }
}

fn fall_back(reason: &str, name: &str) -> Result<(), CommandError> {
    let what = if name == BREAK { "the break" } else { name };
    let file = if name == BREAK {
        "masse-break.svg"
    } else {
        "masse-scene.svg"
    };
    say(&format!(
        "masse: {reason}, so {what} runs without a window and is drawn in {file}."
    ));
    let scenario = library::open(name)?;
    let record = simulate(&scenario.scene)?;
    let drawn = picture::draw(&scenario.title, &scenario.scene, &record);
    to_file(Path::new(file), drawn.as_bytes())?;
    let summary = record_file::Summary::of(name, &scenario.title, &scenario.scene, &record);
    to_stdout(|out| writeln!(out, "{}", summary.text()))
}
