//! Frames of ten seconds, clocks that stand or go back.

use std::time::{Duration, Instant};

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use masse::sim::clock::Clock;
use masse::sim::stepping;

use super::{frame, moves, strike, table, to_rest, undisturbed};

/// The most that is played in one frame, s: what is slower than that falls behind.
const MOST: f64 = 0.25;

#[test]
fn a_machine_that_slept_plays_on_from_where_it_was() {
    let undisturbed = undisturbed();
    for asleep in [10.0, 1e4] {
        let mut app = table();
        strike(&mut app);
        frame(&mut app, 1.0 / 60.0);
        let mut frames = 0;
        while moves(&app) {
            let before = app.world().resource::<Clock>().time();
            frame(&mut app, asleep);
            let played = app.world().resource::<Clock>().time() - before;
            assert!(played <= MOST + 0.01, "{played} s in one frame");
            frames += 1;
        }
        assert!(frames > 10, "{frames}");
        assert_eq!(stepping::states(&mut app), undisturbed);
    }
}

#[test]
fn a_clock_that_stands_or_goes_back_does_not_stop_the_game() {
    let undisturbed = undisturbed();
    let start = Instant::now() + Duration::from_secs(1000);
    let mut app = table();
    strike(&mut app);
    frame(&mut app, 1.0 / 60.0);
    let at = |app: &mut App, milliseconds: u64| {
        let now = start + Duration::from_millis(milliseconds);
        app.insert_resource(TimeUpdateStrategy::ManualInstant(now));
        app.update();
    };
    let mut now = 500_000;
    at(&mut app, now);
    for frames in 0..200 {
        let before = app.world().resource::<Clock>().time();
        // An hour back, the same moment again and again, and a little on.
        let back = frames % 20 == 7;
        now = match frames % 20 {
            7 => now - 2000,
            11..15 => now,
            _ => now + 16,
        };
        at(&mut app, now);
        let after = app.world().resource::<Clock>().time();
        assert!(after >= before, "the shot goes back");
        if back {
            assert_eq!(after, before, "time that went back is no time");
        }
    }
    assert!(app.world().resource::<Clock>().time() > 1.0, "it stands");
    assert_eq!(to_rest(&mut app), undisturbed);
}

/// What the hand does while the machine sleeps is nothing.
#[cfg(feature = "window")]
mod held {
    use bevy::input::ButtonState;
    use bevy::input::keyboard::{Key, KeyboardInput, NativeKey};
    use masse::game::aim::Aim;

    use super::*;
    use crate::window::blind;

    #[test]
    fn a_key_held_while_the_machine_slept_counts_as_held_for_a_moment() {
        let mut app = blind();
        for _ in 0..4 {
            frame(&mut app, 0.016);
        }
        let heading = |app: &App| app.world().resource::<Aim>().shot.heading;
        let first = heading(&app);
        app.world_mut().write_message(KeyboardInput {
            key_code: KeyCode::ArrowLeft,
            logical_key: Key::Unidentified(NativeKey::Unidentified),
            state: ButtonState::Pressed,
            text: None,
            repeat: false,
            window: Entity::PLACEHOLDER,
        });
        for _ in 0..60 {
            frame(&mut app, 0.016);
        }
        let held = (heading(&app) - first).abs();
        assert!((0.1..0.6).contains(&held), "it turns by {held} rad");
        let before = heading(&app);
        frame(&mut app, 10.0);
        let jump = (heading(&app) - before).abs();
        assert!(
            jump > 0.0 && jump < 0.1,
            "ten seconds turn it by {jump} rad"
        );
    }
}
