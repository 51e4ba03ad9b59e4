//! The table in tiles: who owns which ball.

use glam::DVec2;

use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::census::Tally;
use crate::sim::stepped::crowd::patch::{Origin, Patch, Role, Stretch};

/// A ball that is in no tile.
pub(super) const NOWHERE: [u32; 2] = [u32::MAX; 2];

/// The balls of one rectangle of the table. The rectangles at the edge reach to infinity.
#[derive(Debug)]
pub(super) struct Tile<B> {
    pub least: DVec2,
    pub most: DVec2,
    pub bodies: Vec<B>,
    pub numbers: Vec<u32>,
    /// The balls near each side: towards less x, more x, less z, more z.
    sides: [Vec<u32>; 4],
    /// How far from the sides balls are listed, m; negative while the lists are out of date.
    listed: f64,
    /// Whether anything moves.
    pub moves: bool,
}

/// What became of a tile in a stretch.
#[derive(Debug)]
pub(super) struct Outcome<B> {
    /// The balls at the end, in the order of the tile; not used if the tile slept.
    pub bodies: Vec<B>,
    /// How often the path of each ball changed. In a row of touching balls a blow passes through, and those in the
    /// middle end as they began.
    pub changes: Vec<u32>,
    /// What became of the near balls of other tiles here, with the changes of their paths, their tile and slot.
    pub copies: Vec<(B, u32, [u32; 2])>,
    pub slept: bool,
    /// Whether anything moves at the end.
    pub moves: bool,
    /// Numbers of the balls that have left the tile.
    pub strays: Vec<u32>,
    pub tally: Tally,
    /// Number of the first ball that could not be followed, and why.
    pub failure: Option<(u32, crate::physics::roots::RootError)>,
}

impl<B: Body> Outcome<B> {
    /// Takes what became of one tile out of a patch.
    pub fn take(&mut self, stretch: &Stretch, patch: &Patch<B>, tile: u32, home: &Tile<B>) {
        self.slept = false;
        self.copies.clear();
        self.bodies.truncate(home.bodies.len());
        let known = self.bodies.len();
        self.bodies.extend_from_slice(&home.bodies[known..]);
        self.changes.resize(self.bodies.len(), 0);
        for (body, changes, origin) in patch.ends(stretch) {
            match origin.role {
                Role::Own if origin.tile == tile => {
                    self.bodies[origin.slot as usize] = body;
                    self.changes[origin.slot as usize] = changes;
                }
                Role::Near => self
                    .copies
                    .push((body, changes, [origin.tile, origin.slot])),
                Role::Own | Role::Far => {}
            }
        }
        self.failure = patch.failure;
        self.tally = patch.tally;
        self.moves = false;
        self.strays.clear();
        for (body, number) in self.bodies.iter().zip(&home.numbers) {
            let velocity = body.velocity(0.0);
            self.tally.energy += body.energy(&stretch.ball);
            self.tally.momentum[0] += velocity.x;
            self.tally.momentum[1] += velocity.y;
            self.tally.speed = self.tally.speed.max(velocity.length_squared());
            self.moves |= !body.is_still();
            if home.has_left(body) {
                self.strays.push(*number);
            }
        }
    }

    /// Nothing happened.
    pub fn sleep(&mut self) {
        self.slept = true;
        self.copies.clear();
        self.tally = Tally::default();
        self.failure = None;
    }
}

impl<B> Default for Outcome<B> {
    fn default() -> Self {
        Self {
            bodies: Vec::new(),
            changes: Vec::new(),
            copies: Vec::new(),
            slept: true,
            moves: false,
            strays: Vec::new(),
            tally: Tally::default(),
            failure: None,
        }
    }
}

/// All tiles.
#[derive(Debug)]
pub(super) struct Tiles<B> {
    pub all: Vec<Tile<B>>,
    pub columns: usize,
    pub rows: usize,
    least: DVec2,
    per_tile: DVec2,
    /// Tile and slot of every ball by its number.
    pub places: Vec<[u32; 2]>,
}

impl<B: Body> Tiles<B> {
    /// Empty tiles of about this side in m over a table of this size.
    pub fn new(size: DVec2, side: f64, balls: usize) -> Self {
        let count = (size / side).floor().max(DVec2::ONE);
        let (columns, rows) = (count.x as usize, count.y as usize);
        let least = -0.5 * size;
        let step = size / count;
        let line = |k: usize, count: usize, least: f64, step: f64| match k {
            0 => f64::NEG_INFINITY,
            k if k == count => f64::INFINITY,
            k => least + k as f64 * step,
        };
        let corner = |column, row| {
            DVec2::new(
                line(column, columns, least.x, step.x),
                line(row, rows, least.y, step.y),
            )
        };
        let all = (0..rows)
            .flat_map(|row| (0..columns).map(move |column| (column, row)))
            .map(|(column, row)| Tile {
                least: corner(column, row),
                most: corner(column + 1, row + 1),
                bodies: Vec::new(),
                numbers: Vec::new(),
                sides: [const { Vec::new() }; 4],
                listed: -1.0,
                moves: false,
            })
            .collect();
        Self {
            all,
            columns,
            rows,
            least,
            per_tile: step.recip(),
            places: vec![NOWHERE; balls],
        }
    }

