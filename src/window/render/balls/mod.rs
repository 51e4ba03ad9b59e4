//! The balls: a globe that turns with its markings, and the shade it casts on the cloth.

mod fall;
mod globe;
mod motion;
mod numeral;
mod palette;
mod skin;
mod twin;

pub use motion::Turn;

use bevy::light::{NotShadowCaster, NotShadowReceiver};
use bevy::prelude::*;

use crate::game::settings::{Marks, Settings};
use crate::game::twin::keep_time;
use crate::sim::components::{BallIndex, BallName, Position, Radius};
use crate::sim::playfield::Playfield;
use crate::window::render::Drawing;
use crate::window::render::quality::RenderQuality;
use globe::Looks;
use motion::{Globe, Shade, Track};

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Looks>()
        .add_observer(dress)
        .add_systems(FixedPostUpdate, motion::follow.after(keep_time))
        .add_systems(
            RunFixedMainLoop,
            (change_clothes, motion::place, twin::dress, twin::place)
                .chain()
                .in_set(Drawing::Balls),
        );
}

/// Balls that are there already follow another quality or other marks.
#[expect(
    clippy::too_many_arguments,
    reason = "three stores of assets, two reasons"
)]
fn change_clothes(
    mut looks: ResMut<Looks>,
    mut images: ResMut<Assets<Image>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
    mut meshes: ResMut<Assets<Mesh>>,
    settings: Res<Settings>,
    quality: Res<RenderQuality>,
    mut worn: Local<Option<(Marks, RenderQuality)>>,
    balls: Query<(&BallName, &Children)>,
    mut globes: Query<(&mut Mesh3d, &mut MeshMaterial3d<StandardMaterial>), With<Globe>>,
) {
    let wanted = (settings.marks, *quality);
    let before = worn.replace(wanted);
    if before.is_none_or(|before| before == wanted) {
        return;
    }
    looks.suit(*quality, &mut meshes);
    for (name, children) in &balls {
        let patterned = settings.marks.patterns;
        let material = looks.material(&name.0, patterned, &mut images, &mut materials);
        let mut globes = globes.iter_many_mut(children);
        while let Some((mut mesh, mut worn)) = globes.fetch_next() {
            mesh.0 = looks.globe();
            worn.0 = material.clone();
        }
    }
}

/// Gives a new ball its globe, its shade and its way of moving.
#[expect(
    clippy::too_many_arguments,
    reason = "a system names everything it reads"
)]
fn dress(
    added: On<Add, BallIndex>,
    mut commands: Commands,
    mut looks: ResMut<Looks>,
    mut images: ResMut<Assets<Image>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
    settings: Res<Settings>,
    balls: Query<(&BallIndex, &BallName, &Position, &Radius)>,
    playfield: Res<Playfield>,
) {
    if playfield.solver.is_crowd() {
        // A crowd is drawn as a whole.
        return;
    }
    let Ok((index, name, position, radius)) = balls.get(added.entity) else {
        return;
    };
    let patterned = settings.marks.patterns;
    let material = looks.material(&name.0, patterned, &mut images, &mut materials);
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
