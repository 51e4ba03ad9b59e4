//! What a player says before the stroke, and what somebody means who points at the cloth.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::game::rules::targets::{CallNeeded, On};
use crate::physics::scene::Scene;
use crate::physics::table::Table;

/// What the player at the table says before the stroke.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Call {
    /// Nothing. Where a code asks for calls, obvious shots count all the same.
    #[default]
    Nothing,
    /// This ball into this pocket.
    Pot {
        /// Index of the ball in the scene.
        ball: usize,
        /// Index of the pocket in the table.
        pocket: usize,
    },
    /// This ball, in a game that asks for the ball only: the colour or the free ball of snooker.
    Nominate {
        /// Index of the ball in the scene.
        ball: usize,
    },
    /// Nothing is to be potted: the turn passes whatever falls.
    Safety,
    /// A push out: the cue ball may go anywhere.
    PushOut,
}

impl Call {
    /// The ball named, if any.
    #[must_use]
    pub fn ball(&self) -> Option<usize> {
        match *self {
            Self::Pot { ball, .. } | Self::Nominate { ball } => Some(ball),
            _ => None,
        }
    }
}

/// The pocket nearest to a point, x and z in m, measured to its edge; `None` on a table without pockets.
#[must_use]
pub fn nearest_pocket(table: &Table, point: DVec2) -> Option<usize> {
    let to = |i: &usize| {
        let pocket = &table.pockets[*i];
        point.distance(pocket.center) - pocket.radius
    };
    (0..table.pockets.len()).min_by(|a, b| to(a).total_cmp(&to(b)))
}

/// The ball in play nearest to a point, x and z in m, among those asked for; `None` if there is none within `reach` m of
/// its edge.
#[must_use]
pub fn nearest_ball(scene: &Scene, among: &[usize], point: DVec2, reach: f64) -> Option<usize> {
    let to = |i: usize| {
        let ball = &scene.balls[i];
        let center = DVec2::new(ball.state.position.x, ball.state.position.z);
        point.distance(center) - ball.ball.radius
    };
    among
        .iter()
        .copied()
        .filter(|&i| {
            scene
                .balls
                .get(i)
                .is_some_and(|ball| ball.state.motion.in_play())
        })
        .filter(|&i| to(i) <= reach)
        .min_by(|&a, &b| to(a).total_cmp(&to(b)))
}

/// How far in m beside a ball or the edge of a pocket one may point and still mean it.
const MEANT: f64 = 0.03;

/// What somebody points at who is to call a shot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pointed {
    /// The ball with this index.
    Ball(usize),
    /// The pocket with this index.
    Pocket(usize),
}

/// What somebody means who points at the table: `high` is where the pointer meets the height of the centres of the balls,
/// `low` where it meets the bed, x and z in m. Only balls that may be called count.
#[must_use]
pub fn pointed_at(scene: &Scene, on: &On, high: DVec2, low: DVec2) -> Option<Pointed> {
    if let Some(ball) = nearest_ball(scene, &on.pot, high, MEANT) {
        return Some(Pointed::Ball(ball));
    }
    let pocket = nearest_pocket(&scene.table, low)
        .filter(|_| on.call_needed == CallNeeded::BallAndPocket)?;
    let hole = &scene.table.pockets[pocket];
    (low.distance(hole.center) <= hole.radius + MEANT).then_some(Pointed::Pocket(pocket))
}
