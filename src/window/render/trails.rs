//! The paths of the last shot, coloured by how the ball moved.

use bevy::prelude::*;

use crate::game::view::View;
use crate::sim::recorder::Recorder;
use crate::window::render::Drawing;
use crate::window::render::lines::{Strokes, colour, strip};

pub(super) fn plugin(app: &mut App) {
    app.add_systems(Update, draw.in_set(Drawing::Trails));
}

fn draw(mut lines: Gizmos<Strokes>, view: Res<View>, recorder: Res<Recorder>) {
    if !view.trails {
        return;
    }
    for trail in &recorder.trails {
        let points = trail.iter().filter(|(_, state)| state.motion.in_play());
        // In the air where the centre was, else on the cloth.
        let points = points.map(|(_, state)| {
            let at = state.position.as_vec3();
            let height = if state.motion.flies() { at.y } else { 0.002 };
            (at.with_y(height), colour(state.motion))
        });
        strip(&mut lines, points);
    }
}
