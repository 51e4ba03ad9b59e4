//! Neighbours by cells, for scenes with many balls.
//!
//! A cell is at least as wide as the largest distance at which two balls touch, so that a ball meets only balls of its own
//! and the eight cells around. A ball that leaves its cell is an event of its own, at which only its neighbours are
//! looked through again (Lubachevsky 1991; Marín, Risso & Cordero 1993). Border cells reach to infinity.

use std::ops::{Deref, Range};

use glam::DVec2;

use crate::physics::contact::Track;
use crate::physics::exact::flight::Glide;
use crate::physics::exact::walls::{Area, Walls};
use crate::physics::roots::{RootError, quadratic};
use crate::physics::table::Table;

const NONE: u32 = u32::MAX;

/// How many balls of a cell are found without a list.
const ROOM: usize = 4;

/// The grid and who is where.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    columns: u32,
    rows: u32,
    /// Cells from one row to the next: a rim of empty cells lies around.
    stride: u32,
    origin: DVec2,
    size: DVec2,
    /// The balls of each cell, in any places; the last place begins a list that goes on in `next`.
    rooms: Vec<[u32; ROOM]>,
    next: Vec<u32>,
    pub(super) cell_of: Vec<u32>,
    wall_starts: Vec<u32>,
    walls: Vec<u32>,
    /// Columns and rows between which no cell has walls.
    open: [Range<u32>; 2],
}

/// Balls that may be met.
#[derive(Clone, Debug)]
pub(super) struct Neighbours {
    balls: [u32; Self::MOST],
    count: usize,
}

impl Neighbours {
    /// Room for a part of a table that is not packed with dwarfs.
    const MOST: usize = 64;

    pub(super) fn none() -> Self {
        Self {
            balls: [0; Self::MOST],
            count: 0,
        }
    }

    #[inline]
    pub(super) fn push(&mut self, ball: u32) {
        self.balls[self.count] = ball;
        self.count += 1;
    }

    /// Whether the balls of one more cell may not find room.
    #[inline]
    pub(super) fn is_full(&self) -> bool {
        self.count > Self::MOST - 3 * ROOM
    }

    pub(super) fn clear(&mut self) {
        self.count = 0;
    }
}

impl Deref for Neighbours {
    type Target = [u32];

