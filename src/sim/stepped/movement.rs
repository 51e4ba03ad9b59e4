//! Positions at the end of a tick.

use bevy::prelude::*;

use crate::physics::laws::motion::MotionLaw;
use crate::sim::components::{AngularVelocity, MotionKind, Position, Velocity};
use crate::sim::playfield::Playfield;
use crate::sim::stepped::bodies::Bodies;

/// Moves every ball along its path to the end of the tick and writes the components of those that changed.
pub(super) fn move_balls(
    mut bodies: ResMut<Bodies>,
    playfield: Res<Playfield>,
    mut balls: Query<(
        &mut Position,
        &mut Velocity,
        Option<&mut AngularVelocity>,
        &mut MotionKind,
    )>,
) {
    let tick = bodies.tick;
    let frictionless = playfield.laws.motion == MotionLaw::Frictionless;
    for body in &mut bodies.all {
        if frictionless || !body.is_in_play() {
            body.end = body.piece.start;
        }
        body.end.position = body.piece.position(tick - body.since);
        let Ok((mut position, mut velocity, spin, mut motion)) = balls.get_mut(body.entity) else {
            continue;
        };
        let end = &body.end;
        position.set_if_neq(Position(end.position));
        velocity.set_if_neq(Velocity(end.velocity));
        motion.set_if_neq(MotionKind(end.motion));
        if let Some(mut spin) = spin {
            spin.set_if_neq(AngularVelocity(end.angular_velocity));
        }
    }
}
