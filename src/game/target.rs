//! Which ball the cue points at when the player has not said.

use glam::DVec3;

use crate::physics::cue::Shot;
use crate::physics::scene::{Rack, Scene};

/// The heading in rad from a ball to the next one to hit: in 9-ball the lowest number, else the nearest ball with a
/// free way to it, else the nearest ball. `None` if no other ball is in play.
#[must_use]
pub fn heading(scene: &Scene, ball: usize, rack: Rack) -> Option<f64> {
    let from = scene.balls.get(ball)?.state.position;
    let mut others: Vec<usize> = in_play(scene).filter(|other| *other != ball).collect();
    others.sort_by(|a, b| {
        let distance = |i: &usize| scene.balls[*i].state.position.distance_squared(from);
        distance(a).total_cmp(&distance(b))
    });
    let lowest = match rack {
        Rack::NineBall | Rack::NineOnSpot | Rack::TenBall => others
            .iter()
            .filter_map(|&other| Some((scene.balls[other].name.parse::<u32>().ok()?, other)))
            .min()
            .map(|(_, other)| other),
        _ => None,
    };
    let target = lowest
        .or_else(|| {
            others
                .iter()
                .copied()
                .find(|other| is_way_free(scene, ball, *other))
        })
        .or_else(|| others.first().copied())?;
    Some(Shot::heading_between(
        from,
        scene.balls[target].state.position,
    ))
}

/// The heading in rad from a ball to the object ball that comes next (`step` 1) or before (−1) in the order of
/// directions around it, counted from the present heading. `None` if no other ball is in play.
#[must_use]
pub fn beside(scene: &Scene, ball: usize, heading: f64, step: i32) -> Option<f64> {
    use std::f64::consts::TAU;
    let from = scene.balls.get(ball)?.state.position;
    in_play(scene)
        .filter(|other| *other != ball)
        .map(|other| {
            let to = Shot::heading_between(from, scene.balls[other].state.position);
            let turn = (f64::from(step) * (to - heading)).rem_euclid(TAU);
            // The ball aimed at now comes last.
            (if turn < 1e-9 { TAU } else { turn }, to)
        })
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, to)| to)
}

fn in_play(scene: &Scene) -> impl Iterator<Item = usize> {
    (0..scene.balls.len()).filter(|&ball| scene.balls[ball].state.motion.in_play())
}

/// Whether a ball that rolls straight from one ball to another meets no third ball first.
fn is_way_free(scene: &Scene, from: usize, to: usize) -> bool {
    let place = |ball: usize| scene.balls[ball].state.position;
    let way = place(to) - place(from);
    let reach = |other: usize| scene.balls[from].ball.radius + scene.balls[other].ball.radius;
    in_play(scene)
        .filter(|&other| other != from && other != to)
        .all(|other| {
            let share = (place(other) - place(from)).dot(way) / way.length_squared();
            let foot: DVec3 = place(from) + share.clamp(0.0, 1.0) * way;
            foot.distance(place(other)) >= reach(other)
        })
}
