//! Many balls at once: at random places, on a lattice, in a triangle.

use std::collections::HashSet;

use glam::{DVec2, DVec3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::scene::{Scene, SceneBall, within};
use crate::scenarios::file::error::{FieldError, LayoutError};
use crate::scenarios::file::memory;

/// So many balls where they overlap nothing. The same seed gives the same balls on every platform.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Fill {
    count: u32,
    #[serde(default)]
    order: Order,
    #[serde(default = "Fill::default_seed")]
    seed: u64,
    /// Speed of every ball in m/s, each in a direction of its own.
    #[serde(default)]
    speed: f64,
    /// Largest spin about each axis, rad/s.
    #[serde(default)]
    spin: f64,
    /// Least distance between balls in m.
    #[serde(default = "Fill::default_gap")]
    gap: f64,
    /// The rectangle of the table that is filled at random or by a lattice, its least and greatest x and z in m; absent is
    /// the whole table.
    #[serde(default)]
    within: Option<((f64, f64), (f64, f64))>,
    /// Least and greatest mass, kg; absent is the mass of the file's `ball`.
    #[serde(default)]
    masses: Option<(f64, f64)>,
    /// Least and greatest radius, m; absent is the radius of the file's `ball`.
    #[serde(default)]
    radii: Option<(f64, f64)>,
}

/// How the balls of a fill lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
enum Order {
    /// Anywhere.
    #[default]
    Random,
    /// One in each cell of a square lattice over the whole table, anywhere in its cell, row by row.
    Lattice,
    /// In rows that grow towards +x, the first ball on the foot spot, `gap` apart.
    Triangle,
}

/// Throws at random places before a table counts as full.
const THROWS: u32 = 20_000;

impl Fill {
    fn default_seed() -> u64 {
        1
    }

    fn default_gap() -> f64 {
        1e-6
    }

    /// Adds the balls, named by the free numbers from 1 on.
    pub(super) fn place(&self, scene: &mut Scene, default: Ball) -> Result<(), LayoutError> {
        self.check(default)?;
        self.check_room(scene, default)?;
        self.check_memory(memory::available())?;
        let mut rng = ChaCha8Rng::seed_from_u64(self.seed);
        let largest = self.radii.map_or(default.radius, |(_, most)| most);
        let largest = scene
            .balls
            .iter()
            .map(|ball| ball.ball.radius)
            .fold(largest, f64::max);
        let mut room = Room::new(scene, 2.0 * largest + self.gap);
        let taken: HashSet<String> = scene.balls.iter().map(|ball| ball.name.clone()).collect();
        let mut names = (1..=u64::MAX)
            .map(|i| i.to_string())
            .filter(|name| !taken.contains(name));
        for placed in 0..self.count {
            let ball = Ball {
                mass: within_range(&mut rng, self.masses, default.mass),
                radius: within_range(&mut rng, self.radii, default.radius),
                spins: default.spins,
            };
            let throws = if self.order == Order::Triangle {
                1
            } else {
                THROWS
            };
            let place = (0..throws).find_map(|_| {
                let jitter = DVec2::new(signed(&mut rng), signed(&mut rng));
                let point = self.point(scene, ball.radius, placed, jitter);
                room.is_free(scene, point, ball.radius, self.gap)
                    .then_some(point)
            });
            let (Some(place), Some(name)) = (place, names.next()) else {
                let count = self.count;
                return Err(FieldError::NoRoom { count, placed }.into());
            };
            let angle = std::f64::consts::PI * signed(&mut rng);
            let velocity = self.speed * DVec3::new(libm::cos(angle), 0.0, libm::sin(angle));
            let spin = DVec3::from_array(std::array::from_fn(|_| self.spin * signed(&mut rng)));
            let mut state = State {
                velocity,
                angular_velocity: if ball.spins { spin } else { DVec3::ZERO },
                ..State::at_rest(DVec3::new(place.x, ball.radius, place.y))
            };
            state.motion = scene.laws.motion.classify(&ball, state).motion;
            scene.balls.push(SceneBall { name, ball, state });
            room.take(place, scene.balls.len() - 1);
        }
        Ok(())
    }

