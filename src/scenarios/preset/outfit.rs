//! From what files say to what is played with.

use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::physics::equipment::{BallSet, Equipment};
use crate::physics::laws::motion::{Cloth, MotionLaw};
use crate::scenarios::file::balls::BallConstants;
use crate::scenarios::file::surroundings::{LawsEntry, TableEntry};
use crate::scenarios::file::{FieldError, FileError, LayoutError, spelled, text_of};
use crate::scenarios::preset::numbers::{self, Numbers};
use crate::scenarios::preset::{
    BUILT_IN, CueEntry, LONGEST_CHAIN, Preset, cloth_in, path_of, unknown,
};

/// A preset file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename = "Preset")]
struct PresetFile {
    #[serde(default)]
    title: String,
    #[serde(default)]
    description: String,
    #[serde(default)]
    base: Option<String>,
    #[serde(default)]
    table: Option<TableEntry>,
    #[serde(default)]
    cloth: Option<String>,
    #[serde(default)]
    laws: Option<LawsEntry>,
    #[serde(default)]
    ball: BallConstants,
    #[serde(default)]
    cue_ball: BallConstants,
    #[serde(default)]
    cue: CueEntry,
    #[serde(default)]
    set: Numbers,
}

/// What a scene file or a preset file says about the equipment; what is absent is taken from the base.
pub(in crate::scenarios) struct Outfit {
    pub base: Option<String>,
    pub table: Option<TableEntry>,
    pub cloth: Option<String>,
    pub laws: Option<LawsEntry>,
    pub ball: BallConstants,
    pub cue_ball: BallConstants,
    pub cue: CueEntry,
    pub set: Numbers,
}

/// An equipment and the files it was read from.
pub(in crate::scenarios) type Equipped = (Equipment, Vec<PathBuf>);

impl Outfit {
    /// The equipment; `folder` is where the file lies that says all this.
    pub(in crate::scenarios) fn equipment(self, folder: &Path) -> Result<Equipped, LayoutError> {
        self.made(folder, LONGEST_CHAIN)
    }

    fn made(self, folder: &Path, chain: usize) -> Result<Equipped, LayoutError> {
        let (mut equipment, mut files) = match &self.base {
            Some(name) => {
                let base = find(name, folder, chain)?;
                (base.equipment, base.files)
            }
            None => (Equipment::default(), Vec::new()),
        };
        if let Some(table) = self.table {
            equipment.table = table.table()?;
        }
        if let Some(laws) = self.laws {
            equipment.laws = laws.laws(&equipment.laws);
        }
        if let Some(name) = &self.cloth {
            let (cloth, file) = cloth_in(name, folder)?;
            files.extend(file);
            let gravity = match equipment.laws.motion {
                MotionLaw::Coulomb(old) => old.gravity,
                _ => cloth.gravity,
            };
            equipment.laws.motion = MotionLaw::Coulomb(Cloth { gravity, ..cloth });
        }
        equipment.balls = BallSet {
            object: self.ball.or(equipment.balls.object),
            cue: self.cue_ball.or(self.ball.or(equipment.balls.cue)),
        };
        equipment.cue = self.cue.or(equipment.cue)?;
        numbers::set(&mut equipment, &self.set)?;
        equipment.check()?;
        Ok((equipment, files))
    }
}

/// The preset with this name, as a file in this folder would mean it.
pub(super) fn find(name: &str, folder: &Path, chain: usize) -> Result<Preset, LayoutError> {
    let Some(chain) = chain.checked_sub(1) else {
        return Err(FieldError::Circle {
            name: name.to_owned(),
            most: LONGEST_CHAIN,
        }
        .into());
    };
    if let Some(built_in) = BUILT_IN.iter().find(|preset| preset.name == name) {
        return Ok(parse(built_in.text, built_in.name, chain)?);
    }
    match path_of(name, folder) {
        Some(path) => Ok(read(&path, chain)?),
        None => Err(unknown("preset", "preset", name, BUILT_IN).into()),
    }
}

/// What to call a preset wherever one is: the path of a file that lies in this folder, else the name itself.
pub(in crate::scenarios) fn located(name: &str, folder: &Path) -> String {
    let is_built_in = BUILT_IN.iter().any(|preset| preset.name == name);
    match path_of(name, folder) {
        Some(path) if !is_built_in => path.display().to_string(),
        _ => name.to_owned(),
    }
}

pub(super) fn read(path: &Path, chain: usize) -> Result<Preset, FileError> {
    let mut preset = parse(&text_of(path)?, &path.display().to_string(), chain)?;
    preset.files.insert(0, path.to_owned());
    Ok(preset)
}

pub(super) fn parse(text: &str, file: &str, chain: usize) -> Result<Preset, FileError> {
    let read: PresetFile = spelled(text, file)?;
    let folder = Path::new(file).parent().unwrap_or(Path::new(""));
    let outfit = Outfit {
        base: read.base,
        table: read.table,
        cloth: read.cloth,
        laws: read.laws,
        ball: read.ball,
        cue_ball: read.cue_ball,
        cue: read.cue,
        set: read.set,
    };
    let (equipment, files) = outfit
        .made(folder, chain)
        .map_err(|error| error.in_file(file))?;
    Ok(Preset {
        title: read.title,
        description: read.description,
        equipment,
        files,
    })
}
