//! What a person sees and touches: the drawn table, the cameras, the controls.
//!
//! The children never import each other. They meet in messages and resources of [`sim`](crate::sim) and
//! [`game`](crate::game). A frame runs [`WindowSystems`] in order, with the fixed ticks between `Input` and `Present`.

pub mod action;
mod camera;
mod crowd;
mod display;
mod ending;
mod hud;
mod input;
pub mod language;
mod match_ui;
mod menu;
mod pace;
pub mod page;
mod photo;
mod preset;
mod render;
mod scenario_ui;
mod shot_ui;
mod sound;
mod start;

pub use display::{NoDisplay, film, snapshot, unseen};
pub use preset::Source;
pub use render::quality::RenderQuality;
pub use scenario_ui::{Heat, OnTable, OwnScenes, Stage, Studio, Turn, seats};

use std::time::{Duration, Instant};

use bevy::app::PluginGroupBuilder;
use bevy::asset::AssetPlugin;
use bevy::log::{Level, LogPlugin};

use bevy::prelude::*;
use bevy::window::WindowResizeConstraints;
use bevy_egui::{EguiPlugin, EguiPreUpdateSet, EguiPrimaryContextPass};
use leafwing_input_manager::plugin::InputManagerSystem;

use crate::game::matches::Store;
use crate::game::settings::{SettingsFile, file};
use crate::game::turns::MatchStore;
use crate::game::{GamePlugin, practice};
use crate::scenarios::file::Scenario;
use crate::sim::SimPlugin;
use crate::sim::playfield::lay_out;
use crate::window::page::Screen;

/// The order of one frame.
///
/// While the menu is open nothing is played: `Input` and `Ui` are left out; so they are while a photo is taken.
#[derive(SystemSet, Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum WindowSystems {
    /// The menu is steered. Runs in [`PreUpdate`], before `Input`; and laid out, last in [`EguiPrimaryContextPass`].
    Menu,
    /// A control that the settings ask for is taken. Runs in [`PreUpdate`], after `Menu`.
    Asking,
    /// What is open is closed. Runs in [`PreUpdate`], before `Input`, so that all see the same when a key closes one thing
    /// after the other.
    Close,
    /// Keys and pointer become aim, camera input and messages. Runs in [`PreUpdate`]: once a frame, so that no press is
    /// lost between the fixed ticks or counted twice.
    Input,
    /// Transforms, meshes and sounds follow the simulation. Runs in [`RunFixedMainLoop`], after the fixed ticks.
    Present,
    /// The camera follows. Runs in [`RunFixedMainLoop`], after `Present`.
    Look,
    /// Trick shots and the studio: keys in [`PreUpdate`], after `Input`; panels in [`EguiPrimaryContextPass`], after `Ui`.
    Scenes,
    /// Photo mode: keys in [`PreUpdate`], after `Scenes`; its panel in [`EguiPrimaryContextPass`], after `Overlay`.
    Photo,
    /// Panels are laid out and read. Runs in [`EguiPrimaryContextPass`].
    Ui,
    /// What a match says and asks. Runs in [`EguiPrimaryContextPass`].
    Match,
    /// What lies over the panels: help, status. Runs in [`EguiPrimaryContextPass`].
    Overlay,
    /// Files that were chosen or have changed are taken up. Runs in [`Last`].
    Files,
}

/// Everything with pixels or sound, on top of [`SimPlugin`] and [`GamePlugin`].
pub struct WindowPlugin;

impl Plugin for WindowPlugin {
    fn build(&self, app: &mut App) {
        app.init_schedule(EguiPrimaryContextPass)
            .configure_sets(
                PreUpdate,
                (
                    WindowSystems::Menu,
                    WindowSystems::Asking,
                    WindowSystems::Close.run_if(at_table()),
                    WindowSystems::Input.run_if(at_table()),
                    WindowSystems::Scenes.run_if(at_table()),
                    WindowSystems::Photo,
                )
                    .chain()
                    .after(InputManagerSystem::ManualControl)
                    .after(EguiPreUpdateSet::ProcessInput),
            )
            .configure_sets(
                PreUpdate,
                (WindowSystems::Menu, WindowSystems::Asking).before(EguiPreUpdateSet::BeginPass),
            )
            .configure_sets(
                EguiPrimaryContextPass,
                (
                    WindowSystems::Ui.run_if(at_table()),
                    WindowSystems::Match.run_if(at_table()),
                    WindowSystems::Scenes.run_if(at_table()),
                    WindowSystems::Overlay.run_if(photo::is_off),
                    WindowSystems::Photo,
                    WindowSystems::Menu,
                )
                    .chain(),
            )
            .add_plugins((
                picture,
                camera::panels_plugin,
                language::plugin,
                page::plugin,
                action::plugin,
                input::plugin,
                shot_ui::plugin,
                hud::plugin,
                match_ui::plugin,
                menu::plugin,
                // After the menu: its scenes are listed last.
                crowd::plugin,
                scenario_ui::plugin,
                sound::plugin,
                photo::plugin,
                preset::plugin,
            ))
            .add_plugins(ending::plugin);
    }
}

