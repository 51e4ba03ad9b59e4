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
const POOL_NOSE_HEIGHT: f64 = 0.635 * 0.057_15;

impl Preset {
    /// The presets that need no numbers.
    pub const NAMED: [Self; 4] = [
        Self::NineFoot,
        Self::EightFoot,
        Self::SevenFoot,
        Self::Carom,
    ];

    /// The table in full.
    #[must_use]
    pub fn table(&self) -> Table {
        match *self {
            Self::NineFoot => pool(2.54, 1.27),
            Self::EightFoot => pool(2.3368, 1.1684),
            Self::SevenFoot => pool(1.9812, 0.9906),
            Self::Carom => Table {
                nose: Nose::Round { radius: 0.0 },
                ..Table::closed_box(2.84, 1.42, 0.037)
            },
            Self::Box { length, width } => Table::closed_box(length, width, POOL_NOSE_HEIGHT),
        }
    }
}

/// Corner mouth 4 9/16 in at 142°, side mouth 5 1/16 in at 104°, shelves 1 5/8 in and 3/16 in: the middle of the WPA
/// ranges; hole radii after Alciatore, TP 3.5 and 3.6.
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
