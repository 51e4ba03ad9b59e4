//! Where the cue has room: the least elevation at which it clears the balls and the rails behind the struck ball.
//!
//! The cue is a cone from tip to butt, its axis through the middle of the round tip, which touches the ball as the
//! [`Shot`] says. A ball in its way is a sphere, a cushion its nose edge at its height, the wood behind it a higher edge,
//! the slate a plane. Not modelled: the hand, and how far the cue is drawn back or follows through.

use glam::{DVec2, DVec3};

use crate::physics::cue::Shot;
use crate::physics::scene::Scene;
use crate::physics::table::{Cushion, Table};

/// What the cue would pass through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// The ball with this index in the scene.
    Ball(usize),
    /// The cushion with this index in the table.
    Cushion(usize),
    /// The wood behind the cushions.
    Rail,
    /// The slate.
    Slate,
}

/// How high a cue has to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lift {
    /// Least elevation in rad; from there up nothing is in the way.
    pub elevation: f64,
    /// What a lower cue would pass through; none if a level cue is free.
    pub over: Option<Obstacle>,
}

/// The steepest elevation that is tried, rad.
pub const STEEPEST: f64 = 1.5;

/// Elevations between which a narrow obstacle could be missed, rad.
const STEP: f64 = 0.02;

/// From the nose line back to the wood, m: WPA, cushions are 47.6 to 50.8 mm deep.
const RAIL_BEHIND: f64 = 0.05;

/// The least elevation at which the cue can play this shot, whatever elevation the shot names. `None` if even the
/// [`STEEPEST`] cue is not free.
#[must_use]
pub fn lift(scene: &Scene, ball: usize, shot: &Shot) -> Option<Lift> {
    let at = |elevation: f64| obstacle(scene, ball, &Shot { elevation, ..*shot });
    if at(STEEPEST).is_some() {
        return None;
    }
    let mut free = STEEPEST;
    let mut over = None;
    while over.is_none() && free > 0.0 {
        let lower = (free - STEP).max(0.0);
        over = at(lower);
        if over.is_none() {
            free = lower;
        }
    }
    if over.is_none() {
        return Some(Lift {
            elevation: 0.0,
            over: None,
        });
    }
    let mut blocked = (free - STEP).max(0.0);
    for _ in 0..30 {
        let middle = 0.5 * (blocked + free);
        match at(middle) {
            Some(obstacle) => (blocked, over) = (middle, Some(obstacle)),
            None => free = middle,
        }
    }
    Some(Lift {
        elevation: free,
        over,
    })
}

/// What the cue of this shot would pass through; none if it is free, or if there is no such ball. Of several the one that
/// is deepest inside the cue.
#[must_use]
pub fn obstacle(scene: &Scene, ball: usize, shot: &Shot) -> Option<Obstacle> {
    let axis = Axis::of(scene, ball, shot)?;
    let mut deepest: Option<(f64, Obstacle)> = None;
    let mut note = |clearance: f64, obstacle: Obstacle| {
        if clearance < 0.0 && deepest.is_none_or(|(least, _)| clearance < least) {
            deepest = Some((clearance, obstacle));
        }
    };
    note(axis.above_slate(), Obstacle::Slate);
    for (index, other) in scene.balls.iter().enumerate() {
        if index != ball && other.state.motion.in_play() {
            let clearance = axis.beside_ball(other.state.position, other.ball.radius);
            note(clearance, Obstacle::Ball(index));
        }
    }
    let height = scene.table.nose_height;
    for (index, cushion) in scene.table.cushions.iter().enumerate() {
        let clearance = match cushion {
            Cushion::Line(line) => axis.above_edge(line.from, line.to, height),
            Cushion::Arc(arc) => axis.above_disc(arc.center, arc.radius, height),
        };
        note(clearance, Obstacle::Cushion(index));
    }
    if !scene.table.cushions.is_empty() {
        note(axis.above_rails(&scene.table), Obstacle::Rail);
    }
    deepest.map(|(_, obstacle)| obstacle)
}

/// The axis of the cue, and how thick the cue is along it. All clearances are in m, negative where the cue is inside.
struct Axis {
    /// Centre of the struck ball in plan: edges between it and the tip count too.
    ball: DVec2,
    /// The front of the tip.
    tip: DVec3,
    /// Unit vector from tip to butt.
    back: DVec3,
    /// Radius at the tip.
    thin: f64,
    /// How much the radius grows along the axis.
    taper: f64,
    length: f64,
}

