//! J18 and J19: what goes into a pocket, and which straight shot is hardest. Whole shots of the exact solver.
//!
//! The papers' pocket: sharp points, straight facings that mirror, a ball that is gone when its centre passes the edge of
//! the hole. How wide it is for a ball that comes at an angle is found by trying: a ball goes in or it does not.

use glam::{DVec2, DVec3};

use crate::physics::ball::Ball;
use crate::physics::laws::Laws;
use crate::physics::record::EventKind;
use crate::physics::scene::Scene;
use crate::physics::table::{Arc, Cushion, Line, Nose, Pocket, Table};
use crate::report::judge::Row;
use crate::report::judge::stand::{Stand, cut_line, smooth, turn};
use crate::sim::play::{Stopped, play};

const INCH: f64 = 0.0254;
const LAW: &str = "exact solver, Capture";
const SIDE_PAPER: &str = "Alciatore, TP 3.5: its polynomials, solved apart";
const CORNER_PAPER: &str = "Alciatore, TP 3.6, as printed";

/// A pocket of the papers, in inches and degrees.
#[derive(Clone, Copy)]
struct Mouth {
    width: f64,
    facing: f64,
    hole: f64,
    shelf: f64,
    /// Angle in degrees by which the rails fall back from the line of the mouth; `None` leaves them out.
    rails: Option<f64>,
}

const SIDE: Mouth = Mouth {
    width: 5.0625,
    facing: 14.0,
    hole: 3.0,
    shelf: 0.1875,
    rails: Some(0.0),
};

const CORNER: Mouth = Mouth {
    width: 4.5875,
    facing: 7.0,
    hole: 2.75,
    shelf: 1.125,
    rails: Some(45.0),
};

/// What a ball met on its way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Met {
    Rail,
    Facing,
    Point,
}

impl Mouth {
    /// Facings, points and rails with what they are; the middle of the mouth is the origin, z leads into the pocket.
    fn noses(&self) -> Vec<(Met, Cushion)> {
        let mut noses = Vec::new();
        for side in [-1.0, 1.0] {
            let from = INCH * DVec2::new(0.5 * side * self.width, 0.0);
            let mut line = |met, along: DVec2| {
                let to = from + along;
                noses.push((met, Cushion::Line(Line { from, to })));
            };
            let angle = self.facing.to_radians();
            line(
                Met::Facing,
                0.15 * DVec2::new(-side * libm::sin(angle), libm::cos(angle)),
            );
            if let Some(rails) = self.rails {
                let angle = rails.to_radians();
                line(
                    Met::Rail,
                    1.5 * DVec2::new(side * libm::cos(angle), -libm::sin(angle)),
                );
            }
            noses.push((
                Met::Point,
                Cushion::Arc(Arc {
                    center: from,
                    radius: 0.0,
                }),
            ));
        }
        noses
    }

    /// Plays a ball that comes at this angle in degrees, so far in inches to the left of the middle of the mouth. What it
    /// met before it was captured; `None` if it stays out.
    fn play(&self, degrees: f64, left: f64) -> Result<Option<Vec<Met>>, Stopped> {
        let noses = self.noses();
        let center = INCH * DVec2::new(0.0, self.hole + self.shelf);
        let table = Table {
            length: 8.0,
            width: 8.0,
            nose_height: 1.27 * Ball::POOL.radius,
            nose: Nose::Wall,
            cushions: noses.iter().map(|(_, cushion)| *cushion).collect(),
            pockets: vec![Pocket {
                name: "pocket".to_owned(),
                center,
                radius: INCH * self.hole,
                depth: 0.08,
            }],
        };
        let mut scene = Scene::new(table, Laws::ideal());
        let angle = degrees.to_radians();
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let start = INCH * (left * DVec2::new(-cos, sin) - 45.0 * DVec2::new(sin, cos));
        if self.behind_a_rail(start) {
            return Ok(None);
        }
        let ball = Ball {
            spins: false,
            ..Ball::POOL
        };
        scene.place("ball", ball, start.x, start.y);
        scene.balls[0].state.velocity = DVec3::new(sin, 0.0, cos);
        scene.time_limit = 5.0;
        let mut met = Vec::new();
        for event in play(&scene)?.events {
            match event.kind {
                EventKind::Cushion { cushion } => met.push(noses[cushion].0),
                EventKind::Pocketed { .. } => return Ok(Some(met)),
                _ => {}
            }
        }
        Ok(None)
    }

