//! A scene before its shot: the balls, the cue, where it points.

use glam::DVec2;
use svg::node::element::{Group, Line};

use crate::physics::scene::{PlannedShot, Scene};
use crate::report::picture::table::disc;
use crate::report::picture::{Page, layer, number};

/// Length of the cue that is drawn, m; a picture that shows all of it shows little else.
const CUE: f64 = 0.55;

/// The line of aim, the ghost ball on it, and the cue.
pub(super) fn stroke(page: &Page, scene: &Scene, planned: &PlannedShot) -> Group {
    let mut group = layer("shot");
    let Some(ball) = scene.balls.get(planned.ball) else {
        return group;
    };
    let plan = |at: glam::DVec3| DVec2::new(at.x, at.z);
    let (from, way) = (plan(ball.state.position), plan(planned.shot.forward()));
    let radius = ball.ball.radius;
    let to_ball = (0..scene.balls.len())
        .filter(|other| *other != planned.ball && scene.balls[*other].state.motion.in_play())
        .filter_map(|other| {
            let other = &scene.balls[other];
            let (apart, reach) = (
                plan(other.state.position) - from,
                radius + other.ball.radius,
            );
            let along = apart.dot(way);
            let aside = apart.length_squared() - along * along;
            (along > 0.0 && aside < reach * reach).then(|| along - (reach * reach - aside).sqrt())
        })
        .fold(f64::INFINITY, f64::min);
    let half = 0.5 * DVec2::new(scene.table.length, scene.table.width) - radius;
    let to_rail = |from: f64, way: f64, half: f64| match way {
        way if way > 1e-12 => (half - from) / way,
        way if way < -1e-12 => (-half - from) / way,
        _ => f64::INFINITY,
    };
    let far = to_rail(from.x, way.x, half.x).min(to_rail(from.y, way.y, half.y));
    let end = from + way * far.min(to_ball).max(0.0);
    let dashed = line(page, from, end, "#ffffff", 1.4).set("stroke-dasharray", "6 5");
    let ghost = disc(page.point(end), page.length(radius), "none")
        .set("stroke", "#ffffff")
        .set("stroke-width", 1.2)
        .set("stroke-dasharray", "3 2.5");
    group = group.add(dashed).add(ghost);
    // The tip stands to the side by the english; a raised cue looks shorter from above.
    let right = DVec2::new(-way.y, way.x);
    let shot = &planned.shot;
    let lean = libm::cos(shot.elevation);
    let tip = from + radius * (shot.side * right - 1.15 * way);
    let butt = tip - CUE * lean * way;
    group
        .add(line(page, tip, butt, "#d9b679", 5.0).set("stroke-linecap", "round"))
        .add(line(page, tip, tip - 0.03 * way, "#f4f0e4", 5.0))
}

fn line(page: &Page, from: DVec2, to: DVec2, colour: &str, width: f64) -> Line {
    let (from, to) = (page.point(from), page.point(to));
    Line::new()
        .set("x1", number(from.x))
        .set("y1", number(from.y))
        .set("x2", number(to.x))
        .set("y2", number(to.y))
        .set("stroke", colour)
        .set("stroke-width", number(width))
}

/// The stroke in one line of words.
pub(super) fn caption(scene: &Scene) -> String {
    let Some(planned) = &scene.shot else {
        return format!("{} balls, no shot", scene.balls.len());
    };
    let shot = &planned.shot;
    let name = scene
        .balls
        .get(planned.ball)
        .map_or("?", |ball| ball.name.as_str());
    format!(
        "{name}: heading {:.2} degrees, speed of the cue {:.2} m/s, side {:+.2} R, height {:+.2} R, elevation {:.1} degrees",
        shot.heading.to_degrees(),
        shot.speed,
        shot.side,
        shot.height,
        shot.elevation.to_degrees()
    )
}
