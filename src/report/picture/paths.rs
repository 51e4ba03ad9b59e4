//! The paths of the balls, and what happened on them.

use glam::DVec2;
use svg::node::element::{Circle, Group, Polyline};

use crate::physics::ball::State;
use crate::physics::record::{Event, EventKind};
use crate::physics::scene::Scene;
use crate::report::picture::balls::colour;
use crate::report::picture::table::disc;
use crate::report::picture::{Page, layer, number};

/// Pixels by which a drawn path may leave out a bend.
const TOLERANCE: f64 = 0.1;

/// Most balls whose events are marked and whose paths are wide: with more, the lines would hide the picture.
pub(super) const CROWD: usize = 40;

/// One line for each ball that moved, in its colour.
pub(super) fn draw(page: &Page, scene: &Scene, trails: &[Vec<State>]) -> Group {
    let crowd = scene.balls.len() > CROWD;
    let mut group = layer("paths")
        .set("fill", "none")
        .set("stroke-linejoin", "round")
        .set("stroke-width", if crowd { "0.7" } else { "2" })
        .set("opacity", if crowd { "0.6" } else { "0.9" });
    for (i, (trail, ball)) in trails.iter().zip(&scene.balls).enumerate() {
        let mut points: Vec<DVec2> = std::iter::once(&ball.state)
            .chain(trail)
            .filter(|state| state.motion.in_play())
            .map(|state| page.place(state))
            .collect();
        points.dedup();
        if points.len() < 2 {
            continue;
        }
        let text: Vec<String> = thinned(&points)
            .into_iter()
            .map(|point| format!("{},{}", number(point.x), number(point.y)))
            .collect();
        group = group.add(
            Polyline::new()
                .set("points", text.join(" "))
                .set("stroke", colour(&ball.name, i).0),
        );
    }
    group
}

/// A ring where balls met, a dot at a cushion, a cross-hair ring where the cue struck and where a ball fell.
pub(super) fn marks(page: &Page, scene: &Scene, events: &[Event]) -> Group {
    let mut group = layer("events");
    if scene.balls.len() > CROWD {
        return group;
    }
    for event in events {
        let Some(ball) = scene.balls.get(event.first.ball) else {
            continue;
        };
        let radius = page.length(ball.ball.radius);
        let place = page.place(&event.first.before);
        group = match event.kind {
            EventKind::Strike { .. } => group.add(ring(place, 0.35 * radius, "#ffffff")),
            EventKind::BallBall => {
                let other = event
                    .second
                    .map_or(place, |second| page.place(&second.before));
                let share = event.second.map_or(0.0, |second| {
                    let other = scene
                        .balls
                        .get(second.ball)
                        .map_or(ball.ball.radius, |b| b.ball.radius);
                    ball.ball.radius / (ball.ball.radius + other)
                });
                group.add(ring(place.lerp(other, share), 0.22 * radius, "#ffe9a8"))
            }
            EventKind::Cushion { .. } => group.add(disc(place, 0.14 * radius, "#ffb27a")),
            EventKind::Pocketed { .. } => group.add(ring(place, 0.5 * radius, "#ff6b6b")),
            EventKind::Motion { .. } | EventKind::Rim { .. } => group,
            EventKind::Slate => group.add(disc(place, 0.1 * radius, "#ffff66")),
            EventKind::OffTable => group.add(ring(place, 0.5 * radius, "#ffff66")),
        };
    }
    group
}

fn ring(place: DVec2, radius: f64, colour: &str) -> Circle {
    disc(place, radius, "none")
        .set("stroke", colour)
        .set("stroke-width", 1.2)
}

/// The points that a line needs to stay within [`TOLERANCE`] of all of them (Douglas & Peucker 1973).
pub(super) fn thinned(points: &[DVec2]) -> Vec<DVec2> {
    let mut kept = vec![false; points.len()];
    kept[0] = true;
    kept[points.len() - 1] = true;
    let mut open = vec![(0, points.len() - 1)];
    while let Some((from, to)) = open.pop() {
        let farthest = (from + 1..to)
            .map(|i| (i, distance(points[i], points[from], points[to])))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((i, away)) = farthest
            && away > TOLERANCE
        {
            kept[i] = true;
            open.extend([(from, i), (i, to)]);
        }
    }
    points
        .iter()
        .zip(kept)
        .filter_map(|(point, kept)| kept.then_some(*point))
        .collect()
}

/// Distance of a point from a stretch of line.
fn distance(point: DVec2, from: DVec2, to: DVec2) -> f64 {
    let along = to - from;
    let length = along.length_squared();
    let share = if length > 0.0 {
        ((point - from).dot(along) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (from + share * along - point).length()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_line_needs_two_points_and_a_corner_three() {
        let straight: Vec<DVec2> = (0..100).map(|i| DVec2::new(f64::from(i), 0.01)).collect();
        assert_eq!(thinned(&straight).len(), 2);
        let mut bent = straight.clone();
        bent.extend((1..100).map(|i| DVec2::new(99.0, f64::from(i))));
        assert_eq!(thinned(&bent).len(), 3);
    }
}
