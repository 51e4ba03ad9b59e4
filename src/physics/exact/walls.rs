//! Cushions and pockets as the solver sees them: with boxes, so that most are ruled out by four comparisons.

use glam::DVec2;

use crate::physics::contact::Track;
use crate::physics::table::Table;

/// A box in plan.
#[derive(Clone, Copy, Debug)]
pub(super) struct Area {
    pub(super) least: DVec2,
    pub(super) most: DVec2,
}

impl Area {
    pub(super) fn grown(self, by: f64) -> Self {
        Self {
            least: self.least - DVec2::splat(by),
            most: self.most + DVec2::splat(by),
        }
    }

    pub(super) fn meets(&self, other: &Self) -> bool {
        self.least.x <= other.most.x
            && other.least.x <= self.most.x
            && self.least.y <= other.most.y
            && other.least.y <= self.most.y
    }

    fn holds(&self, other: &Self) -> bool {
        self.least.x < other.least.x
            && other.most.x < self.most.x
            && self.least.y < other.least.y
            && other.most.y < self.most.y
    }

    /// The box of the path of a centre until `time`, which must be finite.
    pub(super) fn of_path(track: &Track, time: f64) -> Self {
        let (x_least, x_most) = range(
            track.position.x,
            track.velocity.x,
            track.acceleration.x,
            time,
        );
        let (z_least, z_most) = range(
            track.position.z,
            track.velocity.z,
            track.acceleration.z,
            time,
        );
        Self {
            least: DVec2::new(x_least, z_least),
            most: DVec2::new(x_most, z_most),
        }
    }
}

/// The range of p + v t + a t²/2 for t in [0, time].
fn range(p: f64, v: f64, a: f64, time: f64) -> (f64, f64) {
    let end = p + time * (v + 0.5 * time * a);
    let (mut least, mut most) = if end < p { (end, p) } else { (p, end) };
    // It turns round inside if the velocity changes its sign.
    if v * (v + time * a) < 0.0 {
        let turn = p - 0.5 * v * v / a;
        least = least.min(turn);
        most = most.max(turn);
    }
    (least, most)
}

/// What does not move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wall {
    Cushion(u32),
    Pocket(u32),
}

/// All cushions and pockets of a table.
#[derive(Clone, Debug)]
pub(super) struct Walls {
    /// What, and the box in which the centre of the largest ball is when it touches; the long ones first.
    pub(super) list: Vec<(Wall, Area)>,
    /// No centre inside this box touches anything.
    open: Area,
}

impl Walls {
    pub(super) fn new(table: &Table, radius: f64) -> Self {
        let mut list: Vec<(Wall, Area)> =
            Vec::with_capacity(table.cushions.len() + table.pockets.len());
        for (index, cushion) in table.cushions.iter().enumerate() {
            let (least, most) = cushion.bounds();
            list.push((
                Wall::Cushion(index as u32),
                Area { least, most }.grown(1.001 * radius),
            ));
        }
        for (index, pocket) in table.pockets.iter().enumerate() {
            let area = Area {
                least: pocket.center,
                most: pocket.center,
            };
            list.push((
                Wall::Pocket(index as u32),
                area.grown(1.001 * pocket.radius),
            ));
        }
        // Long noses rule out most of the rest.
        let is_long =
            |(_, area): &(Wall, Area)| (area.most - area.least).max_element() > 8.0 * radius;
        let (mut list, short): (Vec<_>, Vec<_>) = list.into_iter().partition(is_long);
        list.extend(short);
        let half = DVec2::new(0.5 * table.length, 0.5 * table.width);
        let mut open = Area {
            least: -half,
            most: half,
        };
        for (_, area) in &list {
            open = cut(open, area);
        }
        Self { list, open }
    }

    /// A box in which nothing is touched.
    pub(super) fn open(&self) -> &Area {
        &self.open
    }

    /// Whether a path with this box touches nothing.
    pub(super) fn is_open(&self, path: &Area) -> bool {
        self.open.holds(path)
    }
}

/// The largest box inside `open` on one side of `area`.
fn cut(open: Area, area: &Area) -> Area {
    if !open.meets(area) {
        return open;
    }
    let mut best = open;
    let mut most = -1.0;
    for side in 0..4 {
        let mut part = open;
        match side {
            0 => part.most.x = area.least.x,
            1 => part.least.x = area.most.x,
            2 => part.most.y = area.least.y,
            _ => part.least.y = area.most.y,
        }
        let size = (part.most - part.least).max(DVec2::ZERO);
        if size.x * size.y > most {
            most = size.x * size.y;
            best = part;
        }
    }
    best
}
