//! The crowd scenes of the library, and whatever else takes long to lay out: it is made on another thread.

use bevy::prelude::*;
use bevy::tasks::futures::check_ready;
use bevy::tasks::{AsyncComputeTaskPool, Task};
use bevy_egui::egui;

use crate::game::equip::Told;
use crate::game::saying::Saying;
use crate::physics::scene::Scene;
use crate::scenarios::library;
use crate::sim::messages::LoadScene;
use crate::window::language::Language;
use crate::window::page::{AddPages, Mode};

/// The scene that is being made.
#[derive(Resource, Default)]
pub(super) struct Loading {
    task: Option<(String, Task<Result<Scene, Saying>>)>,
    /// Name and title of every crowd scene, once they are asked for.
    known: Option<Vec<(&'static str, String)>>,
}

impl Loading {
    /// Makes a scene in the background; what was being made before is given up.
    pub fn begin(
        &mut self,
        what: String,
        make: impl FnOnce() -> Result<Scene, Saying> + Send + 'static,
    ) {
        let task = AsyncComputeTaskPool::get().spawn(async move { make() });
        self.task = Some((what, task));
    }

    /// Opens a scene of the library.
    pub fn open(&mut self, name: &'static str, title: String) {
        self.begin(title, move || match library::open(name) {
            Ok(scenario) => Ok(scenario.scene),
            Err(error) => Err(Saying::from(error.to_string())),
        });
    }

    /// What is being made, if anything.
    pub fn what(&self) -> Option<&str> {
        self.task.as_ref().map(|(what, _)| what.as_str())
    }
}

/// Adds the crowds to the games that can be begun.
pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Loading>();
    for (name, title) in crowds() {
        app.add_mode(
            Mode {
                group: "new-game-crowds",
                title: format!("scene-{name}"),
                name: title.clone(),
                about: None,
            },
            move |mut loading: ResMut<Loading>| loading.open(name, title.clone()),
        );
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
                text,
                is_failure: true,
            });
        }
    }
}

/// A button for each scene.
pub(super) fn list(ui: &mut egui::Ui, language: &Language, loading: &mut Loading) {
    let known = loading.known.get_or_insert_with(crowds).clone();
    if known.is_empty() {
        ui.label(language.text("crowd-no-scenes"));
    }
    for (name, title) in known {
        let key = format!("scene-{name}");
        let title = language.find(&key).unwrap_or(&title);
        if ui.button(title).clicked() {
            loading.open(name, title.to_owned());
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
    library::all()
        .filter(|scene| scene.is_crowd().unwrap_or(false))
        .map(|scene| (scene.name, scene.title().unwrap_or_default()))
        .collect()
}