    /// Whether a ball with its centre here would have to come through a rail.
    fn behind_a_rail(&self, start: DVec2) -> bool {
        let Some(rails) = self.rails else {
            return false;
        };
        let (sin, cos) = (libm::sin(rails.to_radians()), libm::cos(rails.to_radians()));
        [-1.0, 1.0].into_iter().any(|side| {
            let point = INCH * DVec2::new(0.5 * side * self.width, 0.0);
            (start - point).dot(DVec2::new(-side * sin, -cos)) <= Ball::POOL.radius
        })
    }

    /// The furthest to the left in inches that goes in after at most so many contacts, searched from `from`, and what the
    /// ball meets there. A gap between two ways in that is narrower than `step` in inches is not seen.
    fn edge(
        &self,
        degrees: f64,
        most: usize,
        (from, step): (f64, f64),
    ) -> Result<(f64, Vec<Met>), Stopped> {
        let goes_in =
            |left: f64| Ok::<_, Stopped>(self.play(degrees, left)?.filter(|met| met.len() <= most));
        let mut inner = from;
        let mut way = goes_in(inner)?;
        while way.is_none() {
            inner -= step;
            if inner < -self.width {
                return Ok((f64::NAN, Vec::new()));
            }
            way = goes_in(inner)?;
        }
        let mut outer = inner + step;
        for _ in 0..44 {
            let middle = f64::midpoint(inner, outer);
            if let Some(met) = goes_in(middle)? {
                (inner, way) = (middle, Some(met));
            } else {
                outer = middle;
            }
        }
        Ok((inner, way.unwrap_or_default()))
    }

    /// Where to search from: beyond this offset in inches the rail is all that a ball meets.
    fn beyond(&self, degrees: f64) -> (f64, f64) {
        let far = 0.5 * self.width * libm::cos(degrees.to_radians()) + Ball::POOL.radius / INCH;
        (far, 0.01)
    }
}

/// The angle in degrees between two at which something ends that holds at the first.
fn last(
    (mut holds, mut fails): (f64, f64),
    test: impl Fn(f64) -> Result<bool, Stopped>,
) -> Result<f64, Stopped> {
    for _ in 0..40 {
        let middle = f64::midpoint(holds, fails);
        if test(middle)? {
            holds = middle;
        } else {
            fails = middle;
        }
    }
    Ok(holds)
}

/// J18: the side pocket of TP 3.5 and the corner pocket of TP 3.6.
pub(super) fn rows() -> Result<Vec<Row>, Stopped> {
    let mut rows = Vec::new();
    // Only one facing counts in the paper; more could not help here.
    let side = |degrees: f64| Ok::<_, Stopped>(SIDE.edge(degrees, 2, SIDE.beyond(degrees))?.0);
    for (degrees, expected) in [
        (0.0, 3.229499560200),
        (20.0, 2.959057204201),
        (35.0, 2.419777828584),
        (60.0, 0.691817244743),
    ] {
        let ours = side(degrees)? + side(-degrees)?;
        let title = format!("J18 side pocket at {degrees}°: target size");
        rows.push(Row::closed(&title, LAW, expected, ours, "in").by(SIDE_PAPER));
    }
    let clears = |degrees: f64| {
        let just = 0.5 * SIDE.width * libm::cos(degrees.to_radians()) - Ball::POOL.radius / INCH;
        Ok(SIDE.play(degrees, just - 1e-9)?.is_some())
    };
    let cut_off = last((60.0, 75.0), clears)?;
    rows.push(
        Row::printed(
            "J18 side pocket: cut-off at",
            LAW,
            (68.292, 3),
            cut_off,
            "°",
        )
        .by("Alciatore, TP 3.5, as printed"),
    );
    let off_facing = |degrees: f64| {
        let (_, met) = SIDE.edge(degrees, 2, SIDE.beyond(degrees))?;
        Ok(met.first() == Some(&Met::Facing))
    };
    let switch = last((-52.0, -45.0), off_facing)?;
    rows.push(
        Row::closed(
            "J18 side pocket: the far point takes over from the far facing at",
            LAW,
            -47.853102736278,
            switch,
            "°",
        )
        .within(1e-6)
        .by(SIDE_PAPER)
        .remark("The paper prints -49.964° for it; its own polynomials, as they are handed down, give the angle expected here."),
    );
    rows.extend(corner()?);
    Ok(rows)
}

