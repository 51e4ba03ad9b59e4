//! The balls: a globe that turns with its markings, and the shade it casts on the cloth.

mod fall;
mod globe;
mod motion;
mod numeral;
mod palette;
mod skin;
mod twin;

pub(super) use motion::Globe;
pub use motion::Turn;
pub(super) use palette::{Marking, look};

use bevy::light::{NotShadowCaster, NotShadowReceiver};
use bevy::prelude::*;

use crate::game::settings::{Marks, Settings};
use crate::game::twin::keep_time;
use crate::sim::components::{BallIndex, BallName, Position, Radius};
use crate::sim::playfield::Playfield;
use crate::window::render::Drawing;
use crate::window::render::quality::RenderQuality;
use crate::window::render::stage::{BallMaterial, Stage};
use crate::window::render::studio::Studio;
use globe::Looks;
use motion::{Shade, Track};

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
    mut materials: ResMut<Assets<BallMaterial>>,
    mut meshes: ResMut<Assets<Mesh>>,
    settings: Res<Settings>,
    (quality, stage, studio): (Res<RenderQuality>, Res<Stage>, Res<Studio>),
    mut worn: Local<Option<(Marks, RenderQuality)>>,
    balls: Query<(&BallName, &Children)>,
    mut globes: Query<(&mut Mesh3d, &mut MeshMaterial3d<BallMaterial>), With<Globe>>,
) {
    let wanted = (settings.marks, *quality);
    // Balls may have been dressed before the settings were read.
    if worn.replace(wanted) == Some(wanted) {
        return;
    }
    looks.suit(*quality, &mut meshes);
    let gloss = stage.gloss(*quality, &studio);
    for (name, children) in &balls {
        let patterned = settings.marks.patterns;
        let material = looks.material(&name.0, patterned, &gloss, &mut images, &mut materials);
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
    mut materials: ResMut<Assets<BallMaterial>>,
    settings: Res<Settings>,
    (stage, studio): (Res<Stage>, Res<Studio>),
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
    let gloss = stage.gloss(looks.quality(), &studio);
    let material = looks.material(&name.0, patterned, &gloss, &mut images, &mut materials);
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
