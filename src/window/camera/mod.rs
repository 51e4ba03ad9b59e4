//! Where the player looks from: behind the cue, overhead, freely around a point, beside a ball, or from where the scene
//! wants it. And what stands beside that picture: another camera, or the same stroke by other laws.
//!
//! A change of mode is eased; within a mode the camera follows without lag. Nothing but the player changes the mode. What is
//! looked at is shown beside the panels, not behind them.

mod frame;
mod halves;
mod panels;
mod pose;
mod rig;

use bevy::prelude::*;

use crate::game::aim::Aim;
use crate::game::replay::Replay;
use crate::game::settings::Settings;
use crate::game::twin::Twin;
use crate::game::view::{
    Beside, CameraInput, CameraMode, FirstEye, SceneCamera, SceneCameras, View,
};
use crate::game::watch::Watch;
use crate::sim::clock::Clock;
use crate::sim::components::{BallIndex, BallName, MotionKind, Position};
use crate::sim::playfield::Playfield;
use crate::sim::stepped::crowd::Crowd;
use crate::window::WindowSystems;
use halves::{SecondEye, Under};
use panels::Covered;
use pose::Pose;
use rig::{Rig, Seat, Surroundings};

pub(super) use panels::plugin as panels_plugin;

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Covered>()
        .add_systems(Startup, spawn)
        .add_systems(
            RunFixedMainLoop,
            (halves::open, halves::share, follow)
                .chain()
                .in_set(WindowSystems::Look),
        );
}

/// What every eye on the table is.
fn eye(name: &'static str) -> impl Bundle {
    (
        Name::new(name),
        Camera3d::default(),
        Projection::Perspective(PerspectiveProjection {
            near: 0.02,
            far: 60.0,
            ..default()
        }),
        Transform::default(),
        Rig::default(),
    )
}

fn spawn(mut commands: Commands) {
    commands.spawn((eye("camera"), FirstEye));
}

type Balls<'w, 's> = Query<
    'w,
    's,
    (
        &'static BallIndex,
        &'static BallName,
        &'static Position,
        &'static MotionKind,
    ),
>;

type Eyes<'w, 's> = Query<
    'w,
    's,
    (
        &'static mut Transform,
        &'static mut Projection,
        &'static mut Rig,
        &'static mut Camera,
        Has<SecondEye>,
    ),
>;

/// Moves the cameras to where their rigs want them.
#[expect(clippy::too_many_arguments, reason = "everything a view depends on")]
fn follow(
    time: Res<Time>,
    (view, cameras, twin): (Res<View>, Res<SceneCameras>, Res<Twin>),
    aim: Res<Aim>,
    clock: Res<Clock>,
    replay: Res<Replay>,
    settings: Res<Settings>,
    playfield: Res<Playfield>,
    (watch, crowd, covered): (Res<Watch>, Res<Crowd>, Res<Covered>),
    balls: Balls,
    mut input: MessageReader<CameraInput>,
    mut looks: ParamSet<(Under, Eyes)>,
) {
    let inputs: Vec<CameraInput> = input.read().copied().collect();
    // Through the same camera other laws are seen as the table is.
    let is_second_steered = looks.p0().is_second() && view.beside != Beside::Laws;
    // Whoever wants less motion sees the camera where it would come to rest.
    let seconds = if settings.reduced_motion {
        f32::INFINITY
    } else {
        time.delta_secs()
    };
    let is_crowd = playfield.solver.is_crowd();
    // Where the shot is played from, which a replay shows again. While balls move the camera behind the cue stays there.
    let waiting = match &replay.0 {
        Some(playback) => playback
            .record
            .paths
            .get(aim.ball)
            .and_then(|path| path.first())
            .map(|first| first.piece.start.position.as_vec3()),
        None => balls
            .iter()
            .find(|(index, _, _, motion)| index.0 == aim.ball && motion.0.in_play())
            .map(|(_, _, position, _)| position.0.as_vec3())
            .filter(|_| !clock.moving),
    };
    for (mut transform, mut projection, mut rig, mut camera, is_second) in &mut looks.p1() {
        if !camera.is_active {
            continue;
        }
        let size = camera
            .logical_viewport_size()
            .unwrap_or(Vec2::new(16.0, 9.0));
        let table = Vec2::new(playfield.table.length as f32, playfield.table.width as f32);
        let aspect = (size.x / size.y.max(1.0)).clamp(0.1, 10.0);
        let frame = rig.framing.advance(
            panels::over(&covered, &camera),
            size,
            rig::overhead(table, aspect),
            seconds,
        );
        let surroundings = Surroundings {
            ball: waiting,
            forward: aim.shot.forward().as_vec3(),
            table,
            aspect,
            frame,
            is_crowd,
            watched: watch
                .chosen
                .filter(|_| is_crowd && watch.follow)
                .and_then(|number| crowd.state(number))
                .map(|state| state.position.as_vec3()),
        };
        let mode = match view.beside {
            Beside::Camera(mode) if is_second => mode,
            _ => view.camera,
        };
        let at = |wanted: &dyn Fn(usize, &str) -> bool| {
            let (index, _, position, motion) =
                balls.iter().find(|ball| wanted(ball.0.0, &ball.1.0))?;
            let twin = twin.state(index.0).filter(|_| is_second);
            let (position, motion) = match (view.beside, twin) {
                (Beside::Laws, Some(state)) => (state.position, state.motion),
                _ => (position.0, motion.0),
            };
            motion.in_play().then(|| position.as_vec3())
        };
        let seat = seat(mode, &cameras, aim.ball, &at);
        rig.suit(&surroundings);
        if is_second == is_second_steered || view.beside == Beside::Laws {
            for input in &inputs {
                rig.steer(seat, input);
            }
        }
        let pose = rig.advance((mode, seat), &surroundings, seconds);
        *transform = Transform::from_translation(pose.eye).with_rotation(pose.rotation);
        if let Projection::Perspective(perspective) = &mut *projection {
            let (fov, part) = frame::lens(pose.frame, pose.fov, size);
            perspective.fov = fov;
            if camera.sub_camera_view != part {
                camera.sub_camera_view = part;
            }
            (perspective.near, perspective.far) = rig.depths();
        }
    }
}

/// What a mode comes to on the table, where `at` knows where a ball is that fits.
fn seat(
    mode: CameraMode,
    cameras: &SceneCameras,
    struck: usize,
    at: &dyn Fn(&dyn Fn(usize, &str) -> bool) -> Option<Vec3>,
) -> Seat {
    match mode {
        CameraMode::BehindCue => Seat::BehindCue,
        CameraMode::Overhead => Seat::Overhead,
        CameraMode::Orbit => Seat::Orbit,
        CameraMode::Follow => Seat::Follow(at(&|index, _| index == struck)),
        CameraMode::Scene(place) => match cameras.0.get(place) {
            // The scene has gone, and its cameras with it.
            None | Some(SceneCamera::BehindCue) => Seat::BehindCue,
            Some(SceneCamera::Overhead) => Seat::Overhead,
            Some(SceneCamera::Follow(ball)) => Seat::Follow(at(&|_, name| name == ball)),
            Some(SceneCamera::Fixed { eye, target, fov }) => {
                let (eye, target) = (eye.as_vec3(), target.as_vec3());
                let down = (target - eye).normalize_or_zero();
                // Straight down has no horizon; the far side is up then, as overhead.
                let up = if down.y.abs() > 0.999 {
                    Vec3::NEG_Z
                } else {
                    Vec3::Y
                };
                Seat::Fixed(Pose::looking_at(eye, target, up, *fov as f32))
            }
        },
    }
}