    /// Where the ball of this index is tried; `jitter` from -1 to 1.
    fn point(&self, scene: &Scene, radius: f64, index: u32, jitter: DVec2) -> DVec2 {
        let whole = 0.5 * DVec2::new(scene.table.length, scene.table.width);
        let (least, most) = self.within.map_or((-whole, whole), |((x0, z0), (x1, z1))| {
            (DVec2::new(x0, z0), DVec2::new(x1, z1))
        });
        let (size, middle) = (most - least, 0.5 * (least + most));
        let index = f64::from(index);
        match self.order {
            Order::Random => middle + jitter * (0.5 * size - radius).max(DVec2::ZERO),
            Order::Lattice => {
                let columns = (f64::from(self.count) * size.x / size.y).sqrt().ceil();
                let rows = (f64::from(self.count) / columns).ceil();
                let cell = size / DVec2::new(columns, rows);
                let place = DVec2::new(index % columns, (index / columns).floor()) + 0.5;
                let free = (0.5 * cell - radius).max(DVec2::ZERO);
                least + place * cell + jitter * free
            }
            Order::Triangle => {
                let row = ((8.0 * index + 1.0).sqrt() * 0.5 - 0.5).floor();
                let column = index - 0.5 * row * (row + 1.0);
                let pitch = 2.0 * radius + 1.01 * self.gap;
                let place = DVec2::new(0.75_f64.sqrt() * row, column - 0.5 * row);
                scene.table.foot_spot() + pitch * place
            }
        }
    }

    /// Refuses what cannot lie on the table in any order, before anything is allocated for it.
    fn check_room(&self, scene: &Scene, default: Ball) -> Result<(), LayoutError> {
        let radius = self.radii.map_or(default.radius, |(least, _)| least);
        let covered = f64::from(self.count) * std::f64::consts::PI * radius * radius;
        let room = match self.within {
            Some(((x0, z0), (x1, z1))) if self.order != Order::Triangle => (x1 - x0) * (z1 - z0),
            _ => scene.table.length * scene.table.width,
        };
        if covered > room {
            let count = self.count;
            let most = room / (std::f64::consts::PI * radius * radius);
            return Err(FieldError::Crowded {
                count,
                most: most as u32,
            }
            .into());
        }
        Ok(())
    }

    /// Refuses more balls than there is memory for, where the system tells how much there is.
    fn check_memory(&self, available: Option<u64>) -> Result<(), LayoutError> {
        let need = u64::from(self.count) * memory::BALL;
        match available {
            Some(available) if need > available => {
                let count = self.count;
                Err(FieldError::NoMemory {
                    count,
                    need,
                    available,
                }
                .into())
            }
            _ => Ok(()),
        }
    }

    fn check(&self, default: Ball) -> Result<(), LayoutError> {
        within("fill.count", f64::from(self.count), 0.0, 1e8)?;
        within("fill.speed", self.speed, 0.0, 1e3)?;
        within("fill.spin", self.spin, 0.0, 1e5)?;
        within("fill.gap", self.gap, 0.0, 1.0)?;
        within("ball.radius", default.radius, 1e-6, 1e3)?;
        within("ball.mass", default.mass, 1e-9, 1e9)?;
        if let Some((from, to)) = self.within {
            for (field, least, most) in [
                ("fill.within (x)", from.0, to.0),
                ("fill.within (z)", from.1, to.1),
            ] {
                within(field, least, -1e4, 1e4)?;
                within(field, most, -1e4, 1e4)?;
                if least > most {
                    return Err(FieldError::EmptyRange { field, least, most }.into());
                }
            }
        }
        for (field, range, least, most) in [
            ("fill.masses", self.masses, 1e-9, 1e9),
            ("fill.radii", self.radii, 1e-6, 1e3),
        ] {
            let Some((first, last)) = range else { continue };
            within(field, first, least, most)?;
            within(field, last, least, most)?;
            if first > last {
                return Err(FieldError::EmptyRange {
                    field,
                    least: first,
                    most: last,
                }
                .into());
            }
        }
        Ok(())
    }
}

