//! The file as a whole.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::physics::scene::{Scene, Solver};
use crate::scenarios::camera::Camera;
use crate::scenarios::expect::Expectation;
use crate::scenarios::file::Scenario;
use crate::scenarios::file::balls::{BallConstants, BallEntry, RackEntry};
use crate::scenarios::file::error::{FieldError, LayoutError};
use crate::scenarios::file::fill::Fill;
use crate::scenarios::file::shot::ShotEntry;
use crate::scenarios::file::surroundings::{LawsEntry, TableEntry};
use crate::scenarios::preset::{CueEntry, Outfit};
use crate::scenarios::search::{Free, Tie};

/// A scene file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Scene")]
pub(super) struct SceneFile {
    /// Version of the format.
    #[serde(default = "SceneFile::version")]
    version: u32,
    /// One line.
    #[serde(default)]
    pub(super) title: String,
    /// What to look at.
    #[serde(default)]
    pub(super) description: String,
    /// What to watch for.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub(super) look_for: String,
    /// What must happen.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) expect: Vec<Expectation>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) cameras: Vec<Camera>,
    /// What a search may change, see [`crate::scenarios::search`].
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) free: Vec<Free>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) ties: Vec<Tie>,
    /// Name or file of a preset, see [`crate::scenarios::preset`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    preset: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    table: Option<TableEntry>,
    /// Name or file of a cloth.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    cloth: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    laws: Option<LawsEntry>,
    #[serde(default)]
    cue: CueEntry,
    /// Constants of every ball that does not give its own.
    #[serde(default)]
    ball: BallConstants,
    /// Constants of the ball named `cue`.
    #[serde(default)]
    cue_ball: BallConstants,
    /// Single numbers by their paths.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    set: BTreeMap<String, f64>,
    /// A rack on the foot spot, with a cue ball on the head spot. A ball of `balls` with the name of a racked one
    /// takes its place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    rack: Option<RackEntry>,
    #[serde(default)]
    balls: Vec<BallEntry>,
    /// Balls at random places.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    fill: Option<Fill>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    shot: Option<ShotEntry>,
    /// The solver; without one, the one that suits the laws.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    solver: Option<Solver>,
    #[serde(default = "SceneFile::time_limit")]
    time_limit: f64,
}

impl SceneFile {
    fn version() -> u32 {
        1
    }

    fn time_limit() -> f64 {
        Scene::TIME_LIMIT
    }

    /// Whether the solver it names works on the balls as a crowd.
    pub(super) fn is_crowd(&self) -> bool {
        self.solver.is_some_and(|solver| solver.is_crowd())
    }

    /// The file of a scene, with every default spelled out.
    pub(super) fn of(scenario: &Scenario) -> Self {
        let scene = &scenario.scene;
        Self {
            version: Self::version(),
            title: scenario.title.clone(),
            description: scenario.description.clone(),
            look_for: scenario.look_for.clone(),
            expect: scenario.expect.clone(),
            cameras: scenario.cameras.clone(),
            free: scenario.free.clone(),
            ties: scenario.ties.clone(),
            preset: None,
            table: Some(TableEntry::of(&scene.table)),
            cloth: None,
            laws: Some(LawsEntry::of(&scene.laws)),
            cue: CueEntry::of(&scene.cue),
            ball: BallConstants::default(),
            cue_ball: BallConstants::default(),
            set: BTreeMap::new(),
            rack: None,
            balls: scene
                .balls
                .iter()
                .map(|ball| BallEntry::of(&scene.laws, ball))
                .collect(),
            fill: None,
            shot: scene
                .shot
                .and_then(|planned| ShotEntry::of(scene, &planned)),
            solver: Some(scene.solver),
            time_limit: scene.time_limit,
        }
    }

    /// The preset that the file names.
    pub(super) fn preset(&self) -> Option<String> {
        self.preset.clone()
    }

    /// The scene, checked; `folder` is where the file lies.
    pub(super) fn into_scene(self, folder: &Path) -> Result<Scene, LayoutError> {
        if self.version != Self::version() {
            return Err(FieldError::Version {
                version: self.version,
            }
            .into());
        }
        if self.table.is_none() && self.preset.is_none() {
            return Err(FieldError::NoTable.into());
        }
        let outfit = Outfit {
            base: self.preset,
            table: self.table,
            cloth: self.cloth,
            laws: self.laws,
            ball: self.ball,
            cue_ball: self.cue_ball,
            cue: self.cue,
            set: self.set,
        };
        let (equipment, _) = outfit.equipment(folder)?;
        let balls = equipment.balls;
        let mut scene = equipment.scene();
        scene.solver = self.solver.unwrap_or(scene.solver);
        scene.time_limit = self.time_limit;
        scene.check_surroundings()?;
        if let Some(rack) = &self.rack {
            rack.place(&mut scene, &balls)?;
        }
        let racked = scene.balls.len();
        for (i, entry) in self.balls.into_iter().enumerate() {
            let placed = entry.ball(i, &scene, &balls)?;
            match scene.balls[..racked]
                .iter_mut()
                .find(|other| other.name == placed.name)
            {
                Some(other) => *other = placed,
                None => scene.balls.push(placed),
            }
        }
        if let Some(fill) = &self.fill {
            fill.place(&mut scene, balls.object)?;
        }
        scene.shot = match &self.shot {
            Some(shot) => Some(shot.planned(&scene)?),
            None => None,
        };
        scene.check()?;
        Ok(scene)
    }
}
