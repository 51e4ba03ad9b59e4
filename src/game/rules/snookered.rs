//! Whether a ball can be hit: the cue ball's straight ways to both sides of it.

use glam::DVec2;

use crate::game::rules::area::Area;
use crate::game::rules::targets::in_play;
use crate::physics::scene::Scene;

/// Overlap in m that does not bar a way: rounding.
const EDGE: f64 = 1e-9;

/// Points along each side of the D that are tried with the cue ball in hand.
const TRIED: u32 = 24;

fn plan(scene: &Scene, ball: usize) -> DVec2 {
    let position = scene.balls[ball].state.position;
    DVec2::new(position.x, position.z)
}

/// Whether the way of the cue ball's centre between two points is clear of these balls.
fn is_clear(scene: &Scene, cue: usize, from: DVec2, to: DVec2, bars: &[usize]) -> bool {
    let way = to - from;
    bars.iter().all(|&ball| {
        let reach = scene.balls[cue].ball.radius + scene.balls[ball].ball.radius;
        let center = plan(scene, ball);
        let share = (center - from).dot(way) / way.length_squared().max(f64::MIN_POSITIVE);
        (from + share.clamp(0.0, 1.0) * way).distance(center) >= reach - EDGE
    })
}

/// Where the centre of the cue ball is when it touches a ball at one of its edges: `side` −1 left, 1 right, 0 full.
fn touching(from: DVec2, target: DVec2, reach: f64, side: f64) -> DVec2 {
    let way = target - from;
    let distance = way.length();
    if side == 0.0 || distance <= reach {
        return target - way.normalize_or_zero() * reach;
    }
    // The tangent to the circle of radius `reach` around the target.
    let sine = reach / distance;
    let cosine = (1.0 - sine * sine).sqrt();
    let along = way / distance;
    let turned = cosine * along + side * sine * along.perp();
    from + distance * cosine * turned
}

/// Whether the cue ball here can hit both edges of one of the balls on by straight lines, with only these balls in the
/// way.
fn is_open_from(scene: &Scene, cue: usize, from: DVec2, on: &[usize], bars: &[usize]) -> bool {
    on.iter().any(|&ball| {
        let reach = scene.balls[cue].ball.radius + scene.balls[ball].ball.radius;
        let target = plan(scene, ball);
        [-1.0, 1.0].into_iter().all(|side| {
            let to = touching(from, target, reach, side);
            is_clear(scene, cue, from, to, bars)
        })
    })
}

/// The places from which the cue ball may be played.
fn starts(scene: &Scene, cue: usize, in_hand: Option<Area>) -> Vec<DVec2> {
    let Some(area) = in_hand else {
        return vec![plan(scene, cue)];
    };
    let (least, most) = area.bounds();
    (0..=TRIED)
        .flat_map(|i| (0..=TRIED).map(move |j| DVec2::new(f64::from(i), f64::from(j))))
        .map(|share| least + share / f64::from(TRIED) * (most - least))
        .filter(|spot| area.is_legal(scene, cue, *spot))
        .collect()
}

/// Whether the cue ball is snookered on all of these balls by balls that are not among them: from no place where it may
/// be played can it hit both edges of any. With nothing on nobody is snookered.
#[must_use]
pub fn is_snookered(scene: &Scene, cue: usize, in_hand: Option<Area>, on: &[usize]) -> bool {
    let bars: Vec<usize> = in_play(scene)
        .filter(|ball| *ball != cue && !on.contains(ball))
        .collect();
    !on.is_empty() && is_snookered_by(scene, cue, in_hand, on, &bars)
}

/// Whether the cue ball is snookered on all of these balls by these others.
#[must_use]
pub fn is_snookered_by(
    scene: &Scene,
    cue: usize,
    in_hand: Option<Area>,
    on: &[usize],
    bars: &[usize],
) -> bool {
    let starts = starts(scene, cue, in_hand);
    !starts
        .into_iter()
        .any(|from| is_open_from(scene, cue, from, on, bars))
}

/// Whether one of these balls can be hit full by a straight line.
#[must_use]
pub fn is_full_ball_open(scene: &Scene, cue: usize, on: &[usize]) -> bool {
    let from = plan(scene, cue);
    on.iter().any(|&ball| {
        let reach = scene.balls[cue].ball.radius + scene.balls[ball].ball.radius;
        let to = touching(from, plan(scene, ball), reach, 0.0);
        let bars: Vec<usize> = in_play(scene)
            .filter(|&other| other != cue && other != ball)
            .collect();
        is_clear(scene, cue, from, to, &bars)
    })
}