impl Axis {
    fn of(scene: &Scene, ball: usize, shot: &Shot) -> Option<Self> {
        let struck = scene.balls.get(ball)?;
        let along = shot.along();
        let cue = &scene.cue;
        let center = struck.state.position;
        let tip_center =
            center + struck.ball.radius * cue.tip_offset(&struck.ball) * shot.contact();
        let stick = &cue.stick;
        Some(Self {
            ball: DVec2::new(center.x, center.z),
            tip: tip_center + cue.tip_radius * along,
            back: -along,
            thin: 0.5 * stick.tip_width,
            taper: 0.5 * (stick.butt_width - stick.tip_width) / stick.length,
            length: stick.length,
        })
    }

    fn radius(&self, along: f64) -> f64 {
        self.thin + self.taper * along
    }

    fn above_slate(&self) -> f64 {
        let level = (1.0 - self.back.y * self.back.y).max(0.0).sqrt();
        let low = |along: f64| self.tip.y + along * self.back.y - level * self.radius(along);
        low(0.0).min(low(self.length))
    }

    /// Clearance from a sphere: the least over the spheres that fill the cue from its tip to its butt.
    fn beside_ball(&self, center: DVec3, radius: f64) -> f64 {
        let offset = center - self.tip;
        let middle = offset.dot(self.back);
        let aside = (offset.length_squared() - middle * middle).max(0.0).sqrt();
        // √(aside² + (s − middle)²) − radius(s) is least where its slope is that of the taper.
        let lag = aside * self.taper / (1.0 - self.taper * self.taper).sqrt();
        let least = self.thin.min(self.length);
        let along = (middle + lag).clamp(least, self.length);
        let distance = (aside * aside + (along - middle) * (along - middle)).sqrt();
        distance - self.radius(along) - radius
    }

    /// The axis in plan: from where, and the way back for a metre of cue.
    fn in_plan(&self) -> (DVec2, DVec2) {
        (
            DVec2::new(self.tip.x, self.tip.z),
            DVec2::new(self.back.x, self.back.z),
        )
    }

    /// Clearance over an edge that this much of the cue behind the tip crosses in plan, where the sine of the angle
    /// between both in plan is `across`.
    fn over(&self, along: f64, across: f64, height: f64) -> f64 {
        if along > self.length {
            return f64::INFINITY;
        }
        // The tip may already be past the edge, under it.
        let along = along.max(0.0);
        let rise = self.tip.y + along * self.back.y - height;
        let level = (1.0 - self.back.y * self.back.y).max(0.0).sqrt();
        let skew = level * across.abs();
        // The distance of two skew lines, one of them horizontal.
        let distance = rise * skew / (self.back.y * self.back.y + skew * skew).sqrt();
        distance - self.radius(along)
    }

    /// Clearance over a horizontal edge; infinite if the cue does not cross it.
    fn above_edge(&self, from: DVec2, to: DVec2, height: f64) -> f64 {
        let (tip, way) = self.in_plan();
        let level = way.length();
        let edge = to - from;
        let cross = way.perp_dot(edge);
        if level == 0.0 || cross.abs() <= 1e-12 * level * edge.length() {
            return f64::INFINITY;
        }
        let along = (from - tip).perp_dot(edge) / cross;
        let share = (from - tip).perp_dot(way) / cross;
        // The part between the middle of the ball and the tip counts, the part before the ball does not.
        let first = (self.ball - tip).dot(way) / (level * level);
        if !(0.0..=1.0).contains(&share) || along < first {
            return f64::INFINITY;
        }
        self.over(along, cross / (level * edge.length()), height)
    }

    /// Clearance over an upright peg or jaw; infinite if the cue does not cross it.
    fn above_disc(&self, center: DVec2, radius: f64, height: f64) -> f64 {
        let (tip, way) = self.in_plan();
        let level = way.length();
        if level == 0.0 {
            return f64::INFINITY;
        }
        let way = way / level;
        let middle = (center - tip).dot(way);
        let aside = (center - tip).perp_dot(way);
        let half = radius * radius - aside * aside;
        if half <= 0.0 || middle + half.sqrt() < (self.ball - tip).dot(way) {
            return f64::INFINITY;
        }
        let entry = (middle - half.sqrt()) / level;
        self.over(entry, half.sqrt() / radius, height)
    }

    /// Clearance over the wood around the table.
    fn above_rails(&self, table: &Table) -> f64 {
        let corner = 0.5 * DVec2::new(table.length, table.width) + RAIL_BEHIND;
        let corners = [
            DVec2::new(-corner.x, -corner.y),
            DVec2::new(corner.x, -corner.y),
            corner,
            DVec2::new(-corner.x, corner.y),
        ];
        (0..4)
            .map(|i| self.above_edge(corners[i], corners[(i + 1) % 4], table.rail_height()))
            .fold(f64::INFINITY, f64::min)
    }
}
