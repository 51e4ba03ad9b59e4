//! Finding contacts: pairs of balls by cells, cushions by their own cells, changes of motion.

use glam::{DVec2, DVec3};

use crate::physics::contact::{self, Track};
use crate::physics::roots::RootError;
use crate::physics::table::Cushion;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::patch::{END, MARGIN, Origin, Patch, Stretch};
use crate::sim::stepped::crowd::queue::{Contact, Kind};
use crate::sim::stepped::resolve::{BOUNCES, IMPACTS};

/// A ball that has met so many others in a part of a tick that it no longer bounces meets them at most this often in a
/// part: balls pressed together would meet without end. Until then they may overlap a little.
const RATTLES: f64 = 16.0;

impl<B: Body> Patch<B> {
    /// Finds the first contact of every pair and every change of motion.
    pub(super) fn collide_balls(&mut self, stretch: &Stretch) {
        self.find_close(stretch);
        self.sieve(stretch);
        for k in 0..self.close.len() {
            let [first, second] = self.close[k];
            self.find_pair(stretch, first, second, 0.0);
        }
        for k in 0..self.fast.len() {
            self.scan(stretch, self.fast[k], 0.0);
        }
        if B::BENDS {
            for ball in 0..self.bodies.len() {
                if self.bodies[ball].left() <= stretch.length {
                    self.find_change(stretch, ball as u32);
                }
            }
        }
    }

    /// Lists all pairs that are near enough in the middle of the stretch to touch during it.
    fn find_close(&mut self, stretch: &Stretch) {
        let reach = 2.0 * (stretch.ball.radius + self.slack) * (1.0 + MARGIN);
        let reach = reach * reach;
        let Self {
            x: xs,
            z: zs,
            first,
            close,
            ..
        } = self;
        let mut found = 0;
        for row in 0..self.rows {
            for column in 0..self.columns {
                let cell = row * self.columns + column;
                let (begin, end) = (first[cell] as usize, first[cell + 1] as usize);
                if begin == end {
                    continue;
                }
                let left = column.saturating_sub(self.span[0]);
                let right = (column + self.span[0]).min(self.columns - 1);
                for other in row..=(row + self.span[1]).min(self.rows - 1) {
                    let other_row = other * self.columns;
                    let last = first[other_row + right + 1] as usize;
                    let window = if other == row {
                        begin
                    } else {
                        first[other_row + left] as usize
                    };
                    let most = found + (end - begin) * (last - window);
                    if close.len() < most {
                        close.resize(2 * most + 64, [0; 2]);
                    }
                    for ball in begin..end {
                        let from = if other == row { ball + 1 } else { window };
                        let (x, z) = (xs[ball], zs[ball]);
                        let window = xs[from..last].iter().zip(&zs[from..last]);
                        for (other, (x2, z2)) in (from as u32..).zip(window) {
                            let (dx, dz) = (x2 - x, z2 - z);
                            // Written always, kept when near: a branch would be guessed wrongly half the time.
                            close[found] = [ball as u32, other];
                            found += usize::from(dx * dx + dz * dz < reach);
                        }
                    }
                }
            }
        }
        close.truncate(found);
    }

    /// Keeps of the close pairs those that certainly or perhaps meet, without a division and without a root.
    fn sieve(&mut self, stretch: &Stretch) {
        let length = stretch.length;
        let reach = 2.0 * stretch.ball.radius;
        // Two balls that both bend stay this close to straight lines.
        let margin = if B::BENDS {
            self.bend * length * length
        } else {
            0.0
        };
        let wide = (reach + margin) * (1.0 + MARGIN);
        let wide = wide * wide;
        let mut kept = 0;
        for k in 0..self.close.len() {
            let pair = self.close[k];
            let (a, b) = (
                &self.bodies[pair[0] as usize],
                &self.bodies[pair[1] as usize],
            );
            let offset = b.position(0.0) - a.position(0.0);
            let velocity = b.velocity(0.0) - a.velocity(0.0);
            let gap = offset.length_squared() - wide;
            let slope = offset.dot(velocity);
            let square = velocity.length_squared();
            let end = gap + length * (2.0 * slope + square * length);
            let passes = gap * square > slope * slope || -slope >= square * length;
            let meets = gap <= 0.0 || slope < 0.0 && (end <= 0.0 || !passes);
            self.close[kept] = pair;
            kept += usize::from(meets);
        }
        self.close.truncate(kept);
    }

