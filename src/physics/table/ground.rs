//! What is below a point of the table.

use glam::DVec2;

use crate::physics::table::{Cushion, Pocket, Table};

/// What a ball that comes down would meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// The slate, the shelf of a pocket included.
    Slate,
    /// The hole of this pocket.
    Hole(usize),
    /// A rail, or the floor beyond it.
    Off,
}

/// How far the rails reach beyond the noses, m.
pub const RAIL: f64 = 0.15;

/// Height of the floor over the slate, m.
pub const FLOOR: f64 = -0.76;

/// A ball whose centre stands this near to the edge of a pocket in m has passed it: rounding of the time at which it does.
const EDGE: f64 = 1e-9;

impl Table {
    /// What is below a point, x and z in m.
    #[must_use]
    pub fn ground(&self, point: DVec2) -> Ground {
        let within = |pocket: &Pocket, radius: f64| point.distance(pocket.center) < radius;
        let over = |factor: f64| {
            self.pockets
                .iter()
                .position(|pocket| within(pocket, factor * pocket.radius + EDGE))
        };
        if let Some(pocket) = over(1.0) {
            return Ground::Hole(pocket);
        }
        let half = 0.5 * DVec2::new(self.length, self.width);
        if point.abs().cmple(half).all() {
            return Ground::Slate;
        }
        // Behind the line of the noses only the shelves of the pockets are slate: what the hole sees past its facings.
        let is_shelf = over(2.5).is_some_and(|pocket| {
            let center = self.pockets[pocket].center;
            // Behind the hole there is wood.
            (point - center).dot(self.outward(center)) <= 0.0
                && !self.cushions.iter().any(|cushion| match cushion {
                    Cushion::Line(line) => {
                        let (from, to) = self.facing(line.from, line.to);
                        crosses(center, point, from, to)
                    }
                    Cushion::Arc(arc) => {
                        let way = point - center;
                        let share = (arc.center - center).dot(way) / way.length_squared();
                        (center + share.clamp(0.0, 1.0) * way).distance(arc.center) < arc.radius
                    }
                })
        });
        if is_shelf { Ground::Slate } else { Ground::Off }
    }

    /// A stretch of nose, drawn out by [`RAIL`] where it leads away from the playing surface: what is beside the throat of a
    /// pocket is wood.
    fn facing(&self, from: DVec2, to: DVec2) -> (DVec2, DVec2) {
        let further = RAIL * (to - from).normalize_or_zero();
        let (here, there) = (self.beyond(from), self.beyond(to));
        if there > here {
            (from, to + further)
        } else if here > there {
            (from - further, to)
        } else {
            (from, to)
        }
    }

    /// Unit vector in plan from the playing surface to a point beyond it; zero inside.
    #[must_use]
    pub fn outward(&self, point: DVec2) -> DVec2 {
        let half = 0.5 * DVec2::new(self.length, self.width);
        (point - point.clamp(-half, half)).normalize_or_zero()
    }

    /// Distance in plan in m from a point to the playing surface.
    #[must_use]
    pub fn beyond(&self, point: DVec2) -> f64 {
        let half = 0.5 * DVec2::new(self.length, self.width);
        (point.abs() - half).max(DVec2::ZERO).length()
    }
}

/// Whether two stretches cross.
fn crosses(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> bool {
    let (one, two) = (b - a, d - c);
    let apart = |x: f64, y: f64| (x > 0.0) != (y > 0.0);
    apart(one.perp_dot(c - a), one.perp_dot(d - a))
        && apart(two.perp_dot(a - c), two.perp_dot(b - c))
}
