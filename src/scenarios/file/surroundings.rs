//! The table and the laws as a file names them.

use serde::{Deserialize, Serialize};

use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::BallBallLaw;
use crate::physics::laws::cushion::CushionLaw;
use crate::physics::laws::motion::MotionLaw;
use crate::physics::laws::pocket::PocketLaw;
use crate::physics::laws::slate::SlateLaw;
use crate::physics::table::{Preset, Table};

/// A table by name or in full.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Table")]
pub(super) enum TableEntry {
    NineFoot,
    EightFoot,
    SevenFoot,
    Carom,
    Box { length: f64, width: f64 },
    Full(Table),
}

impl TableEntry {
    /// The shortest entry that gives this table back.
    pub(super) fn of(table: &Table) -> Self {
        let (length, width) = (table.length, table.width);
        [
            Self::NineFoot,
            Self::EightFoot,
            Self::SevenFoot,
            Self::Carom,
            Self::Box { length, width },
        ]
        .into_iter()
        .find(|entry| entry.clone().table() == *table)
        .unwrap_or_else(|| Self::Full(table.clone()))
    }

    pub(super) fn table(self) -> Table {
        match self {
            Self::NineFoot => Preset::NineFoot.table(),
            Self::EightFoot => Preset::EightFoot.table(),
            Self::SevenFoot => Preset::SevenFoot.table(),
            Self::Carom => Preset::Carom.table(),
            Self::Box { length, width } => Preset::Box { length, width }.table(),
            Self::Full(table) => table,
        }
    }
}

/// Laws by the name of a set, or one by one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Laws")]
pub(super) enum LawsEntry {
    #[default]
    Pool,
    Ideal,
    Coursework,
    Custom(CustomLaws),
}

/// A set of laws with some of them exchanged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct CustomLaws {
    base: BaseLaws,
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename = "Laws")]
enum BaseLaws {
    #[default]
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
    pub(super) fn of(laws: &Laws) -> Self {
        Self::Custom(CustomLaws {
            base: BaseLaws::Pool,
            motion: Some(laws.motion),
            ball_ball: Some(laws.ball_ball),
            cushion: Some(laws.cushion),
            slate: Some(laws.slate),
            pocket: Some(laws.pocket),
        })
    }

    pub(super) fn laws(self) -> Laws {
        match self {
            Self::Pool => BaseLaws::Pool.laws(),
            Self::Ideal => BaseLaws::Ideal.laws(),
            Self::Coursework => BaseLaws::Coursework.laws(),
            Self::Custom(custom) => {
                let base = custom.base.laws();
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
        let laws = entry.laws();
        assert_eq!(laws.motion, MotionLaw::Frictionless);
        let CushionLaw::Han2005(han) = laws.cushion else {
            panic!("{:?}", laws.cushion);
        };
        assert_eq!((han.restitution, han.friction), (0.85, 0.3));
    }
}
