//! `masse` and `masse play`: the window, and what is done where there is none.

use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use crate::cli::{CommandError, say, to_file, to_stdout};
use crate::game::racking;
use crate::physics::scene::{Rack, Solver};
use crate::report::{picture, record_file};
use crate::scenarios::file::Scenario;
use crate::scenarios::{library, preset};
use crate::sim;

/// The scene that is run where there is no window.
const BREAK: &str = "break-eight";

/// Plays from this scene, or from a racked table, with this preset; times the start if it is told when that was.
pub(super) fn play(
    scene: Option<&str>,
    preset: Option<&str>,
    timed: Option<Instant>,
) -> Result<ExitCode, CommandError> {
    let mut scenario = scene.map(library::open).transpose()?;
    if let Some(name) = preset {
        scenario = Some(equipped(scenario, name)?);
    }
    match window(scenario.as_ref(), scene, preset, timed) {
        Ok(code) => Ok(code),
        Err(reason) => {
            let name = scene.unwrap_or(BREAK);
            // A rack stands still: what is drawn is the break of it.
            let scenario = match scenario {
                Some(scenario) if scene.is_some() => scenario,
                _ => {
                    let opened = library::open(BREAK)?;
                    match preset {
                        Some(preset) => equipped(Some(opened), preset)?,
                        None => opened,
                    }
                }
            };
            fall_back(&reason, name, &scenario).map(|()| ExitCode::SUCCESS)
        }
    }
}

/// A scene, or a rack, with the equipment of a preset.
fn equipped(scenario: Option<Scenario>, name: &str) -> Result<Scenario, CommandError> {
    let preset = preset::open(name)?;
    let mut scenario = match scenario {
        Some(scenario) => scenario,
        None => Scenario::plain(
            &preset.title,
            &preset.description,
            racking::set_up(&preset.equipment, Solver::Exact, Rack::EightBall, 1),
        ),
    };
    let shot = scenario.scene.shot;
    if !preset.equipment.take_over(&mut scenario.scene) {
        return Err(CommandError::Usage(format!(
            "--preset {name}: the balls of the scene have no room there"
        )));
    }
    scenario.scene.shot = shot;
    scenario.preset = Some(name.to_owned());
    Ok(scenario)
}

/// Opens the window; the error is why there is none.
#[cfg(feature = "window")]
fn window(
    scenario: Option<&Scenario>,
    scene: Option<&str>,
    preset: Option<&str>,
    timed: Option<Instant>,
) -> Result<ExitCode, String> {
    use crate::window::Source;
    let source = match (preset, scene, scenario) {
        (Some(preset), ..) => Some(Source::Preset(preset.to_owned())),
        (
            None,
            Some(scene),
            Some(Scenario {
                preset: Some(_), ..
            }),
        ) => Some(Source::Scene(scene.to_owned())),
        _ => None,
    };
    let exit =
        crate::window::play(scenario.cloned(), source, timed).map_err(|error| error.to_string())?;
    Ok(match exit {
        bevy::app::AppExit::Success => ExitCode::SUCCESS,
        bevy::app::AppExit::Error(code) => ExitCode::from(code.get()),
    })
}

/// A build without a window never opens one.
#[cfg(not(feature = "window"))]
fn window(
    _: Option<&Scenario>,
    _: Option<&str>,
    _: Option<&str>,
    _: Option<Instant>,
) -> Result<ExitCode, String> {
    Err("this is a build without a window".to_owned())
}

/// Says why there is no window, runs the break without one, draws `masse-break.svg` in the current folder and tells
/// what happened.
#[must_use]
pub fn fallback(reason: &str) -> ExitCode {
    let outcome = library::open(BREAK)
        .map_err(CommandError::from)
        .and_then(|scenario| fall_back(reason, BREAK, &scenario));
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            say(&format!("masse: {error}"));
            ExitCode::from(error.code())
        }
    }
}

fn fall_back(reason: &str, name: &str, scenario: &Scenario) -> Result<(), CommandError> {
    let what = if name == BREAK { "the break" } else { name };
    let file = if name == BREAK {
        "masse-break.svg"
    } else {
        "masse-scene.svg"
    };
    say(&format!(
        "masse: {reason}, so {what} runs without a window and is drawn in {file}."
    ));
    let record = sim::play::play(&scenario.scene)?;
    let drawn = picture::draw(&scenario.title, &scenario.scene, &record);
    to_file(Path::new(file), drawn.as_bytes())?;
    let summary = record_file::Summary::of(name, &scenario.title, &scenario.scene, &record);
    to_stdout(|out| writeln!(out, "{}", summary.text()))
}
