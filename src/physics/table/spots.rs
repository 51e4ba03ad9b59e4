//! The spots and lines that rules speak of.
//!
//! Measures of snooker are those of the full-size table, scaled with its length: baulk line 737 mm from the bottom
//! cushion, D of 292 mm radius, black 324 mm from the top cushion on 3569 mm (WPBSA, official rules of the games of snooker
//! and billiards, section 1).

use glam::DVec2;

use crate::physics::table::Table;

impl Table {
    /// The point on the centre line a quarter of the length from the foot: where the rack begins.
    #[must_use]
    pub fn foot_spot(&self) -> DVec2 {
        DVec2::new(0.25 * self.length, 0.0)
    }

    /// The point on the centre line a quarter of the length from the head.
    #[must_use]
    pub fn head_spot(&self) -> DVec2 {
        DVec2::new(-0.25 * self.length, 0.0)
    }

    /// The point at these diamonds, as players count them: across (x) from 0 to 4, along (y) from 0 at the foot rail to 8 at
    /// the head rail, seen by somebody who stands at the foot and looks towards the head with 0 across at his left.
    #[must_use]
    pub fn at_diamonds(&self, diamonds: DVec2) -> DVec2 {
        DVec2::new(
            self.length * (0.5 - diamonds.y / 8.0),
            self.width * (0.5 - diamonds.x / 4.0),
        )
    }

    /// The diamonds of a point, across and along, as for [`at_diamonds`](Self::at_diamonds).
    #[must_use]
    pub fn diamonds_of(&self, point: DVec2) -> DVec2 {
        DVec2::new(
            4.0 * (0.5 - point.y / self.width),
            8.0 * (0.5 - point.x / self.length),
        )
    }

    /// Middle of the baulk line of a snooker table: the spot of the brown, and the middle of the D.
    #[must_use]
    pub fn baulk_spot(&self) -> DVec2 {
        DVec2::new((0.737 / 3.569 - 0.5) * self.length, 0.0)
    }

    /// Radius of the D of a snooker table, m.
    #[must_use]
    pub fn d_radius(&self) -> f64 {
        0.292 / 3.569 * self.length
    }

    /// The spot of the black on a snooker table.
    #[must_use]
    pub fn black_spot(&self) -> DVec2 {
        DVec2::new((0.5 - 0.324 / 3.569) * self.length, 0.0)
    }
}
