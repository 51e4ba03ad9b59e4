//! How fast time goes on the screen: the fixed tick of the app follows the tick of the solver, and time slows down for
//! the ball that decides a rack. The table does not know: its ticks stay as long as they are.

use std::time::Duration;

use bevy::prelude::*;

use crate::game::decisive::decisive_pot;
use crate::game::replay::Replay;
use crate::game::settings::Settings;
use crate::game::turns::Turns;
use crate::sim::clock::Clock;
use crate::sim::messages::Strike;

/// How fast time goes as the ball drops.
const SLOWEST: f64 = 0.22;
/// Seconds of the table before and after the drop that are slow.
const BEFORE: f64 = 0.42;
const AFTER: f64 = 0.30;
/// Seconds of the table in which time changes its pace.
const EASE: f64 = 0.18;

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Decisive>()
        .add_message::<Strike>()
        .add_systems(
            RunFixedMainLoop,
            (
                keep_pace,
                foresee,
                slow_down.run_if(resource_exists::<Turns>),
            )
                .chain()
                .in_set(RunFixedMainLoopSystems::BeforeFixedMainLoop),
        );
}

/// A scene may bring its own tick. A fast machine shows it at its true speed, a slow one falls behind the wall clock but
/// plays the same ticks.
fn keep_pace(clock: Res<Clock>, mut fixed: ResMut<Time<Fixed>>) {
    let tick = Duration::from_secs_f64(clock.tick.clamp(1e-6, 1.0));
    if fixed.timestep() != tick {
        fixed.set_timestep(tick);
    }
}

/// When the ball drops that decides the rack, in seconds since the stroke.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
struct Decisive(Option<f64>);

/// Looks ahead, once a stroke.
fn foresee(
    mut strikes: MessageReader<Strike>,
    turns: Option<Res<Turns>>,
    clock: Res<Clock>,
    settings: Res<Settings>,
    mut decisive: ResMut<Decisive>,
) {
    let Some(strike) = strikes.read().last() else {
        return;
    };
    // What is asked for while balls roll is not played.
    if clock.moving && clock.time() > 0.1 {
        return;
    }
    let game = turns.as_ref().and_then(|turns| turns.game());
    let wanted = settings.slow_motion && !settings.reduced_motion;
    decisive.0 = game
        .filter(|_| wanted)
        .and_then(|game| decisive_pot(game.state(), &game.table(), &game.called(), &strike.shot));
}

/// Slows time down around the drop. Whoever plays fast is not held up.
fn slow_down(
    decisive: Res<Decisive>,
    clock: Res<Clock>,
    replay: Res<Replay>,
    mut time: ResMut<Time<Virtual>>,
    mut slowed: Local<bool>,
) {
    let pace = match decisive.0 {
        Some(at) if clock.moving && !replay.is_active() => pace(clock.time() - at),
        _ => 1.0,
    };
    if pace < 1.0 && time.relative_speed_f64() <= 1.0 {
        time.set_relative_speed_f64(pace);
        *slowed = true;
    } else if *slowed {
        if time.relative_speed_f64() < 1.0 {
            time.set_relative_speed_f64(1.0);
        }
        *slowed = false;
    }
}

/// How fast time goes so many seconds after the drop.
fn pace(after: f64) -> f64 {
    let from = ((after + BEFORE) / EASE).clamp(0.0, 1.0);
    let until = ((AFTER - after) / EASE).clamp(0.0, 1.0);
    let share = from.min(until);
    1.0 + (SLOWEST - 1.0) * share * share * (3.0 - 2.0 * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_is_slowest_at_the_drop_and_as_ever_before_and_after() {
        assert!((pace(0.0) - SLOWEST).abs() < 1e-12);
        assert_eq!(pace(-1.0), 1.0);
        assert_eq!(pace(1.0), 1.0);
        let mut last = pace(-0.6);
        for i in -600..600 {
            let now = pace(f64::from(i) / 1000.0);
            assert!((now - last).abs() < 0.02, "it jumps at {i} ms");
            last = now;
        }
    }
}
