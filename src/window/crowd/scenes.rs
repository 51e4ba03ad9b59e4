//! The crowd scenes of the library, and whatever else takes long to lay out: it is made on another thread.

use bevy::prelude::*;
use bevy::tasks::futures::check_ready;
use bevy::tasks::{AsyncComputeTaskPool, Task};
use bevy_egui::{EguiContexts, egui};

use crate::game::equip::Told;
use crate::physics::scene::Scene;
use crate::scenarios::library::{self, BUILT_IN};
use crate::sim::messages::LoadScene;
use crate::sim::playfield::Playfield;

/// The scene that is being made.
#[derive(Resource, Default)]
pub(super) struct Loading {
    task: Option<(String, Task<Result<Scene, String>>)>,
    /// Name and title of every crowd scene, once they are asked for.
    known: Option<Vec<(&'static str, String)>>,
    open: bool,
}

impl Loading {
    /// Makes a scene in the background; what was being made before is given up.
    pub fn begin(
        &mut self,
        what: String,
        make: impl FnOnce() -> Result<Scene, String> + Send + 'static,
    ) {
        let task = AsyncComputeTaskPool::get().spawn(async move { make() });
        self.task = Some((what, task));
    }

    /// What is being made, if anything.
    pub fn what(&self) -> Option<&str> {
        self.task.as_ref().map(|(what, _)| what.as_str())
    }
}

/// Brings a scene that is done to the table.
pub(super) fn arrive(
    mut loading: ResMut<Loading>,
    mut time: ResMut<Time<Virtual>>,
    mut commands: Commands,
) {
    let Some((_, task)) = &mut loading.task else {
        return;
    };
    let Some(made) = check_ready(task) else {
        return;
    };
    loading.task = None;
    match made {
        Ok(scene) => {
            commands.write_message(LoadScene(scene));
            // Scenes are laid out by a tick.
            time.unpause();
        }
        Err(text) => {
            commands.write_message(Told {
                text: text.into(),
                is_failure: true,
            });
        }
    }
}

/// Lays out the button that opens the list while something else is played.
pub(super) fn show(
    mut contexts: EguiContexts,
    mut loading: ResMut<Loading>,
    playfield: Res<Playfield>,
) -> Result {
    if playfield.solver.is_crowd() {
        loading.open = false;
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    if !loading.open {
        egui::Area::new(egui::Id::new("crowds button"))
            .anchor(egui::Align2::LEFT_TOP, egui::vec2(84.0, 8.0))
            .show(context, |ui| {
                let hint = "Thousands of balls and more: gases, racks, boards of pegs.";
                if ui.button("Crowds").on_hover_text(hint).clicked() {
                    loading.open = true;
                }
            });
        return Ok(());
    }
    let mut open = true;
    egui::Window::new("Crowds")
        .open(&mut open)
        .anchor(egui::Align2::LEFT_TOP, egui::vec2(84.0, 8.0))
        .auto_sized()
        .collapsible(false)
        .show(context, |ui| list(ui, &mut loading));
    loading.open = open;
    Ok(())
}

/// A button for each scene.
pub(super) fn list(ui: &mut egui::Ui, loading: &mut Loading) {
    let known = loading.known.get_or_insert_with(crowds).clone();
    if known.is_empty() {
        ui.label("No crowd is built in.");
    }
    for (name, title) in known {
        if ui.button(name).on_hover_text(title).clicked() {
            loading.begin(name.to_owned(), move || {
                let opened = library::open(name);
                opened
                    .map(|scenario| scenario.scene)
                    .map_err(|error| error.to_string())
            });
        }
    }
    if let Some(what) = loading.what() {
        ui.horizontal(|ui| {
            ui.spinner();
            ui.label(what);
        });
    }
}

fn crowds() -> Vec<(&'static str, String)> {
    BUILT_IN
        .iter()
        .filter(|scene| scene.is_crowd().unwrap_or(false))
        .map(|scene| (scene.name, scene.title().unwrap_or_default()))
        .collect()
}
