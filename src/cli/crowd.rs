//! `masse run` of a crowd: it is counted, not written down ball by ball.

use std::process::ExitCode;

use bevy::prelude::Messages;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;

use crate::cli::{CommandError, say, to_stdout};
use crate::physics::scene::Scene;
use crate::sim::clock::Clock;
use crate::sim::messages::Failed;
use crate::sim::play::Stopped;
use crate::sim::stepped::crowd::Census;
use crate::sim::stepping;

/// Runs a crowd to rest or to its time limit, and writes its last census as a line of JSON.
pub(super) fn run(
    name: &str,
    title: &str,
    scene: &Scene,
    quiet: bool,
) -> Result<ExitCode, CommandError> {
    let mut app = stepping::headless_app(scene);
    // Seconds of the scene: a crowd may take its time. Where nobody looks no bar is drawn.
    let bar = ProgressBar::new(scene.time_limit.ceil() as u64);
    let style = "{elapsed_precise} {bar:40} {pos} of at most {len} s, {msg}";
    if let Ok(style) = ProgressStyle::with_template(style) {
        bar.set_style(style);
    }
    loop {
        stepping::step(&mut app, 1);
        let mut failures = app.world_mut().resource_mut::<Messages<Failed>>();
        if let Some(failed) = failures.drain().last() {
            return Err(Stopped::Stepped(failed).into());
        }
        let clock = app.world().resource::<Clock>();
        bar.set_position(clock.time() as u64);
        if clock.ticks.is_multiple_of(64) {
            let awake = app.world().resource::<Census>().awake;
            bar.set_message(format!("{awake} balls move"));
        }
        if !clock.moving || clock.time() >= scene.time_limit {
            break;
        }
    }
    bar.finish_and_clear();
    let (time, census) = (
        app.world().resource::<Clock>().time(),
        app.world().resource::<Census>(),
    );
    let line = json!({
        "scene": name,
        "title": title,
        "time": time,
        "balls": census.balls,
        "awake": census.awake,
        "contacts": census.contacts_in_all,
        "energy": census.energy,
        "momentum": census.momentum,
        "speed": census.speed,
        "overlap": census.overlap,
        "late": census.late,
        "saturated": census.saturated,
    });
    if !quiet {
        to_stdout(|out| writeln!(out, "{line}"))?;
        say(&format!(
            "{title}: {} balls, {:.3} s, {} contacts, {:.6} J, deepest overlap {:.1e} m",
            census.balls, time, census.contacts_in_all, census.energy, census.overlap
        ));
    }
    Ok(ExitCode::SUCCESS)
}
