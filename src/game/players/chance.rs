//! How likely a pot is, in closed form: what an eye sees before anything is rehearsed.
//!
//! An error ε of the heading turns the object ball by about ε d / (2R cos φ), d the way of the cue ball and φ the cut
//! angle. The pot goes while that stays within the window of the pocket, so its probability is erf(w / (σ √2)), w half
//! the width of the window and σ the standard deviation of the direction of the object ball.

use glam::DVec2;

use crate::game::placing;
use crate::game::players::noise::Noise;
use crate::game::players::sight::{Mouth, Seen, Sight, toward};
use crate::game::rules::{Area, On};
use crate::physics::scene::Scene;

/// Least cosine of a cut angle that is tried: 80°.
const THINNEST: f64 = 0.17;

/// Widening of a window in rad m, times one over the distance: a ball that rubs a jaw still falls.
const RUBS: f64 = 0.003;

/// Standard deviation in rad that uncertain throw adds to the direction of an object ball, for the hand of `FastFiz`.
const THROW: f64 = 0.003;

/// Ways in m of the cue ball to a ball that is shot at with the cue ball in hand.
const IN_HAND_WAYS: [f64; 2] = [0.2, 0.4];

/// Cut angles in rad from which a ball is shot at with the cue ball in hand.
const IN_HAND_CUTS: [f64; 5] = [0.0, -0.35, 0.35, -0.8, 0.8];

/// A free way of an object ball into a pocket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lane {
    /// Index of the ball.
    pub ball: usize,
    /// Index of the pocket.
    pub pocket: usize,
    /// Where the ball lies, m.
    pub from: DVec2,
    /// The angle in rad of its way.
    pub angle: f64,
    /// Half the width of the window in rad.
    pub half: f64,
    /// Where the centre of the cue ball has to be when they meet, m.
    pub ghost: DVec2,
}

/// A player's eye: the pockets of the table and the errors of the own hand.
#[derive(Clone, Debug)]
pub struct Eye {
    /// The pockets.
    pub mouths: Vec<Mouth>,
    /// Standard deviation of the direction of a struck ball, rad.
    pub direction: f64,
    throw: f64,
}

impl Eye {
    /// The eye of a player with this hand, factor times that of `FastFiz`, on the table of a scene.
    #[must_use]
    pub fn new(scene: &Scene, cue: usize, factor: f64) -> Self {
        Self {
            mouths: Mouth::all(&scene.table),
            direction: Noise::times(factor).direction(&scene.cue, &scene.balls[cue].ball),
            throw: THROW * factor,
        }
    }

    /// The free way of a ball to a pocket, for a cue ball of this radius.
    #[must_use]
    pub fn lane(&self, sight: &Sight, seen: &Seen, pocket: usize, cue: &Seen) -> Option<Lane> {
        let mouth = self.mouths.get(pocket)?;
        let (angle, half) = mouth.window(seen.at, seen.radius)?;
        let way = toward(angle);
        let distance = (mouth.hole - seen.at).dot(way).max(0.0);
        let goal = seen.at + distance * way;
        let ghost = seen.at - (seen.radius + cue.radius) * way;
        let free = sight.is_free(seen.at, goal, seen.radius, [seen.ball, cue.ball]);
        free.then_some(Lane {
            ball: seen.ball,
            pocket,
            from: seen.at,
            angle,
            half: half + RUBS / distance.max(0.02),
            ghost,
        })
    }

    /// The ways of all balls that may be met first and whose pot counts.
    #[must_use]
    pub fn lanes(&self, sight: &Sight, on: &On, cue: &Seen) -> Vec<Lane> {
        let mut lanes = Vec::new();
        for ball in on.pot.iter().filter(|ball| on.first.contains(ball)) {
            let Some(seen) = sight.ball(*ball).filter(|seen| seen.ball != cue.ball) else {
                continue;
            };
            lanes.extend(
                on.pockets
                    .iter()
                    .filter_map(|&pocket| self.lane(sight, seen, pocket, cue)),
            );
        }
        lanes
    }

    /// The probability that the cue ball sends a ball along a lane, from where it is or from another place.
    #[must_use]
    pub fn chance(&self, sight: &Sight, lane: &Lane, cue: &Seen) -> f64 {
        let way = lane.ghost - cue.at;
        let distance = way.length();
        let toward_ball = lane.from - lane.ghost;
        let cosine = way.dot(toward_ball) / (distance * toward_ball.length()).max(1e-12);
        if cosine < THINNEST
            || !sight.is_inside(lane.ghost, cue.radius)
            || !sight.is_free(cue.at, lane.ghost, cue.radius, [cue.ball, lane.ball])
        {
            return 0.0;
        }
        let error = self.direction * (distance / (toward_ball.length() * cosine)).max(0.5);
        let deviation = (error * error + self.throw * self.throw).sqrt();
        let sure = libm::erf(lane.half / (deviation.max(1e-9) * std::f64::consts::SQRT_2));
        // A cue over a rail or a ball is raised, and a raised cue is less sure.
        let rail = (sight.half - cue.at.abs()).min_element() - cue.radius;
        sure * if rail < 0.01 { 0.85 } else { 1.0 } * if cosine < 0.35 { 0.85 } else { 1.0 }
    }

    /// The probability of the best pot from where the cue ball lies, with a little more for a second choice.
    #[must_use]
    pub fn best(&self, sight: &Sight, on: &On, cue: &Seen) -> f64 {
        let (mut first, mut second) = (0.0_f64, 0.0_f64);
        for lane in self.lanes(sight, on, cue) {
            let chance = self.chance(sight, &lane, cue);
            if chance > first {
                (first, second) = (chance, first);
            } else {
                second = second.max(chance);
            }
        }
        first + 0.15 * second * (1.0 - first)
    }

    /// Places in an area for a cue ball in hand with the probability of a pot from each, the best first. Whether there is
    /// room for it is not looked at, see [`placing::is_free`]. `cue` names the ball.
    #[must_use]
    pub fn spots(&self, scene: &Scene, on: &On, area: &Area, cue: usize) -> Vec<(f64, DVec2)> {
        let mut sight = Sight::of(scene);
        sight.balls.retain(|seen| seen.ball != cue);
        let away = Seen {
            ball: cue,
            at: DVec2::ZERO,
            radius: scene.balls[cue].ball.radius,
        };
        let mut spots = Vec::new();
        for lane in self.lanes(&sight, on, &away) {
            for way in IN_HAND_WAYS {
                for cut in IN_HAND_CUTS {
                    let at = lane.ghost - way * toward(lane.angle + cut);
                    let chance = self.chance(&sight, &lane, &Seen { at, ..away });
                    if chance > 0.0 && area.allows(at) {
                        spots.push((chance, at));
                    }
                }
            }
            // Where the area does not reach that far: from its edge.
            let edge = area.nearest(lane.ghost - 0.4 * toward(lane.angle));
            let chance = self.chance(&sight, &lane, &Seen { at: edge, ..away });
            if chance > 0.0 {
                spots.push((chance, edge));
            }
        }
        spots.sort_by(|a, b| b.0.total_cmp(&a.0));
        spots
    }

    /// The probability of the best pot with the cue ball in hand.
    #[must_use]
    pub fn best_in_hand(&self, scene: &Scene, on: &On, area: &Area) -> f64 {
        let spots = self.spots(scene, on, area, on.cue);
        let free = |(_, at): &&(f64, DVec2)| placing::is_free(scene, on.cue, *at);
        spots.iter().find(free).map_or(0.0, |(chance, _)| *chance)
    }
}
