//! One place to look from.

use bevy::prelude::*;

/// Where the eye is, how it is turned, how wide it sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pose {
    /// Position, m.
    pub eye: Vec3,
    /// Turn from looking along −z with y up.
    pub rotation: Quat,
    /// Vertical field of view, rad.
    pub fov: f32,
}

impl Pose {
    /// An eye that looks at a point.
    pub fn looking_at(eye: Vec3, target: Vec3, up: Vec3, fov: f32) -> Self {
        Self {
            eye,
            rotation: Transform::from_translation(eye)
                .looking_at(target, up)
                .rotation,
            fov,
        }
    }

    /// The pose this share of the way to another.
    pub fn towards(&self, other: &Self, share: f32) -> Self {
        Self {
            eye: self.eye.lerp(other.eye, share),
            rotation: self.rotation.slerp(other.rotation, share),
            fov: self.fov + share * (other.fov - self.fov),
        }
    }
}
