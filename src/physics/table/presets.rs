//! Tables as they are sold.

use serde::{Deserialize, Serialize};

use crate::physics::table::{Mouth, Nose, PocketedTable, Table};

/// A table by name.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Preset {
    /// 9 ft pool table, 2.54 m × 1.27 m (WPA equipment specification).
    NineFoot,
    /// 8 ft pool table, 2.3368 m × 1.1684 m (WPA).
    EightFoot,
    /// 7 ft pool table, 1.9812 m × 0.9906 m, the usual bar box.
    SevenFoot,
    /// 12 ft snooker table, 3.569 m × 1.778 m (WPBSA).
    Snooker,
    /// Carom table, 2.84 m × 1.42 m, no pockets (UMB).
    Carom,
    /// A closed box without pockets.
    Box {
        /// Along x, m.
        length: f64,
        /// Along z, m.
        width: f64,
    },
}

/// Nose height of a pool table: 63.5 % of a 57.15 mm ball (WPA: 62.5 to 64.5 %).
pub(super) const POOL_NOSE_HEIGHT: f64 = 0.635 * 0.057_15;

impl Preset {
    /// The presets that need no numbers.
    pub const NAMED: [Self; 5] = [
        Self::NineFoot,
        Self::EightFoot,
        Self::SevenFoot,
        Self::Snooker,
        Self::Carom,
    ];

    /// The table in full.
    #[must_use]
    pub fn table(&self) -> Table {
        match *self {
            Self::NineFoot => pool(2.54, 1.27),
            Self::EightFoot => pool(2.3368, 1.1684),
            Self::SevenFoot => pool(1.9812, 0.9906),
            Self::Snooker => snooker(),
            Self::Carom => Table {
                nose: Nose::Round { radius: 0.0 },
                ..Table::closed_box(2.84, 1.42, 0.037)
            },
            Self::Box { length, width } => Table::closed_box(length, width, POOL_NOSE_HEIGHT),
        }
    }
}

/// Corner mouth 4 9/16 in at 142°, side mouth 5 1/16 in at 104°, shelves 1 5/8 in and 3/16 in: the middle of the WPA
/// ranges; holes of 62 mm and 64.5 mm radius after pooltool 0.6. How much the jaws are rounded no rule says: 12 mm and 8 mm
/// here.
fn pool(length: f64, width: f64) -> Table {
    PocketedTable {
        length,
        width,
        nose_height: POOL_NOSE_HEIGHT,
        cushion_depth: 0.0508,
        corner: Mouth {
            width: 0.115_9,
            cut_angle: 142.0_f64.to_radians(),
            jaw_radius: 0.012,
            hole_radius: 0.062,
            shelf: 0.041_3,
        },
        side: Mouth {
            width: 0.128_6,
            cut_angle: 104.0_f64.to_radians(),
            jaw_radius: 0.008,
            hole_radius: 0.064_5,
            shelf: 0.004_8,
        },
    }
    .build()
}

/// Playing area after the WPBSA: 11 ft 8½ in × 5 ft 10 in. The noses stand at 7/5 of the radius of a 52.5 mm ball (Mathavan
/// 2010). The WPBSA keeps the templates of its pockets to itself; the openings here, 83 mm at the corners and 87 mm in the
/// middle, their round jaws of 3.6 in and 2.5 in, which run out into throats with parallel sides, and the falls of the slate
/// are those of pooltool 0.6, inside the 80 to 89 mm that are told.
fn snooker() -> Table {
    PocketedTable {
        length: 3.569,
        width: 1.778,
        nose_height: 1.4 * 0.026_25,
        cushion_depth: 0.039_4,
        corner: Mouth {
            width: 0.083,
            cut_angle: 135.0_f64.to_radians(),
            jaw_radius: 0.091_4,
            hole_radius: 0.043,
            shelf: 0.036,
        },
        side: Mouth {
            width: 0.087,
            cut_angle: 90.0_f64.to_radians(),
            jaw_radius: 0.063_5,
            hole_radius: 0.042_7,
            shelf: 0.024_1,
        },
    }
    .build()
}
