//! The aim line, the ghost ball and the ways after the first contact.

use bevy::light::{NotShadowCaster, NotShadowReceiver};
use bevy::math::DVec3;
use bevy::prelude::*;

use crate::game::aim::Aim;
use crate::game::guide::{Guide, Hit, first_contact};
use crate::game::replay::Replay;
use crate::game::view::View;
use crate::sim::clock::Clock;
use crate::sim::playfield::{BallQuery, Playfield, snapshot};
use crate::window::render::Drawing;
use crate::window::render::lines::Strokes;

/// How far the ways after the contact are shown, m.
const REACH: f64 = 0.45;

pub(super) fn plugin(app: &mut App) {
    app.add_systems(Startup, make.in_set(Drawing::Guides))
        // Gizmos belong to the schedule they are drawn in; those of the fixed loop would not be seen every frame.
        .add_systems(Update, draw.in_set(Drawing::Guides));
}

/// The translucent ball at the first contact.
#[derive(Component)]
struct Ghost;

fn make(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
) {
    commands.spawn((
        Ghost,
        Mesh3d(meshes.add(Sphere::new(1.0).mesh().uv(40, 20))),
        MeshMaterial3d(materials.add(StandardMaterial {
            base_color: Color::srgba(1.0, 1.0, 1.0, 0.13),
            perceptual_roughness: 0.2,
            alpha_mode: AlphaMode::Blend,
            ..default()
        })),
        Transform::default(),
        Visibility::Hidden,
        NotShadowCaster,
        NotShadowReceiver,
    ));
}

/// Draws the guides of the present aim while nothing moves.
#[expect(
    clippy::too_many_arguments,
    reason = "everything the aim line depends on"
)]
fn draw(
    mut lines: Gizmos<Strokes>,
    view: Res<View>,
    aim: Res<Aim>,
    clock: Res<Clock>,
    replay: Res<Replay>,
    playfield: Res<Playfield>,
    balls: BallQuery,
    mut ghost: Single<(&mut Transform, &mut Visibility), With<Ghost>>,
) {
    let (transform, visibility) = &mut *ghost;
    let is_played = !clock.moving && !replay.is_active() && !playfield.solver.is_crowd();
    let shown = view.guides && is_played;
    let scene = shown.then(|| snapshot(&playfield, &balls));
    let guide = scene
        .as_ref()
        .and_then(|scene| first_contact(scene, aim.ball, &aim.shot, REACH).ok());
    let (Some(guide), Some(scene)) = (guide, scene) else {
        visibility.set_if_neq(Visibility::Hidden);
        return;
    };
    let radius = scene.balls[aim.ball].ball.radius;
    let is_ghostly = matches!(guide.first.hit, Hit::Ball(_) | Hit::Cushion(_));
    visibility.set_if_neq(if is_ghostly {
        Visibility::Inherited
    } else {
        Visibility::Hidden
    });
    **transform = Transform::from_translation(guide.first.end.position.as_vec3())
        .with_scale(Vec3::splat(0.999 * radius as f32));
    strokes(&mut lines, &guide, radius);
}

fn strokes(lines: &mut Gizmos<Strokes>, guide: &Guide, radius: f64) {
    let white = if guide.miscue {
        LinearRgba::new(1.0, 0.12, 0.08, 0.9)
    } else {
        LinearRgba::new(1.0, 1.0, 1.0, 0.8)
    };
    polyline(lines, &guide.first.points, radius, white);
    if let Some(leg) = &guide.object {
        polyline(
            lines,
            &leg.points,
            radius,
            LinearRgba::new(1.0, 0.75, 0.15, 0.9),
        );
    }
    if let Some(leg) = &guide.onward {
        polyline(
            lines,
            &leg.points,
            radius,
            LinearRgba::new(0.55, 0.85, 1.0, 0.7),
        );
    }
    if matches!(guide.first.hit, Hit::Ball(_)) {
        let at = on_cloth(guide.first.end.position);
        let flat = Quat::from_rotation_x(std::f32::consts::FRAC_PI_2);
        lines
            .circle(Isometry3d::new(at, flat), radius as f32, white)
            .resolution(48);
    }
}

/// Lines lie on the cloth under the centres, where the eye looks for them; the part below the ball itself is left out.
fn polyline(lines: &mut Gizmos<Strokes>, points: &[DVec3], radius: f64, colour: LinearRgba) {
    let Some(&first) = points.first() else {
        return;
    };
    let seen = points.iter().filter(|p| p.distance(first) > radius);
    let start = points
        .iter()
        .find(|p| p.distance(first) > radius)
        .map(|p| first + radius * (*p - first).normalize_or_zero());
    lines.linestrip(start.iter().chain(seen).map(|p| on_cloth(*p)), colour);
}

fn on_cloth(point: DVec3) -> Vec3 {
    point.as_vec3().with_y(0.0015)
}
