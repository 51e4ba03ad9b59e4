//! Time slows down for the ball that decides a rack, in a match as it is played.

use std::time::Duration;

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use masse::game::decisive::decisive_pot;
use masse::game::matches::{Breaks, Match, Mind, Player, Setup};
use masse::game::practice;
use masse::game::rules::Game;
use masse::game::settings::Settings;
use masse::game::turns::{TurnCommand, Turns};
use masse::physics::cue::Shot;
use masse::sim::clock::Clock;
use masse::sim::messages::Strike;
use masse::sim::stepping;

use super::window::blind;

const FRAME: Duration = Duration::from_micros(16_667);

fn nine_ball(seed: u64) -> Setup {
    let person = |name: &str| Player {
        name: name.to_owned(),
        mind: Mind::Person,
    };
    Setup {
        game: Game::named("9-ball").expect("it is among the games"),
        players: vec![person("Ada"), person("Bob")],
        race: 1,
        breaks: Breaks::Alternate,
        first: 0,
        seed,
        undo: true,
    }
}

/// A rack whose break pots the 9, the break, and when the 9 drops in s.
fn golden_break() -> (Setup, Shot, f64) {
    let game = Match::new(nine_ball(0), &practice::opening()).expect("a table for it");
    let table = game.table();
    for tenths in -20..=20 {
        for speed in [8.0, 8.5, 9.0, 9.5] {
            let shot = Shot {
                heading: (0.1 * f64::from(tenths)).to_radians(),
                elevation: 2.5_f64.to_radians(),
                side: 0.0,
                height: 0.0,
                speed,
            };
            if let Some(drop) = decisive_pot(game.state(), &table, &game.called(), &shot) {
                return (nine_ball(0), shot, drop);
            }
        }
    }
    panic!("no break of this rack pots the 9");
}

/// Plays the break and gives the times of the table in s at which time was slow.
fn slow_times(with: impl Fn(&mut Settings)) -> (Vec<f64>, f64) {
    let (setup, shot, drop) = golden_break();
    let mut app = blind();
    app.insert_resource(TimeUpdateStrategy::ManualDuration(FRAME));
    app.update();
    with(&mut app.world_mut().resource_mut::<Settings>());
    app.world_mut().write_message(TurnCommand::Begin {
        setup: Box::new(setup),
        like: Box::new(practice::opening()),
    });
    stepping::step(&mut app, 2);
    let turns = app.world().resource::<Turns>();
    let game = turns.game().expect("it has begun");
    let ball = game.state().cue_ball(&game.table());
    app.world_mut().write_message(Strike { ball, shot });
    let mut slow = Vec::new();
    for _ in 0..4000 {
        app.update();
        let (clock, time) = (
            app.world().resource::<Clock>(),
            app.world().resource::<Time<Virtual>>(),
        );
        if time.relative_speed_f64() < 0.5 {
            slow.push(clock.time());
        }
        if clock.time() > drop + 1.0 {
            assert_eq!(time.relative_speed_f64(), 1.0, "time goes on as ever");
            return (slow, drop);
        }
    }
    panic!("the 9 never dropped");
}

#[test]
fn time_is_slow_while_the_nine_of_a_golden_break_drops() {
    let (slow, drop) = slow_times(|_| ());
    let (first, last) = (slow[0], slow[slow.len() - 1]);
    assert!(first < drop && drop < last, "{first} {drop} {last}");
    assert!(last - first < 1.0, "{first} to {last}");
    // Half a second of the table fills more than a second of frames.
    assert!(slow.len() > 60, "{}", slow.len());
}

#[test]
fn time_does_not_slow_down_for_whoever_wants_less_motion_or_no_slow_motion() {
    assert!(
        slow_times(|settings| settings.reduced_motion = true)
            .0
            .is_empty()
    );
    assert!(
        slow_times(|settings| settings.slow_motion = false)
            .0
            .is_empty()
    );
}
