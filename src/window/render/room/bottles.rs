//! Bottles on lit shelves: what is where, and in which colour. The wall is painted with them for mirrors, the bar is
//! built of them for the eye.

use bevy::prelude::*;

use crate::window::render::room::walls::{bump, smooth};

/// Half its length, m.
pub(super) const WIDE: f32 = 1.9;
/// Height of the lowest shelf above the floor, and from one shelf to the next, m.
pub(super) const LOWEST: f32 = 1.12;
pub(super) const STEP: f32 = 0.42;
/// How many shelves there are.
pub(super) const SHELVES: u8 = 3;
/// Length of wall for each bottle, m.
pub(super) const CELL: f32 = 0.105;
/// Thickness of a shelf, m.
pub(super) const BOARD: f32 = 0.022;
/// Dark wood, and brass: linear.
pub(super) const WOOD: Vec3 = Vec3::new(0.045, 0.018, 0.009);
pub(super) const BRASS: Vec3 = Vec3::new(0.60, 0.38, 0.13);

/// A bottle.
pub(super) struct Bottle {
    /// Its middle along the wall, its height, half its width and that of its neck, m.
    pub along: f32,
    pub tall: f32,
    pub half: f32,
    neck: f32,
    tint: Vec3,
    has_label: bool,
}

impl Bottle {
    /// The one in a cell of a shelf, if there is one.
    pub fn of(shelf: f32, cell: f32) -> Option<Self> {
        let chance = |salt: f32| {
            let x = libm::sinf(cell * 12.9898 + shelf * 78.233 + salt * 37.719) * 43_758.547;
            x - x.floor()
        };
        if chance(3.0) < 0.12 {
            return None;
        }
        Some(Self {
            along: CELL * (cell + 0.5) + 0.012 * (chance(1.0) - 0.5),
            tall: 0.20 + 0.15 * chance(2.0),
            half: 0.030 + 0.014 * chance(4.0),
            neck: 0.010,
            tint: match (chance(5.0) * 6.0) as u32 {
                0 => Vec3::new(0.10, 0.42, 0.12),
                1 => Vec3::new(0.75, 0.28, 0.04),
                2 => Vec3::new(0.80, 0.74, 0.62),
                3 => Vec3::new(0.10, 0.26, 0.55),
                4 => Vec3::new(0.50, 0.05, 0.03),
                _ => Vec3::new(0.42, 0.17, 0.03),
            },
            has_label: chance(6.0) > 0.35,
        })
    }

    /// Half its width at a share of its height.
    pub fn radius(&self, share: f32) -> f32 {
        match share {
            s if s < 0.60 => self.half,
            s if s < 0.74 => self.half + (self.neck - self.half) * (s - 0.60) / 0.14,
            s if s < 1.0 => self.neck,
            _ => 0.0,
        }
    }

    /// Its colour at a share of its height and of its width there, from −1 to 1, before this light.
    pub fn colour(&self, share: f32, across: f32, back: Vec3, edge: f32) -> Vec3 {
        if share > 0.93 {
            return 0.25 * self.tint;
        }
        let round = 1.0 - across * across;
        if self.has_label && (0.14..0.42).contains(&share) {
            return Vec3::new(0.42, 0.36, 0.26) * (0.35 + 0.4 * round) * edge;
        }
        // Thick glass at the sides is dark; a lamp of the room glints on it.
        let glint = bump(across, -0.55, 0.12);
        back * self.tint * (0.55 + 1.2 * round) + Vec3::splat(0.30) * glint * self.tint
    }
}

/// The light behind the bottles this far above a shelf.
pub(super) fn glow(along: f32, height: f32) -> (Vec3, f32) {
    let edge = smooth(WIDE - along.abs(), 0.35);
    let up = libm::expf(-height * 3.2) + 0.25;
    (Vec3::new(0.80, 0.40, 0.12) * (up * edge * 0.62), edge)
}

/// Shelf and height above it.
fn shelf(up: f32) -> (f32, f32) {
    let shelf = ((up - LOWEST) / STEP).floor();
    (shelf, up - LOWEST - STEP * shelf)
}

/// The wall there without what stands before it.
pub(super) fn bare(along: f32, up: f32) -> Option<Vec3> {
    if along.abs() > WIDE + 0.12 || up > 2.52 {
        return None;
    }
    if up < 1.08 {
        let front = WOOD * (0.8 + 0.4 * bump((along / 0.95).rem_euclid(1.0), 0.5, 0.42));
        return Some(front * (0.35 + 0.65 * up) + BRASS * bump(up, 1.05, 0.012));
    }
    if along.abs() > WIDE || up > 2.42 {
        return Some(WOOD * 1.4);
    }
    let (_, height) = shelf(up);
    let (back, edge) = glow(along, height);
    if height < BOARD {
        return Some(Vec3::new(0.22, 0.11, 0.04) * (0.4 + 0.6 * edge));
    }
    Some(back)
}

/// The same with bottles, as mirrors see it.
pub(super) fn painted(along: f32, up: f32) -> Option<Vec3> {
    let bare = bare(along, up)?;
    let (shelf, height) = shelf(up);
    if !(1.08..=2.42).contains(&up) || along.abs() > WIDE || height < BOARD {
        return Some(bare);
    }
    let Some(bottle) = Bottle::of(shelf, (along / CELL).floor()) else {
        return Some(bare);
    };
    let x = along - bottle.along;
    let share = (height - BOARD) / bottle.tall;
    let half = bottle.radius(share);
    if half == 0.0 {
        return Some(bare);
    }
    if x.abs() > half {
        return Some(bare * (1.0 - 0.5 * bump(x.abs(), half, 0.006)));
    }
    Some(bottle.colour(share, x / half, bare, glow(along, height).1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_built_bottles_are_the_painted_ones() {
        let cells = (WIDE / CELL).floor();
        let mut seen = 0;
        for shelf in 0..SHELVES {
            let mut cell = -cells;
            while cell < cells {
                if let Some(bottle) = Bottle::of(f32::from(shelf), cell) {
                    let up = LOWEST + STEP * f32::from(shelf) + BOARD + 0.55 * bottle.tall;
                    assert_ne!(painted(bottle.along, up), bare(bottle.along, up));
                    seen += 1;
                }
                cell += 1.0;
            }
        }
        assert!((80..120).contains(&seen), "{seen} bottles");
    }
}
