//! The cue stick: it lies along the aim, pulls back, strikes and fades away.

mod stick;

use bevy::math::DVec3;
use bevy::prelude::*;

use crate::game::aim::Aim;
use crate::game::replay::Replay;
use crate::physics::cue::{Cue, Shot};
use crate::sim::clock::Clock;
use crate::sim::components::{BallIndex, MotionKind, Position, Radius};
use crate::sim::messages::Struck;
use crate::sim::playfield::Playfield;
use crate::window::render::Drawing;

/// Gap between tip and ball at address, m.
const ADDRESS: f64 = 0.012;

/// Length of a full backstroke, m.
const BACKSTROKE: f64 = 0.24;

/// How far the tip follows through, m.
const FOLLOW_THROUGH: f64 = 0.07;

/// Seconds of the follow-through, and of the fading after it.
const THRUST: f32 = 0.09;
const FADE: f32 = 0.35;

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Stroke>()
        .add_systems(Startup, make.in_set(Drawing::Cue))
        .add_systems(
            RunFixedMainLoop,
            (
                turn.run_if(resource_exists_and_changed::<Playfield>),
                strike,
                show,
            )
                .chain()
                .in_set(Drawing::Cue),
        );
}

/// The stick. Its meshes lie along −x from the tip at the origin.
#[derive(Component)]
struct Stick;

/// A part of the stick: polished, or not.
#[derive(Component)]
struct Finish {
    polished: bool,
}

/// The stroke that is being shown.
#[derive(Resource, Default)]
struct Stroke {
    /// The ball's centre, its radius, the stroke and how far the cue was drawn back.
    struck: Option<(DVec3, f64, Shot, f64)>,
    /// Seconds since the tip met the ball.
    age: f32,
}

fn make(mut commands: Commands, mut materials: ResMut<Assets<StandardMaterial>>) {
    let mut finish = |polished: bool| {
        let material = StandardMaterial {
            perceptual_roughness: if polished { 0.26 } else { 0.82 },
            reflectance: if polished { 0.5 } else { 0.25 },
            ..default()
        };
        (
            Finish { polished },
            MeshMaterial3d(materials.add(material)),
            Transform::default(),
        )
    };
    commands.spawn((
        Stick,
        Transform::default(),
        Visibility::Hidden,
        children![finish(true), finish(false)],
    ));
}

/// Turns the stick of the cue that is played with.
fn turn(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    playfield: Res<Playfield>,
    parts: Query<(Entity, &Finish)>,
    mut turned: Local<Option<Cue>>,
) {
    let cue = playfield.cue;
    let shape = |cue: &Cue| (cue.stick, cue.tip_radius);
    if parts.is_empty() || turned.as_ref().is_some_and(|old| shape(old) == shape(&cue)) {
        return;
    }
    *turned = Some(cue);
    let stick::Stick { polished, matt } = stick::stick(&cue);
    let [polished, matt] = [polished, matt].map(|solid| meshes.add(solid.mesh()));
    for (part, finish) in &parts {
        let mesh = if finish.polished { &polished } else { &matt };
        commands.entity(part).insert(Mesh3d(mesh.clone()));
    }
}

/// Notes a stroke as it happens.
fn strike(
    mut struck: MessageReader<Struck>,
    mut stroke: ResMut<Stroke>,
    aim: Res<Aim>,
    balls: Query<(&BallIndex, &Radius)>,
) {
    for Struck(event) in struck.read() {
        let hit = event.first;
        let radius = balls
            .iter()
            .find(|(index, _)| index.0 == hit.ball)
            .map_or(0.028, |(_, radius)| radius.0);
        *stroke = Stroke {
            struck: Some((hit.before.position, radius, aim.shot, aim.draw_back)),
            age: 0.0,
        };
    }
}

/// Lays the stick behind its ball while nothing moves; after a stroke follows through and lifts it away.
#[expect(clippy::too_many_arguments, reason = "everything the stick depends on")]
fn show(
    time: Res<Time>,
    aim: Res<Aim>,
    clock: Res<Clock>,
    replay: Res<Replay>,
    playfield: Res<Playfield>,
    mut stroke: ResMut<Stroke>,
    mut stick: Single<(&mut Transform, &mut Visibility), With<Stick>>,
    balls: Query<(&BallIndex, &Position, &Radius, &MotionKind)>,
) {
    let (transform, visibility) = &mut *stick;
    if let Some((center, radius, shot, draw_back)) = stroke.struck {
        stroke.age += time.delta_secs();
        if stroke.age < THRUST + FADE {
            let thrust = f64::from((stroke.age / THRUST).min(1.0));
            let start = -ADDRESS - draw_back * BACKSTROKE;
            let reach = start + (FOLLOW_THROUGH - start) * ease_out(thrust);
            let fade = ((stroke.age - THRUST) / FADE).clamp(0.0, 1.0);
            let mut placed = lay(&playfield.cue, center, radius, &shot, reach);
            // It is taken away upwards and backwards rather than made of glass.
            let away = placed.rotation * Vec3::NEG_X * 0.25 + Vec3::Y * 0.12;
            placed.translation += away * fade * fade;
            placed.scale = Vec3::splat(1.0 - 0.999 * fade * fade * fade);
            **transform = placed;
            visibility.set_if_neq(Visibility::Inherited);
            return;
        }
        stroke.struck = None;
    }
    let ball = balls
        .iter()
        .find(|(index, _, _, motion)| index.0 == aim.ball && motion.0.in_play());
    let is_aimed = !clock.moving && !replay.is_active() && !playfield.solver.is_crowd();
    match ball {
        Some((_, position, radius, _)) if is_aimed => {
            let reach = -ADDRESS - aim.draw_back * BACKSTROKE;
            **transform = lay(&playfield.cue, position.0, radius.0, &aim.shot, reach);
            visibility.set_if_neq(Visibility::Inherited);
        }
        _ => {
            visibility.set_if_neq(Visibility::Hidden);
        }
    }
}

fn ease_out(t: f64) -> f64 {
    1.0 - (1.0 - t) * (1.0 - t)
}

/// The place of a stick whose tip is `reach` m beyond where it touches the ball. The cue lies as the shot says: the aim is
/// raised where it would pass through something.
fn lay(cue: &Cue, center: DVec3, radius: f64, shot: &Shot, reach: f64) -> Transform {
    let along = shot.along();
    // The middle of the round tip lies on the line from the centre of the ball through the contact.
    let middle = center + (radius + cue.tip_radius) * shot.contact();
    let tip = middle + (cue.tip_radius + reach) * along;
    let z = along.cross(DVec3::Y).normalize_or(DVec3::Z);
    let y = z.cross(along);
    let rotation = Quat::from_mat3(&Mat3::from_cols(along.as_vec3(), y.as_vec3(), z.as_vec3()));
    Transform {
        translation: tip.as_vec3(),
        rotation,
        scale: Vec3::ONE,
    }
}