    fn tile_at(&self, place: DVec2) -> usize {
        // The casts saturate.
        let at = (place - self.least) * self.per_tile;
        let column = (at.x as usize).min(self.columns - 1);
        let row = (at.y as usize).min(self.rows - 1);
        row * self.columns + column
    }

    /// Gives a ball to the tile it is in.
    pub fn add(&mut self, body: B, number: u32) {
        let tile = self.tile_at(body.position(0.0));
        let home = &mut self.all[tile];
        self.places[number as usize] = [tile as u32, home.bodies.len() as u32];
        home.bodies.push(body);
        home.numbers.push(number);
        home.moves |= !body.is_still();
        home.listed = -1.0;
    }

    /// The body of a ball in play.
    pub fn body(&self, number: u32) -> Option<&B> {
        let [tile, slot] = self.places[number as usize];
        self.all.get(tile as usize)?.bodies.get(slot as usize)
    }

    /// Hands every ball that has left its tile to the tile it is in.
    pub fn hand_over(&mut self, strays: &[u32]) {
        for &number in strays {
            let [tile, slot] = self.places[number as usize];
            let home = &mut self.all[tile as usize];
            let body = home.bodies.swap_remove(slot as usize);
            home.numbers.swap_remove(slot as usize);
            if let Some(&filler) = home.numbers.get(slot as usize) {
                self.places[filler as usize] = [tile, slot];
            }
            self.add(body, number);
        }
    }

    /// The tiles next to this one, with the side of each that faces it.
    pub fn around(&self, tile: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        let (column, row) = (tile % self.columns, tile / self.columns);
        let offsets = [-1_isize, 0, 1];
        offsets
            .into_iter()
            .flat_map(move |dz| offsets.into_iter().map(move |dx| (dx, dz)))
            .filter(|offset| *offset != (0, 0))
            .filter_map(move |(dx, dz)| {
                let column = column.checked_add_signed(dx)?;
                let row = row.checked_add_signed(dz)?;
                let side = match (dx, dz) {
                    (1, _) => 0,
                    (-1, _) => 1,
                    (_, 1) => 2,
                    _ => 3,
                };
                (column < self.columns && row < self.rows)
                    .then_some((row * self.columns + column, side))
            })
    }

    /// Whether anything moves in a tile or next to it.
    pub fn is_awake(&self, tile: usize) -> bool {
        self.all[tile].moves || self.around(tile).any(|(other, _)| self.all[other].moves)
    }

    /// The balls of a tile, as its own.
    pub fn own(&self, tile: usize) -> impl Iterator<Item = (&B, Origin)> + '_ {
        let home = &self.all[tile];
        (0..)
            .zip(home.bodies.iter().zip(&home.numbers))
            .map(move |(slot, (body, &number))| {
                let origin = Origin {
                    number,
                    tile: tile as u32,
                    slot,
                    role: Role::Own,
                };
                (body, origin)
            })
    }

    /// The balls of `other`, of which this side faces `tile`, that lie within `far` m of `tile`.
    pub fn halo(
        &self,
        tile: usize,
        (other, side): (usize, usize),
        near: f64,
        far: f64,
    ) -> impl Iterator<Item = (&B, Origin)> + '_ {
        let (least, most) = (self.all[tile].least, self.all[tile].most);
        let home = &self.all[other];
        home.sides[side].iter().filter_map(move |&slot| {
            let body = &home.bodies[slot as usize];
            let place = body.position(0.0);
            let distance = (least - place).max(place - most).max_element();
            (distance < far).then(|| {
                let origin = Origin {
                    number: home.numbers[slot as usize],
                    tile: other as u32,
                    slot,
                    role: if distance < near {
                        Role::Near
                    } else {
                        Role::Far
                    },
                };
                (body, origin)
            })
        })
    }
}

impl<B: Body> Tile<B> {
    /// Puts the balls on their new paths.
    pub fn commit(&mut self, outcome: &mut Outcome<B>) {
        std::mem::swap(&mut self.bodies, &mut outcome.bodies);
        self.moves = outcome.moves;
        self.listed = -1.0;
    }

    /// Whether the balls within `far` m of each side are listed.
    pub fn is_listed(&self, far: f64) -> bool {
        self.listed >= far
    }

    /// Lists the balls near each side.
    pub fn list_sides(&mut self, far: f64) {
        self.listed = far;
        let (least, most) = (self.least + far, self.most - far);
        for side in &mut self.sides {
            side.clear();
        }
        for (slot, body) in (0..).zip(&self.bodies) {
            let place = body.position(0.0);
            if place.x < least.x {
                self.sides[0].push(slot);
            }
            if place.x > most.x {
                self.sides[1].push(slot);
            }
            if place.y < least.y {
                self.sides[2].push(slot);
            }
            if place.y > most.y {
                self.sides[3].push(slot);
            }
        }
    }

    /// Whether a ball here belongs to another tile.
    pub fn has_left(&self, body: &B) -> bool {
        let place = body.position(0.0);
        place.x < self.least.x
            || place.x >= self.most.x
            || place.y < self.least.y
            || place.y >= self.most.y
    }
}
