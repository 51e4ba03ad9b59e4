//! Thin lines on the cloth.

use bevy::prelude::*;

/// The lines of guides and trails.
#[derive(Default, Reflect, GizmoConfigGroup)]
pub(super) struct Strokes;

pub(super) fn plugin(app: &mut App) {
    app.insert_gizmo_config(
        Strokes,
        GizmoConfig {
            line: GizmoLineConfig {
                width: 2.0,
                joints: GizmoLineJoint::Miter,
                ..default()
            },
            depth_bias: -0.0002,
            ..default()
        },
    );
}
