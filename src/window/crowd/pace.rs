//! How fast a crowd goes: held and released, begun again, and never more ticks in a frame than the machine can do.

use std::time::{Duration, Instant};

use bevy::prelude::*;
use leafwing_input_manager::prelude::ActionState;

use crate::game::practice::PracticeCommand;
use crate::game::watch::Watch;
use crate::physics::scene::Scene;
use crate::sim::messages::LoadScene;
use crate::sim::playfield::Playfield;
use crate::sim::recorder::Recorder;
use crate::sim::stepped::crowd::{Crowd, Mirror};
use crate::window::action::Action;
use crate::window::crowd::pack::Packed;

/// Time of a frame that ticks may take.
const SHARE: Duration = Duration::from_millis(14);
/// Bevy's own bound of what a frame may catch up.
const CATCH_UP: Duration = Duration::from_millis(250);

/// What a tick costs on the clock on the wall.
#[derive(Resource, Debug, Default)]
pub(super) struct Cost {
    begun: Option<Instant>,
    /// s, the last ticks count most.
    pub tick: f64,
}

pub(super) fn start(mut cost: ResMut<Cost>) {
    cost.begun = Some(Instant::now());
}

pub(super) fn stop(mut cost: ResMut<Cost>) {
    if let Some(begun) = cost.begun.take() {
        let now = begun.elapsed().as_secs_f64();
        cost.tick += 0.2 * (now - cost.tick);
    }
}

/// The components are needed once a frame: after its last tick.
pub(super) fn ask(mut crowd: ResMut<Crowd>, playfield: Res<Playfield>, fixed: Res<Time<Fixed>>) {
    if !playfield.solver.is_crowd() {
        return;
    }
    crowd.mirror = Mirror::WhenAsked;
    if fixed.overstep() < fixed.timestep() {
        crowd.ask();
    }
}

/// A frame that is late by many ticks would be the later for computing them: a crowd too large for the machine runs slower
/// than life instead, tick by tick the same.
pub(super) fn keep_up(
    playfield: Res<Playfield>,
    cost: Res<Cost>,
    fixed: Res<Time<Fixed>>,
    scenes: Res<Messages<LoadScene>>,
    commands: Res<Messages<PracticeCommand>>,
    mut time: ResMut<Time<Virtual>>,
    mut was: Local<bool>,
) {
    if !scenes.is_empty() || !commands.is_empty() {
        // What lies on the table is changed by a tick.
        time.unpause();
    }
    let is = playfield.solver.is_crowd();
    if *was && !is {
        time.set_max_delta(CATCH_UP);
        time.unpause();
    }
    *was = is;
    if !is {
        return;
    }
    let ticks = (SHARE.as_secs_f64() / cost.tick.max(1e-6)).max(1.0);
    let most = fixed.timestep().mul_f64(ticks.min(1e3)).min(CATCH_UP);
    if time.max_delta() != most && !most.is_zero() {
        time.set_max_delta(most);
    }
}

/// Holds, goes on, begins again, lets go of the ball that is watched.
pub(super) fn command(
    actions: Single<&ActionState<Action>>,
    mut time: ResMut<Time<Virtual>>,
    mut load: MessageWriter<LoadScene>,
    mut watch: ResMut<Watch>,
    packed: Res<Packed>,
    recorder: Res<Recorder>,
    playfield: Res<Playfield>,
) {
    if actions.just_pressed(&Action::Strike) {
        hold(&mut time);
    }
    if actions.just_pressed(&Action::Retry) {
        begin_again(&mut time, &mut load, &recorder, &playfield);
    }
    for (action, step) in [(Action::NextBallLeft, -1), (Action::NextBallRight, 1)] {
        if actions.just_pressed(&action) {
            let last = packed.sheet.count().saturating_sub(1);
            let next = watch
                .chosen
                .and_then(|number| number.checked_add_signed(step));
            watch.chosen = Some(next.unwrap_or(0).min(last));
        }
    }
}

/// Holds or goes on.
pub(super) fn hold(time: &mut Time<Virtual>) {
    if time.is_paused() {
        time.unpause();
    } else {
        time.pause();
    }
}

/// Lays the scene out as it began, under the laws and with the tick of now.
pub(super) fn begin_again(
    time: &mut Time<Virtual>,
    load: &mut MessageWriter<LoadScene>,
    recorder: &Recorder,
    playfield: &Playfield,
) {
    let Some(before) = &recorder.before else {
        return;
    };
    load.write(LoadScene(Scene {
        laws: playfield.laws,
        solver: playfield.solver,
        ..before.clone()
    }));
    // Scenes are laid out by a tick.
    time.unpause();
}
