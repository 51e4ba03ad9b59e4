//! One place to look from.

use bevy::prelude::*;

use crate::window::camera::frame::WHOLE;

/// Where the eye is, how it is turned, how wide it sees, and where in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pose {
    /// Position, m.
    pub eye: Vec3,
    /// Turn from looking along −z with y up.
    pub rotation: Quat,
    /// Vertical field of view, rad.
    pub fov: f32,
    /// The part of the picture that this field of view fills, in shares of the picture; around it more is seen.
    pub frame: Rect,
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
            frame: WHOLE,
        }
    }

    /// The pose this share of the way to another.
    pub fn towards(&self, other: &Self, share: f32) -> Self {
        Self {
            eye: self.eye.lerp(other.eye, share),
            rotation: self.rotation.slerp(other.rotation, share),
            fov: self.fov + share * (other.fov - self.fov),
            frame: Rect {
                min: self.frame.min.lerp(other.frame.min, share),
                max: self.frame.max.lerp(other.frame.max, share),
            },
        }
    }
}
