//! Spotting: where a ball goes that comes back to the table.

use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

use crate::game::placing;
use crate::physics::ball::{Motion, State};
use crate::physics::scene::Scene;

/// Gap in m left where a ball must lie near another without touching it.
pub const APART: f64 = 1e-4;

/// Rounding of a place beside a ball, m: less than counts as an overlap.
const ROUNDING: f64 = 1e-12;

/// A ball put back by the referee.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Spotted {
    /// Index of the ball in the scene.
    pub ball: usize,
    /// Where its centre comes to lie, x and z in m.
    pub position: DVec2,
}

/// Puts balls back on a table, one after the other, each in the way of the next.
#[derive(Clone, Debug)]
pub struct Spotter {
    scene: Scene,
    /// What was put back, in order.
    pub spotted: Vec<Spotted>,
}

/// What may touch what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touching {
    /// Against an object ball, but clear of the cue ball: pool.
    Object,
    /// Clear of every ball: snooker.
    Nothing,
}

impl Spotter {
    /// Begins with the table as the stroke left it; a cue ball that comes in hand should be out of play in it.
    #[must_use]
    pub fn new(scene: Scene) -> Self {
        Self {
            scene,
            spotted: Vec::new(),
        }
    }

    /// The table with everything put back so far.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The table with everything put back.
    #[must_use]
    pub fn into_scene(self) -> Scene {
        self.scene
    }

    /// Puts a ball down here, whatever lies there.
    pub fn put(&mut self, ball: usize, position: DVec2) {
        let placed = &mut self.scene.balls[ball];
        placed.state = State::at_rest(DVec3::new(position.x, placed.ball.radius, position.y));
        self.spotted.push(Spotted { ball, position });
    }

    /// Takes a ball off the table, to be put down again.
    pub fn lift(&mut self, ball: usize) {
        self.scene.balls[ball].state.motion = Motion::OffTable;
    }

    /// Whether this spot is free for this ball: on pool spots a ball may touch an object ball, nowhere may it overlap.
    #[must_use]
    pub fn is_free(&self, ball: usize, spot: DVec2, touching: Touching) -> bool {
        self.blocked(ball, spot, touching)
            .iter()
            .all(|stretch| !bars(*stretch, spot.x))
    }

    /// Puts a ball on the spot or as near to it as possible on the long line through it, first towards the foot, and if
    /// that part of the line is full, towards the head. False if the whole line is full.
    pub fn on_long_line(&mut self, ball: usize, spot: DVec2, touching: Touching) -> bool {
        let Some(place) = self.place_on_line(ball, spot, touching) else {
            return false;
        };
        self.put(ball, place);
        true
    }

    fn place_on_line(&self, ball: usize, spot: DVec2, touching: Touching) -> Option<DVec2> {
        let blocked = self.blocked(ball, spot, touching);
        let radius = self.scene.balls[ball].ball.radius;
        let end = 0.5 * self.scene.table.length - self.scene.table.reach(radius);
        let free = |x: &f64| x.abs() <= end && blocked.iter().all(|stretch| !bars(*stretch, *x));
        if free(&spot.x) {
            return Some(spot);
        }
        let towards_foot = blocked
            .iter()
            .map(|(_, to)| *to)
            .filter(|x| *x >= spot.x && free(x))
            .min_by(f64::total_cmp);
        let x = towards_foot.or_else(|| {
            blocked
                .iter()
                .map(|(from, _)| *from)
                .filter(|x| *x <= spot.x && free(x))
                .max_by(f64::total_cmp)
        })?;
        Some(DVec2::new(x, spot.y))
    }

    /// The stretches of the long line through a point that other balls bar, ends excluded.
    fn blocked(&self, ball: usize, spot: DVec2, touching: Touching) -> Vec<(f64, f64)> {
        let radius = self.scene.balls[ball].ball.radius;
        let mut blocked = Vec::new();
        for (index, other) in self.scene.balls.iter().enumerate() {
            if index == ball || !other.state.motion.in_play() {
                continue;
            }
            let apart = match touching {
                Touching::Object if other.name != "cue" => 0.0,
                _ => APART,
            };
            // Balls of different size touch at 2 √(R₁ R₂) in plan.
            let reach = 2.0 * (radius * other.ball.radius).sqrt() + apart;
            let aside = other.state.position.z - spot.y;
            let square = reach * reach - aside * aside;
            if square > 0.0 {
                let half = square.sqrt();
                let x = other.state.position.x;
                blocked.push((x - half, x + half));
            }
        }
        blocked
    }
}

/// Whether a barred stretch of the line holds this point; its ends are free, within rounding.
fn bars((from, to): (f64, f64), x: f64) -> bool {
    x > from + ROUNDING && x < to - ROUNDING
}

/// The table as a record left it, everything at rest.
#[must_use]
pub fn left_behind(scene: &Scene, ends: &[State]) -> Scene {
    let mut after = Scene {
        shot: None,
        ..scene.clone()
    };
    for (placed, end) in after.balls.iter_mut().zip(ends) {
        placed.state = State {
            motion: if end.motion.in_play() {
                Motion::Rest
            } else {
                end.motion
            },
            ..State::at_rest(end.position)
        };
        if end.motion.in_play() {
            placed.state.position.y = placed.ball.radius;
        }
    }
    after
}

/// Where a shot left balls that no shot can begin with, because one hangs over an edge or leans into another after the time
/// ran out, they move to the nearest places where they can lie.
pub(super) fn make_playable(scene: &mut Scene) {
    if scene.check().is_ok() {
        return;
    }
    for ball in 0..scene.balls.len() {
        let at = scene.balls[ball].state.position;
        let at = DVec2::new(at.x, at.z);
        if scene.balls[ball].state.motion.in_play() && !placing::is_free(scene, ball, at) {
            placing::place(scene, ball, at);
        }
    }
}
