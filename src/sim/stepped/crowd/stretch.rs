//! A stretch of time: what holds for all balls during a tick, or a part of it.
#![expect(
    clippy::inline_always,
    reason = "the innermost loops of a tick: a call would cost as much as the work"
)]

use glam::DVec2;

use crate::physics::ball::Ball;
use crate::physics::laws::Laws;
use crate::physics::table::Table;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::cells::{Cells, MARKED, Record};
use crate::sim::stepped::crowd::census::Tally;
use crate::sim::stepped::crowd::look::Turn;
use crate::sim::stepped::crowd::rows::Near;
use crate::sim::stepped::crowd::walls::Walls;

/// How much two balls may overlap before they are set apart, as a share of their distance at contact.
const DEEP: f64 = 1e-4;

/// What holds for all balls during one stretch of time: the tick, or a part of it. Times are on the clock of the crowd.
#[derive(Clone, Copy)]
pub(super) struct Stretch<'a> {
    pub laws: &'a Laws,
    pub table: &'a Table,
    /// The constants of every ball.
    pub ball: Ball,
    pub walls: &'a Walls,
    pub cells: Cells,
    pub start: f64,
    pub end: f64,
    /// Balls that get further than this from the middle of their path are looked after one by one, m.
    pub cut: f64,
    /// The square of the speed at which they do, m²/s².
    pub fast: f64,
    /// Half the sides of the rectangle in which the others are far from all cushions in the middle of their path, m.
    pub clear: DVec2,
    /// Largest acceleration, m/s².
    pub bend: f64,
    /// Acceleration of every ball along a tilted table, m/s².
    pub pull: f64,
}

impl Stretch<'_> {
    /// The distance of centres at contact, m.
    #[inline]
    pub fn reach(&self) -> f64 {
        2.0 * self.ball.radius
    }

    /// This stretch on the clock of the crowd, cut into these cells, for balls that get this far.
    pub fn within(self, [start, end]: [f64; 2], cells: Cells, cut: f64) -> Self {
        let length = end - start;
        let straight = (cut - 0.5 * length * length * self.bend).max(0.0);
        let fast = straight / (0.5 * length);
        Self {
            start,
            end,
            cells,
            cut,
            fast: fast * fast,
            clear: self.clear(cut),
            ..self
        }
    }

    /// Half the sides of the rectangle in which a ball that gets this far from a place in it touches no cushion, m.
    #[inline]
    pub fn clear(&self, cut: f64) -> DVec2 {
        self.walls.clear(self.ball.radius * (1.0 + 1e-6) + cut)
    }

    /// What rounding to f32 does to places on the table, m, with room to spare.
    fn rounding(&self) -> f64 {
        8.0 * f64::from(f32::EPSILON) * f64::max(self.table.length, self.table.width)
    }

    /// Half the sides of the rectangle in which a ball touches no cushion, m.
    pub fn free(&self) -> [f32; 2] {
        let free = self.clear(self.rounding());
        [free.x as f32, free.y as f32]
    }

    /// What two balls must come near enough to meet.
    pub fn near(&self) -> Near {
        let rounding = 1e-5 * self.reach() + self.rounding();
        let length = self.end - self.start;
        let wide = self.reach() + length * length * self.bend + rounding;
        let side = wide + self.cut + rounding;
        Near {
            wide: wide as f32,
            side: side as f32,
            edge: (side + self.cut) as f32,
        }
    }

    /// Two balls nearer than this are set apart, m²: a contact that was seen in time is off by rounding only.
    #[inline]
    pub fn least_square(&self) -> f64 {
        let least = self.reach() * (1.0 - DEEP);
        least * least
    }

    /// How far a ball of this square of its speed gets from the middle of its path, m.
    pub fn freedom(&self, square: f64) -> f64 {
        let length = self.end - self.start;
        0.5 * length * (square.sqrt() + length * self.bend)
    }

    /// A ball as its cell knows it, and the cell.
    #[inline(always)]
    pub fn record<B: Body>(&self, body: &B, slot: u32, tally: &mut Tally) -> (Record, u32) {
        let length = self.end - self.start;
        let middle = body.position(self.start + 0.5 * length);
        let velocity = body.velocity(self.start);
        let square = velocity.length_squared();
        tally.speed = if square > tally.speed {
            square
        } else {
            tally.speed
        };
        tally.squares += square;
        tally.stopped += u64::from(square == 0.0);
        let mut record = Record::new(middle, length * velocity, slot);
        let [column, row] = self.cells.at(middle);
        let key = (row * self.cells.columns + column) as u32;
        let ends = B::BENDS && body.change() <= self.end;
        // Without a branch: hardly any is marked.
        let is_far = (middle.x.abs() > self.clear.x) | (middle.y.abs() > self.clear.y);
        let marked = (square > self.fast) | ends | is_far;
        record.ball |= MARKED * u32::from(marked);
        (record, key)
    }

    /// A ball that is on a path from a moment on.
    #[inline(always)]
    pub fn turn<B: Body>(&self, ball: u32, body: &B, from: f64) -> Turn {
        let length = self.end - self.start;
        let after = ((from - self.start) / length) as f32;
        let (place, way) = (body.position(from), length * body.velocity(from));
        let (x, z, dx, dz) = (place.x as f32, place.y as f32, way.x as f32, way.y as f32);
        let left = 1.0 - after;
        let (end_x, end_z) = (x + left * dx, z + left * dz);
        let bend = if B::BENDS {
            0.5 * left * left * (length * length * self.bend) as f32
        } else {
            0.0
        };
        let least = |a: f32, b: f32| if a < b { a } else { b } - bend;
        let most = |a: f32, b: f32| if a > b { a } else { b } + bend;
        Turn {
            ball,
            after,
            bounds: [
                least(x, end_x),
                least(z, end_z),
                most(x, end_x),
                most(z, end_z),
            ],
            path: [x - after * dx, z - after * dz, dx, dz],
        }
    }
}
