//! The balls: a globe that turns with its markings, and the shade it casts on the cloth.

mod fall;
mod globe;
mod motion;
mod numeral;
mod palette;
mod skin;

pub use motion::Turn;

use bevy::light::{NotShadowCaster, NotShadowReceiver};
use bevy::prelude::*;

use crate::sim::components::{BallIndex, BallName, Position, Radius};
use crate::window::render::Drawing;
use globe::Looks;
use motion::{Globe, Shade, Track};

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Looks>()
        .add_observer(dress)
        .add_systems(FixedPostUpdate, motion::follow)
        .add_systems(RunFixedMainLoop, motion::place.in_set(Drawing::Balls));
}

/// Gives a new ball its globe, its shade and its way of moving.
fn dress(
    added: On<Add, BallIndex>,
    mut commands: Commands,
    mut looks: ResMut<Looks>,
    mut images: ResMut<Assets<Image>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
    balls: Query<(&BallIndex, &BallName, &Position, &Radius)>,
) {
    let Ok((index, name, position, radius)) = balls.get(added.entity) else {
        return;
    };
    let material = looks.material(&name.0, &mut images, &mut materials);
    let scale = Vec3::splat(radius.0 as f32);
    let turn = motion::resting_turn(index.0, &name.0);
    commands.entity(added.entity).insert((
        Track::at(position.0),
        Turn(turn),
        Transform::default(),
        Visibility::default(),
        children![
            (
                Globe,
                Mesh3d(looks.globe()),
                MeshMaterial3d(material),
                Transform::from_scale(scale),
            ),
            (
                Shade,
                Mesh3d(looks.shade()),
                MeshMaterial3d(looks.shade_material()),
                Transform::from_xyz(0.0, (0.0006 - radius.0) as f32, 0.0).with_scale(scale),
                NotShadowCaster,
                NotShadowReceiver,
            ),
        ],
    ));
}
