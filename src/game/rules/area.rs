//! Where the cue ball may be put down.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::game::placing;
use crate::physics::scene::Scene;
use crate::physics::table::Table;

/// A line of the table belongs to the area it bounds, this many m beyond it included: rounding.
const EDGE: f64 = 1e-9;

/// Points along each side of an area that are looked at for a free one.
const SPOTS: u32 = 48;

/// A part of the cloth, as data: to draw, and to ask.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Area {
    /// Between two corners, x and z in m.
    Rectangle {
        /// The corner with the smaller coordinates.
        least: DVec2,
        /// The corner with the greater coordinates.
        most: DVec2,
    },
    /// The half of a disc that lies towards the head of the table: the D of a snooker table.
    HalfDisc {
        /// Middle of its straight side, m.
        center: DVec2,
        /// Radius in m.
        radius: f64,
    },
}

impl Area {
    /// The whole playing surface.
    #[must_use]
    pub fn anywhere(table: &Table) -> Self {
        let half = 0.5 * DVec2::new(table.length, table.width);
        Self::Rectangle {
            least: -half,
            most: half,
        }
    }

    /// Behind the head string, a quarter of the length from the head.
    #[must_use]
    pub fn behind_head_string(table: &Table) -> Self {
        let half = 0.5 * DVec2::new(table.length, table.width);
        Self::Rectangle {
            least: -half,
            most: DVec2::new(table.head_spot().x, half.y),
        }
    }

    /// The D of a snooker table.
    #[must_use]
    pub fn in_d(table: &Table) -> Self {
        Self::HalfDisc {
            center: table.baulk_spot(),
            radius: table.d_radius(),
        }
    }

    /// Whether a ball whose centre is above this point, x and z in m, lies in the area. Other balls are not looked at: see
    /// [`Self::is_legal`].
    #[must_use]
    pub fn allows(&self, point: DVec2) -> bool {
        match *self {
            Self::Rectangle { least, most } => {
                point.cmpge(least - EDGE).all() && point.cmple(most + EDGE).all()
            }
            Self::HalfDisc { center, radius } => {
                point.x <= center.x + EDGE && point.distance(center) <= radius + EDGE
            }
        }
    }

    /// The point of the area nearest to a point.
    #[must_use]
    pub fn nearest(&self, point: DVec2) -> DVec2 {
        match *self {
            Self::Rectangle { least, most } => point.clamp(least, most),
            Self::HalfDisc { center, radius } => {
                let offset = point - center;
                if offset.x > 0.0 {
                    return center + DVec2::new(0.0, offset.y.clamp(-radius, radius));
                }
                center + offset.clamp_length_max(radius)
            }
        }
    }

    /// Whether this ball of the scene may be put down there: inside the area, on no other ball and in no cushion.
    #[must_use]
    pub fn is_legal(&self, scene: &Scene, ball: usize, point: DVec2) -> bool {
        self.allows(point) && placing::is_free(scene, ball, point)
    }

    /// A legal place for this ball of the scene near to a wish; `None` if the area is full.
    #[must_use]
    pub fn place(&self, scene: &Scene, ball: usize, wish: DVec2) -> Option<DVec2> {
        let wish = self.nearest(wish);
        let free = placing::nearest_free(scene, ball, wish)?;
        if self.allows(free) {
            return Some(free);
        }
        // The nearest free spot lies outside.
        self.spots(wish)
            .into_iter()
            .find(|spot| placing::is_free(scene, ball, *spot))
    }

    /// Where a ball in hand is offered to a player: in the open, near to the head spot, or in the D between brown and yellow.
    #[must_use]
    pub fn start(&self, scene: &Scene, ball: usize) -> Option<DVec2> {
        let wish = match *self {
            Self::Rectangle { .. } => self.nearest(scene.table.head_spot()),
            Self::HalfDisc { center, radius } => center + DVec2::new(0.0, 0.5 * radius),
        };
        let mut spots = vec![wish];
        spots.extend(self.spots(wish));
        spots
            .into_iter()
            .find(|spot| placing::is_free(scene, ball, *spot))
            .or_else(|| self.place(scene, ball, wish))
    }

    /// Points all over the area, nearest to a wish first.
    fn spots(&self, wish: DVec2) -> Vec<DVec2> {
        let (least, most) = self.bounds();
        let mut spots: Vec<DVec2> = (0..=SPOTS)
            .flat_map(|i| (0..=SPOTS).map(move |j| DVec2::new(f64::from(i), f64::from(j))))
            .map(|share| least + share / f64::from(SPOTS) * (most - least))
            .filter(|spot| self.allows(*spot))
            .collect();
        spots.sort_by(|a, b| {
            a.distance_squared(wish)
                .total_cmp(&b.distance_squared(wish))
        });
        spots
    }

    /// Smallest rectangle that holds the area, as (least, greatest) corner.
    #[must_use]
    pub fn bounds(&self) -> (DVec2, DVec2) {
        match *self {
            Self::Rectangle { least, most } => (least, most),
            Self::HalfDisc { center, radius } => (
                center - DVec2::splat(radius),
                center + DVec2::new(0.0, radius),
            ),
        }
    }
}
