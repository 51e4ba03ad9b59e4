//! The measures of the furniture around the playing surface.

use bevy::math::DVec2;

use crate::physics::table::{Cushion, Table};

/// Sizes in m that the rules leave to the maker, chosen to suit the table.
#[derive(Clone, Copy, Debug)]
pub(in crate::window::render) struct Measures {
    /// Half the playing surface along x and z.
    pub half: DVec2,
    /// From the nose line back to the wood.
    pub depth: f64,
    /// Width of the wooden rails.
    pub rail: f64,
    /// Height of the nose above the slate.
    pub nose: f64,
    /// Height of the wood above the slate.
    pub top: f64,
    /// Thickness of the rim around a pocket.
    pub rim: f64,
    /// Height of the lower edge of the frame: below the slate, and below whatever pockets there are.
    pub apron: f64,
    /// How small the table is beside a nine-foot one, at most 1.
    pub scale: f64,
}

/// Height of the slate above the floor, m.
pub(in crate::window::render) const FLOOR: f64 = 0.78;

impl Measures {
    pub fn of(table: &Table) -> Self {
        let half = 0.5 * DVec2::new(table.length, table.width);
        let scale = (table.length.min(table.width) / 1.27).clamp(0.1, 1.0);
        let reach = table
            .cushions
            .iter()
            .filter(|cushion| matches!(cushion, Cushion::Line(_)))
            .map(|cushion| {
                let (least, most) = cushion.bounds();
                (most - half).max(-half - least).max_element()
            })
            .fold(0.0, f64::max);
        Self {
            half,
            depth: if reach > 0.01 {
                reach.min(0.5)
            } else {
                0.05 * scale
            },
            rail: 0.125 * scale,
            nose: table.nose_height,
            top: table.rail_height(),
            rim: 0.013,
            apron: (table.rail_height() - 0.19 * scale).min(if table.pockets.is_empty() {
                -0.03
            } else {
                super::pockets::BOTTOM
            }),
            scale,
        }
    }

    /// Half the wooden frame inside.
    pub fn inner(&self) -> DVec2 {
        self.half + self.depth
    }

    /// Half the wooden frame outside.
    pub fn outer(&self) -> DVec2 {
        self.half + self.depth + self.rail
    }

    /// Whether a point in plan lies on the wood or beyond.
    pub fn is_frame(&self, point: DVec2) -> bool {
        (point.abs() - self.inner()).max_element() > -1e-4
    }
}
