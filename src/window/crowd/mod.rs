//! Crowds on the screen: thousands to a million balls in one draw, a ball to watch, numbers, sliders, scenes.
//!
//! The balls of a crowd have no meshes of their own. [`pack`] writes them into one sheet of bytes each frame, [`cloud`]
//! brings the sheet to the graphics card and draws a sphere for every record. Everything here sleeps while the scene on
//! the table is no crowd.

mod cloud;
mod dials;
mod numbers;
mod pace;
mod pack;
mod panel;
mod pointer;
mod scenes;
mod shade;
mod sheet;
mod turn;

use bevy::prelude::*;
use bevy_egui::EguiPrimaryContextPass;
use bevy_egui::input::egui_wants_any_keyboard_input;

use crate::game::view::{CameraMode, FirstEye, View};
use crate::game::watch::Watch;
use crate::sim::SimSystems;
use crate::sim::playfield::Playfield;
use crate::sim::stepped::crowd::{Crowd, is_crowd};
use crate::window::WindowSystems;
use crate::window::page::Screen;

/// What can be seen without touching anything.
pub(super) fn picture(app: &mut App) {
    app.init_resource::<pack::Packed>()
        .insert_gizmo_config(
            Ring,
            GizmoConfig {
                depth_bias: -1.0,
                ..default()
            },
        )
        .add_plugins((cloud::plugin, shade::plugin))
        .add_systems(
            RunFixedMainLoop,
            (enter, pack::pack, cloud::assemble)
                .chain()
                .in_set(RunFixedMainLoopSystems::AfterFixedMainLoop)
                .after(WindowSystems::Present)
                .before(WindowSystems::Look),
        )
        .add_systems(Update, ring.run_if(is_crowd));
}

/// What can be touched.
pub(super) fn plugin(app: &mut App) {
    app.init_resource::<pointer::Grasp>()
        .init_resource::<numbers::Numbers>()
        .init_resource::<panel::Panel>()
        .add_plugins(scenes::plugin)
        .init_resource::<pace::Cost>()
        .add_systems(
            PreUpdate,
            (
                pointer::press,
                pointer::drag,
                pointer::wheel,
                pace::command.run_if(not(egui_wants_any_keyboard_input)),
                panel::toggle.run_if(not(egui_wants_any_keyboard_input)),
            )
                .chain()
                .run_if(is_crowd.and_then(in_state(Screen::Table)))
                .after(WindowSystems::Input)
                .before(WindowSystems::Photo),
        )
        .add_systems(FixedFirst, pace::start)
        .add_systems(
            FixedUpdate,
            pace::ask
                .after(SimSystems::Strike)
                .before(SimSystems::Advance),
        )
        .add_systems(FixedLast, (pace::stop, numbers::count).chain())
        .add_systems(
            Last,
            (
                pace::keep_up,
                scenes::arrive,
                numbers::follow.run_if(is_crowd),
            )
                .chain()
                .after(WindowSystems::Files),
        )
        .add_systems(
            EguiPrimaryContextPass,
            panel::show
                .run_if(in_state(Screen::Table))
                .after(WindowSystems::Scenes)
                .before(WindowSystems::Overlay),
        );
}

/// A crowd is first seen from above; and nobody plays it with a cue.
fn enter(playfield: Res<Playfield>, mut view: ResMut<View>, mut was: Local<bool>) {
    let is = playfield.solver.is_crowd();
    if is && !*was {
        view.camera = CameraMode::Overhead;
    }
    *was = is;
}

/// The ring around the ball that is watched.
#[derive(Default, Reflect, GizmoConfigGroup)]
struct Ring;

fn ring(
    mut lines: Gizmos<Ring>,
    watch: Res<Watch>,
    crowd: Res<Crowd>,
    packed: Res<pack::Packed>,
    camera: Single<&GlobalTransform, With<FirstEye>>,
) {
    let Some(state) = watch.chosen.and_then(|number| crowd.state(number)) else {
        return;
    };
    let at = state.position.as_vec3();
    // However far away, it is seen.
    let radius = (1.6 * packed.radius).max(0.012 * at.distance(camera.translation()));
    let facing = Isometry3d::new(at, camera.rotation());
    lines.circle(facing, radius, Color::srgb(1.0, 0.95, 0.2));
}
