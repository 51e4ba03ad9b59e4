//! Snooker, WPBSA.

mod fouls;
mod free_ball;
mod miss;
mod points;

use masse::game::rules::snooker::BallOn;
use masse::game::rules::{Call, Game, GameState, Snooker};
use masse::physics::scene::Scene;
use masse::physics::table::Preset;

use super::story::{Story, lay, start};

/// A frame in its middle: player 0 is at the table with these balls, and this is on.
fn frame(on: BallOn, balls: &[(&str, f64, f64)]) -> (GameState, Scene) {
    let (mut state, mut scene) = start(Game::Snooker(Snooker::default()), Preset::Snooker);
    lay(&mut scene, balls);
    state.game = Game::Snooker(Snooker {
        on,
        ..Snooker::default()
    });
    state.standing.shots = 5;
    state.standing.in_hand = None;
    (state, scene)
}

fn rules(state: &GameState) -> &Snooker {
    match &state.game {
        Game::Snooker(rules) => rules,
        other => panic!("not snooker: {other:?}"),
    }
}

fn nominate(scene: &Scene, name: &str) -> Call {
    let ball = scene.ball_named(name).expect("the ball is there");
    Call::Nominate { ball }
}

/// The colours on their spots, two reds, and the cue ball in the open.
fn whole() -> Vec<(&'static str, f64, f64)> {
    let (state, scene) = start(Game::Snooker(Snooker::default()), Preset::Snooker);
    assert_eq!(state.standing.turn, 0);
    let mut balls: Vec<(&str, f64, f64)> = masse::physics::scene::COLOURS
        .into_iter()
        .map(|name| {
            let place = super::story::place(&scene, name);
            (name, place.x, place.y)
        })
        .collect();
    balls.extend([
        ("cue", -0.4, 0.3),
        ("red 1", 0.4, 0.5),
        ("red 2", 0.4, -0.5),
    ]);
    balls
}

/// Points of the opponent after a foul of player 0.
fn cost(story: &Story, state: &GameState, call: &Call) -> i32 {
    let verdict = story.judge(state, call);
    assert!(verdict.is_foul(), "no foul");
    assert_eq!(
        verdict.points[0], 0,
        "a foul gives points to the other side"
    );
    assert_eq!(verdict.next_player(), 1);
    verdict.points[1]
}