    #[inline]
    fn deref(&self) -> &[u32] {
        &self.balls[..self.count]
    }
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
        let stride = columns + 2;
        let total = (stride * (rows + 2)) as usize;
        let mut cells = Self {
            columns,
            rows,
            stride,
            origin: -0.5 * area,
            size,
            rooms: vec![[NONE; ROOM]; total],
            next: vec![NONE; count],
            cell_of: vec![NONE; count],
            wall_starts: Vec::with_capacity(total + 1),
            walls: Vec::new(),
            open: [0..0, 0..0],
        };
        for cell in 0..total {
            cells.wall_starts.push(cells.walls.len() as u32);
            let (column, row) = cells.place(cell as u32);
            if column >= columns || row >= rows {
                continue; // the rim
            }
            let area = cells.area(column, row);
            for (index, (_, bounds)) in walls.list.iter().enumerate() {
                if bounds.meets(&area) {
                    cells.walls.push(index as u32);
                }
            }
        }
        cells.wall_starts.push(cells.walls.len() as u32);
        cells.open = cells.without_walls(walls);
        cells
    }

    /// The columns and the rows whose cells lie in the open part of the table.
    fn without_walls(&self, walls: &Walls) -> [Range<u32>; 2] {
        let holds = |column: u32, row: u32, axis: usize| {
            let (area, open) = (self.area(column, row), walls.open());
            open.least[axis] < area.least[axis] && area.most[axis] < open.most[axis]
        };
        let range = |count: u32, is_open: &dyn Fn(u32) -> bool| {
            let first = (0..count).find(|&i| is_open(i)).unwrap_or(count);
            let end = (first..count).find(|&i| !is_open(i)).unwrap_or(count);
            first..end
        };
        [
            range(self.columns, &|column| holds(column, 0, 0)),
            range(self.rows, &|row| holds(0, row, 1)),
        ]
    }

    /// Column and row of a cell; beyond the last of them on the rim.
    #[inline]
    fn place(&self, cell: u32) -> (u32, u32) {
        (
            (cell % self.stride).wrapping_sub(1),
            (cell / self.stride).wrapping_sub(1),
        )
    }

    /// Bounds of a cell; border cells reach to infinity, and all a little beyond their lines, for rounding.
    fn area(&self, column: u32, row: u32) -> Area {
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
        (row + 1) * self.stride + column + 1
    }

    /// Whether this is the number of a cell of the table.
    pub(super) fn has(&self, cell: u32) -> bool {
        let (column, row) = (cell % self.stride, cell / self.stride);
        (1..=self.columns).contains(&column) && (1..=self.rows).contains(&row)
    }

    pub(super) fn insert(&mut self, ball: u32, cell: u32) {
        let room = &mut self.rooms[cell as usize];
        let free = room[..ROOM - 1].iter().position(|other| *other == NONE);
        let place = free.unwrap_or(ROOM - 1);
        self.next[ball as usize] = if free.is_none() { room[place] } else { NONE };
        room[place] = ball;
        self.cell_of[ball as usize] = cell;
    }

    pub(super) fn remove(&mut self, ball: u32) {
        let cell = self.cell_of[ball as usize];
        if cell == NONE {
            return;
        }
        self.cell_of[ball as usize] = NONE;
        let next = self.next[ball as usize];
        let room = &mut self.rooms[cell as usize];
        if let Some(place) = room.iter().position(|other| *other == ball) {
            room[place] = next;
            return;
        }
        let mut before = room[ROOM - 1];
        while before != NONE {
            let after = self.next[before as usize];
            if after == ball {
                self.next[before as usize] = next;
                return;
            }
            before = after;
        }
    }

    /// Collects the balls in the cell of a ball and in those around it, itself among them. Where they are more than a list
    /// holds they come in several.
    #[inline]
    pub(super) fn around<E>(
        &self,
        ball: u32,
        list: &mut Neighbours,
        mut full: impl FnMut(&mut Neighbours) -> Result<(), E>,
    ) -> Result<(), E> {
        let cell = self.cell_of[ball as usize];
        for first in [cell - self.stride - 1, cell - 1, cell + self.stride - 1] {
            let rooms = &self.rooms[first as usize..first as usize + 3];
            if list.is_full() {
                full(list)?;
                list.clear();
            }
            // Without branches: most places are empty, and which is not to be guessed.
            for room in rooms {
                for &other in room {
                    list.balls[list.count] = other;
                    list.count += usize::from(other != NONE);
                }
            }
            for room in rooms {
                if room[ROOM - 1] == NONE {
                    continue;
                }
                let mut other = self.next[room[ROOM - 1] as usize];
                while other != NONE {
                    if list.is_full() {
                        full(list)?;
                        list.clear();
                    }
                    list.push(other);
                    other = self.next[other as usize];
                }
            }
        }
        Ok(())
    }

    /// Asks the memory for what [`Self::around`] needs.
    #[inline]
    pub(super) fn look(&self, ball: u32) {
        let Some(&cell) = self.cell_of.get(ball as usize) else {
            return;
        };
        for cell in [
            cell.wrapping_sub(self.stride),
            cell,
            cell.wrapping_add(self.stride),
        ] {
            std::hint::black_box(self.rooms.get(cell as usize).map_or(NONE, |room| room[0]));
        }
    }

    /// Places in the list of walls of all that can be touched in the cell of a ball.
    #[inline]
    pub(super) fn walls(&self, ball: u32) -> &[u32] {
        let (column, row) = self.place(self.cell_of[ball as usize]);
        if self.open[0].contains(&column) && self.open[1].contains(&row) {
            return &[];
        }
        let cell = self.cell_of[ball as usize] as usize;
        &self.walls[self.wall_starts[cell] as usize..self.wall_starts[cell + 1] as usize]
    }

    /// When a ball on a straight path leaves its cell, and the cell that it enters.
    #[inline]
    pub(super) fn leaves_straight(&self, ball: u32, glide: &Glide) -> Option<(f64, u32)> {
        let cell = self.cell_of[ball as usize];
        let (column, row) = self.place(cell);
        let side =
            |(place, speed): (f64, f64), index: u32, count, origin: f64, size: f64, pitch| {
                let near = origin + f64::from(index) * size;
                let (way, to) = if speed > 0.0 && index + 1 < count {
                    (near + size - place, cell + pitch)
                } else if speed < 0.0 && index > 0 {
                    (place - near, cell - pitch)
                } else {
                    return (f64::INFINITY, cell);
                };
                ((way / speed.abs()).max(0.0), to)
            };
        let (origin, size) = (self.origin, self.size);
        let along = side(glide.along(), column, self.columns, origin.x, size.x, 1);
        let across = side(
            glide.across(),
            row,
            self.rows,
            origin.y,
            size.y,
            self.stride,
        );
        let first = if across.0 < along.0 { across } else { along };
        (first.0 < f64::INFINITY).then_some(first)
    }

    /// When a ball leaves its cell, and the cell that it enters.
    pub(super) fn leaves(
        &self,
        ball: u32,
        track: &Track,
        horizon: f64,
    ) -> Result<Option<(f64, u32)>, RootError> {
        let cell = self.cell_of[ball as usize];
        let (column, row) = self.place(cell);
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
            side([p.z - near, v.z, h.z], cell - self.stride)?;
        }
        if row + 1 < self.rows {
            side([near + self.size.y - p.z, -v.z, -h.z], cell + self.stride)?;
        }
        Ok(best)
    }
}
