//! Where the player looks from: behind the cue, overhead, or freely around a point.
//!
//! A change of mode is eased; within a mode the camera follows without lag. Nothing but the player changes the mode.

mod pose;
mod rig;

use bevy::prelude::*;

use crate::game::aim::Aim;
use crate::game::replay::Replay;
use crate::game::settings::Settings;
use crate::game::view::{CameraInput, View};
use crate::game::watch::Watch;
use crate::sim::clock::Clock;
use crate::sim::components::{BallIndex, MotionKind, Position};
use crate::sim::playfield::Playfield;
use crate::sim::stepped::crowd::Crowd;
use crate::window::WindowSystems;
use rig::{Rig, Surroundings};

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Rig>()
        .add_systems(Startup, spawn)
        .add_systems(RunFixedMainLoop, follow.in_set(WindowSystems::Look));
}

fn spawn(mut commands: Commands) {
    commands.spawn((
        Name::new("camera"),
        Camera3d::default(),
        Projection::Perspective(PerspectiveProjection {
            near: 0.02,
            far: 60.0,
            ..default()
        }),
        Transform::default(),
    ));
}

/// Moves the camera to where the rig wants it.
#[expect(clippy::too_many_arguments, reason = "everything a view depends on")]
fn follow(
    time: Res<Time>,
    view: Res<View>,
    aim: Res<Aim>,
    clock: Res<Clock>,
    replay: Res<Replay>,
    settings: Res<Settings>,
    playfield: Res<Playfield>,
    (watch, crowd): (Res<Watch>, Res<Crowd>),
    balls: Query<(&BallIndex, &Position, &MotionKind)>,
    mut input: MessageReader<CameraInput>,
    mut rig: ResMut<Rig>,
    mut camera: Single<(&mut Transform, &mut Projection, &Camera), With<Camera3d>>,
) {
    let (transform, projection, camera) = &mut *camera;
    let size = camera
        .logical_viewport_size()
        .unwrap_or(Vec2::new(16.0, 9.0));
    let is_crowd = playfield.solver.is_crowd();
    let ball = balls
        .iter()
        .find(|(index, _, motion)| index.0 == aim.ball && motion.0.in_play())
        .map(|(_, position, _)| position.0.as_vec3());
    let surroundings = Surroundings {
        // While balls move the camera behind the cue stays where the shot was played from.
        ball: ball.filter(|_| !clock.moving && !replay.is_active()),
        forward: aim.shot.forward().as_vec3(),
        table: Vec2::new(playfield.table.length as f32, playfield.table.width as f32),
        aspect: (size.x / size.y.max(1.0)).clamp(0.1, 10.0),
        is_crowd,
        watched: watch
            .chosen
            .filter(|_| is_crowd && watch.follow)
            .and_then(|number| crowd.state(number))
            .map(|state| state.position.as_vec3()),
    };
    rig.suit(&surroundings);
    for input in input.read() {
        rig.steer(view.camera, input);
    }
    // Whoever wants less motion sees the camera where it would come to rest.
    let seconds = if settings.reduced_motion {
        f32::INFINITY
    } else {
        time.delta_secs()
    };
    let pose = rig.advance(view.camera, &surroundings, seconds);
    **transform = Transform::from_translation(pose.eye).with_rotation(pose.rotation);
    if let Projection::Perspective(perspective) = &mut **projection {
        perspective.fov = pose.fov;
        (perspective.near, perspective.far) = rig.depths();
    }
}
