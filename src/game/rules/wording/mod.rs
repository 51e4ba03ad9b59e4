//! Everything that the rules say to people, in one place: the English sentence, and the key of its translation.

mod fouls;
mod notes;

use crate::game::rules::Game;
use crate::game::rules::targets::number;
use crate::game::saying::{Saying, Value};
use crate::physics::scene::Scene;

/// A ball with a name of its own.
struct Known {
    /// The name in a scene.
    name: &'static str,
    /// Key and words within a sentence.
    within: (&'static str, &'static str),
    /// Key and words of a name that stands alone.
    alone: (&'static str, &'static str),
}

const fn ball_called(
    name: &'static str,
    within: (&'static str, &'static str),
    alone: (&'static str, &'static str),
) -> Known {
    Known {
        name,
        within,
        alone,
    }
}

/// The reds of snooker are all alike; that of three-cushion is the only one.
const KNOWN: [Known; 10] = [
    ball_called(
        "cue",
        ("ball-cue", "the cue ball"),
        ("name-cue", "cue ball"),
    ),
    ball_called("red 1", ("ball-a-red", "a red"), ("name-red", "red")),
    ball_called("red", ("ball-red", "the red"), ("name-red", "red")),
    ball_called(
        "yellow",
        ("ball-yellow", "the yellow"),
        ("name-yellow", "yellow"),
    ),
    ball_called(
        "green",
        ("ball-green", "the green"),
        ("name-green", "green"),
    ),
    ball_called(
        "brown",
        ("ball-brown", "the brown"),
        ("name-brown", "brown"),
    ),
    ball_called("blue", ("ball-blue", "the blue"), ("name-blue", "blue")),
    ball_called("pink", ("ball-pink", "the pink"), ("name-pink", "pink")),
    ball_called(
        "black",
        ("ball-black", "the black"),
        ("name-black", "black"),
    ),
    ball_called(
        "white",
        ("ball-white", "the white"),
        ("name-white", "white"),
    ),
];

fn known(name: &str) -> Option<&'static Known> {
    let name = if name.starts_with("red ") {
        "red 1"
    } else {
        name
    };
    KNOWN.iter().find(|known| known.name == name)
}

/// What a game is called.
#[must_use]
pub fn title(game: &Game) -> Saying {
    let code = game.rules().code();
    let key = format!("game-{}", code.name.replace('.', "-"));
    Saying::new(key, &[], code.title)
}

/// A ball within a sentence: the 8, the cue ball, the blue, a red.
#[must_use]
pub fn ball(scene: &Scene, ball: usize) -> Saying {
    let Some(placed) = scene.balls.get(ball) else {
        let values = vec![("number", ball.into())];
        return Saying::of("ball-unknown", values, "ball number {number}");
    };
    if let Some(Known { within, .. }) = known(&placed.name) {
        Saying::new(within.0, &[], within.1)
    } else {
        let values = vec![("name", placed.name.as_str().into())];
        Saying::of("ball-named", values, "the {name}")
    }
}

/// A ball that stands alone, as on a button: 8, blue, red.
#[must_use]
pub fn ball_alone(scene: &Scene, ball: usize) -> Saying {
    let name = scene.balls.get(ball).map_or("?", |ball| ball.name.as_str());
    match known(name) {
        Some(Known { alone, .. }) => Saying::new(alone.0, &[], alone.1),
        None => Saying::from(name.to_owned()),
    }
}

/// A pocket, as `side left`.
#[must_use]
pub fn pocket(scene: &Scene, pocket: usize) -> Saying {
    if let Some(pocket) = scene.table.pockets.get(pocket) {
        let key = format!("pocket-{}", pocket.name.replace(' ', "-"));
        Saying::new(key, &[], pocket.name.as_str())
    } else {
        let values = vec![("number", pocket.into())];
        Saying::of("pocket-unknown", values, "number {number}")
    }
}

/// The balls in the order of their numbers, each name once.
fn in_order(scene: &Scene, balls: &[usize], name: fn(&Scene, usize) -> Saying) -> Vec<Saying> {
    let mut balls = balls.to_vec();
    balls.sort_by_key(|&ball| (number(scene, ball), ball));
    let mut names: Vec<Saying> = Vec::new();
    for name in balls.iter().map(|&ball| name(scene, ball)) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// One or another of these balls, in the order of their numbers, each name once.
#[must_use]
pub fn any_of(scene: &Scene, balls: &[usize]) -> Value {
    Value::AnyOf(in_order(scene, balls, ball))
}

/// All of these balls, in the order of their numbers, each name once.
fn all_of(scene: &Scene, balls: &[usize]) -> Value {
    Value::AllOf(in_order(scene, balls, ball))
}

/// These balls by names that stand alone, in the order of their numbers, each name once.
#[must_use]
pub fn alone(scene: &Scene, balls: &[usize]) -> Vec<Saying> {
    in_order(scene, balls, ball_alone)
}

/// Somebody by name; players without one are counted.
fn who(names: &[String], player: usize) -> Value {
    if let Some(name) = names.get(player).filter(|name| !name.is_empty()) {
        name.as_str().into()
    } else {
        let values = vec![("number", (player + 1).into())];
        Saying::of("match-player", values, "Player {number}").into()
    }
}

/// The form of an English word that a number takes.
fn plural<'a>(number: i64, one: &'a str, many: &'a str) -> &'a str {
    if number == 1 { one } else { many }
}
