//! What goes wrong around a game while it is played. It goes on, or says clearly what it cannot do; nothing kept is lost.
//!
//! | fault | tests | what the player sees |
//! |---|---|---|
//! | full disk | `disk` | which file is not saved and why; the old file stays whole, the match goes on |
//! | folder that cannot be written | `disk`, `matches::beside`, `turns` | the same, once; saved as soon as it can be, at the latest at the end |
//! | watched file removed, edited, replaced | `watched`, `window::preset` | what is wrong with it; played on with what it said before |
//! | sound device gone | `window::sound` | one notice; the log is not filled, voices end |
//! | window of one pixel, minimised | `resized` | everything again when it has room again |
//! | adapter that lacks something, no adapter, no display | `graphics`, `window::display` | what is missing, then a picture instead of a window |
//! | ten seconds without a frame, a clock that stands or goes back | `time`, `fuzz::whims` | the same shot, the same aim |
//! | the end in the midst of a shot or of a save | `ending` | the match, up to its last shot, at the next start |

mod disk;
mod ending;
mod graphics;
#[cfg(feature = "window")]
mod resized;
mod time;
#[cfg(feature = "window")]
mod watched;

use bevy::prelude::*;
use masse::game::matches::{Breaks, Mind, Player, Setup};
use masse::game::practice;
use masse::game::rules::Game;
use masse::game::turns::{TurnCommand, Turns};
use masse::physics::ball::State;
use masse::physics::cue::Shot;
use masse::sim::clock::Clock;
use masse::sim::messages::Strike;
use masse::sim::stepping;

use crate::fuzz::whims::{frame, table};

/// A break.
fn strike(app: &mut App) {
    let shot = Shot {
        speed: 7.0,
        heading: 0.01,
        ..Shot::default()
    };
    app.world_mut().write_message(Strike { ball: 0, shot });
}

fn moves(app: &App) -> bool {
    app.world().resource::<Clock>().moving
}

/// Plays frames of a sixtieth until everything lies.
fn to_rest(app: &mut App) -> Vec<State> {
    for _ in 0..3000 {
        if !moves(app) {
            return stepping::states(app);
        }
        frame(app, 1.0 / 60.0);
    }
    panic!("it never comes to rest");
}

/// How the break ends when nothing disturbs it.
fn undisturbed() -> Vec<State> {
    let mut app = table();
    strike(&mut app);
    frame(&mut app, 1.0 / 60.0);
    to_rest(&mut app)
}

/// Begins a match of two people.
fn begin(app: &mut App) {
    let person = |name: &str| Player {
        name: name.to_owned(),
        mind: Mind::Person,
    };
    let setup = Setup {
        game: Game::named("9-ball").expect("a game"),
        players: vec![person("Ada"), person("Bob")],
        race: 5,
        breaks: Breaks::Alternate,
        first: 0,
        seed: 11,
        undo: true,
    };
    app.world_mut().write_message(TurnCommand::Begin {
        setup: Box::new(setup),
        like: Box::new(practice::opening()),
    });
    frame(app, 0.1);
    frame(app, 0.1);
    assert!(app.world().resource::<Turns>().is_on());
}
