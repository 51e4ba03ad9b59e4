//! Loads the settings when the program starts, and saves them when they have changed.

use std::path::PathBuf;
use std::time::Duration;

use bevy::prelude::*;

use super::{Settings, file};
use crate::game::Keeping;
use crate::game::equip::Told;
use crate::game::saying::Saying;

/// How long settings are left alone before they are saved: a slider that is dragged is one change.
const SETTLED: Duration = Duration::from_millis(500);

/// After how long it is tried again to save settings that could not be saved.
const PATIENCE: Duration = Duration::from_secs(5);

/// The file in which the settings are kept. Without one they last as long as the program runs.
#[derive(Resource, Clone, Debug, Default, PartialEq, Eq)]
pub struct SettingsFile(pub Option<PathBuf>);

/// What the file says, since when the settings say something else, and why that could not be saved when it was tried last.
#[derive(Resource, Debug, Default)]
struct Saved {
    settings: Option<Settings>,
    changed: Option<Duration>,
    unsaved: Option<String>,
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Saved>()
        .add_systems(PreStartup, load)
        .add_systems(Last, save.in_set(Keeping));
}

fn load(
    mut commands: Commands,
    mut settings: ResMut<Settings>,
    mut file: ResMut<SettingsFile>,
    mut saved: ResMut<Saved>,
) {
    if let Some(path) = file.0.clone() {
        let (loaded, damage) = file::load(&path);
        *settings = loaded;
        if let Some(damage) = damage {
            let (text, may_write) = told(&path.display().to_string(), &damage);
            if !may_write {
                file.0 = None;
            }
            commands.write_message(Told {
                text,
                is_failure: true,
            });
        }
    }
    saved.settings = Some(settings.clone());
}

/// What a player is told of a damaged file, and whether its name is free again.
fn told(file: &str, damage: &file::Damage) -> (Saying, bool) {
    let reason = damage.error.to_string();
    match &damage.kept {
        Ok(kept) => {
            let kept = kept.display().to_string();
            let text = Saying::new(
                "notice-settings-damaged",
                &[("file", file), ("reason", &reason), ("kept", &kept)],
                format!("{file}: {reason}. It is kept as {kept}; every setting is as at first."),
            );
            (text, true)
        }
        Err(error) => {
            let text = Saying::new(
                "notice-settings-stuck",
                &[
                    ("file", file),
                    ("reason", &reason),
                    ("error", &error.to_string()),
                ],
                format!(
                    "{file}: {reason}. It cannot be renamed ({error}), so nothing is saved this time."
                ),
            );
            (text, false)
        }
    }
}

fn save(
    mut commands: Commands,
    settings: Res<Settings>,
    file: Res<SettingsFile>,
    time: Res<Time<Real>>,
    mut exits: MessageReader<AppExit>,
    mut saved: ResMut<Saved>,
) {
    let ends = exits.read().count() > 0;
    if settings.is_changed() {
        let differs = saved.settings.as_ref() != Some(&*settings);
        saved.changed = differs.then(|| time.elapsed());
        if !differs {
            saved.unsaved = None;
        }
    }
    let (Some(since), Some(path)) = (saved.changed, &file.0) else {
        return;
    };
    let wait = match saved.unsaved {
        Some(_) => PATIENCE,
        None => SETTLED,
    };
    if !ends && time.elapsed() < since + wait {
        return;
    }
    let Err(error) = file::save(path, &settings) else {
        saved.changed = None;
        saved.settings = Some(settings.clone());
        saved.unsaved = None;
        return;
    };
    saved.changed = Some(time.elapsed());
    let (file, error) = (path.display().to_string(), error.to_string());
    // Told once, and once more when nothing can be done about it any more.
    if ends || saved.unsaved.as_ref() != Some(&error) {
        commands.write_message(Told {
            text: Saying::new(
                "notice-settings-unsaved",
                &[("file", &file), ("error", &error)],
                format!("The settings could not be saved in {file}: {error}"),
            ),
            is_failure: true,
        });
    }
    saved.unsaved = Some(error);
}
