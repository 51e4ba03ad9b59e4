//! The balls of the same stroke by other laws, in the layer of their own.

use bevy::light::{NotShadowCaster, NotShadowReceiver};
use bevy::math::DQuat;
use bevy::prelude::*;

use super::globe::Looks;
use super::motion;
use crate::game::settings::{Marks, Settings};
use crate::game::twin::Twin;
use crate::sim::components::{BallIndex, BallName, MotionKind, Position, Radius};
use crate::window::render::quality::RenderQuality;
use crate::window::render::stage::{BallMaterial, Stage};
use crate::window::render::studio::Studio;
use crate::window::render::twin::{alone, is_shown};

/// A ball of the twin.
#[derive(Component)]
pub(super) struct TwinBall {
    /// The ball of the table that it stands for.
    ball: Entity,
    index: usize,
    turn: DQuat,
    /// Time of the shot when it was last drawn, s.
    time: f64,
}

/// Gives every ball of the table its twin while other laws are shown.
#[expect(
    clippy::too_many_arguments,
    reason = "three stores of assets, who is there, who shall be"
)]
pub(super) fn dress(
    mut commands: Commands,
    mut looks: ResMut<Looks>,
    mut images: ResMut<Assets<Image>>,
    mut materials: ResMut<Assets<BallMaterial>>,
    (view, settings, quality): (
        Res<crate::game::view::View>,
        Res<Settings>,
        Res<RenderQuality>,
    ),
    (stage, studio): (Res<Stage>, Res<Studio>),
    mut worn: Local<Option<(Marks, RenderQuality)>>,
    balls: Query<(Entity, &BallIndex, &BallName, &Radius)>,
    twins: Query<(Entity, &TwinBall)>,
) {
    let is_wanted = is_shown(view);
    let wanted = (settings.marks, *quality);
    let same = worn.replace(wanted) == Some(wanted);
    let standing = twins.iter().all(|(_, twin)| balls.contains(twin.ball));
    let count = if is_wanted { balls.iter().len() } else { 0 };
    if same && standing && twins.iter().len() == count {
        return;
    }
    for (twin, _) in &twins {
        commands.entity(twin).despawn();
    }
    if !is_wanted {
        return;
    }
    let gloss = stage.gloss(looks.quality(), &studio);
    for (ball, index, name, radius) in &balls {
        let patterned = settings.marks.patterns;
        let material = looks.material(&name.0, patterned, &gloss, &mut images, &mut materials);
        commands
            .spawn((
                TwinBall {
                    ball,
                    index: index.0,
                    turn: motion::resting_turn(index.0, &name.0),
                    time: 0.0,
                },
                Mesh3d(looks.globe()),
                MeshMaterial3d(material),
                Transform::from_scale(Vec3::splat(radius.0 as f32)),
                alone(),
            ))
            .with_child((
                Mesh3d(looks.shade()),
                MeshMaterial3d(looks.shade_material()),
                NotShadowCaster,
                NotShadowReceiver,
                alone(),
            ));
    }
}

/// Puts every twin where its laws have it; before a stroke, where the table has it.
pub(super) fn place(
    twin: Res<Twin>,
    balls: Query<(&Position, &MotionKind, &Radius, &BallName)>,
    mut twins: Query<(&mut TwinBall, &mut Transform, &mut Visibility, &Children)>,
    mut shades: Query<&mut Transform, Without<TwinBall>>,
) {
    for (mut one, mut transform, mut visibility, children) in &mut twins {
        let Ok((position, motion, radius, name)) = balls.get(one.ball) else {
            continue;
        };
        let state = twin.state(one.index);
        let (at, motion) = state.map_or((position.0, motion.0), |state| {
            (state.position, state.motion)
        });
        // By its spin, forwards and backwards.
        let spin = state.map_or_else(Default::default, |state| state.angular_velocity);
        let step = twin.time - one.time;
        one.turn = if state.is_none() {
            motion::resting_turn(one.index, &name.0)
        } else {
            (DQuat::from_scaled_axis(spin * step) * one.turn).normalize()
        };
        one.time = twin.time;
        let turned = one.turn.as_quat();
        *transform = Transform::from_translation(at.as_vec3())
            .with_rotation(turned)
            .with_scale(Vec3::splat(radius.0 as f32));
        visibility.set_if_neq(if motion.in_play() {
            Visibility::Inherited
        } else {
            Visibility::Hidden
        });
        // The shade lies on the cloth however the ball is turned.
        let down = turned.inverse() * Vec3::new(0.0, 0.0006 / radius.0 as f32 - 1.0, 0.0);
        let mut shades = shades.iter_many_mut(children);
        while let Some(mut shade) = shades.fetch_next() {
            *shade = Transform::from_translation(down).with_rotation(turned.inverse());
        }
    }
}
