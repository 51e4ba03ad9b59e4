//! Where a ball may be put down by hand.
//!
//! A ball stands inside the rectangle of the noses, clear of cushions, pockets and other balls. The nearest allowed spot
//! lies on the edge of one of these obstacles or where two edges cross; all of them are tried.

use glam::{DVec2, DVec3};

use crate::physics::ball::State;
use crate::physics::scene::Scene;
use crate::physics::table::Cushion;

/// Room in m left between a placed ball and what it is put against.
const CLEARANCE: f64 = 1e-6;

/// The edge of a place where the centre of the ball cannot be.
#[derive(Clone, Copy)]
enum Edge {
    /// Through a point, along a unit vector.
    Line(DVec2, DVec2),
    /// Centre and radius.
    Circle(DVec2, f64),
}

impl Edge {
    fn nearest(self, point: DVec2) -> DVec2 {
        match self {
            Self::Line(through, along) => through + (point - through).dot(along) * along,
            Self::Circle(center, radius) => {
                let away = (point - center).try_normalize().unwrap_or(DVec2::X);
                center + radius * away
            }
        }
    }

    fn crossings(self, other: Self) -> [Option<DVec2>; 2] {
        match (self, other) {
            (Self::Line(a, u), Self::Line(b, v)) => {
                let cross = u.perp_dot(v);
                let point = (cross.abs() > 1e-12).then(|| a + (b - a).perp_dot(v) / cross * u);
                [point, None]
            }
            (Self::Line(through, along), Self::Circle(center, radius))
            | (Self::Circle(center, radius), Self::Line(through, along)) => {
                let foot = through + (center - through).dot(along) * along;
                let square = radius * radius - foot.distance_squared(center);
                either_side(foot, along, square)
            }
            (Self::Circle(a, r), Self::Circle(b, s)) => {
                let distance = a.distance(b);
                if distance == 0.0 {
                    return [None, None];
                }
                let axis = (b - a) / distance;
                let along = 0.5 * (distance + (r * r - s * s) / distance);
                either_side(a + along * axis, axis.perp(), r * r - along * along)
            }
        }
    }
}

fn either_side(foot: DVec2, along: DVec2, square: f64) -> [Option<DVec2>; 2] {
    if square < 0.0 {
        return [None, None];
    }
    let half = square.sqrt() * along;
    [Some(foot + half), Some(foot - half)]
}

/// Whether this ball of the scene may stand with its centre at x, z in m.
#[must_use]
pub fn is_free(scene: &Scene, ball: usize, spot: DVec2) -> bool {
    let Some(placed) = scene.balls.get(ball) else {
        return false;
    };
    let radius = placed.ball.radius;
    let reach = scene.table.reach(radius);
    let half = 0.5 * DVec2::new(scene.table.length, scene.table.width) - reach;
    spot.is_finite()
        && spot.x.abs() <= half.x
        && spot.y.abs() <= half.y
        && scene
            .table
            .cushions
            .iter()
            .all(|cushion| cushion.nearest(spot).0 >= reach)
        && scene
            .table
            .pockets
            .iter()
            .all(|pocket| spot.distance(pocket.center) >= pocket.radius)
        && others(scene, ball).all(|(center, other)| spot.distance(center) >= radius + other)
}

/// The free spot nearest to x, z in m for this ball of the scene; `None` if there is none on the table.
#[must_use]
pub fn nearest_free(scene: &Scene, ball: usize, wish: DVec2) -> Option<DVec2> {
    if is_free(scene, ball, wish) {
        return Some(wish);
    }
    if !wish.is_finite() {
        return None;
    }
    let edges = edges(scene, ball)?;
    let mut best: Option<(f64, DVec2)> = None;
    let mut consider = |spot: DVec2| {
        let distance = spot.distance_squared(wish);
        if best.is_none_or(|(least, _)| distance < least) && is_free(scene, ball, spot) {
            best = Some((distance, spot));
        }
    };
    for (i, edge) in edges.iter().enumerate() {
        consider(edge.nearest(wish));
        for other in &edges[..i] {
            edge.crossings(*other)
                .into_iter()
                .flatten()
                .for_each(&mut consider);
        }
    }
    best.map(|(_, spot)| spot)
}

/// Puts this ball of the scene at rest on the free spot nearest to x, z in m. False if there is none.
pub fn place(scene: &mut Scene, ball: usize, wish: DVec2) -> bool {
    let Some(spot) = nearest_free(scene, ball, wish) else {
        return false;
    };
    let placed = &mut scene.balls[ball];
    placed.state = State::at_rest(DVec3::new(spot.x, placed.ball.radius, spot.y));
    true
}

/// Centre and radius of every other ball in play.
fn others(scene: &Scene, ball: usize) -> impl Iterator<Item = (DVec2, f64)> {
    scene
        .balls
        .iter()
        .enumerate()
        .filter(move |(index, other)| *index != ball && other.state.motion.in_play())
        .map(|(_, other)| {
            let center = other.state.position;
            (DVec2::new(center.x, center.z), other.ball.radius)
        })
}

/// Everything the ball can be put against. Noses on the border of the table are the border itself.
fn edges(scene: &Scene, ball: usize) -> Option<Vec<Edge>> {
    let radius = scene.balls.get(ball)?.ball.radius;
    let corner = 0.5 * DVec2::new(scene.table.length, scene.table.width);
    let half = corner - scene.table.reach(radius) - CLEARANCE;
    if half.min_element() < 0.0 {
        return None;
    }
    let mut edges = vec![
        Edge::Line(DVec2::new(0.0, -half.y), DVec2::X),
        Edge::Line(DVec2::new(0.0, half.y), DVec2::X),
        Edge::Line(DVec2::new(-half.x, 0.0), DVec2::Y),
        Edge::Line(DVec2::new(half.x, 0.0), DVec2::Y),
    ];
    let reach = scene.table.reach(radius) + CLEARANCE;
    edges.extend(
        others(scene, ball).map(|(center, other)| Edge::Circle(center, radius + CLEARANCE + other)),
    );
    for pocket in &scene.table.pockets {
        edges.push(Edge::Circle(pocket.center, pocket.radius + CLEARANCE));
    }
    let inside = corner - CLEARANCE;
    for cushion in &scene.table.cushions {
        let (least, most) = cushion.bounds();
        if least.cmpge(inside).any() || most.cmple(-inside).any() {
            continue;
        }
        match cushion {
            Cushion::Arc(arc) => edges.push(Edge::Circle(arc.center, reach + arc.radius)),
            Cushion::Line(line) => {
                let along = (line.to - line.from).normalize_or_zero();
                let aside = reach * along.perp();
                edges.push(Edge::Line(line.from + aside, along));
                edges.push(Edge::Line(line.from - aside, along));
                edges.push(Edge::Circle(line.from, reach));
                edges.push(Edge::Circle(line.to, reach));
            }
        }
    }
    Some(edges)
}