    /// Finds the contacts of one ball with all others from this time on.
    pub(super) fn scan(&mut self, stretch: &Stretch, ball: u32, time: f64) {
        let index = ball as usize;
        let age = time - self.since[index];
        let left = stretch.length - time;
        let body = self.bodies[index];
        let middle = body.position(age + 0.5 * left);
        let reach = 2.0 * stretch.ball.radius + self.slack + Self::extent(&body, age, left);
        let reach = reach * (1.0 + MARGIN);
        let at = |place: DVec2| (place - self.least) * self.per_cell;
        // The casts saturate: cells at the edge reach to infinity.
        let column = |x: f64| (x as usize).min(self.columns - 1);
        let row = |z: f64| (z as usize).min(self.rows - 1);
        let (low, high) = (at(middle - reach), at(middle + reach));
        let (left, right) = (column(low.x), column(high.x));
        let (low, high) = (row(low.y), row(high.y));
        let square = reach * reach;
        let mut near = std::mem::take(&mut self.near);
        near.clear();
        for row in low..=high {
            let (from, to) = (row * self.columns + left, row * self.columns + right + 1);
            let (begin, end) = (self.first[from] as usize, self.first[to] as usize);
            let window = self.x[begin..end].iter().zip(&self.z[begin..end]);
            for (other, (x, z)) in (begin as u32..).zip(window) {
                let (dx, dz) = (x - middle.x, z - middle.y);
                if dx * dx + dz * dz < square {
                    near.push(other);
                }
            }
            for &head in &self.heads[from..to] {
                let mut other = head;
                while other != END {
                    if self.middles[other as usize].distance_squared(middle) < square {
                        near.push(other);
                    }
                    other = self.next[other as usize];
                }
            }
        }
        for &other in &near {
            if other != ball {
                self.find_pair(stretch, ball, other, time);
            }
        }
        self.near = near;
        for k in 0..self.fast.len() {
            if self.fast[k] != ball {
                self.find_pair(stretch, ball, self.fast[k], time);
            }
        }
    }

    /// Finds when two balls meet. Most pass each other, which is told without a division and without a root.
    #[inline]
    pub(super) fn find_pair(&mut self, stretch: &Stretch, one: u32, other: u32, time: f64) {
        let (i, j) = (one as usize, other as usize);
        let (a, b) = (&self.bodies[i], &self.bodies[j]);
        let ages = [time - self.since[i], time - self.since[j]];
        let left = stretch.length - time;
        let offset = b.position(ages[1]) - a.position(ages[0]);
        let velocity = b.velocity(ages[1]) - a.velocity(ages[0]);
        // Two balls that both bend stay this close to straight lines.
        let margin = if B::BENDS {
            self.bend * left * left
        } else {
            0.0
        };
        let wide = (2.0 * stretch.ball.radius + margin) * (1.0 + MARGIN);
        let gap = offset.length_squared() - wide * wide;
        if gap > 0.0 {
            let slope = offset.dot(velocity);
            if slope >= 0.0 {
                return;
            }
            let square = velocity.length_squared();
            let end = gap + left * (2.0 * slope + square * left);
            let passes = gap * square > slope * slope;
            if end > 0.0 && (passes || -slope >= square * left) {
                return;
            }
        }
        self.meet(stretch, i, j, time);
    }

