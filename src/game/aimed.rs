//! What a shot that is aimed means to do: the call that goes with it.

use glam::{DVec2, DVec3};

use crate::game::guide;
use crate::game::rules::{Call, CallNeeded, On};
use crate::physics::cue::Shot;
use crate::physics::scene::Scene;

/// How far in m the ball that is hit is followed: beyond the longest table.
const REACH: f64 = 10.0;

/// The call for a shot as it is aimed: the ball that the cue ball meets first, into the pocket that its way leads nearest
/// to. Where that is called already, into the pocket that comes next. `None` if nothing has to be called, or if the shot
/// meets no ball that may be.
#[must_use]
pub fn call(scene: &Scene, on: &On, shot: &Shot, called: Call) -> Option<Call> {
    let guide = guide::first_contact(scene, on.cue, shot, REACH).ok()?;
    let guide::Hit::Ball(ball) = guide.first.hit else {
        return None;
    };
    let object = guide.object.filter(|leg| leg.ball == ball)?;
    if !on.pot.contains(&ball) {
        return None;
    }
    match on.call_needed {
        CallNeeded::No => None,
        CallNeeded::Ball => Some(Call::Nominate { ball }),
        CallNeeded::BallAndPocket => {
            let from = plan(scene.balls[ball].state.position);
            let way = plan(*object.points.get(1)?) - from;
            let pockets = by_direction(scene, on, from, way);
            let next = match called {
                Call::Pot { ball: same, pocket } if same == ball => {
                    let at = pockets.iter().position(|known| *known == pocket);
                    at.map_or(0, |at| at + 1)
                }
                _ => 0,
            };
            let pocket = *pockets.get(next % pockets.len().max(1))?;
            Some(Call::Pot { ball, pocket })
        }
    }
}

/// The pockets that count, the one straight ahead first.
fn by_direction(scene: &Scene, on: &On, from: DVec2, way: DVec2) -> Vec<usize> {
    let mut pockets: Vec<(f64, usize)> = on
        .pockets
        .iter()
        .filter_map(|&pocket| {
            let to = scene.table.pockets.get(pocket)?.center - from;
            Some((-to.normalize_or_zero().dot(way.normalize_or_zero()), pocket))
        })
        .collect();
    pockets.sort_by(|a, b| a.0.total_cmp(&b.0));
    pockets.into_iter().map(|(_, pocket)| pocket).collect()
}

fn plan(point: DVec3) -> DVec2 {
    DVec2::new(point.x, point.z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::ball::Ball;
    use crate::physics::laws::Laws;
    use crate::physics::table::Preset;

    #[test]
    fn the_ball_that_is_aimed_at_is_called_into_the_pocket_ahead_and_then_the_next() {
        let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
        scene.place("cue", Ball::POOL, -0.3, 0.0);
        let ball = scene.place("1", Ball::POOL, 0.3, 0.0);
        let other = scene.place("2", Ball::POOL, -0.3, 0.3);
        let on = On {
            pot: vec![ball],
            pockets: (0..6).collect(),
            call_needed: CallNeeded::BallAndPocket,
            ..On::default()
        };
        // Straight at the ball a little above its middle: it goes to the foot, to the other side.
        let corner = (0..6).max_by(|a, b| {
            let x = |i: &usize| scene.table.pockets[*i].center;
            (x(a).x + x(a).y).total_cmp(&(x(b).x + x(b).y))
        });
        let way = scene.table.pockets[corner.expect("six")].center - DVec2::new(0.3, 0.0);
        let ghost = DVec2::new(0.3, 0.0) - 2.0 * Ball::POOL.radius * way.normalize();
        let level = |at: DVec2| DVec3::new(at.x, 0.0, at.y);
        let from = scene.balls[0].state.position;
        let shot = Shot {
            heading: Shot::heading_between(level(plan(from)), level(ghost)),
            ..Shot::default()
        };
        let first = call(&scene, &on, &shot, Call::Nothing).expect("it meets the 1");
        assert_eq!(
            first,
            Call::Pot {
                ball,
                pocket: corner.expect("six")
            }
        );
        let mut called = first;
        let mut seen = Vec::new();
        for _ in 0..6 {
            called = call(&scene, &on, &shot, called).expect("there is a next one");
            assert!(!seen.contains(&called));
            seen.push(called);
        }
        assert_eq!(called, first, "all six, and round again");
        // The other ball is not on.
        let shot = Shot {
            heading: Shot::heading_between(from, scene.balls[other].state.position),
            ..Shot::default()
        };
        assert_eq!(call(&scene, &on, &shot, Call::Nothing), None);
    }
}
