//! Presets in the window: they are opened when they are chosen, and their files are followed while they are played with.

use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use bevy::prelude::*;
use bevy::time::common_conditions::on_real_timer;

use crate::game::aim::Aim;
use crate::game::equip::{ChoosePreset, Equip, OpenScene, PresetInUse, Told};
use crate::game::practice::Practice;
use crate::game::saying::Saying;
use crate::game::turns::Turns;
use crate::physics::equipment::{BallSet, Equipment};
use crate::scenarios::{library, preset};
use crate::sim::messages::LoadScene;
use crate::sim::playfield::{BallQuery, Playfield, snapshot};
use crate::window::WindowSystems;

/// How often the files are looked at.
const LOOK: Duration = Duration::from_millis(300);

/// Where the equipment comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Source {
    /// The preset with this name, or in this file.
    Preset(String),
    /// The scene with this name, or in this file, which names a preset and may change some of it.
    Scene(String),
}

/// The files in use, and how they were when they were last read.
#[derive(Resource, Debug, Default)]
struct Followed {
    source: Option<Source>,
    files: Vec<(PathBuf, Stamp)>,
    /// A change is taken up when the file has been left alone for one look: whoever writes it may not be done.
    changing: bool,
}

/// When a file was written and how long it is; none if it is not there.
type Stamp = Option<(SystemTime, u64)>;

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Followed>().add_systems(
        Last,
        (
            choose.run_if(on_message::<ChoosePreset>),
            lay_out.run_if(on_message::<OpenScene>),
            follow.run_if(on_real_timer(LOOK)),
        )
            .chain()
            .in_set(WindowSystems::Files),
    );
}

/// Follows the files of this source from now on; what they say is on the table already.
pub(super) fn begin(world: &mut World, source: Source) {
    let opened = open(&source);
    let mut followed = world.resource_mut::<Followed>();
    if let Ok(opened) = opened {
        followed.watch(opened.files);
        if let Some(name) = opened.preset {
            world.resource_mut::<PresetInUse>().0 = Some(name);
        }
        world.resource_mut::<Followed>().source = Some(source);
    }
}

/// What a source says.
struct Opened {
    title: String,
    preset: Option<String>,
    equipment: Equipment,
    files: Vec<PathBuf>,
}

/// Opens a source; the error is a line for the player.
fn open(source: &Source) -> Result<Opened, String> {
    match source {
        Source::Preset(name) => {
            let preset = preset::open(name).map_err(|error| error.to_string())?;
            Ok(Opened {
                title: preset.title,
                preset: Some(name.clone()),
                equipment: preset.equipment,
                files: preset.files,
            })
        }
        Source::Scene(name) => {
            let scenario = library::open(name).map_err(|error| error.to_string())?;
            let mut files = match &scenario.preset {
                Some(name) => preset::open(name).map_err(|error| error.to_string())?.files,
                None => Vec::new(),
            };
            files.extend(Path::new(name).is_file().then(|| PathBuf::from(name)));
            Ok(Opened {
                title: scenario.title,
                preset: scenario.preset,
                equipment: Equipment {
                    balls: BallSet::in_scene(&scenario.scene).unwrap_or_default(),
                    table: scenario.scene.table,
                    laws: scenario.scene.laws,
                    cue: scenario.scene.cue,
                },
                files,
            })
        }
    }
}

impl Followed {
    fn watch(&mut self, files: Vec<PathBuf>) {
        self.files = files
            .into_iter()
            .map(|file| (file.clone(), stamp(&file)))
            .collect();
        self.changing = false;
    }

    /// Whether a file has changed and is now left alone.
    fn has_changed(&mut self) -> bool {
        let mut moved = false;
        for (file, known) in &mut self.files {
            let now = stamp(file);
            moved |= now != *known;
            *known = now;
        }
        let settled = self.changing && !moved;
        self.changing = moved;
        settled
    }
}