    /// Finds when two balls meet that are likely to.
    #[inline(never)]
    fn meet(&mut self, stretch: &Stretch, one: usize, other: usize, time: f64) {
        let in_order = self.origins[one].number < self.origins[other].number;
        let (i, j) = if in_order { (one, other) } else { (other, one) };
        let (a, b) = (&self.bodies[i], &self.bodies[j]);
        let ages = [time - self.since[i], time - self.since[j]];
        let (one, two) = (track(a, ages[0]), track(b, ages[1]));
        let mut left = stretch.length - time;
        if B::BENDS {
            left = left
                .min(a.left() - ages[0])
                .min(b.left() - ages[1])
                .max(0.0);
        }
        let reach = 2.0 * stretch.ball.radius;
        if time == 0.0 {
            let overlap = reach - (two.position - one.position).length();
            self.tally.overlap = self.tally.overlap.max(overlap);
        }
        let met = self.impacts[i].max(self.impacts[j]);
        if met > IMPACTS || B::BENDS && !(a.translates() || b.translates()) {
            return;
        }
        let rattles = met >= BOUNCES;
        let met = contact::pair(&one, &two, reach, left);
        if let Some(mut met) = found(&mut self.failure, &self.origins[i], met) {
            if rattles {
                // A ball that rattles between others meets them at most so often.
                met = met.max(stretch.length / RATTLES);
                if time + met > stretch.length {
                    return;
                }
            }
            let (first, second) = (self.origins[i].number, self.origins[j].number);
            self.calendar.push(Contact {
                time: time + met,
                order: Contact::order(2, second, first),
                ball: i as u32,
                kind: Kind::Ball(j as u32),
                versions: [self.versions[i], self.versions[j]],
            });
        }
    }

    /// Finds the cushions that each ball can meet.
    pub(super) fn collide_cushions(&mut self, stretch: &Stretch) {
        let extent = DVec2::new(self.columns as f64, self.rows as f64) / self.per_cell;
        let slack = DVec2::splat(self.slack);
        if !stretch
            .walls
            .any(self.least - slack, self.least + extent + slack)
        {
            return;
        }
        let half = 0.5 * stretch.length;
        for ball in 0..self.bodies.len() {
            if !stretch.walls.is_clear(self.bodies[ball].position(half)) {
                self.find_cushions(stretch, ball as u32, 0.0);
            }
        }
    }

    /// Finds the cushions that a ball meets from this time on.
    pub(super) fn find_cushions(&mut self, stretch: &Stretch, ball: u32, time: f64) {
        let i = ball as usize;
        let body = &self.bodies[i];
        let age = time - self.since[i];
        let mut left = stretch.length - time;
        let middle = body.position(age + 0.5 * left);
        if stretch.walls.is_clear(middle) {
            return;
        }
        let near = stretch.walls.near(middle);
        if near.is_empty() || !body.translates() {
            return;
        }
        left = left.min(body.left() - age).max(0.0);
        let path = track(body, age);
        let reach = stretch.table.reach(stretch.ball.radius);
        for listed in near {
            let index = stretch.walls.cushion(listed);
            let met = match &stretch.table.cushions[index as usize] {
                Cushion::Line(line) => contact::line(&path, line, reach, left),
                Cushion::Arc(arc) => contact::arc(&path, arc, reach, left),
            };
            let origin = &self.origins[i];
            if let Some(met) = found(&mut self.failure, origin, met) {
                self.calendar.push(Contact {
                    time: time + met,
                    order: Contact::order(1, index, origin.number),
                    ball,
                    kind: Kind::Cushion(index),
                    versions: [self.versions[i]; 2],
                });
            }
        }
    }

    /// Notes when the kind of motion of a ball changes, if it does in this stretch.
    pub(super) fn find_change(&mut self, stretch: &Stretch, ball: u32) {
        let i = ball as usize;
        let time = self.since[i] + self.bodies[i].left();
        if time <= stretch.length {
            self.calendar.push(Contact {
                time,
                order: Contact::order(0, 0, self.origins[i].number),
                ball,
                kind: Kind::Change,
                versions: [self.versions[i]; 2],
            });
        }
    }
}

/// The path of a ball seen from `age` seconds after it began. The heights of equal balls are equal.
#[inline]
fn track<B: Body>(body: &B, age: f64) -> Track {
    let space = |v: DVec2| DVec3::new(v.x, 0.0, v.y);
    Track {
        position: space(body.position(age)),
        velocity: space(body.velocity(age)),
        acceleration: space(body.acceleration()),
    }
}

/// The time found; the failure of the ball with the lowest number is kept.
#[inline]
fn found(
    failure: &mut Option<(u32, RootError)>,
    origin: &Origin,
    result: Result<Option<f64>, RootError>,
) -> Option<f64> {
    result.unwrap_or_else(|error| {
        if failure.is_none_or(|(number, _)| origin.number < number) {
            *failure = Some((origin.number, error));
        }
        None
    })
}
