//! What is drawn of the same stroke by other laws: a layer of its own, with balls, lamps and lines that only the second
//! camera sees. Table and room lie in both layers.

use bevy::camera::visibility::RenderLayers;
use bevy::prelude::*;

use crate::game::twin::Twin;
use crate::game::view::{Beside, FirstEye, View};
use crate::window::render::Drawing;
use crate::window::render::lines::{colour, strip};

/// The layer of the other laws; everything else is in layer 0.
const LAYER: usize = 1;

/// Points of a line in a second of the shot.
const RATE: f64 = 120.0;

/// Of what only the camera on the other laws sees.
pub(super) fn alone() -> RenderLayers {
    RenderLayers::layer(LAYER)
}

/// Of what both cameras see.
pub(super) fn both() -> RenderLayers {
    RenderLayers::from_layers(&[0, LAYER])
}

/// Whether other laws are shown.
pub(super) fn is_shown(view: Res<View>) -> bool {
    view.beside == Beside::Laws
}

/// The lines of the other laws.
#[derive(Default, Reflect, GizmoConfigGroup)]
struct TwinStrokes;

pub(super) fn plugin(app: &mut App) {
    app.insert_gizmo_config(
        TwinStrokes,
        GizmoConfig {
            line: GizmoLineConfig {
                width: 2.0,
                ..default()
            },
            depth_bias: -0.0002,
            render_layers: alone(),
            ..default()
        },
    )
    .add_systems(
        RunFixedMainLoop,
        (show, hang_lamps).chain().in_set(Drawing::Room),
    )
    .add_systems(Update, draw.in_set(Drawing::Trails).run_if(is_shown));
}

/// The second camera looks at the layer that is wanted.
fn show(
    mut commands: Commands,
    view: Res<View>,
    second: Query<(Entity, Option<&RenderLayers>), (With<Camera3d>, Without<FirstEye>)>,
) {
    let wanted = if view.beside == Beside::Laws {
        alone()
    } else {
        RenderLayers::default()
    };
    for (camera, layers) in &second {
        if layers.cloned().unwrap_or_default() != wanted {
            commands.entity(camera).insert(wanted.clone());
        }
    }
}

/// A lamp that lights the other balls, where one lights the balls of the table: a shadow falls only in its own picture.
#[derive(Component)]
struct TwinLamp;

type Lamps<'w, 's> =
    Query<'w, 's, (Ref<'static, SpotLight>, &'static Transform), Without<TwinLamp>>;

fn hang_lamps(
    mut commands: Commands,
    view: Res<View>,
    lamps: Lamps,
    mut twins: Query<(Entity, &mut Visibility), With<TwinLamp>>,
) {
    let wanted = if view.beside == Beside::Laws {
        Visibility::Inherited
    } else {
        Visibility::Hidden
    };
    for (_, mut seen) in &mut twins {
        seen.set_if_neq(wanted);
    }
    let changed = lamps.iter().any(|(lamp, _)| lamp.is_changed());
    let as_many = twins.iter().len() == lamps.iter().len();
    if wanted == Visibility::Hidden || (as_many && !changed) {
        return;
    }
    for (lamp, _) in &twins {
        commands.entity(lamp).despawn();
    }
    for (lamp, place) in &lamps {
        commands.spawn((TwinLamp, *lamp, *place, alone()));
    }
}

/// The paths of the other balls so far, where trails are wanted.
fn draw(mut lines: Gizmos<TwinStrokes>, view: Res<View>, twin: Res<Twin>) {
    let Some(record) = twin.record.as_ref().filter(|_| view.trails) else {
        return;
    };
    let until = twin.time.min(record.end_time);
    let steps = (until * RATE).ceil().clamp(1.0, 6_000.0) as u32;
    for ball in 0..record.paths.len() {
        let states = (0..=steps)
            .map(|step| record.state_at(ball, until * f64::from(step) / f64::from(steps)));
        let points = states.filter(|state| state.motion.in_play()).map(|state| {
            let at = state.position.as_vec3();
            let height = if state.motion.flies() { at.y } else { 0.002 };
            (at.with_y(height), colour(state.motion))
        });
        strip(&mut lines, points);
    }
}