fn stamp(file: &Path) -> Stamp {
    let known = std::fs::metadata(file).ok()?;
    Some((known.modified().ok()?, known.len()))
}

/// The key of the name of a built-in preset.
fn preset_key(name: &str) -> String {
    format!("preset-{}", name.replace('_', "-"))
}

/// Opens the preset that was asked for and racks with it.
fn choose(
    mut asked: MessageReader<ChoosePreset>,
    mut followed: ResMut<Followed>,
    mut in_use: ResMut<PresetInUse>,
    mut equip: MessageWriter<Equip>,
    mut told: MessageWriter<Told>,
) {
    let Some(ChoosePreset(name)) = asked.read().last() else {
        return;
    };
    let source = Source::Preset(name.clone());
    match open(&source) {
        Ok(opened) => {
            followed.watch(opened.files);
            followed.source = Some(source);
            in_use.0 = opened.preset;
            equip.write(Equip {
                equipment: opened.equipment,
                rack: true,
            });
            told.write(Told {
                text: Saying::new(preset_key(name), &[], opened.title),
                is_failure: false,
            });
        }
        Err(error) => {
            told.write(Told {
                text: error.into(),
                is_failure: true,
            });
        }
    }
}

/// Opens the scene that was asked for. What lay on the table can be undone to; a match is left.
#[expect(
    clippy::too_many_arguments,
    reason = "what a scene brings and what it replaces"
)]
fn lay_out(
    mut asked: MessageReader<OpenScene>,
    mut followed: ResMut<Followed>,
    mut in_use: ResMut<PresetInUse>,
    mut practice: ResMut<Practice>,
    mut turns: ResMut<Turns>,
    mut load: MessageWriter<LoadScene>,
    mut told: MessageWriter<Told>,
    aim: Res<Aim>,
    playfield: Res<Playfield>,
    balls: BallQuery,
) {
    let Some(OpenScene { name, play }) = asked.read().last() else {
        return;
    };
    let source = Source::Scene(name.clone());
    let opened = open(&source).and_then(|opened| {
        let scenario = library::open(name).map_err(|error| error.to_string())?;
        let scene = if *play {
            scenario.scene
        } else {
            scenario.laid_out()
        };
        Ok((opened, scene))
    });
    let text = match opened {
        Ok((opened, scene)) => {
            let key = format!("scene-{name}");
            followed.watch(opened.files);
            followed.source = Some(source);
            in_use.0 = opened.preset;
            if turns.is_on() {
                *turns = Turns::default();
            }
            practice.history.laid(snapshot(&playfield, &balls), *aim);
            load.write(LoadScene(scene));
            Ok(Saying::new(key, &[], opened.title))
        }
        Err(error) => Err(error.into()),
    };
    let is_failure = text.is_err();
    let (Ok(text) | Err(text)) = text;
    told.write(Told { text, is_failure });
}

