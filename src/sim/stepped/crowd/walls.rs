//! Cushions by cells: most balls of a crowd are far from all of them.

use glam::DVec2;

use crate::physics::table::Table;

/// For each cell the cushions that a ball in it can touch.
#[derive(Debug, Default)]
pub(super) struct Walls {
    least: DVec2,
    per_cell: DVec2,
    columns: usize,
    rows: usize,
    first: Vec<u32>,
    cushions: Vec<u32>,
    /// Half the sides of a rectangle without cushions, m: a box without pegs. Zero if there is none.
    half: DVec2,
}

/// Most cells along one side.
const MOST: f64 = 2000.0;

impl Walls {
    /// Lists the cushions of a table for balls whose centre stays within `reach` m of the middle of its path, radius
    /// included.
    pub fn new(table: &Table, reach: f64) -> Self {
        let size = DVec2::new(table.length, table.width);
        let cell = DVec2::splat(2.0 * reach).max(size / MOST);
        let cells = (size / cell).ceil().max(DVec2::ONE);
        let half = 0.5 * size * (1.0 - 1e-12);
        let is_outside = table.cushions.iter().all(|cushion| {
            let (least, most) = cushion.bounds();
            least.cmpge(half).any() || most.cmple(-half).any()
        });
        let mut walls = Self {
            half: if is_outside { half } else { DVec2::ZERO },
            least: -0.5 * size,
            per_cell: cells / size,
            columns: cells.x as usize,
            rows: cells.y as usize,
            ..Self::default()
        };
        let mut listed: Vec<(usize, u32)> = Vec::new();
        for (index, cushion) in (0..).zip(&table.cushions) {
            let (least, most) = cushion.bounds();
            let [c0, r0] = walls.place(least - reach);
            let [c1, r1] = walls.place(most + reach);
            for row in r0..=r1 {
                for column in c0..=c1 {
                    listed.push((row * walls.columns + column, index));
                }
            }
        }
        listed.sort_unstable();
        walls.first = vec![0; walls.columns * walls.rows + 1];
        for (cell, cushion) in listed {
            walls.first[cell + 1] += 1;
            walls.cushions.push(cushion);
        }
        for cell in 1..walls.first.len() {
            walls.first[cell] += walls.first[cell - 1];
        }
        walls
    }

    fn place(&self, point: DVec2) -> [usize; 2] {
        // The casts saturate: what lies outside counts to the edge.
        let at = (point - self.least) * self.per_cell;
        [
            (at.x as usize).min(self.columns - 1),
            (at.y as usize).min(self.rows - 1),
        ]
    }

    /// Half the sides of a rectangle, m: as long as the centre of a ball is in it, the ball is further than this from every
    /// cushion. Below zero if there is none.
    #[inline]
    pub fn clear(&self, distance: f64) -> DVec2 {
        self.half - distance
    }

    /// The cushions that a ball with the middle of its path here can touch.
    #[inline]
    pub fn near(&self, point: DVec2) -> std::ops::Range<usize> {
        let [column, row] = self.place(point);
        let cell = row * self.columns + column;
        self.first[cell] as usize..self.first[cell + 1] as usize
    }

    #[inline]
    pub fn cushion(&self, listed: usize) -> u32 {
        self.cushions[listed]
    }
}
