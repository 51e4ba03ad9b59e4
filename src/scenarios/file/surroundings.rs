//! The table and the laws as a file names them.

use serde::{Deserialize, Serialize};

use crate::physics::laws::ball_ball::BallBallLaw;
use crate::physics::laws::cushion::CushionLaw;
use crate::physics::laws::motion::MotionLaw;
use crate::physics::laws::pocket::PocketLaw;
use crate::physics::laws::slate::SlateLaw;
use crate::physics::laws::{Check, Laws};
use crate::physics::scene::{SceneError, check_parameter};
use crate::physics::table::{Mouth, PegBoard, PocketedTable, Preset, Table};

/// A table by name, by the measures of a maker, or in full.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Table")]
pub(in crate::scenarios) enum TableEntry {
    NineFoot,
    EightFoot,
    SevenFoot,
    Snooker,
    Carom,
    Box { length: f64, width: f64 },
    Pocketed(PocketedEntry),
    Pegs(PegsEntry),
    Full(Table),
}

/// The measures of a table with six pockets.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Pocketed")]
pub(in crate::scenarios) struct PocketedEntry {
    /// m, nose to nose.
    length: f64,
    width: f64,
    nose_height: f64,
    cushion_depth: f64,
    corner: MouthEntry,
    side: MouthEntry,
}

/// The measures of a board of pegs, see [`PegBoard`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Pegs")]
pub(in crate::scenarios) struct PegsEntry {
    rows: u32,
    pitch: f64,
    peg_radius: f64,
    room: f64,
    funnel: f64,
    mouth: f64,
    bins: f64,
}

impl PegsEntry {
    fn table(self) -> Result<Table, SceneError> {
        let board = PegBoard {
            rows: self.rows,
            pitch: self.pitch,
            peg_radius: self.peg_radius,
            room: self.room,
            funnel: self.funnel,
            mouth: self.mouth,
            bins: self.bins,
        };
        for parameter in board.parameters() {
            check_parameter(&parameter.within("table"))?;
        }
        Ok(board.build())
    }
}

/// The measures of a pocket mouth, see [`Mouth`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Mouth")]
struct MouthEntry {
    width: f64,
    cut_angle_deg: f64,
    jaw_radius: f64,
    hole_radius: f64,
    shelf: f64,
}

impl MouthEntry {
    fn mouth(self) -> Mouth {
        Mouth {
            width: self.width,
            cut_angle: self.cut_angle_deg.to_radians(),
            jaw_radius: self.jaw_radius,
            hole_radius: self.hole_radius,
            shelf: self.shelf,
        }
    }
}

impl PocketedEntry {
    fn table(self) -> Result<Table, SceneError> {
        let measures = PocketedTable {
            length: self.length,
            width: self.width,
            nose_height: self.nose_height,
            cushion_depth: self.cushion_depth,
            corner: self.corner.mouth(),
            side: self.side.mouth(),
        };
        for parameter in measures.parameters() {
            check_parameter(&parameter.within("table"))?;
        }
        Ok(measures.build())
    }
}

impl TableEntry {
    /// The shortest entry that gives this table back.
    pub(in crate::scenarios) fn of(table: &Table) -> Self {
        let (length, width) = (table.length, table.width);
        [
            Self::NineFoot,
            Self::EightFoot,
            Self::SevenFoot,
            Self::Snooker,
            Self::Carom,
            Self::Box { length, width },
        ]
        .into_iter()
        .find(|entry| {
            entry
                .preset()
                .is_some_and(|preset| preset.table() == *table)
        })
        .unwrap_or_else(|| Self::Full(table.clone()))
    }

    fn preset(&self) -> Option<Preset> {
        match *self {
            Self::NineFoot => Some(Preset::NineFoot),
            Self::EightFoot => Some(Preset::EightFoot),
            Self::SevenFoot => Some(Preset::SevenFoot),
            Self::Snooker => Some(Preset::Snooker),
            Self::Carom => Some(Preset::Carom),
            Self::Box { length, width } => Some(Preset::Box { length, width }),
            Self::Pocketed(_) | Self::Pegs(_) | Self::Full(_) => None,
        }
    }

