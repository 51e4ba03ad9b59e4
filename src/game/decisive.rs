//! The pot that decides a rack: known when the cue strikes, for the solver knows the whole shot.

use crate::game::preview::preview;
use crate::game::rules::{Call, GameState};
use crate::physics::cue::Shot;
use crate::physics::record::EventKind;
use crate::physics::scene::Scene;

/// Seconds after the stroke at which the ball drops that wins the rack for whoever plays this shot, if one does. `before`
/// is the table before the stroke.
#[must_use]
pub fn decisive_pot(state: &GameState, before: &Scene, call: &Call, shot: &Shot) -> Option<f64> {
    let player = state.standing.turn;
    let record = preview(before, state.cue_ball(before), shot).ok()?;
    let verdict = state.judge(before, &record, call);
    let over = verdict.next.standing.over.as_ref()?;
    if over.winner != Some(player) {
        return None;
    }
    record
        .events
        .iter()
        .filter(|event| {
            matches!(event.kind, EventKind::Pocketed { .. })
                && verdict.made.contains(&event.first.ball)
        })
        .map(|event| event.time)
        .fold(None, |last, time| Some(last.unwrap_or(0.0).max(time)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::rules::Game;
    use crate::physics::ball::{Ball, Motion};
    use crate::physics::laws::Laws;
    use crate::physics::table::Preset;
    use glam::DVec2;

    /// A table of nine-ball on which only these balls are left: the cue ball, and others before the pocket at the foot.
    fn left(names: &[&str]) -> (GameState, Scene) {
        let mut like = Scene::new(Preset::NineFoot.table(), Laws::default());
        like.place("cue", Ball::POOL, -0.6, 0.0);
        let game = Game::named("9-ball").expect("it is among the games");
        let (mut state, mut scene) = GameState::start(game, 2, 0, &like, 1);
        let (pocket, out) = corner(&scene);
        for (i, ball) in scene.balls.iter_mut().enumerate() {
            let place = |back: f64| pocket - back * out;
            let at = if i == state.cue_ball(&like) {
                Some(place(0.55))
            } else {
                let rank = names.iter().position(|name| *name == ball.name);
                rank.map(|rank| place(0.12) + f64::from(rank as u32) * DVec2::new(-0.8, 0.0))
            };
            match at {
                Some(at) => (ball.state.position.x, ball.state.position.z) = (at.x, at.y),
                None => ball.state.motion = Motion::Pocketed,
            }
        }
        // Not the break any more.
        state.standing.shots = 5;
        (state, scene)
    }

    /// A pocket in a corner, and the way into it.
    fn corner(scene: &Scene) -> (DVec2, DVec2) {
        let pockets = scene.table.pockets.iter().map(|pocket| pocket.center);
        let at = pockets
            .max_by(|a, b| (a.x + a.y).total_cmp(&(b.x + b.y)))
            .expect("a table of nine-ball has pockets");
        (at, at.signum() / 2.0_f64.sqrt())
    }

    fn at_the_pocket(scene: &Scene, speed: f64) -> Shot {
        let (_, way) = corner(scene);
        Shot {
            heading: libm::atan2(-way.y, way.x),
            speed,
            // The cue ball stays behind.
            height: -0.45,
            ..Shot::default()
        }
    }

    #[test]
    fn the_last_ball_of_a_rack_decides_and_no_other() {
        let (state, scene) = left(&["9"]);
        let shot = at_the_pocket(&scene, 2.0);
        let time = decisive_pot(&state, &scene, &Call::Nothing, &shot);
        let time = time.expect("the nine drops");
        assert!((0.1..3.0).contains(&time), "{time}");
        let soft = at_the_pocket(&scene, 0.05);
        assert_eq!(decisive_pot(&state, &scene, &Call::Nothing, &soft), None);

        let (state, scene) = left(&["8", "9"]);
        let shot = at_the_pocket(&scene, 2.0);
        assert_eq!(decisive_pot(&state, &scene, &Call::Nothing, &shot), None);
    }
}