/// A number between -1 and 1.
fn signed(rng: &mut ChaCha8Rng) -> f64 {
    2.0 * rng.random::<f64>() - 1.0
}

fn within_range(rng: &mut ChaCha8Rng, range: Option<(f64, f64)>, default: f64) -> f64 {
    range.map_or(default, |(least, most)| {
        least + (most - least) * rng.random::<f64>()
    })
}

/// The balls by cells at least as wide as two balls, so that a throw asks its neighbours only.
struct Room {
    cell: f64,
    columns: usize,
    rows: usize,
    corner: DVec2,
    cells: Vec<Vec<usize>>,
}

impl Room {
    /// Most cells along one side.
    const MOST: f64 = 1000.0;

    fn new(scene: &Scene, reach: f64) -> Self {
        let size = DVec2::new(scene.table.length, scene.table.width);
        let cell = reach.max(size.max_element() / Self::MOST);
        let (columns, rows) = ((size.x / cell) as usize + 1, (size.y / cell) as usize + 1);
        let mut room = Self {
            cell,
            columns,
            rows,
            corner: -0.5 * size,
            cells: vec![Vec::new(); columns * rows],
        };
        for (i, ball) in scene.balls.iter().enumerate() {
            let position = ball.state.position;
            room.take(DVec2::new(position.x, position.z), i);
        }
        room
    }

    fn column_and_row(&self, point: DVec2) -> (usize, usize) {
        // A cast of a float saturates: what lies outside counts to the edge.
        let at = (point - self.corner) / self.cell;
        (
            (at.x as usize).min(self.columns - 1),
            (at.y as usize).min(self.rows - 1),
        )
    }

    fn take(&mut self, point: DVec2, ball: usize) {
        let (column, row) = self.column_and_row(point);
        self.cells[row * self.columns + column].push(ball);
    }

    fn is_free(&self, scene: &Scene, point: DVec2, radius: f64, gap: f64) -> bool {
        let clear_of_table = scene
            .table
            .cushions
            .iter()
            .all(|nose| nose.nearest(point).0 >= scene.table.reach(radius))
            && scene
                .table
                .pockets
                .iter()
                .all(|p| (point - p.center).length() >= p.radius);
        let (column, row) = self.column_and_row(point);
        clear_of_table
            && (row.saturating_sub(1)..=(row + 1).min(self.rows - 1))
                .flat_map(|r| {
                    let columns = column.saturating_sub(1)..=(column + 1).min(self.columns - 1);
                    columns.map(move |c| r * self.columns + c)
                })
                .flat_map(|cell| &self.cells[cell])
                .all(|&i| {
                    let other = &scene.balls[i];
                    let position = other.state.position;
                    let distance = (DVec2::new(position.x, position.z) - point).length();
                    distance >= other.ball.radius + radius + gap
                })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_balls_than_memory_are_refused_with_numbers() {
        let fill = Fill {
            count: 5_000_000,
            order: Order::Random,
            seed: 1,
            speed: 0.0,
            spin: 0.0,
            gap: 1e-6,
            within: None,
            masses: None,
            radii: None,
        };
        assert!(fill.check_memory(None).is_ok());
        assert!(fill.check_memory(Some(1 << 40)).is_ok());
        let Err(LayoutError::Field(refusal)) = fill.check_memory(Some(1 << 30)) else {
            panic!("10 GB do not fit into 1");
        };
        let text = refusal.to_string();
        assert!(text.contains("fill.count: 5000000"), "{text}");
        assert!(memory::available().is_none_or(|bytes| bytes > 1 << 20));
    }
}
