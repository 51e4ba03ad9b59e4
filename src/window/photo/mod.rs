//! Photo mode: time stands still, the panels go, the camera is free, and what it sees becomes a file.

mod file;
mod lens;
mod panel;
mod shoot;

use bevy::prelude::*;
use bevy_egui::input::EguiWantsInput;
use bevy_egui::{EguiPrimaryContextPass, egui};
use leafwing_input_manager::prelude::ActionState;

use crate::window::action::Action;
use crate::window::language::Language;
use crate::window::page::{AddPages, Open, Page, PageId, Screen};
use crate::window::{RenderQuality, WindowSystems};
use lens::Lens;

/// Photo mode.
#[derive(Resource, Debug, Default)]
pub(super) struct Photo {
    /// Whether it is on.
    on: bool,
    lens: Lens,
    /// Whether its own panel is shown.
    panel: bool,
    /// What became of the last picture, and whether it failed.
    news: Option<(String, bool)>,
    /// Whether time stood still before.
    held: bool,
}

/// Whether photo mode is off: then the table is played on as ever.
pub(super) fn is_off(photo: Res<Photo>) -> bool {
    !photo.on
}

fn is_on(photo: Res<Photo>) -> bool {
    photo.on
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Photo>()
        .add_page(
            Page {
                id: PageId("photo"),
                title: "photo-title",
                place: Some((PageId::MAIN, 35)),
            },
            page,
        )
        .add_plugins(shoot::plugin)
        .add_systems(
            PreUpdate,
            (
                switch.run_if(in_state(Screen::Table)),
                lens::steer.run_if(is_on),
            )
                .chain()
                .in_set(WindowSystems::Photo),
        )
        .add_systems(
            RunFixedMainLoop,
            lens::look
                .run_if(is_on)
                .in_set(RunFixedMainLoopSystems::AfterFixedMainLoop)
                .after(WindowSystems::Look),
        )
        .add_systems(
            EguiPrimaryContextPass,
            panel::show.run_if(is_on).in_set(WindowSystems::Photo),
        );
}

/// The page of the menu: what photo mode is, and the way into it.
fn page(
    InMut(ui): InMut<egui::Ui>,
    language: Res<Language>,
    mut open: ResMut<Open>,
    mut photo: ResMut<Photo>,
) {
    ui.label(language.text("photo-about"));
    ui.vertical_centered_justified(|ui| {
        if ui.button(language.text("photo-begin")).clicked() {
            open.close();
            photo.begin();
        }
    });
}

impl Photo {
    fn begin(&mut self) {
        if !self.on {
            *self = Self {
                on: true,
                lens: Lens::default(),
                panel: true,
                news: None,
                held: false,
            };
        }
    }
}

/// Enters and leaves by keys; holds time meanwhile.
#[expect(clippy::too_many_arguments, reason = "keys, time, lines, cameras")]
fn switch(
    mut commands: Commands,
    egui: Res<EguiWantsInput>,
    actions: Single<&ActionState<Action>>,
    mut photo: ResMut<Photo>,
    mut time: ResMut<Time<Virtual>>,
    mut lines: Option<ResMut<GizmoConfigStore>>,
    quality: Res<RenderQuality>,
    cameras: Query<Entity, With<Camera3d>>,
    mut was_on: Local<bool>,
) {
    let typing = egui.wants_any_keyboard_input();
    if actions.just_pressed(&Action::Photo) && !typing {
        if photo.on {
            photo.on = false;
        } else {
            photo.begin();
        }
    } else if photo.on && *was_on {
        if actions.just_pressed(&Action::Close) && !typing {
            photo.on = false;
        } else if actions.just_pressed(&Action::Panel) {
            photo.panel = !photo.panel;
        }
    }
    if photo.on {
        if !*was_on {
            photo.held = time.is_paused();
        }
        time.pause();
    }
    if photo.on == *was_on {
        return;
    }
    *was_on = photo.on;
    // Lines that help to aim are no part of the picture.
    if let Some(store) = &mut lines {
        for (_, config, _) in store.iter_mut() {
            config.enabled = !photo.on;
        }
    }
    if !photo.on {
        if !photo.held {
            time.unpause();
        }
        for camera in &cameras {
            lens::put_away(&mut commands.entity(camera), *quality);
        }
    }
}
