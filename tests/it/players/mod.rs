//! The computer opponents: hands, thoughts, whole racks.

mod contests;
mod hands;
mod thoughts;

use glam::DVec2;
use masse::game::rules::eight_ball::Phase;
use masse::game::rules::{EightBall, Game, GameState};
use masse::physics::ball::Motion;
use masse::physics::laws::Laws;
use masse::physics::scene::Scene;
use masse::physics::table::Preset;

/// A pool table.
fn pool() -> Scene {
    Scene::new(Preset::NineFoot.table(), Laws::default())
}

/// A game of 8-ball in its course: the player at the table has the solids, and only these balls lie on the table, by number,
/// 0 for the cue ball.
fn eight_ball(balls: &[(u8, f64, f64)]) -> (GameState, Scene) {
    let (mut state, mut scene) =
        GameState::start(Game::EightBall(EightBall::default()), 2, 0, &pool(), 1);
    state.standing.in_hand = None;
    state.standing.shots = 5;
    if let Game::EightBall(rules) = &mut state.game {
        rules.phase = Phase::Closed { solids: 0 };
    }
    for placed in &mut scene.balls {
        placed.state.motion = Motion::Pocketed;
    }
    for &(number, x, z) in balls {
        lay(&mut scene, number, DVec2::new(x, z));
    }
    scene.check().expect("the balls have room");
    (state, scene)
}

/// Lays a ball down.
fn lay(scene: &mut Scene, number: u8, at: DVec2) {
    let name = if number == 0 {
        "cue".to_owned()
    } else {
        number.to_string()
    };
    let ball = scene.ball_named(&name).expect("a ball of the rack");
    masse::game::players::contest::put(scene, ball, at);
}
