//! The balls, in the colours of a set of pool balls.

use glam::DVec2;
use svg::node::element::{Group, Path, Text};

use crate::physics::ball::State;
use crate::physics::scene::Scene;
use crate::report::picture::table::disc;
use crate::report::picture::{Page, layer, line_of_text, number};

/// Ivory.
const WHITE: &str = "#f4f0e4";

/// The colours of the balls 1 to 8; the stripes 9 to 15 have those of 1 to 7.
const COLOURS: [&str; 8] = [
    "#f2c21b", "#1d4fb8", "#d0262b", "#5b2a86", "#ee7a1a", "#15803d", "#7c1f2b", "#16161a",
];

/// Half the height of a stripe, R.
const STRIPE: f64 = 0.55;

/// The colour of a ball, as `#rrggbb`, and whether it is striped, from its name; any other name takes the colours in turn.
#[must_use]
pub fn colour(name: &str, index: usize) -> (&'static str, bool) {
    match name {
        "cue" | "white" => (WHITE, false),
        "yellow" => (COLOURS[0], false),
        "red" => (COLOURS[2], false),
        _ => match name.parse::<usize>() {
            Ok(n @ 1..=8) => (COLOURS[n - 1], false),
            Ok(n @ 9..=15) => (COLOURS[n - 9], true),
            _ => (COLOURS[index % 7], false),
        },
    }
}

/// Where the balls began, faint.
pub(super) fn starts(page: &Page, scene: &Scene) -> Group {
    let mut group = layer("start").set("opacity", 0.4);
    for (i, ball) in scene.balls.iter().enumerate() {
        if ball.state.motion.in_play() {
            let radius = page.length(ball.ball.radius);
            group = drawn(group, &ball.name, i, page.place(&ball.state), radius);
        }
    }
    group
}

/// Where the balls ended, those in pockets left out.
pub(super) fn ends(page: &Page, scene: &Scene, end: &[State]) -> Group {
    let mut group = layer("end");
    for (i, (ball, state)) in scene.balls.iter().zip(end).enumerate() {
        if state.motion.in_play() {
            let radius = page.length(ball.ball.radius);
            group = drawn(group, &ball.name, i, page.place(state), radius);
        }
    }
    group
}

/// The balls in pockets, below the table.
pub(super) fn tray(page: &Page, scene: &Scene, potted: &[usize]) -> Group {
    let y = page.height() - page.list - Page::BELOW + 28.0;
    let radius = 12.0;
    let mut group = layer("potted").add(line_of_text(Page::MARGIN, y + 5.0, 14.0, "potted"));
    let mut x = Page::MARGIN + 72.0;
    for &i in potted {
        group = drawn(group, &scene.balls[i].name, i, DVec2::new(x, y), radius);
        x += 2.4 * radius;
    }
    group
}

fn drawn(mut group: Group, name: &str, index: usize, place: DVec2, radius: f64) -> Group {
    let (colour, striped) = colour(name, index);
    group = group.add(
        disc(place, radius, if striped { WHITE } else { colour })
            .set("stroke", "#0b0b0d")
            .set("stroke-width", number((0.05 * radius).max(0.3))),
    );
    if striped {
        group = group.add(stripe(place, radius, colour));
    }
    if name == "cue" || name.chars().count() > 2 || radius < 4.0 {
        return group;
    }
    let number_disc = disc(place, 0.52 * radius, WHITE);
    let text = Text::new(name)
        .set("x", number(place.x))
        .set("y", number(place.y + 0.26 * radius))
        .set("font-size", number(0.72 * radius))
        .set("font-weight", "bold")
        .set("text-anchor", "middle")
        .set("fill", "#16161a");
    group.add(number_disc).add(text)
}

/// The band of a striped ball.
fn stripe(place: DVec2, radius: f64, colour: &str) -> Path {
    let (high, wide) = (STRIPE * radius, (1.0 - STRIPE * STRIPE).sqrt() * radius);
    let (left, right) = (number(place.x - wide), number(place.x + wide));
    let (top, bottom) = (number(place.y - high), number(place.y + high));
    let r = number(radius);
    let outline = format!(
        "M{left} {top}L{right} {top}A{r} {r} 0 0 1 {right} {bottom}L{left} {bottom}A{r} {r} 0 0 1 {left} {top}Z"
    );
    Path::new().set("d", outline).set("fill", colour)
}
