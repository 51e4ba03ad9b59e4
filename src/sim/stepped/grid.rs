//! The uniform grid: which balls and which cushions meet in which cell.
//!
//! The cells cover the table evenly; those at the edge reach to infinity, so that no ball is ever outside. A ball is
//! listed in every cell that its path of the tick touches, a cushion or pocket in every cell from which a ball can touch
//! it. The lists are chains of indices in flat stores: a fixed one of chain heads, one a cell, and a pool of links that
//! keeps its memory from tick to tick. The cells without cushions cost no cushion test.

use bevy::prelude::*;
use glam::DVec2;

use crate::physics::laws::cluster::TOUCH;
use crate::physics::scene::{Solver, Stepped};
use crate::physics::table::Table;
use crate::sim::playfield::Playfield;
use crate::sim::stepped::bodies::Bodies;

const END: u32 = u32::MAX;

/// A rectangle of cells, ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct CellRange {
    pub least: [u32; 2],
    pub most: [u32; 2],
}

impl CellRange {
    pub const EMPTY: Self = Self {
        least: [1, 1],
        most: [0, 0],
    };

    pub fn holds(&self, column: u32, row: u32) -> bool {
        (self.least[0]..=self.most[0]).contains(&column)
            && (self.least[1]..=self.most[1]).contains(&row)
    }

    /// Every cell of the range.
    pub fn cells(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let Self { least, most } = *self;
        (least[1]..=most[1])
            .flat_map(move |row| (least[0]..=most[0]).map(move |column| (column, row)))
    }

    /// The smallest range that holds both.
    fn hull(&self, other: &Self) -> Self {
        if *self == Self::EMPTY {
            return *other;
        }
        Self {
            least: std::array::from_fn(|i| self.least[i].min(other.least[i])),
            most: std::array::from_fn(|i| self.most[i].max(other.most[i])),
        }
    }

    /// Of all cells that two ranges share this is the first: the one in which the pair is looked at, and no other.
    pub fn meeting(&self, other: &Self) -> (u32, u32) {
        (
            self.least[0].max(other.least[0]),
            self.least[1].max(other.least[1]),
        )
    }
}

#[derive(Clone, Copy, Debug)]
struct Link {
    item: u32,
    next: u32,
}

/// Chains of indices, one a cell.
#[derive(Debug, Default)]
struct Chains {
    heads: Vec<u32>,
    links: Vec<Link>,
}

impl Chains {
    fn reset(&mut self, cells: usize) {
        self.heads.clear();
        self.heads.resize(cells, END);
        self.links.clear();
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "a scene holds fewer than 2^32 balls"
    )]
    fn push(&mut self, cell: usize, item: usize) {
        self.links.push(Link {
            item: item as u32,
            next: self.heads[cell],
        });
        self.heads[cell] = self.links.len() as u32 - 1;
    }

    fn iter(&self, cell: usize) -> impl Iterator<Item = usize> + '_ {
        self.links_from(self.heads[cell])
            .map(|link| link.item as usize)
    }

    fn links_from(&self, mut at: u32) -> impl Iterator<Item = Link> + '_ {
        std::iter::from_fn(move || {
            let link = *self.links.get(at as usize)?;
            at = link.next;
            Some(link)
        })
    }

    /// All pairs of a chain, the older item first.
    fn pairs(&self, cell: usize, mut visit: impl FnMut(usize, usize)) {
        for newer in self.links_from(self.heads[cell]) {
            for older in self.links_from(newer.next) {
                visit(older.item as usize, newer.item as usize);
            }
        }
    }
}

/// The grid of a tick. Without cells every ball meets every ball and every cushion.
#[derive(Resource, Debug, Default)]
pub struct Grid {
    cells: Option<[u32; 2]>,
    least: DVec2,
    per_cell: DVec2,
    balls: Chains,
    cushions: Chains,
    pockets: Chains,
    /// Largest ball radius the cushion lists reach for, m.
    radius: f64,
}

