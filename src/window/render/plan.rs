//! Areas in plan: a polygon less some holes, cut into quadrilaterals.

use bevy::math::DVec2;

/// Corners of a circle, as a polygon of this many sides.
pub(super) fn circle(center: DVec2, radius: f64, sides: u32) -> Vec<DVec2> {
    (0..sides)
        .map(|i| {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(sides);
            center + radius * DVec2::from_angle(angle)
        })
        .collect()
}

/// One side of a polygon, from left to right.
struct Edge {
    from: DVec2,
    to: DVec2,
    /// 0 for the polygon itself, then the holes.
    owner: usize,
}

impl Edge {
    fn at(&self, x: f64) -> f64 {
        let share = (x - self.from.x) / (self.to.x - self.from.x);
        self.from.y + share * (self.to.y - self.from.y)
    }

    fn crossing(&self, other: &Self) -> Option<f64> {
        let (a, b) = (self.to - self.from, other.to - other.from);
        let turn = a.perp_dot(b);
        let offset = other.from - self.from;
        let (s, t) = (offset.perp_dot(b) / turn, offset.perp_dot(a) / turn);
        let inside = 0.0..=1.0;
        (inside.contains(&s) && inside.contains(&t)).then_some(self.from.x + s * a.x)
    }
}

/// The area inside `outline` and outside every hole, as quadrilaterals. Polygons may cross each other, not themselves.
pub(super) fn area(outline: &[DVec2], holes: &[Vec<DVec2>]) -> Vec<[DVec2; 4]> {
    let mut edges = Vec::new();
    let mut cuts = Vec::new();
    for (owner, polygon) in std::iter::once(outline)
        .chain(holes.iter().map(Vec::as_slice))
        .enumerate()
    {
        for (i, &a) in polygon.iter().enumerate() {
            let b = polygon[(i + 1) % polygon.len()];
            let (from, to) = if a.x < b.x { (a, b) } else { (b, a) };
            cuts.push(from.x);
            if to.x - from.x > THIN {
                edges.push(Edge { from, to, owner });
            }
        }
    }
    for (i, edge) in edges.iter().enumerate() {
        cuts.extend(
            edges[i + 1..]
                .iter()
                .filter_map(|other| edge.crossing(other)),
        );
    }
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|a, b| *a - *b < THIN);
    cuts.windows(2)
        .flat_map(|cut| strip(&edges, holes.len(), cut[0], cut[1]))
        .collect()
}

/// Strips and sides narrower than this in m are left out.
const THIN: f64 = 1e-7;

/// The parts of the area between two neighbouring cuts, where no edges cross or end.
fn strip(edges: &[Edge], holes: usize, left: f64, right: f64) -> Vec<[DVec2; 4]> {
    let middle = 0.5 * (left + right);
    let mut crossed: Vec<&Edge> = edges
        .iter()
        .filter(|edge| edge.from.x < middle && middle < edge.to.x)
        .collect();
    crossed.sort_by(|a, b| a.at(middle).total_cmp(&b.at(middle)));
    let mut inside = vec![false; holes + 1];
    let is_area = |inside: &[bool]| inside[0] && !inside[1..].contains(&true);
    let mut parts = Vec::new();
    let mut start: Option<&Edge> = None;
    for edge in crossed {
        inside[edge.owner] = !inside[edge.owner];
        match (start, is_area(&inside)) {
            (None, true) => start = Some(edge),
            (Some(low), false) => {
                let corner = |edge: &Edge, x: f64| DVec2::new(x, edge.at(x));
                parts.push([
                    corner(low, left),
                    corner(low, right),
                    corner(edge, right),
                    corner(edge, left),
                ]);
                start = None;
            }
            _ => {}
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn size(parts: &[[DVec2; 4]]) -> f64 {
        parts
            .iter()
            .map(|p| 0.5 * ((p[2] - p[0]).perp_dot(p[3] - p[1])).abs())
            .sum()
    }

    fn square(half: f64) -> Vec<DVec2> {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, y)| half * DVec2::new(x, y))
            .to_vec()
    }

    #[test]
    fn a_hole_inside_takes_its_own_area() {
        let parts = area(&square(1.0), &[square(0.5)]);
        assert!((size(&parts) - 3.0).abs() < 1e-9);
    }

    #[test]
    fn a_hole_over_a_corner_takes_only_what_it_covers() {
        let mut hole = square(0.5);
        for point in &mut hole {
            *point += DVec2::ONE;
        }
        let parts = area(&square(1.0), &[hole]);
        assert!((size(&parts) - 3.75).abs() < 1e-9);
    }

    #[test]
    fn overlapping_holes_count_once() {
        let round = circle(DVec2::ZERO, 0.3, 48);
        let one = size(&area(&square(1.0), std::slice::from_ref(&round)));
        let two = size(&area(&square(1.0), &[round.clone(), round]));
        assert!((one - two).abs() < 1e-6, "{one} {two}");
    }
}
