//! The table: cushions as lines and arcs, pockets as circles, all in plan.

mod build;
mod ground;
mod hole;
mod nose;
mod peg_board;
mod presets;
mod spots;

pub use build::{Mouth, PocketedTable};
pub use ground::{FLOOR, Ground, RAIL};
pub use hole::AtEdge;
pub use nose::Nose;
pub use peg_board::PegBoard;
pub use presets::Preset;

use glam::DVec2;
use serde::{Deserialize, Serialize};

/// A straight nose line in plan, x and z in m. A wall from both sides, without end caps.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Line {
    /// One end.
    pub from: DVec2,
    /// The other end.
    pub to: DVec2,
}

impl Line {
    /// Unit normal from the line to the side on which a point lies, and its distance from the line in m; the point is given
    /// from the first end.
    #[must_use]
    pub fn side_of(&self, offset: DVec2) -> (DVec2, f64) {
        let along = self.to - self.from;
        let normal = (along / along.length()).perp();
        let gap = offset.dot(normal);
        if gap < 0.0 {
            (-normal, -gap)
        } else {
            (normal, gap)
        }
    }
}

/// A round nose in plan: a jaw, a peg, or with radius 0 the end of a line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Arc {
    /// Centre, x and z in m.
    pub center: DVec2,
    /// Radius in m.
    pub radius: f64,
}

/// One stretch of cushion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Cushion {
    /// Straight.
    Line(Line),
    /// Round.
    Arc(Arc),
}

impl Cushion {
    /// Smallest box in plan that holds the nose, as (least, greatest) corner.
    #[must_use]
    pub fn bounds(&self) -> (DVec2, DVec2) {
        match self {
            Self::Line(line) => (line.from.min(line.to), line.from.max(line.to)),
            Self::Arc(arc) => (
                arc.center - DVec2::splat(arc.radius),
                arc.center + DVec2::splat(arc.radius),
            ),
        }
    }

    /// Distance in plan from a point to the nose, and the unit vector from the nose to the point.
    #[must_use]
    pub fn nearest(&self, point: DVec2) -> (f64, DVec2) {
        let (foot, radius) = match self {
            Self::Line(line) => {
                let along = line.to - line.from;
                let offset = point - line.from;
                let share = offset.dot(along) / along.length_squared();
                if (0.0..=1.0).contains(&share) {
                    // The very normal by which contacts are found: one from the foot is off by rounding over distance,
                    // and of 80 m/s along the nose that is more than the speed at which a ball parts from it.
                    let (normal, gap) = line.side_of(offset);
                    return (gap, normal);
                }
                (line.from + share.clamp(0.0, 1.0) * along, 0.0)
            }
            Self::Arc(arc) => (arc.center, arc.radius),
        };
        let offset = point - foot;
        (offset.length() - radius, offset.normalize_or_zero())
    }
}

/// A hole in plan. A ball falls when its centre passes the edge.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pocket {
    /// What players call it.
    pub name: String,
    /// Centre, x and z in m.
    pub center: DVec2,
    /// Radius in m.
    pub radius: f64,
    /// How deep a captured ball lies below the slate, m.
    #[serde(default = "Pocket::default_depth")]
    pub depth: f64,
}

impl Pocket {
    fn default_depth() -> f64 {
        0.08
    }
}

/// A table in full.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Length of the playing surface along x in m, nose to nose.
    pub length: f64,
    /// Width of the playing surface along z in m, nose to nose.
    pub width: f64,
    /// Height of the cushion nose above the slate in m.
    pub nose_height: f64,
    /// The profile of the nose.
    #[serde(default)]
    pub nose: Nose,
    /// All cushions.
    pub cushions: Vec<Cushion>,
    /// All pockets.
    #[serde(default)]
    pub pockets: Vec<Pocket>,
}

impl Table {
    /// A closed box without pockets.
    #[must_use]
    pub fn closed_box(length: f64, width: f64, nose_height: f64) -> Self {
        let (x, z) = (0.5 * length, 0.5 * width);
        let corners = [
            DVec2::new(-x, -z),
            DVec2::new(x, -z),
            DVec2::new(x, z),
            DVec2::new(-x, z),
        ];
        let cushions = (0..4)
            .map(|i| {
                Cushion::Line(Line {
                    from: corners[i],
                    to: corners[(i + 1) % 4],
                })
            })
            .collect();
        Self {
            length,
            width,
            nose_height,
            nose: Nose::Wall,
            cushions,
            pockets: Vec::new(),
        }
    }

    /// Distance in plan in m from a nose line at which a ball of this radius on the slate touches it.
    #[inline]
    #[must_use]
    pub fn reach(&self, radius: f64) -> f64 {
        self.nose.reach(self.nose_height, radius)
    }

    /// Height in m of the wood behind the cushions: it lies a little higher than the noses, so that a cue that rests on it
    /// clears them.
    #[must_use]
    pub fn rail_height(&self) -> f64 {
        1.16 * self.nose_height
    }
}
