//! Exact places for a ball that is placed by hand: touching another ball, touching a rail, on a diamond.

use glam::DVec2;

use crate::game::placing::{is_free, nearest_free};
use crate::physics::scene::Scene;

/// Steps in which places around a ball are tried, half of them to either side.
const AROUND: u32 = 720;

/// Widest gap in m that rounding leaves between what should touch.
const ROUNDING: f64 = 1e-12;

fn plan(scene: &Scene, ball: usize) -> Option<DVec2> {
    let placed = scene.balls.get(ball)?;
    let at = placed.state.position;
    placed
        .state
        .motion
        .in_play()
        .then_some(DVec2::new(at.x, at.z))
}

/// The free spot where this ball touches another: on the line between them, else as near to it as there is room.
#[must_use]
pub fn to_ball(scene: &Scene, ball: usize, other: usize) -> Option<DVec2> {
    if ball == other {
        return None;
    }
    let (at, center) = (plan(scene, ball)?, plan(scene, other)?);
    let apart = scene.balls[ball].ball.radius + scene.balls[other].ball.radius;
    let out = (at - center).try_normalize().unwrap_or(DVec2::NEG_X);
    (0..=AROUND).find_map(|step| {
        let turn = f64::from(step.div_ceil(2)) * std::f64::consts::TAU / f64::from(AROUND);
        let turn = if step % 2 == 0 { turn } else { -turn };
        let (sin, cos) = libm::sincos(turn);
        let way = DVec2::new(cos, sin).rotate(out);
        touching(scene, ball, |gap| center + (apart + gap) * way)
    })
}

/// The ball in play whose surface is nearest to that of this one.
#[must_use]
pub fn nearest_ball(scene: &Scene, ball: usize) -> Option<usize> {
    let at = plan(scene, ball)?;
    let gap = |other: &usize| {
        plan(scene, *other).map_or(f64::INFINITY, |center| {
            at.distance(center) - scene.balls[*other].ball.radius
        })
    };
    (0..scene.balls.len())
        .filter(|other| *other != ball && plan(scene, *other).is_some())
        .min_by(|a, b| gap(a).total_cmp(&gap(b)))
}

/// The nearest free spot where this ball touches one of the four rails.
#[must_use]
pub fn to_rail(scene: &Scene, ball: usize) -> Option<DVec2> {
    let at = plan(scene, ball)?;
    let reach = scene.table.reach(scene.balls[ball].ball.radius);
    let half = 0.5 * DVec2::new(scene.table.length, scene.table.width) - reach;
    let sides = [
        (DVec2::X, at.with_x(half.x)),
        (DVec2::NEG_X, at.with_x(-half.x)),
        (DVec2::Y, at.with_y(half.y)),
        (DVec2::NEG_Y, at.with_y(-half.y)),
    ];
    sides
        .into_iter()
        .filter_map(|(out, spot)| touching(scene, ball, |gap| spot - gap * out))
        .min_by(|a, b| at.distance(*a).total_cmp(&at.distance(*b)))
}

/// The crossing of the lines through diamonds that is nearest to this ball and inside the rails; where that is taken, the
/// nearest free spot beside it.
#[must_use]
pub fn to_diamond(scene: &Scene, ball: usize) -> Option<DVec2> {
    let diamonds = scene.table.diamonds_of(plan(scene, ball)?);
    let whole = DVec2::new(
        diamonds.x.round().clamp(1.0, 3.0),
        diamonds.y.round().clamp(1.0, 7.0),
    );
    nearest_free(scene, ball, scene.table.at_diamonds(whole))
}

/// The spot with the least gap that counts as free.
fn touching(scene: &Scene, ball: usize, spot: impl Fn(f64) -> DVec2) -> Option<DVec2> {
    [0.0, 1e-3 * ROUNDING, ROUNDING]
        .into_iter()
        .map(spot)
        .find(|spot| is_free(scene, ball, *spot))
}
