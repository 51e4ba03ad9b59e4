//! Where the balls of a scene may be.

use glam::DVec2;

use crate::physics::ball::Motion;
use crate::physics::laws::cluster::{Other, inside};
use crate::physics::laws::pocket::PocketLaw;
use crate::physics::scene::check::in_play;
use crate::physics::scene::{Scene, SceneBall, SceneError};
use crate::physics::table::Ground;

/// Overlap in m that still counts as touching: rounding of positions written in a file.
pub const OVERLAP_TOLERANCE: f64 = 1e-9;

/// A ball whose centre comes nearer than this share of its radius to the nose line passes over the nose, or under it.
const LEAST_REACH: f64 = 0.1;

/// How deep in m a ball may be in the edge of a pocket: over it balls roll in straight pieces.
const SUNK: f64 = 1e-4;

impl Scene {
    /// Every ball lies on the slate, clear of cushions and holes.
    pub(super) fn check_places(&self) -> Result<(), SceneError> {
        for ball in &self.balls {
            let (radius, position) = (ball.ball.radius, ball.state.position);
            let name = || ball.name.clone();
            if 2.0 * radius > self.table.length.min(self.table.width) {
                return Err(SceneError::TableTooSmall {
                    length: self.table.length,
                    width: self.table.width,
                    ball: name(),
                    radius,
                });
            }
            if !in_play(ball) {
                continue;
            }
            // One that begins in the air comes down.
            let nose_height = self.table.nose_height;
            let reach = self.table.nose.reach_at(nose_height, radius, radius);
            let held = reach.is_some_and(|reach| reach >= LEAST_REACH * radius);
            if !held && !self.table.cushions.is_empty() {
                return Err(SceneError::NotHeld {
                    ball: name(),
                    radius,
                    nose_height,
                });
            }
            let height = position.y - radius;
            let flies = self.laws.motion.gravity().is_some()
                && (height > OVERLAP_TOLERANCE || self.is_in_pocket(ball)?);
            if height.abs() > OVERLAP_TOLERANCE && !flies {
                return Err(SceneError::OffSlate {
                    ball: name(),
                    height: position.y,
                    radius,
                });
            }
            let plan = DVec2::new(position.x, position.z);
            for (cushion, nose) in self.table.cushions.iter().enumerate() {
                let (profile, nose_height) = (&self.table.nose, self.table.nose_height);
                let Some(reach) = profile.reach_at(nose_height, radius, position.y) else {
                    continue;
                };
                let overlap = reach - nose.nearest(plan).0;
                if overlap > OVERLAP_TOLERANCE {
                    return Err(SceneError::InsideCushion {
                        ball: name(),
                        cushion,
                        overlap,
                    });
                }
            }
            for pocket in &self.table.pockets {
                let distance = (plan - pocket.center).length();
                if distance < pocket.radius && !flies {
                    return Err(SceneError::OverPocket {
                        ball: name(),
                        pocket: pocket.name.clone(),
                        overlap: pocket.radius - distance,
                    });
                }
            }
            // On the shelf of a pocket a ball can rest past the line of the noses.
            if self.table.beyond(plan) > 0.0 && self.table.ground(plan) == Ground::Off {
                return Err(SceneError::OffTable {
                    ball: name(),
                    x: plan.x,
                    z: plan.y,
                });
            }
        }
        Ok(())
    }

    /// Whether a ball is wedged where a pocket could hold it. What nothing holds falls from there.
    fn is_in_pocket(&self, ball: &SceneBall) -> Result<bool, SceneError> {
        if ball.state.motion != Motion::Wedged {
            return Ok(false);
        }
        let position = ball.state.position;
        let plan = DVec2::new(position.x, position.z);
        let mut near = false;
        for (index, pocket) in self.table.pockets.iter().enumerate() {
            // Behind the hole a ball may lie in the liner, however deep.
            let edge = Other::Rim(index as u32);
            let met = inside(&self.laws, &self.table, (&ball.ball, &ball.state), edge);
            let overlap = met.map_or(0.0, |met| -met.gap);
            let reach = pocket.radius + ball.ball.radius;
            if plan.distance(pocket.center) > reach || position.y < -pocket.depth {
                continue;
            }
            near = true;
            if overlap > SUNK {
                return Err(SceneError::InsidePocket {
                    ball: ball.name.clone(),
                    pocket: pocket.name.clone(),
                    overlap,
                });
            }
        }
        Ok(near)
    }

    /// Where balls fall into pockets, every ball falls through every pocket.
    pub(super) fn check_pockets(&self) -> Result<(), SceneError> {
        let (PocketLaw::Rim(rim), Some(_)) = (self.laws.pocket, self.laws.motion.gravity()) else {
            return Ok(());
        };
        let playing = self.balls.iter().filter(|ball| in_play(ball));
        let Some(largest) = playing.max_by(|a, b| a.ball.radius.total_cmp(&b.ball.radius)) else {
            return Ok(());
        };
        for pocket in &self.table.pockets {
            // Between the noses of its throat, and inside the wall.
            let noses = self.table.cushions.iter();
            let throat = noses
                .map(|nose| nose.nearest(pocket.center).0)
                .fold(f64::INFINITY, f64::min);
            let most = throat.min(pocket.radius - rim.edge);
            if largest.ball.radius > most {
                return Err(SceneError::TooLargeForPocket {
                    ball: largest.name.clone(),
                    radius: largest.ball.radius,
                    pocket: pocket.name.clone(),
                    most,
                });
            }
        }
        Ok(())
    }

    /// No two balls overlap. The balls are swept along x, so that a crowd costs little more than its neighbours; the
    /// pair that is named is the first in scene order.
    pub(super) fn check_overlaps(&self) -> Result<(), SceneError> {
        let mut swept: Vec<(f64, usize)> = (0..)
            .zip(&self.balls)
            .filter(|(_, ball)| in_play(ball))
            .map(|(i, ball)| (ball.state.position.x, i))
            .collect();
        swept.sort_by(|a, b| a.0.total_cmp(&b.0));
        let largest = self
            .balls
            .iter()
            .map(|ball| ball.ball.radius)
            .fold(0.0, f64::max);
        let mut worst: Option<(usize, usize, f64)> = None;
        for (k, &(x, i)) in swept.iter().enumerate() {
            let first = &self.balls[i];
            let reach = first.ball.radius + largest;
            for &(_, j) in swept[k + 1..]
                .iter()
                .take_while(|(other, _)| other - x < reach)
            {
                let second = &self.balls[j];
                let distance = (first.state.position - second.state.position).length();
                let overlap = first.ball.radius + second.ball.radius - distance;
                let pair = (i.max(j), i.min(j), overlap);
                let sooner = worst.is_none_or(|(late, early, _)| (pair.0, pair.1) < (late, early));
                if overlap > OVERLAP_TOLERANCE && sooner {
                    worst = Some(pair);
                }
            }
        }
        match worst {
            Some((late, early, overlap)) => Err(SceneError::Overlap {
                first: self.balls[early].name.clone(),
                second: self.balls[late].name.clone(),
                overlap,
            }),
            None => Ok(()),
        }
    }
}
