//! The table as a player's eye takes it in: where the balls lie in plan, which ways are free, and where the pockets open.

use glam::DVec2;

use crate::physics::scene::Scene;
use crate::physics::table::{Cushion, Table};

/// Share of the sum of two radii within which a passing ball touches: a hair of contact is no obstacle to the eye.
const TOUCHES: f64 = 0.995;

/// A point of the slate below a position.
#[must_use]
pub fn plan(position: glam::DVec3) -> DVec2 {
    DVec2::new(position.x, position.z)
}

/// Angle in rad of a direction in plan, from x towards z. A heading of a cue is its negative.
#[must_use]
pub fn angle(direction: DVec2) -> f64 {
    libm::atan2(direction.y, direction.x)
}

/// The unit vector at this angle in rad.
#[must_use]
pub fn toward(angle: f64) -> DVec2 {
    DVec2::new(libm::cos(angle), libm::sin(angle))
}

/// The same angle in rad between −π and π.
#[must_use]
pub fn wrapped(angle: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    (angle + PI).rem_euclid(TAU) - PI
}

/// A ball as the eye sees it.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// Index in the scene.
    pub ball: usize,
    /// Where its centre is, m.
    pub at: DVec2,
    /// Its radius, m.
    pub radius: f64,
}

/// All balls in play in plan.
#[derive(Clone, Debug)]
pub struct Sight {
    /// The balls in play.
    pub balls: Vec<Seen>,
    /// Half the length and width of the playing surface, m.
    pub half: DVec2,
}

impl Sight {
    /// Looks at a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let balls = scene
            .balls
            .iter()
            .enumerate()
            .filter(|(_, placed)| placed.state.motion.in_play())
            .map(|(ball, placed)| Seen {
                ball,
                at: plan(placed.state.position),
                radius: placed.ball.radius,
            })
            .collect();
        Self {
            balls,
            half: 0.5 * DVec2::new(scene.table.length, scene.table.width),
        }
    }

    /// A ball in play.
    #[must_use]
    pub fn ball(&self, ball: usize) -> Option<&Seen> {
        self.balls.iter().find(|seen| seen.ball == ball)
    }

    /// Whether a ball of this radius gets straight from one point to another without touching a ball, those named not
    /// counted.
    #[must_use]
    pub fn is_free(&self, from: DVec2, to: DVec2, radius: f64, but: [usize; 2]) -> bool {
        let way = to - from;
        let square = way.length_squared().max(1e-12);
        self.balls
            .iter()
            .filter(|seen| !but.contains(&seen.ball))
            .all(|seen| {
                let share = ((seen.at - from).dot(way) / square).clamp(0.0, 1.0);
                let reach = TOUCHES * (radius + seen.radius);
                seen.at.distance_squared(from + share * way) >= reach * reach
            })
    }

    /// Whether a ball of this radius can lie there without being in a cushion.
    #[must_use]
    pub fn is_inside(&self, point: DVec2, radius: f64) -> bool {
        let inside = self.half - radius + 1e-4;
        point.abs().cmple(inside).all()
    }
}

/// The opening of a pocket as two round jaws in plan.
#[derive(Clone, Copy, Debug)]
pub struct Mouth {
    /// Index of the pocket.
    pub pocket: usize,
    /// Centre of the hole, m.
    pub hole: DVec2,
    /// Centre and radius in m of either jaw.
    jaws: [(DVec2, f64); 2],
}

impl Mouth {
    /// The mouths of all pockets of a table.
    #[must_use]
    pub fn all(table: &Table) -> Vec<Self> {
        table
            .pockets
            .iter()
            .enumerate()
            .map(|(pocket, hole)| Self {
                pocket,
                hole: hole.center,
                jaws: jaws(table, hole.center, hole.radius),
            })
            .collect()
    }

    /// The middle of the opening, m.
    #[must_use]
    pub fn middle(&self) -> DVec2 {
        0.5 * (self.jaws[0].0 + self.jaws[1].0)
    }

    /// The directions in which a ball of this radius rolls from a point between the jaws into the pocket: the angle in rad
    /// of the middle one and half the width. `None` if it gets by no way.
    #[must_use]
    pub fn window(&self, from: DVec2, radius: f64) -> Option<(f64, f64)> {
        let axis = (self.hole - from).try_normalize()?;
        let mut bounds = [0.0; 2];
        for (bound, (center, jaw)) in bounds.iter_mut().zip(self.jaws) {
            let to = center - from;
            let side = libm::atan2(axis.perp_dot(to), axis.dot(to));
            let reach = (radius + jaw) / to.length().max(1e-9);
            if reach >= 1.0 {
                // Between the jaws already.
                return Some((angle(axis), 0.5));
            }
            *bound = side - side.signum() * libm::asin(reach);
        }
        let (low, high) = (bounds[0].min(bounds[1]), bounds[0].max(bounds[1]));
        let crossed = (bounds[0] > bounds[1]) != (self.side(0, from) > self.side(1, from));
        let half = 0.5 * (high - low);
        (!crossed && half < 1.2).then(|| (angle(axis) + 0.5 * (low + high), half))
    }

    fn side(&self, jaw: usize, from: DVec2) -> f64 {
        (self.hole - from).perp_dot(self.jaws[jaw].0 - from)
    }
}

/// The nearest jaw on either side of a hole; without jaws the edge of the hole itself.
fn jaws(table: &Table, hole: DVec2, radius: f64) -> [(DVec2, f64); 2] {
    let inward = (-hole).try_normalize().unwrap_or(DVec2::X);
    let half = 0.5 * DVec2::new(table.length, table.width) + 1e-6;
    let mut best: [Option<(f64, (DVec2, f64))>; 2] = [None; 2];
    let mut consider = |center: DVec2, round: f64| {
        let side = usize::from(inward.perp_dot(center - hole) > 0.0);
        let distance = center.distance(hole) - round;
        if best[side].is_none_or(|(least, _)| distance < least) {
            best[side] = Some((distance, (center, round)));
        }
    };
    let round = |cushion: &&Cushion| matches!(cushion, Cushion::Arc(arc) if arc.radius > 1e-4);
    if table.cushions.iter().any(|cushion| round(&cushion)) {
        for cushion in table.cushions.iter().filter(round) {
            if let Cushion::Arc(arc) = cushion {
                consider(arc.center, arc.radius);
            }
        }
    } else {
        for cushion in &table.cushions {
            if let Cushion::Line(line) = cushion {
                for end in [line.from, line.to] {
                    if end.abs().cmple(half).all() {
                        consider(end, 0.0);
                    }
                }
            }
        }
    }
    let edge = |side: f64| (hole + side * radius * inward.perp(), 0.0);
    let near = |found: Option<(f64, (DVec2, f64))>, side: f64| match found {
        Some((distance, jaw)) if distance < 4.0 * radius => jaw,
        _ => edge(side),
    };
    [near(best[0], -1.0), near(best[1], 1.0)]
}
