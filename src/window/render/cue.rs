//! The cue stick: it lies along the aim, pulls back, strikes and fades away.

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
use crate::window::render::solid::{Solid, lathe};

/// Length of the stick, m.
const LENGTH: f64 = 1.47;

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
            (strike, show).chain().in_set(Drawing::Cue),
        );
}

/// The stick. Its mesh lies along −x from the tip at the origin.
#[derive(Component)]
struct Stick;

/// The stroke that is being shown.
#[derive(Resource, Default)]
struct Stroke {
    /// The ball's centre, its radius, the stroke and how far the cue was drawn back.
    struck: Option<(DVec3, f64, Shot, f64)>,
    /// Seconds since the tip met the ball.
    age: f32,
}

fn make(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
) {
    // From the tip to the butt: from, to, radius there and there, colour.
    let parts = [
        (
            0.0,
            0.008,
            0.0058,
            0.0062,
            Color::srgb(0.10, 0.25, 0.42),
            0.9,
        ),
        (
            0.008,
            0.03,
            0.0062,
            0.0064,
            Color::srgb(0.90, 0.88, 0.82),
            0.35,
        ),
        (
            0.03,
            0.74,
            0.0064,
            0.0098,
            Color::srgb(0.72, 0.52, 0.31),
            0.35,
        ),
        (
            0.74,
            0.755,
            0.0100,
            0.0101,
            Color::srgb(0.80, 0.74, 0.55),
            0.25,
        ),
        (
            0.755,
            1.06,
            0.0101,
            0.0122,
            Color::srgb(0.20, 0.06, 0.035),
            0.25,
        ),
        (
            1.06,
            1.36,
            0.0123,
            0.0138,
            Color::srgb(0.035, 0.035, 0.04),
            0.6,
        ),
        (
            1.36,
            1.44,
            0.0138,
            0.0142,
            Color::srgb(0.20, 0.06, 0.035),
            0.25,
        ),
        (
            1.44,
            LENGTH,
            0.0142,
            0.0135,
            Color::srgb(0.03, 0.03, 0.03),
            0.7,
        ),
    ];
    let stick = commands
        .spawn((Stick, Transform::default(), Visibility::Hidden))
        .id();
    for (from, to, thin, thick, colour, roughness) in parts {
        let mut solid = Solid::new(DVec3::Y, 0.1);
        let dome = if from == 0.0 { 0.0015 } else { 0.0 };
        let mut profile = vec![(thin, dome), (thick, to - from)];
        if from == 0.0 {
            profile.insert(0, (0.55 * thin, 0.3 * dome));
            profile.insert(0, (0.0, 0.0));
        }
        if to == LENGTH {
            profile.push((0.0, to - from));
        }
        lathe(&mut solid, DVec3::ZERO, &profile, 24);
        commands.spawn((
            ChildOf(stick),
            Mesh3d(meshes.add(solid.mesh())),
            MeshMaterial3d(materials.add(StandardMaterial {
                base_color: colour,
                perceptual_roughness: roughness,
                reflectance: 0.4,
                ..default()
            })),
            // The lathe turns about y; the stick lies along −x.
            Transform::from_xyz(-(from as f32), 0.0, 0.0)
                .with_rotation(Quat::from_rotation_z(std::f32::consts::FRAC_PI_2)),
        ));
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
