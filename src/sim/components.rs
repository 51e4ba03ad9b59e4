//! What a ball entity carries.

use bevy::prelude::*;
use glam::DVec3;

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::scene::SceneBall;

/// Position of the centre in m; a ball on the slate has its radius for y. An entity with a position is a ball: what it
/// lacks it gets, see [`joining`](crate::sim::joining).
#[derive(Component, Clone, Copy, Debug, Default, PartialEq)]
#[require(Velocity, Mass, Radius, MotionKind)]
pub struct Position(pub DVec3);

/// Velocity of the centre in m/s.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq)]
pub struct Velocity(pub DVec3);

/// Angular velocity in rad/s. A ball without this component has no spin and costs no spin work.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq)]
pub struct AngularVelocity(pub DVec3);

/// Mass in kg.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Mass(pub f64);

impl Default for Mass {
    /// A pool ball's.
    fn default() -> Self {
        Self(Ball::POOL.mass)
    }
}

/// Radius in m.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Radius(pub f64);

impl Default for Radius {
    /// A pool ball's.
    fn default() -> Self {
        Self(Ball::POOL.radius)
    }
}

/// The kind of motion the ball is in.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MotionKind(pub Motion);

/// Place of the ball in its scene: the order in which balls are worked on, whatever the order of the entities.
#[derive(Component, Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[component(immutable)]
pub struct BallIndex(pub usize);

/// What players call the ball.
#[derive(Component, Clone, Debug, PartialEq, Eq)]
pub struct BallName(pub String);

/// Everything of one ball, to spawn it.
#[derive(Bundle)]
pub struct BallBundle {
    index: BallIndex,
    name: BallName,
    position: Position,
    velocity: Velocity,
    mass: Mass,
    radius: Radius,
    motion: MotionKind,
}

impl BallBundle {
    /// The components of a ball of a scene; [`AngularVelocity`] is added apart, only to a ball that spins.
    #[must_use]
    pub fn new(index: usize, ball: &SceneBall) -> Self {
        Self {
            index: BallIndex(index),
            name: BallName(ball.name.clone()),
            position: Position(ball.state.position),
            velocity: Velocity(ball.state.velocity),
            mass: Mass(ball.ball.mass),
            radius: Radius(ball.ball.radius),
            motion: MotionKind(ball.state.motion),
        }
    }
}

/// The components of a ball, read as the structs of the pure layer.
#[must_use]
pub fn ball_and_state(
    position: &Position,
    velocity: &Velocity,
    spin: Option<&AngularVelocity>,
    mass: &Mass,
    radius: &Radius,
    motion: &MotionKind,
) -> (Ball, State) {
    (
        Ball {
            mass: mass.0,
            radius: radius.0,
            spins: spin.is_some(),
        },
        State {
            position: position.0,
            velocity: velocity.0,
            angular_velocity: spin.map_or(DVec3::ZERO, |spin| spin.0),
            motion: motion.0,
        },
    )
}