/// What a frame counts at most for whoever looks on or holds a key: a machine that slept had nobody at it.
const LONGEST_FRAME: Duration = Duration::from_millis(200);

/// How long this frame was for a person.
fn felt(time: &Time<Real>) -> Duration {
    time.delta().min(LONGEST_FRAME)
}

/// Whether the table has keys, pointer and panels: no menu is open and no photo is being taken.
fn at_table() -> impl SystemCondition<()> {
    in_state(Screen::Table).and_then(photo::is_off)
}

/// What can be seen without touching anything: the part that also draws without a window.
fn picture(app: &mut App) {
    app.configure_sets(
        RunFixedMainLoop,
        (WindowSystems::Present, WindowSystems::Look)
            .chain()
            .in_set(RunFixedMainLoopSystems::AfterFixedMainLoop),
    )
    .add_plugins((pace::plugin, camera::plugin, render::plugin, crowd::picture));
}

/// The plugins of the whole program on top of Bevy's own.
#[must_use]
pub fn windowed() -> PluginGroupBuilder {
    PluginGroupBuilder::start::<Windowed>()
        .add(EguiPlugin::default())
        .add(SimPlugin)
        .add(GamePlugin)
        .add(WindowPlugin)
}

struct Windowed;

impl PluginGroup for Windowed {
    fn build(self) -> PluginGroupBuilder {
        windowed()
    }
}

/// Opens the window and plays until it is closed, starting from this scene or from a racked table. The files of the
/// source, if there is one, are followed: a change of them comes to the table between two shots. If the start is to be
/// timed, from when the program began, its phases are printed and it ends when everything is there.
///
/// # Errors
/// [`NoDisplay`] if there is nothing to draw on or with.
pub fn play(
    scenario: Option<Scenario>,
    source: Option<Source>,
    timed: Option<Instant>,
) -> Result<AppExit, NoDisplay> {
    let mut app = display::on_screen(|quality| {
        let mut app = App::new();
        app.insert_resource(quality)
            .insert_resource(SettingsFile(file::place()))
            .insert_resource(MatchStore(Store::of_platform()))
            .add_plugins(engine())
            .add_plugins(windowed());
        app
    })?;
    app.insert_resource(OwnScenes::of_platform());
    let scene = match scenario {
        Some(scenario) => {
            let scene = scenario.scene.clone();
            scenario_ui::begin(app.world_mut(), scenario);
            scene
        }
        None => practice::opening(),
    };
    lay_out(app.world_mut(), &scene);
    if let Some(source) = source {
        preset::begin(app.world_mut(), source);
    }
    ending::listen(&mut app);
    if let Some(begun) = timed {
        start::time(&mut app, begun);
    }
    Ok(app.run())
}

/// Bevy's plugins for a window of ours. Nothing is read from files: every asset is generated or embedded.
fn engine() -> PluginGroupBuilder {
    DefaultPlugins
        .set(bevy::window::WindowPlugin {
            primary_window: Some(Window {
                title: "Massé".to_owned(),
                name: Some("masse".to_owned()),
                resolution: (1280, 720).into(),
                // Nothing can be read or clicked in less.
                resize_constraints: WindowResizeConstraints {
                    min_width: 320.0,
                    min_height: 240.0,
                    ..default()
                },
                ..default()
            }),
            ..default()
        })
        .set(AssetPlugin {
            watch_for_changes_override: Some(false),
            ..default()
        })
        .set(LogPlugin {
            level: Level::WARN,
            custom_layer: sound::log_layer,
            ..default()
        })
}
