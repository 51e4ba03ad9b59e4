//! Neighbours by cells, for scenes with many balls.
//!
//! A cell is at least as wide as the largest distance at which two balls touch, so that a ball meets only balls of its own
//! and the eight cells around. A ball that leaves its cell is an event of its own, at which only its neighbours are
//! looked through again (Lubachevsky 1991; Marín, Risso & Cordero 1993). Border cells reach to infinity.

use glam::DVec2;

use crate::physics::contact::Track;
use crate::physics::exact::walls::{Area, Walls};
use crate::physics::roots::{RootError, quadratic};
use crate::physics::table::Table;

const NONE: u32 = u32::MAX;

/// The grid and who is where.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    columns: u32,
    rows: u32,
    origin: DVec2,
    size: DVec2,
    heads: Vec<u32>,
    next: Vec<u32>,
    before: Vec<u32>,
    pub(super) cell_of: Vec<u32>,
    wall_starts: Vec<u32>,
    walls: Vec<u32>,
}

impl Cells {
    /// A grid for this many balls whose largest distance at contact is `reach`.
    pub(super) fn new(table: &Table, walls: &Walls, count: usize, reach: f64) -> Self {
        let area = DVec2::new(table.length, table.width);
        // About 0.7 balls a cell where they are not packed more densely than that.
        let wide = (0.7 * area.x * area.y / count as f64)
            .sqrt()
            .max(1.000_001 * reach);
        let columns = (area.x / wide).floor().clamp(1.0, 4096.0);
        let rows = (area.y / wide).floor().clamp(1.0, 4096.0);
        let size = DVec2::new(area.x / columns, area.y / rows);
        let (columns, rows) = (columns as u32, rows as u32);
        let total = (columns * rows) as usize;
        let mut cells = Self {
            columns,
            rows,
            origin: -0.5 * area,
            size,
            heads: vec![NONE; total],
            next: vec![NONE; count],
            before: vec![NONE; count],
            cell_of: vec![NONE; count],
            wall_starts: Vec::with_capacity(total + 1),
            walls: Vec::new(),
        };
        for cell in 0..total {
            cells.wall_starts.push(cells.walls.len() as u32);
            let area = cells.area(cell as u32);
            for (index, (_, bounds)) in walls.list.iter().enumerate() {
                if bounds.meets(&area) {
                    cells.walls.push(index as u32);
                }
            }
        }
        cells.wall_starts.push(cells.walls.len() as u32);
        cells
    }

    /// Bounds of a cell; border cells reach to infinity, and all a little beyond their lines, for rounding.
    fn area(&self, cell: u32) -> Area {
        let (column, row) = (cell % self.columns, cell / self.columns);
        let line = |index: u32, count: u32, origin: f64, size: f64| {
            if index == 0 {
                f64::NEG_INFINITY
            } else if index == count {
                f64::INFINITY
            } else {
                origin + f64::from(index) * size
            }
        };
        let (origin, size) = (self.origin, self.size);
        Area {
            least: DVec2::new(
                line(column, self.columns, origin.x, size.x),
                line(row, self.rows, origin.y, size.y),
            ),
            most: DVec2::new(
                line(column + 1, self.columns, origin.x, size.x),
                line(row + 1, self.rows, origin.y, size.y),
            ),
        }
        .grown(1e-9)
    }

    pub(super) fn at(&self, point: DVec2) -> u32 {
        let place = (point - self.origin) / self.size;
        let column = place.x.floor().clamp(0.0, f64::from(self.columns - 1)) as u32;
        let row = place.y.floor().clamp(0.0, f64::from(self.rows - 1)) as u32;
        row * self.columns + column
    }

    pub(super) fn insert(&mut self, ball: u32, cell: u32) {
        let head = self.heads[cell as usize];
        self.next[ball as usize] = head;
        self.before[ball as usize] = NONE;
        if head != NONE {
            self.before[head as usize] = ball;
        }
        self.heads[cell as usize] = ball;
        self.cell_of[ball as usize] = cell;
    }

    pub(super) fn remove(&mut self, ball: u32) {
        let cell = self.cell_of[ball as usize];
        if cell == NONE {
            return;
        }
        let (before, next) = (self.before[ball as usize], self.next[ball as usize]);
        if before == NONE {
            self.heads[cell as usize] = next;
        } else {
            self.next[before as usize] = next;
        }
        if next != NONE {
            self.before[next as usize] = before;
        }
        self.cell_of[ball as usize] = NONE;
    }

    /// Visits the balls in the cell of a ball and in those around it, itself among them, until one visit fails.
    #[inline]
    pub(super) fn around<E>(
        &self,
        ball: u32,
        mut visit: impl FnMut(usize) -> Result<(), E>,
    ) -> Result<(), E> {
        let cell = self.cell_of[ball as usize];
        let (column, row) = (cell % self.columns, cell / self.columns);
        let left = column.saturating_sub(1);
        let right = (column + 1).min(self.columns - 1);
        for row in row.saturating_sub(1)..=(row + 1).min(self.rows - 1) {
            let line = row * self.columns;
            for &head in &self.heads[(line + left) as usize..=(line + right) as usize] {
                let mut other = head;
                while other != NONE {
                    visit(other as usize)?;
                    other = self.next[other as usize];
                }
            }
        }
        Ok(())
    }

    /// Places in the list of walls of all that can be touched in the cell of a ball.
    pub(super) fn walls(&self, ball: u32) -> &[u32] {
        let cell = self.cell_of[ball as usize] as usize;
        &self.walls[self.wall_starts[cell] as usize..self.wall_starts[cell + 1] as usize]
    }

    /// When a ball leaves its cell, and the cell that it enters.
    pub(super) fn leaves(
        &self,
        ball: u32,
        track: &Track,
        horizon: f64,
    ) -> Result<Option<(f64, u32)>, RootError> {
        let cell = self.cell_of[ball as usize];
        let (column, row) = (cell % self.columns, cell / self.columns);
        let (p, v, h) = (track.position, track.velocity, 0.5 * track.acceleration);
        let mut best = None;
        let mut horizon = horizon;
        let mut side = |c: [f64; 3], to: u32| -> Result<(), RootError> {
            if c[1] >= 0.0 && c[2] >= 0.0 {
                return Ok(());
            }
            if let Some(time) = quadratic::first_closing(c, 0.0, horizon)?
                && best.is_none_or(|(soonest, _)| time < soonest)
            {
                best = Some((time, to));
                horizon = time;
            }
            Ok(())
        };
        let left = self.origin.x + f64::from(column) * self.size.x;
        let near = self.origin.y + f64::from(row) * self.size.y;
        if column > 0 {
            side([p.x - left, v.x, h.x], cell - 1)?;
        }
        if column + 1 < self.columns {
            side([left + self.size.x - p.x, -v.x, -h.x], cell + 1)?;
        }
        if row > 0 {
            side([p.z - near, v.z, h.z], cell - self.columns)?;
        }
        if row + 1 < self.rows {
            side([near + self.size.y - p.z, -v.z, -h.z], cell + self.columns)?;
        }
        Ok(best)
    }
}
