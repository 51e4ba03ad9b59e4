//! The scenes of the library in which something must happen, each with a still picture.

use std::sync::{Arc, LazyLock, OnceLock};

use bevy::prelude::*;
use bevy::tasks::AsyncComputeTaskPool;

use super::still::Still;
use crate::scenarios::file::Scenario;
use crate::scenarios::library;

/// A trick shot.
pub(super) struct Trick {
    /// What the library calls it.
    pub(super) name: &'static str,
    /// The scene and what must happen.
    pub(super) scenario: Scenario,
}

static TRICKS: LazyLock<Vec<Trick>> = LazyLock::new(|| {
    let all = library::BUILT_IN.iter().filter_map(|scene| {
        let scenario = scene.scenario().ok()?;
        let name = scene.name;
        (!scenario.expect.is_empty()).then_some(Trick { name, scenario })
    });
    all.collect()
});

/// Every trick shot, in the order of the library.
pub(super) fn tricks() -> &'static [Trick] {
    &TRICKS
}

/// The still pictures, drawn one after the other beside the game.
#[derive(Resource, Clone, Default)]
pub(super) struct Stills(Option<Arc<Vec<OnceLock<Still>>>>);

impl Stills {
    /// The picture of a trick shot by its place in the list, as soon as it is there. The first question begins the work.
    pub(super) fn get(&mut self, place: usize) -> Option<&Still> {
        let stills = self.0.get_or_insert_with(|| {
            let empty = tricks().iter().map(|_| OnceLock::new());
            let stills = Arc::new(empty.collect::<Vec<_>>());
            let work = stills.clone();
            let draw = async move {
                for (trick, still) in tricks().iter().zip(work.iter()) {
                    still.get_or_init(|| Still::of(&trick.scenario.scene));
                }
            };
            AsyncComputeTaskPool::get().spawn(draw).detach();
            stills
        });
        stills.get(place)?.get()
    }
}
