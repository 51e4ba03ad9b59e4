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
    /// How far the cushion may be undercut here before it meets itself, m.
    pub room: f64,
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

/// A [`NosePoint`] in the making; `back` is known where it is not straight behind.
struct Front {
    at: DVec2,
    normal: DVec2,
    back: Option<DVec2>,
    room: f64,
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
            let mut points = side(table, &mut free, line.from, outward, measures);
            points.reverse();
            points.extend(between(line, outward));
            points.extend(side(table, &mut free, line.to, outward, measures));
            let ends = [line.from, line.to].map(|end| is_corner(table, index, end));
            let last = points.len() - 1;
            let behind = |(i, front): (usize, &Front)| {
                let at = front.at;
                let mut back = front.back.unwrap_or_else(|| {
                    at + (measures.depth - (at - line.from).dot(outward)) * outward
                });
                let along = (line.to - line.from).normalize();
                if i == 0 && ends[0] {
                    back -= measures.depth * along;
                }
                if i == last && ends[1] {
                    back += measures.depth * along;
                }
                NosePoint {
                    at,
                    normal: front.normal,
                    back,
                    room: front.room.min(at.distance(back)),
                }
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

/// The stretch of a nose line away from its jaws, where there is room for the whole undercut.
fn between(line: &Line, outward: DVec2) -> Vec<Front> {
    let way = line.to - line.from;
    let share = CLEAR_OF_JAW / way.length();
    if share >= 0.5 {
        return Vec::new();
    }
    [share, 1.0 - share]
        .map(|share| Front {
            at: line.from + share * way,
            normal: -outward,
            back: None,
            room: f64::INFINITY,
        })
        .into()
}

/// Distance from a jaw along the nose over which the undercut grows to its full depth, m.
const CLEAR_OF_JAW: f64 = 0.03;

/// From the end `at` of a nose outwards: the end itself, the jaw, the facing.
fn side(
    table: &Table,
    free: &mut [bool],
    at: DVec2,
    outward: DVec2,
    measures: &Measures,
) -> Vec<Front> {
    let mut points = vec![Front {
        at,
        normal: -outward,
        back: None,
        room: f64::INFINITY,
    }];
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
    let room = 0.8 * arc.radius;
    points[0].room = room;
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
        points.push(Front {
            at: arc.center + arc.radius * normal,
            normal,
            back: None,
            room,
        });
    }
    let normal = end.normalize_or(-outward);
    let (at, back) = cut_at_hole(
        table,
        (near, far),
        outward,
        measures.depth - (near - at).dot(outward),
    );
    points.push(Front {
        at,
        normal,
        back,
        room,
    });
    points
}

/// A facing that reaches over a hole ends at its edge: the end of the facing, and the point of the wood behind that end.
/// `depth` is the way from the near end back to the wood.
fn cut_at_hole(
    table: &Table,
    (near, far): (DVec2, DVec2),
    outward: DVec2,
    depth: f64,
) -> (DVec2, Option<DVec2>) {
    let cut = table.pockets.iter().find_map(|pocket| {
        let (start, way) = (near - pocket.center, far - near);
        // |start + t way|² = radius²
        let (a, b) = (way.length_squared(), start.dot(way));
        let c = start.length_squared() - pocket.radius * pocket.radius;
        let root = b * b - a * c;
        let share = (-b - root.max(0.0).sqrt()) / a;
        if root <= 0.0 || !(0.0..1.0).contains(&share) {
            return None;
        }
        let end = near + share * way;
        let level = depth - (pocket.center - near).dot(outward);
        let half = (pocket.radius * pocket.radius - level * level)
            .max(0.0)
            .sqrt();
        let back = [-half, half]
            .map(|along| pocket.center + level * outward + along * outward.perp())
            .into_iter()
            .min_by(|a, b| a.distance(end).total_cmp(&b.distance(end)));
        Some((end, back))
    });
    cut.unwrap_or((far, None))
}

/// Corners of a jaw.
const JAW_STEPS: u32 = 8;

fn touches(arc: &Arc, point: DVec2) -> bool {
    (arc.center.distance(point) - arc.radius).abs() < TOUCH && arc.radius > TOUCH
}
