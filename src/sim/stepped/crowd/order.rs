//! The order of the balls in memory: near what is near them on the table.

use glam::DVec2;

use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::cells::{Cells, TURNED};
use crate::sim::stepped::crowd::field::Field;
use crate::sim::stepped::crowd::stretch::Stretch;
use crate::sim::stepped::crowd::stripe::{Stripe, place};

/// Most stripes, unless there are more balls than they can hold.
const STRIPES: usize = 8;
/// A table is cut into a few stripes if each of them has this many rows.
const ROWS: usize = 18;
const FEW: usize = 4;
/// It is cut into more if each has this many: what lies at the edges of stripes is left to one thread.
const MANY: usize = 64;

impl<B: Body> Field<B> {
    /// Sorts the balls by cell, those that move and those that do not.
    pub fn sort(&mut self, stretch: &Stretch, cell: Option<DVec2>, cut: f64) {
        let table = DVec2::new(stretch.table.length, stretch.table.width);
        let reach = Self::reach(stretch, cut) * 1.05;
        // Far more cells than balls would only cost memory.
        let least = (table.x * table.y / (4 * self.bodies.len() + 1024) as f64).sqrt();
        self.cells = Cells::new(table, cell.unwrap_or(DVec2::splat(reach.max(least))));
        let (cells, now) = (self.cells, self.now);
        let keys: Vec<u32> = self
            .bodies
            .iter()
            .map(|body| {
                let [column, row] = cells.at(body.position(now));
                let cell = (row * cells.columns + column) as u32;
                cell | u32::from(body.is_still()) << 31
            })
            .collect();
        let count = cells.columns * cells.rows;
        let mut first = vec![0_u32; 2 * count + 1];
        let index = |key: u32| (key & !TURNED) as usize + (key >> 31) as usize * count;
        for key in &keys {
            first[index(*key) + 1] += 1;
        }
        for cell in 1..first.len() {
            first[cell] += first[cell - 1];
        }
        let starts = first.clone();
        let mut order = vec![0_u32; keys.len()];
        for (slot, key) in (0..).zip(&keys) {
            let place = &mut first[index(*key)];
            order[*place as usize] = slot;
            *place += 1;
        }
        let ball = &stretch.ball;
        self.bodies = order
            .iter()
            .map(|slot| self.bodies[*slot as usize].rebased(ball, now))
            .collect();
        self.numbers = order
            .iter()
            .map(|slot| self.numbers[*slot as usize])
            .collect();
        for (slot, number) in (0..).zip(&self.numbers) {
            self.slots[*number as usize] = slot;
        }
        self.moving = starts[count] as usize;
        self.woken.clear();
        self.stirred.clear();
        self.stirred.resize(self.bodies.len() - self.moving, false);
        self.told = false;
        (self.now, self.ticks, self.work) = (0.0, 0, 0);
        self.cut_stripes(&starts);
        self.sort_still();
    }

    /// Cuts the table into stripes with about as many balls each; how many does not depend on threads.
    fn cut_stripes(&mut self, first: &[u32]) {
        let (columns, rows) = (self.cells.columns, self.cells.rows);
        let enough = self.bodies.len() >> place::BITS;
        let stripes = (rows / ROWS).min(FEW).max(rows / MANY).clamp(1, STRIPES);
        let stripes = stripes.max(enough + 1).min(rows);
        self.stripes.clear();
        let (mut row, mut slot) = (0, 0);
        for index in 0..stripes {
            let most = self.moving * (index + 1) / stripes;
            let mut end = row + 1;
            while end < rows - (stripes - 1 - index)
                && (index + 1 == stripes || (first[end * columns] as usize) < most)
            {
                end += 1;
            }
            let end_slot = if index + 1 == stripes {
                self.moving
            } else {
                first[end * columns] as usize
            };
            self.stripes
                .push(Stripe::new(index, row..end, slot..end_slot));
            (row, slot) = (end, end_slot);
        }
    }

    fn sort_still(&mut self) {
        let columns_of = |body: &B| self.cells.at(body.position(0.0));
        let mut balls: Vec<(DVec2, u32)> = Vec::new();
        let mut slot = self.moving;
        for stripe in &mut self.stripes {
            balls.clear();
            while slot < self.bodies.len()
                && stripe.rows.contains(&columns_of(&self.bodies[slot])[1])
            {
                balls.push((self.bodies[slot].position(0.0), slot as u32));
                slot += 1;
            }
            stripe.sort_still(&self.cells, &balls);
        }
    }

    /// Sets the clock of the bodies to zero.
    pub fn rebase(&mut self, stretch: &Stretch) {
        for body in &mut self.bodies {
            *body = body.rebased(&stretch.ball, self.now);
        }
        (self.now, self.ticks) = (0.0, 0);
    }
}
