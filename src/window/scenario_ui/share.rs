//! Saving, copying and pasting what lies on the table.

use bevy::prelude::*;

use super::stage::Stage;
use super::studio::Studio;
use crate::game::aim::Aim;
use crate::game::equip::{OpenScene, Told};
use crate::game::saying::Saying;
use crate::physics::scene::PlannedShot;
use crate::scenarios::file::Scenario;
use crate::scenarios::own::Own;
use crate::scenarios::share;
use crate::sim::playfield::{BallQuery, Playfield, snapshot};

/// The clipboard of the system, taken up when it is first asked for: on some systems what is copied lasts only as long as
/// somebody holds it.
#[derive(Resource, Default)]
pub(super) struct Clipboard(Option<arboard::Clipboard>);

impl Clipboard {
    fn held(&mut self) -> Result<&mut arboard::Clipboard, arboard::Error> {
        match &mut self.0 {
            Some(held) => Ok(held),
            empty => Ok(empty.insert(arboard::Clipboard::new()?)),
        }
    }

    fn copy(&mut self, text: &str) -> Result<(), arboard::Error> {
        self.held()?.set_text(text)
    }

    fn paste(&mut self) -> Result<String, arboard::Error> {
        self.held()?.get_text()
    }
}

/// Where the player's own scenes are kept; nowhere, if the system has no place.
#[derive(Resource, Clone, Debug, Default)]
pub struct OwnScenes(pub Option<Own>);

impl OwnScenes {
    /// Where this platform keeps the data of programs.
    #[must_use]
    pub fn of_platform() -> Self {
        Self(Own::of_platform())
    }

    fn folder(&self) -> Result<&Own, Saying> {
        let english = "This system has no place for scenes.";
        let nowhere = || Saying::new("notice-no-place", &[], english);
        self.0.as_ref().ok_or_else(nowhere)
    }

    /// Saves a scene and says where.
    fn save(&self, name: &str, scenario: &Scenario) -> Result<Saying, Saying> {
        let saved = self.folder()?.save(name, scenario);
        let path = saved.map_err(|error| {
            let error = error.to_string();
            let english = format!("The scene is not saved: {error}");
            Saying::new("notice-unsaved", &[("error", &error)], english)
        })?;
        let file = path.display().to_string();
        let english = format!("Saved as {file}");
        Ok(Saying::new("notice-saved", &[("file", &file)], english))
    }

    /// The file of a scene.
    fn path(&self, name: &str) -> Result<String, Saying> {
        let path = self.folder()?.path(name);
        let shown = path.map(|path| path.display().to_string());
        shown.map_err(|error| error.to_string().into())
    }
}

/// What is asked of files and the clipboard.
#[derive(Message, Clone, Debug, PartialEq, Eq)]
pub(super) enum Asked {
    /// Save under this name.
    Save(String),
    /// Open what was saved under this name.
    Reopen(String),
    /// Put the shared text on the clipboard.
    Copy,
    /// Open the shared text on the clipboard.
    Paste,
    /// Open this shared text.
    Open(String),
}

/// Does what is asked, and tells what came of it.
#[expect(
    clippy::too_many_arguments,
    reason = "the table, the words about it, and where they go"
)]
pub(super) fn obey(
    mut asked: MessageReader<Asked>,
    mut clipboard: ResMut<Clipboard>,
    mut open: MessageWriter<OpenScene>,
    mut told: MessageWriter<Told>,
    stage: Res<Stage>,
    studio: Res<Studio>,
    own: Res<OwnScenes>,
    aim: Res<Aim>,
    playfield: Res<Playfield>,
    balls: BallQuery,
) {
    let laid = || scenario(&stage, &studio, &aim, &playfield, &balls);
    for ask in asked.read() {
        let done = match ask {
            Asked::Save(name) => own.save(name, &laid()).map(Some),
            Asked::Reopen(name) => own.path(name).map(|name| {
                open.write(OpenScene { name, play: false });
                None
            }),
            Asked::Copy => share::write(&laid())
                .map_err(|error| error.to_string())
                .and_then(|text| clipboard.copy(&text).map_err(|error| error.to_string()))
                .map(|()| {
                    let english = "The scene is on the clipboard as a text.";
                    Some(Saying::new("notice-copied", &[], english))
                })
                .map_err(no_clipboard),
            Asked::Paste => match clipboard.paste() {
                Ok(text) => paste(&text, &mut open),
                Err(error) => Err(no_clipboard(error.to_string())),
            },
            Asked::Open(text) => paste(text, &mut open),
        };
        let is_failure = done.is_err();
        if let Some(text) = done.unwrap_or_else(Some) {
            told.write(Told { text, is_failure });
        }
    }
}

fn no_clipboard(error: String) -> Saying {
    let english = format!("The clipboard cannot be used: {error}");
    Saying::new("notice-clipboard", &[("error", &error)], english)
}

/// Opens a shared text; whoever opens it tells what is wrong with it.
fn paste(text: &str, open: &mut MessageWriter<OpenScene>) -> Result<Option<Saying>, Saying> {
    let name = text.trim().to_owned();
    if share::is_shared(&name) {
        open.write(OpenScene { name, play: false });
        return Ok(None);
    }
    let english = "That is no shared scene: a shared scene begins with `masse1:`.";
    Err(Saying::new("notice-not-shared", &[], english))
}

/// What lies on the table now, with the stroke as it is aimed. Balls that are out of play are left out.
pub(super) fn scenario(
    stage: &Stage,
    studio: &Studio,
    aim: &Aim,
    playfield: &Playfield,
    balls: &BallQuery,
) -> Scenario {
    let mut scene = snapshot(playfield, balls);
    let struck = scene.balls.get(aim.ball).map(|ball| ball.name.clone());
    scene.balls.retain(|ball| ball.state.motion.in_play());
    let struck = struck.and_then(|name| scene.ball_named(&name));
    scene.shot = struck.map(|ball| PlannedShot {
        ball,
        shot: aim.shot,
    });
    let mut scenario = match stage.on_table() {
        Some(on) => on.scenario.clone(),
        None => Scenario::plain("", "", scene.clone()),
    };
    scene.time_limit = scenario.scene.time_limit;
    scenario.scene = scene;
    studio.title.trim().clone_into(&mut scenario.title);
    studio.look_for.trim().clone_into(&mut scenario.look_for);
    // What a search may change and which preset was played with say nothing about a layout that was built by hand.
    scenario.free.clear();
    scenario.ties.clear();
    if !studio.keeps_expectations {
        scenario.expect.clear();
    }
    scenario
}