/// Reads what has changed again. A file that is no good now changes nothing.
fn follow(
    mut followed: ResMut<Followed>,
    mut equip: MessageWriter<Equip>,
    mut told: MessageWriter<Told>,
) {
    let Some(source) = followed.source.clone() else {
        return;
    };
    if !followed.has_changed() {
        return;
    }
    let name = match &source {
        Source::Preset(name) | Source::Scene(name) => name.clone(),
    };
    match open(&source) {
        Ok(opened) => {
            followed.watch(opened.files);
            equip.write(Equip {
                equipment: opened.equipment,
                rack: false,
            });
            told.write(Told {
                text: Saying::new(
                    "notice-file-changed",
                    &[("name", &name)],
                    format!("{name} has changed: played with from the next shot on."),
                ),
                is_failure: false,
            });
        }
        Err(error) => {
            told.write(Told {
                text: Saying::new(
                    "notice-file-no-good",
                    &[("error", &error)],
                    format!("{error}\nPlaying on with what it said before."),
                ),
                is_failure: true,
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An app that follows this preset file, and its last words.
    fn app(file: &Path) -> App {
        let mut app = App::new();
        app.add_plugins((
            MinimalPlugins,
            crate::sim::SimPlugin,
            crate::game::GamePlugin,
        ));
        app.add_plugins(plugin);
        app.finish();
        app.cleanup();
        begin(app.world_mut(), Source::Preset(file.display().to_string()));
        app
    }

    /// Looks often enough to see a change and take it up.
    fn look(app: &mut App) -> (Option<Equip>, Option<Told>) {
        let mut heard = (None, None);
        for _ in 0..8 {
            std::thread::sleep(LOOK / 3);
            app.update();
            let world = app.world_mut();
            if let Some(equip) = world.resource_mut::<Messages<Equip>>().drain().last() {
                heard.0 = Some(equip);
            }
            if let Some(told) = world.resource_mut::<Messages<Told>>().drain().last() {
                heard.1 = Some(told);
            }
        }
        heard
    }

    #[test]
    fn a_file_is_followed_and_a_broken_one_changes_nothing() {
        let folder = std::env::temp_dir().join(format!("masse-follow-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let file = folder.join("mine.ron");
        let write = |text: &str| std::fs::write(&file, text).expect("a file");
        write("(base: \"pool\")");
        let mut app = app(&file);
        let in_use = app.world().resource::<PresetInUse>().0.clone();
        assert_eq!(in_use, Some(file.display().to_string()));
        assert_eq!(look(&mut app), (None, None));
        write("(base: \"pool\", set: {\"laws.cushion.restitution\": 0.7})");
        let (equip, told) = look(&mut app);
        let equip = equip.expect("a change is taken up");
        assert_eq!(equip.equipment.laws.cushion.restitution(1.0), 0.7);
        assert!(!equip.rack && told.is_some_and(|told| !told.is_failure));
        write("(base: \"pool\", set: {\"laws.cushion.restitution\": 1.7})");
        let (equip, told) = look(&mut app);
        let text = told
            .filter(|told| told.is_failure)
            .expect("an error")
            .text
            .english;
        assert_eq!(equip, None);
        for part in [
            "mine.ron",
            "laws.cushion.restitution",
            "1.7",
            "between 0 and 1",
        ] {
            assert!(text.contains(part), "{text}");
        }
        assert_eq!(look(&mut app), (None, None), "an error is told once");
        write("(base: \"snooker\")");
        let (equip, _) = look(&mut app);
        assert_eq!(
            equip.map(|equip| equip.equipment.balls.cue.mass),
            Some(0.1406)
        );
        let _ = std::fs::remove_dir_all(&folder);
    }

    /// The clock may go backwards while somebody plays, and files may vanish.
    #[test]
    fn a_file_from_the_past_is_taken_up_and_one_that_is_gone_is_told_of() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("mine.ron");
        let text =
            |e: &str| format!("(base: \"pool\", set: {{\"laws.cushion.restitution\": {e}}})");
        std::fs::write(&file, text("0.8")).expect("a file");
        let mut app = app(&file);
        assert_eq!(look(&mut app), (None, None));
        std::fs::write(&file, text("0.7")).expect("a file");
        let past = SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000_000);
        let written = std::fs::File::options().write(true).open(&file);
        written
            .and_then(|file| file.set_modified(past))
            .expect("an older date");
        let (equip, _) = look(&mut app);
        let restitution = |equip: Equip| equip.equipment.laws.cushion.restitution(1.0);
        assert_eq!(equip.map(restitution), Some(0.7));
        std::fs::remove_file(&file).expect("it is there");
        let (equip, told) = look(&mut app);
        assert_eq!(equip, None);
        assert!(told.is_some_and(|told| told.is_failure && told.text.english.contains("mine.ron")));
        std::fs::write(&file, text("0.6")).expect("a file");
        assert_eq!(look(&mut app).0.map(restitution), Some(0.6), "it came back");
    }
}