/// The paper follows three contacts, and where the rail is one of them, the two after it by themselves.
fn corner() -> Result<Vec<Row>, Stopped> {
    let mut rows = Vec::new();
    let bare = Mouth {
        rails: None,
        ..CORNER
    };
    let along_rail = (4.0, 0.01);
    for (degrees, mouth, most, from, expected) in [
        (28.167, CORNER, 3, along_rail, 0.945),
        (38.558, CORNER, 3, along_rail, 1.829),
        (-51.442, bare, 2, (2.0, 0.01), 0.841),
    ] {
        let (ours, _) = mouth.edge(degrees, most, from)?;
        let title = format!("J18 corner pocket at {degrees}°: left of the middle");
        // The angle is printed to half a thousandth of a degree too, which is worth 0.00005 in.
        rows.push(
            Row::printed(&title, LAW, (expected, 3), ours, "in")
                .within(5.6e-4)
                .by(CORNER_PAPER),
        );
    }
    let two_facings = |degrees: f64| {
        let (_, met) = CORNER.edge(degrees, 3, along_rail)?;
        Ok(met == [Met::Rail, Met::Facing, Met::Facing])
    };
    let switch = last((36.0, 40.0), two_facings)?;
    rows.push(
        Row::printed(
            "J18 corner pocket: rail, then the far point instead of two facings, from",
            LAW,
            (38.558, 3),
            switch,
            "°",
        )
        .by(CORNER_PAPER),
    );
    // The way by the rail begins as a narrow one beside the other: it is found once it is as wide as the search is fine,
    // here some 0.0001° late.
    let by_rail = |degrees: f64| {
        let (_, met) = CORNER.edge(degrees, 3, (0.95, 5e-6))?;
        Ok(met.first() == Some(&Met::Rail))
    };
    let switch = last((28.2, 28.1), by_rail)?;
    rows.push(
        Row::printed(
            "J18 corner pocket: the rail helps from",
            LAW,
            (28.167, 3),
            switch,
            "°",
        )
        // Half a unit of the last digit, and what the remark says.
        .within(1.4e-3)
        .remark("A ball that meets the rail within 8 µm of the point is nearer to the point than the 1e-9 m at which bodies touch, and meets both: that shifts the angle by 0.0008°.")
        .by(CORNER_PAPER),
    );
    Ok(rows)
}

/// J19: with the same error of aim, a straight shot misses by most if the cue ball and the object ball go equally far.
pub(super) fn straight() -> Result<Vec<Row>, Stopped> {
    const WHOLE: f64 = 2.0;
    const ERROR: f64 = 1e-5;
    let stand = Stand::POOL;
    // How far off the object ball passes the pocket, for a cue ball that goes this far to the hit.
    let miss = |way: f64| {
        let mut scene = stand.room(smooth(1.0));
        scene.place("cue", stand.ball, 0.0, 0.0);
        scene.place("1", stand.ball, way + 2.0 * stand.ball.radius, 0.0);
        let velocity = 3.0 * cut_line(ERROR);
        scene.balls[0].state = stand.moving(velocity, stand.ball.rolling_spin(velocity));
        let end = play(&scene)?.end[1].position;
        let start = scene.balls[1].state.position;
        Ok::<_, Stopped>((WHOLE - way) * libm::tan(turn(DVec3::X, end - start).abs()))
    };
    // The miss is a parabola in the way, but for the cube of the error of aim: its top from three points.
    let [a, b, c] = [miss(0.8)?, miss(1.0)?, miss(1.3)?];
    let slope_1 = (b - a) / 0.2;
    let slope_2 = (c - b) / 0.3;
    let bend = (slope_2 - slope_1) / 0.5;
    let top = 0.9 - 0.5 * slope_1 / bend;
    let most = WHOLE * WHOLE / (8.0 * stand.ball.radius) * ERROR;
    let source = "Alciatore, TP 3.4";
    Ok(vec![
        Row::closed(
            "J19 hardest straight shot: cue ball goes, of the whole way",
            "exact solver",
            0.5,
            top / WHOLE,
            "",
        )
        .within(1e-6)
        .by(source),
        Row::closed(
            "J19 hardest straight shot, 2 m, aim off by 1e-5: misses by",
            "exact solver",
            most,
            miss(1.0)?,
            "m",
        )
        .within(1e-6)
        .by(source),
    ])
}
