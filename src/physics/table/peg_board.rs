//! A board of pegs, for a table that is tilted towards +z.

use glam::DVec2;

use crate::physics::laws::{Check, Parameter};
use crate::physics::table::presets::POOL_NOSE_HEIGHT;
use crate::physics::table::{Arc, Cushion, Line, Table};

/// A quincunx (Galton, Natural Inheritance (1889), chapter 5): at the top a room for the balls with a funnel as its floor,
/// below it rows of pegs, each moved by half a pitch against the one before, and a bin below each gap of the last row.
/// It lies on the table with its top at −z. A ball that passes a row goes left or right; after all rows it is in one of as
/// many bins as there are rows, and one more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PegBoard {
    /// Rows of pegs.
    pub rows: u32,
    /// Distance between pegs of a row, m; rows are √3/2 of it apart.
    pub pitch: f64,
    /// Radius of a peg, m.
    pub peg_radius: f64,
    /// Length along z of the room above the funnel, m.
    pub room: f64,
    /// Length along z of the funnel, m.
    pub funnel: f64,
    /// Width of the mouth of the funnel, m.
    pub mouth: f64,
    /// Length along z of the bins, m.
    pub bins: f64,
}

impl PegBoard {
    /// Width of the board along x, m: a pitch for each bin.
    #[must_use]
    pub fn width(&self) -> f64 {
        f64::from(self.rows + 1) * self.pitch
    }

    /// Distance of two rows along z, m.
    fn rise(&self) -> f64 {
        0.75_f64.sqrt() * self.pitch
    }

    /// Length of the board along z, m.
    #[must_use]
    pub fn height(&self) -> f64 {
        self.room + self.funnel + f64::from(self.rows) * self.rise() + self.bins
    }

    /// The middle of the mouth of the funnel, x and z in m.
    #[must_use]
    pub fn mouth(&self) -> DVec2 {
        DVec2::new(0.0, self.room + self.funnel - 0.5 * self.height())
    }

    /// The bin, counted from the left, that a place at or below the last row is in; `None` above it.
    #[must_use]
    pub fn bin(&self, place: DVec2) -> Option<usize> {
        let bin = ((place.x + 0.5 * self.width()) / self.pitch).floor();
        let is_below = place.y >= 0.5 * self.height() - self.bins;
        // The cast saturates: what lies on the edge counts to the last bin.
        is_below.then(|| (bin.max(0.0) as usize).min(self.rows as usize))
    }

    /// Box, funnel, pegs and walls between the bins.
    #[must_use]
    pub fn build(&self) -> Table {
        let (half, bottom) = (0.5 * self.width(), 0.5 * self.height());
        let mut table = Table::closed_box(self.width(), self.height(), POOL_NOSE_HEIGHT);
        let mouth = self.mouth();
        for side in [-1.0, 1.0] {
            let lip = DVec2::new(0.5 * side * self.mouth, mouth.y);
            table.cushions.push(Cushion::Line(Line {
                from: DVec2::new(side * half, mouth.y - self.funnel),
                to: lip,
            }));
            table.cushions.push(Cushion::Arc(Arc {
                center: lip,
                radius: 0.0,
            }));
        }
        let edge = bottom - self.bins;
        for row in 0..self.rows {
            // Counted from the last row, whose pegs stand over the walls between the bins.
            let (from, count) = if row % 2 == 0 {
                (1.0, self.rows)
            } else {
                // Beside a wall a ball would be caught between it and a peg half a pitch away.
                (1.5, self.rows - 1)
            };
            let z = edge - f64::from(row) * self.rise();
            table.cushions.extend((0..count).map(|peg| {
                Cushion::Arc(Arc {
                    center: DVec2::new((from + f64::from(peg)) * self.pitch - half, z),
                    radius: self.peg_radius,
                })
            }));
        }
        table.cushions.extend((1..=self.rows).map(|wall| {
            let x = f64::from(wall) * self.pitch - half;
            Cushion::Line(Line {
                from: DVec2::new(x, edge),
                to: DVec2::new(x, bottom),
            })
        }));
        table
    }
}

impl Check for PegBoard {
    fn parameters(&self) -> Vec<Parameter> {
        let pitch = self.pitch;
        let long = |field, value| Parameter::new(field, value, 1e-3, 1e3).basis("m");
        vec![
            Parameter::new("rows", f64::from(self.rows), 1.0, 500.0),
            long("pitch", pitch),
            Parameter::new("peg_radius", self.peg_radius, 0.0, 0.499 * pitch)
                .basis("m; less than half a pitch, or nothing passes"),
            long("room", self.room),
            long("funnel", self.funnel),
            Parameter::new("mouth", self.mouth, 1e-3, self.width().max(1e-3))
                .basis("m; no wider than the board"),
            long("bins", self.bins),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOARD: PegBoard = PegBoard {
        rows: 4,
        pitch: 0.1,
        peg_radius: 0.01,
        room: 0.5,
        funnel: 0.2,
        mouth: 0.07,
        bins: 0.3,
    };

    #[test]
    fn the_first_peg_is_below_the_mouth_and_every_wall_below_a_peg() {
        for rows in 1..6 {
            let board = PegBoard { rows, ..BOARD };
            let table = board.build();
            let pegs: Vec<&Arc> = table
                .cushions
                .iter()
                .filter_map(|cushion| match cushion {
                    Cushion::Arc(arc) if arc.radius > 0.0 => Some(arc),
                    _ => None,
                })
                .collect();
            let top = pegs
                .iter()
                .map(|peg| peg.center.y)
                .fold(f64::INFINITY, f64::min);
            let is_first = |peg: &&&Arc| peg.center.y == top && peg.center.x.abs() < 1e-12;
            assert_eq!(pegs.iter().filter(is_first).count(), 1, "{rows} rows");
            let walls = table.cushions.iter().filter_map(|cushion| match cushion {
                Cushion::Line(line)
                    if line.from.x == line.to.x && line.from.x.abs() < 0.499 * table.length =>
                {
                    Some(line.from)
                }
                _ => None,
            });
            let mut count = 0;
            for end in walls {
                assert!(pegs.iter().any(|peg| peg.center == end), "{end}");
                count += 1;
            }
            assert_eq!(count, rows);
        }
    }

    #[test]
    fn places_are_in_the_bins_they_are_in() {
        let low = 0.5 * BOARD.height() - 0.1;
        for (x, bin) in [
            (-0.249, 0),
            (-0.16, 0),
            (-0.14, 1),
            (0.0, 2),
            (0.249, 4),
            (0.251, 4),
        ] {
            assert_eq!(BOARD.bin(DVec2::new(x, low)), Some(bin), "{x}");
        }
        assert_eq!(BOARD.bin(DVec2::new(0.0, 0.0)), None);
    }
}
