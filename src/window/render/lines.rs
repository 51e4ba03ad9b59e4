//! Thin lines on the cloth.

use bevy::prelude::*;

use crate::physics::ball::Motion;

/// The lines of guides, previews and trails. They have no joints: where a ball comes straight back, the point of a mitred
/// joint would lie infinitely far away.
#[derive(Default, Reflect, GizmoConfigGroup)]
pub(super) struct Strokes;

pub(super) fn plugin(app: &mut App) {
    app.insert_gizmo_config(
        Strokes,
        GizmoConfig {
            line: GizmoLineConfig {
                width: 2.0,
                ..default()
            },
            depth_bias: -0.0002,
            ..default()
        },
    );
}

/// Sliding is warm, rolling is cool, flight is bright.
pub(super) fn colour(motion: Motion) -> LinearRgba {
    match motion {
        Motion::Sliding => LinearRgba::new(1.0, 0.35, 0.05, 0.9),
        Motion::Rolling | Motion::Rest | Motion::Spinning | Motion::Wedged => {
            LinearRgba::new(0.25, 0.75, 1.0, 0.9)
        }
        Motion::Gliding => LinearRgba::new(0.8, 0.8, 0.8, 0.9),
        Motion::Airborne | Motion::Tipping => LinearRgba::new(1.0, 1.0, 0.3, 0.9),
        Motion::Pocketed | Motion::OffTable => LinearRgba::NONE,
    }
}

/// Points nearer to each other than this, in m, are one: a shot has many events in one place.
const NEAR: f32 = 1e-3;

/// Draws a line through these points, each with its colour.
pub(super) fn strip<Group: GizmoConfigGroup>(
    lines: &mut Gizmos<Group>,
    points: impl IntoIterator<Item = (Vec3, LinearRgba)>,
) {
    let mut last: Option<Vec3> = None;
    let apart: Vec<_> = points
        .into_iter()
        .filter(|(at, _)| {
            let far = at.is_finite() && last.is_none_or(|last| last.distance(*at) >= NEAR);
            if far {
                last = Some(*at);
            }
            far
        })
        .collect();
    if apart.len() > 1 {
        lines.linestrip_gradient(apart);
    }
}
