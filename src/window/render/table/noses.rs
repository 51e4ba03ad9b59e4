//! Cushions in plan: noses with the jaws and facings at their ends, from the lines and arcs of a table.

use bevy::math::DVec2;

use crate::physics::table::{Arc, Cushion, Line, Table};
use crate::window::render::table::measures::Measures;

/// A point of a nose line with the unit vector towards the playing surface, and the point of the wood behind it.
#[derive(Clone, Copy, Debug)]
pub(super) struct NosePoint {
    pub at: DVec2,
    pub normal: DVec2,
    pub back: DVec2,
}

/// The cushions of a table, sorted by how they are drawn.
#[derive(Default)]
pub(super) struct Noses {
    /// Along the frame, each from one mouth to the next.
    pub rails: Vec<Vec<NosePoint>>,
    /// Walls that stand in the open.
    pub walls: Vec<Line>,
    /// Pegs.
    pub pegs: Vec<Arc>,
}

/// Distances in m below which ends meet.
const TOUCH: f64 = 1e-6;

impl Noses {
    pub fn of(table: &Table, measures: &Measures) -> Self {
        let mut free = vec![true; table.cushions.len()];
        let mut noses = Self::default();
        for (index, cushion) in table.cushions.iter().enumerate() {
            let Cushion::Line(line) = cushion else {
                continue;
            };
            let Some(outward) = outward(line, measures) else {
                continue;
            };
            free[index] = false;
            let mut points = side(table, &mut free, line.from, outward);
            points.reverse();
            points.extend(side(table, &mut free, line.to, outward));
            let ends = [line.from, line.to].map(|end| is_corner(table, index, end));
            let last = points.len() - 1;
            let behind = |(i, &(at, normal)): (usize, &(DVec2, DVec2))| {
                let mut back = at + (measures.depth - (at - line.from).dot(outward)) * outward;
                let along = (line.to - line.from).normalize();
                if i == 0 && ends[0] {
                    back -= measures.depth * along;
                }
                if i == last && ends[1] {
                    back += measures.depth * along;
                }
                NosePoint { at, normal, back }
            };
            noses
                .rails
                .push(points.iter().enumerate().map(behind).collect());
        }
        for (cushion, _) in table.cushions.iter().zip(free).filter(|(_, free)| *free) {
            match cushion {
                Cushion::Line(line) => noses.walls.push(*line),
                Cushion::Arc(arc) if arc.radius > 0.0 => noses.pegs.push(*arc),
                Cushion::Arc(_) => {}
            }
        }
        noses
    }
}

/// The way out of the table, if the line runs along its edge.
fn outward(line: &Line, measures: &Measures) -> Option<DVec2> {
    [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y]
        .into_iter()
        .find(|&out| {
            let edge = measures.half.dot(out.abs());
            [line.from, line.to]
                .iter()
                .all(|end| (end.dot(out) - edge).abs() < TOUCH)
        })
}

/// Whether another cushion line ends here too.
fn is_corner(table: &Table, index: usize, end: DVec2) -> bool {
    table.cushions.iter().enumerate().any(|(other, cushion)| {
        other != index
            && matches!(cushion, Cushion::Line(line)
                if line.from.distance(end) < TOUCH || line.to.distance(end) < TOUCH)
    })
}

/// From the end `at` of a nose outwards: the end itself, the jaw, the facing.
fn side(table: &Table, free: &mut [bool], at: DVec2, outward: DVec2) -> Vec<(DVec2, DVec2)> {
    let mut points = vec![(at, -outward)];
    let Some((jaw, arc)) = table
        .cushions
        .iter()
        .enumerate()
        .find_map(|(i, c)| match c {
            Cushion::Arc(arc) if free[i] && touches(arc, at) => Some((i, *arc)),
            _ => None,
        })
    else {
        return points;
    };
    free[jaw] = false;
    let facing = table
        .cushions
        .iter()
        .enumerate()
        .find_map(|(i, c)| match c {
            Cushion::Line(line) if free[i] && touches(&arc, line.from) => {
                Some((i, line.from, line.to))
            }
            Cushion::Line(line) if free[i] && touches(&arc, line.to) => {
                Some((i, line.to, line.from))
            }
            _ => None,
        });
    let Some((index, near, far)) = facing else {
        return points;
    };
    free[index] = false;
    let (start, end) = (at - arc.center, near - arc.center);
    let turn = start.angle_to(end);
    for i in 1..=JAW_STEPS {
        let normal = DVec2::from_angle(turn * f64::from(i) / f64::from(JAW_STEPS))
            .rotate(start)
            .normalize_or(-outward);
        points.push((arc.center + arc.radius * normal, normal));
    }
    let normal = end.normalize_or(-outward);
    points.push((far, normal));
    points
}

/// Corners of a jaw.
const JAW_STEPS: u32 = 8;

fn touches(arc: &Arc, point: DVec2) -> bool {
    (arc.center.distance(point) - arc.radius).abs() < TOUCH && arc.radius > TOUCH
}