    /// The table.
    pub(in crate::scenarios) fn table(self) -> Result<Table, SceneError> {
        match (self.preset(), self) {
            (Some(preset), _) => Ok(preset.table()),
            (None, Self::Full(table)) => Ok(table),
            (None, Self::Pocketed(measures)) => measures.table(),
            (None, Self::Pegs(measures)) => measures.table(),
            (None, _) => Ok(Preset::NineFoot.table()),
        }
    }
}

/// Laws by the name of a set, or one by one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Laws")]
#[expect(
    clippy::large_enum_variant,
    reason = "there is one of them for each file"
)]
pub(in crate::scenarios) enum LawsEntry {
    Pool,
    Ideal,
    Coursework,
    Custom(CustomLaws),
}

/// A set of laws with some of them exchanged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(in crate::scenarios) struct CustomLaws {
    /// Without it the laws of the preset are changed.
    #[serde(skip_serializing_if = "Option::is_none")]
    base: Option<BaseLaws>,
    #[serde(skip_serializing_if = "Option::is_none")]
    motion: Option<MotionLaw>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ball_ball: Option<BallBallLaw>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cushion: Option<CushionLaw>,
    #[serde(skip_serializing_if = "Option::is_none")]
    slate: Option<SlateLaw>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pocket: Option<PocketLaw>,
}

/// The sets that others are made from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename = "Laws")]
enum BaseLaws {
    Pool,
    Ideal,
    Coursework,
}

impl BaseLaws {
    fn laws(self) -> Laws {
        match self {
            Self::Pool => Laws::default(),
            Self::Ideal => Laws::ideal(),
            Self::Coursework => Laws::coursework(),
        }
    }
}

impl LawsEntry {
    pub(in crate::scenarios) fn of(laws: &Laws) -> Self {
        Self::Custom(CustomLaws {
            base: Some(BaseLaws::Pool),
            motion: Some(laws.motion),
            ball_ball: Some(laws.ball_ball),
            cushion: Some(laws.cushion),
            slate: Some(laws.slate),
            pocket: Some(laws.pocket),
        })
    }

    /// The laws, with those that are not named taken from others.
    pub(in crate::scenarios) fn laws(self, others: &Laws) -> Laws {
        match self {
            Self::Pool => BaseLaws::Pool.laws(),
            Self::Ideal => BaseLaws::Ideal.laws(),
            Self::Coursework => BaseLaws::Coursework.laws(),
            Self::Custom(custom) => {
                let base = custom.base.map_or(*others, BaseLaws::laws);
                Laws {
                    motion: custom.motion.unwrap_or(base.motion),
                    ball_ball: custom.ball_ball.unwrap_or(base.ball_ball),
                    cushion: custom.cushion.unwrap_or(base.cushion),
                    slate: custom.slate.unwrap_or(base.slate),
                    pocket: custom.pocket.unwrap_or(base.pocket),
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_preset_is_written_by_its_name() {
        for preset in Preset::NAMED {
            let entry = TableEntry::of(&preset.table());
            assert!(!matches!(entry, TableEntry::Full(_)), "{preset:?}");
        }
        let (length, width) = (3.5, 0.7);
        let entry = TableEntry::of(&Preset::Box { length, width }.table());
        assert_eq!(entry, TableEntry::Box { length, width });
    }

    #[test]
    fn a_custom_set_changes_only_what_it_names() {
        let text = "Custom(base: Ideal, cushion: Han2005(friction: 0.3))";
        let entry: LawsEntry = crate::scenarios::file::dialect()
            .from_str(text)
            .expect("valid");
        let laws = entry.laws(&Laws::default());
        assert_eq!(laws.motion, MotionLaw::Frictionless);
        let CushionLaw::Han2005(han) = laws.cushion else {
            panic!("{:?}", laws.cushion);
        };
        assert_eq!((han.restitution, han.friction), (0.85.into(), 0.3.into()));
    }
}
