//! Friction and spin at the end of a tick.

use bevy::prelude::*;

use crate::physics::laws::motion::MotionLaw;
use crate::sim::playfield::Playfield;
use crate::sim::stepped::bodies::Bodies;

/// Velocities, spins and kinds of motion at the end of the tick: the closed form of the motion law, or one step of the
/// coursework's.
pub(super) fn apply_friction(mut bodies: ResMut<Bodies>, playfield: Res<Playfield>) {
    let law = &playfield.laws.motion;
    let tick = bodies.tick;
    for body in &mut bodies.all {
        if !body.is_in_play() {
            continue;
        }
        let state = body.at(tick);
        body.end = match law {
            MotionLaw::Coursework(coursework) => {
                law.classify(&body.ball, coursework.rub(&body.ball, &state, tick))
            }
            MotionLaw::Frictionless | MotionLaw::Inclined(_) | MotionLaw::Coulomb(_) => state,
        };
    }
}
