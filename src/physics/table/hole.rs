//! The inside of a pocket in space: where a ball that is over the hole meets the rounded edge of the slate, the wall below
//! that, or the liner above it.

use glam::{DVec2, DVec3};

use crate::physics::table::{Pocket, Table};

/// Where a point is that looks at the rounded edge of a hole from inside, in the plane through the axis of the hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtEdge {
    /// How far the end of the flat lies outwards from it in m.
    inward: f64,
    /// How far it is above the circle around which the edge is rounded, m.
    up: f64,
    /// Its distance from the axis of the hole in m.
    pub from_axis: f64,
    /// Horizontal unit vector away from the axis.
    out: DVec2,
    /// Its distance from the circle around which the edge is rounded, m.
    pub length: f64,
}

impl AtEdge {
    /// Speed in m/s at which the distance from the edge grows.
    #[must_use]
    pub fn speed(&self, velocity: DVec3) -> f64 {
        let out = self.out.dot(DVec2::new(velocity.x, velocity.z));
        (self.up * velocity.y - self.inward * out) / self.length.max(1e-12)
    }

    /// Unit vector from the edge to the point.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        (self.inward * self.away() + self.up * DVec3::Y).normalize_or_zero()
    }

    /// Horizontal unit vector from the point to the axis of the hole.
    #[must_use]
    pub fn away(&self) -> DVec3 {
        -DVec3::new(self.out.x, 0.0, self.out.y)
    }

    /// How hollow in 1/m the edge is for a point that runs along it: its square speed times this is the acceleration at which
    /// it closes.
    #[must_use]
    pub fn hollow(&self) -> f64 {
        (self.inward / (self.length * self.from_axis).max(1e-12)).max(0.0)
    }
}

impl Pocket {
    /// Where a point is that looks at the edge of the hole, which is rounded with `edge` m. The flat of the slate ends at the
    /// radius of the pocket.
    #[must_use]
    pub fn at_edge(&self, edge: f64, position: DVec3) -> AtEdge {
        let offset = DVec2::new(position.x, position.z) - self.center;
        let from_axis = offset.length();
        let (inward, up) = (self.radius - from_axis, position.y + edge);
        AtEdge {
            inward,
            up,
            from_axis,
            out: offset.normalize_or_zero(),
            length: (inward * inward + up * up).sqrt(),
        }
    }

    /// How far from the axis in m the centre of a ball of this radius can be inside the wall, which stands `edge` m behind
    /// the end of the flat.
    #[must_use]
    pub fn room(&self, edge: f64, radius: f64) -> f64 {
        (self.radius - edge - radius).max(1e-6)
    }
}

impl Table {
    /// Whether there is a wall beside the centre of a ball of this radius that is over this hole: below the edge all around,
    /// and above the slate, up to the top of the cushions, the liner on the side away from the table.
    #[must_use]
    pub fn has_wall(&self, pocket: &Pocket, edge: f64, radius: f64, position: DVec3) -> bool {
        let offset = DVec2::new(position.x, position.z) - pocket.center;
        let below = position.y <= -edge;
        let at_liner =
            offset.dot(self.outward(pocket.center)) > 0.0 && position.y < self.nose_height + radius;
        offset.length() <= pocket.radius && (below || at_liner)
    }
}
