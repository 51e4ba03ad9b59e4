//! The paths of the last shot, coloured by how the ball moved.

use bevy::prelude::*;

use crate::game::view::View;
use crate::physics::ball::Motion;
use crate::sim::recorder::Recorder;
use crate::window::render::Drawing;
use crate::window::render::lines::Strokes;

pub(super) fn plugin(app: &mut App) {
    app.add_systems(RunFixedMainLoop, draw.in_set(Drawing::Trails));
}

fn draw(mut lines: Gizmos<Strokes>, view: Res<View>, recorder: Res<Recorder>) {
    if !view.trails {
        return;
    }
    for trail in &recorder.trails {
        let points = trail.iter().filter(|(_, state)| state.motion.in_play());
        lines.linestrip_gradient(points.map(|(_, state)| {
            let at = state.position.as_vec3();
            (at.with_y(0.002), colour(state.motion))
        }));
    }
}

/// Sliding is warm, rolling is cool, flight is bright.
fn colour(motion: Motion) -> LinearRgba {
    match motion {
        Motion::Sliding => LinearRgba::new(1.0, 0.35, 0.05, 0.9),
        Motion::Rolling | Motion::Rest | Motion::Spinning => LinearRgba::new(0.25, 0.75, 1.0, 0.9),
        Motion::Gliding => LinearRgba::new(0.8, 0.8, 0.8, 0.9),
        Motion::Airborne => LinearRgba::new(1.0, 1.0, 0.3, 0.9),
        Motion::Pocketed => LinearRgba::NONE,
    }
}