impl Grid {
    /// Columns and rows; `None` when every pair is tested.
    #[must_use]
    pub fn cells(&self) -> Option<[u32; 2]> {
        self.cells
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the cast saturates, which is what an edge cell that reaches to infinity wants"
    )]
    fn range(&self, cells: [u32; 2], (least, most): (DVec2, DVec2)) -> CellRange {
        let cell = |point: DVec2| {
            let place = (point - self.least) * self.per_cell;
            [
                (place.x as u32).min(cells[0] - 1),
                (place.y as u32).min(cells[1] - 1),
            ]
        };
        CellRange {
            least: cell(least),
            most: cell(most),
        }
    }

    fn cell(&self, column: u32, row: u32) -> usize {
        let columns = self.cells.map_or(1, |cells| cells[0]);
        row as usize * columns as usize + column as usize
    }

    /// Lists a ball in the cells of a new stretch of path that it is not listed in yet.
    pub(super) fn list(&mut self, bodies: &mut Bodies, ball: usize, time: f64) {
        let Some(cells) = self.cells else { return };
        let body = &mut bodies.all[ball];
        if !body.is_in_play() {
            return;
        }
        let old = body.cells;
        let new = old.hull(&self.range(cells, body.sweep(time, bodies.tick)));
        body.cells = new;
        for (column, row) in new.cells() {
            if !old.holds(column, row) {
                let cell = self.cell(column, row);
                self.balls.push(cell, ball);
            }
        }
    }

    /// All pairs of balls that share a cell, each once.
    pub(super) fn pairs(&self, bodies: &Bodies, mut visit: impl FnMut(usize, usize)) {
        let Some(cells) = self.cells else {
            for second in 0..bodies.all.len() {
                for first in 0..second {
                    visit(first, second);
                }
            }
            return;
        };
        for row in 0..cells[1] {
            for column in 0..cells[0] {
                self.balls.pairs(self.cell(column, row), |first, second| {
                    let meeting = bodies.all[first].cells.meeting(&bodies.all[second].cells);
                    if meeting == (column, row) {
                        visit(first, second);
                    }
                });
            }
        }
    }

    /// All balls that share a cell with this one, each once.
    pub(super) fn neighbours(&self, bodies: &Bodies, ball: usize, mut visit: impl FnMut(usize)) {
        if self.cells.is_none() {
            (0..bodies.all.len()).filter(|&i| i != ball).for_each(visit);
            return;
        }
        let range = bodies.all[ball].cells;
        for (column, row) in range.cells() {
            for other in self.balls.iter(self.cell(column, row)) {
                if other != ball && bodies.all[other].cells.meeting(&range) == (column, row) {
                    visit(other);
                }
            }
        }
    }

    /// All cushions that this ball can touch in this tick; some may come twice.
    pub(super) fn cushions(&self, table: &Table, range: &CellRange, visit: impl FnMut(usize)) {
        self.fixed(&self.cushions, table.cushions.len(), range, visit);
    }

    /// All pockets that can take this ball in this tick; some may come twice.
    pub(super) fn pockets(&self, table: &Table, range: &CellRange, visit: impl FnMut(usize)) {
        self.fixed(&self.pockets, table.pockets.len(), range, visit);
    }

    fn fixed(&self, chains: &Chains, count: usize, range: &CellRange, visit: impl FnMut(usize)) {
        if self.cells.is_none() {
            (0..count).for_each(visit);
            return;
        }
        range
            .cells()
            .flat_map(|(column, row)| chains.iter(self.cell(column, row)))
            .for_each(visit);
    }

    /// Lays out cells, cushions and pockets for a table.
    fn lay_out(&mut self, table: &Table, cells: Option<[u32; 2]>, radius: f64) {
        self.radius = radius;
        self.cells = cells;
        let Some(cells) = cells else { return };
        let size = DVec2::new(table.length, table.width);
        self.least = -0.5 * size;
        self.per_cell = DVec2::new(f64::from(cells[0]), f64::from(cells[1])) / size;
        let count = cells[0] as usize * cells[1] as usize;
        self.cushions.reset(count);
        self.pockets.reset(count);
        let reach = DVec2::splat(radius + TOUCH);
        for (index, cushion) in table.cushions.iter().enumerate() {
            let (least, most) = cushion.bounds();
            for (column, row) in self.range(cells, (least - reach, most + reach)).cells() {
                let cell = self.cell(column, row);
                self.cushions.push(cell, index);
            }
        }
        for (index, pocket) in table.pockets.iter().enumerate() {
            let hole = DVec2::splat(pocket.radius);
            let bounds = (pocket.center - hole, pocket.center + hole);
            for (column, row) in self.range(cells, bounds).cells() {
                let cell = self.cell(column, row);
                self.pockets.push(cell, index);
            }
        }
    }
}

/// Lists every ball in the cells of its path of this tick.
pub(super) fn rebuild(
    mut grid: ResMut<Grid>,
    mut bodies: ResMut<Bodies>,
    playfield: Res<Playfield>,
) {
    let Solver::Stepped(Stepped { grid: cells, .. }) = playfield.solver else {
        return;
    };
    let radius = bodies
        .all
        .iter()
        .fold(0.0_f64, |most, body| most.max(body.ball.radius));
    let cells = cells.map(|(columns, rows)| [columns, rows]);
    if playfield.is_changed() || radius > grid.radius {
        grid.lay_out(&playfield.table, cells, radius);
    }
    if let Some([columns, rows]) = cells {
        grid.balls.reset(columns as usize * rows as usize);
    }
    for ball in 0..bodies.all.len() {
        grid.list(&mut bodies, ball, 0.0);
    }
}
