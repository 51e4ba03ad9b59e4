//! More or fewer balls in a crowd scene.

use glam::{DVec2, DVec3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::physics::ball::{Ball, State};
use crate::physics::scene::{Scene, SceneBall};

/// Share of the room that balls may cover: a loose square lattice with room to move in every place.
const DENSEST: f64 = 0.6;

/// A scene like this one with another number of balls: they take the same rectangle of the table and cover the same share
/// of it, at most 0.6, so more balls are smaller balls, of the same material. Speeds are those of the balls of the scene
/// in turn, spins such that the surface of a ball is as fast. The same seed gives the same scene.
///
/// `None` if there is no ball to go by.
#[must_use]
pub fn scattered(like: &Scene, count: usize, seed: u64) -> Option<Scene> {
    let ball = like.balls.first()?.ball;
    let plan = |state: &State| DVec2::new(state.position.x, state.position.z);
    let in_play = || like.balls.iter().filter(|ball| ball.state.motion.in_play());
    let least = in_play().fold(DVec2::INFINITY, |least, b| least.min(plan(&b.state))) - ball.radius;
    let most =
        in_play().fold(DVec2::NEG_INFINITY, |most, b| most.max(plan(&b.state))) + ball.radius;
    let room = most - least;
    let area = room.x * room.y;
    let disc = std::f64::consts::PI * ball.radius * ball.radius;
    let share = (in_play().count() as f64 * disc / area).min(DENSEST);
    if count == 0 || !area.is_finite() || area <= 0.0 {
        return None;
    }
    let radius = (share * area / (count as f64 * std::f64::consts::PI)).sqrt();
    let columns = (count as f64 * room.x / room.y).sqrt().ceil().max(1.0);
    let rows = (count as f64 / columns).ceil();
    let pitch = room / DVec2::new(columns, rows);
    let slack = 0.5 * pitch - radius;
    if slack.min_element() < 0.0 {
        return None;
    }
    let scale = radius / ball.radius;
    let other = Ball {
        radius,
        mass: ball.mass * scale * scale * scale,
        ..ball
    };
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut jitter = |slack: f64| 0.9 * slack * (2.0 * rng.random::<f64>() - 1.0);
    let models: Vec<&SceneBall> = in_play().collect();
    let balls = (0..count)
        .map(|i| {
            let model = models[i % models.len()].state;
            let at = DVec2::new(i as f64 % columns, (i as f64 / columns).floor()) + 0.5;
            let at = least + at * pitch + DVec2::new(jitter(slack.x), jitter(slack.y));
            SceneBall {
                name: i.to_string(),
                ball: other,
                state: State {
                    position: DVec3::new(at.x, radius, at.y),
                    velocity: model.velocity,
                    angular_velocity: model.angular_velocity / scale,
                    motion: model.motion,
                },
            }
        })
        .collect();
    Some(Scene {
        balls,
        table: like.table.clone(),
        ..*like
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::laws::Laws;
    use crate::physics::table::Preset;

    fn gas() -> Scene {
        let table = Preset::Box {
            length: 2.0,
            width: 1.0,
        };
        let mut scene = Scene::new(table.table(), Laws::ideal());
        for i in 0..200 {
            let (x, z) = (f64::from(i % 20), f64::from(i / 20));
            let name = i.to_string();
            let at = scene.place(&name, Ball::POOL, 0.1 * x - 0.95, 0.1 * z - 0.45);
            scene.balls[at].state.velocity.x = 0.01 * f64::from(i);
        }
        scene
    }

    #[test]
    fn any_number_covers_the_same_share_without_overlap() {
        let like = gas();
        let covered = |scene: &Scene| {
            let squares = scene.balls.iter().map(|b| b.ball.radius * b.ball.radius);
            squares.sum::<f64>()
        };
        for count in [1, 7, 100, 333, 2000] {
            let scene = scattered(&like, count, 3).expect("there is room");
            assert_eq!(scene.balls.len(), count);
            assert!((covered(&scene) / covered(&like) - 1.0).abs() < 1e-9);
            for (i, a) in scene.balls.iter().enumerate() {
                let half = 0.5 * DVec2::new(2.0, 1.0) - a.ball.radius + 1e-12;
                let at = a.state.position;
                assert!(at.x.abs() <= half.x && at.z.abs() <= half.y, "{at}");
                for b in &scene.balls[..i] {
                    let apart = at.distance(b.state.position);
                    assert!(apart >= a.ball.radius + b.ball.radius, "{apart}");
                }
            }
            assert_eq!(scattered(&like, count, 3), Some(scene));
        }
        let twice = scattered(&like, 400, 1).expect("there is room");
        assert_eq!(
            twice.balls[0].state.velocity,
            twice.balls[200].state.velocity
        );
        assert_eq!(scattered(&like, 0, 1), None);
    }
}
