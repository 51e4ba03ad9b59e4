//! What a diagram adds to the plain picture: colours of motion, ghost balls, numbers.

use glam::DVec2;
use svg::node::element::{Group, Polyline, Text};

use crate::physics::ball::{Motion, State};
use crate::physics::record::{Event, EventKind};
use crate::physics::scene::Scene;
use crate::report::picture::balls::colour;
use crate::report::picture::paths::{CROWD, thinned};
use crate::report::picture::table::disc;
use crate::report::picture::{Page, layer, line_of_text, number};

/// How a run is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Style {
    /// Paths have the colour of the motion instead of that of the ball.
    pub by_motion: bool,
    /// Balls are outlined where they met others.
    pub ghosts: bool,
    /// Events are numbered, and listed below.
    pub numbers: bool,
}

impl Style {
    /// Everything that a diagram can have.
    pub const DIAGRAM: Self = Self {
        by_motion: true,
        ghosts: true,
        numbers: true,
    };
}

/// Most events that are numbered: with more nobody finds his way.
const MOST_NUMBERED: usize = 45;

/// Most hits of which ghosts are drawn.
const MOST_GHOSTS: usize = 40;

/// Columns of the list of events, and pixels of a row.
const COLUMNS: usize = 3;
const ROW: f64 = 18.0;

/// The colour of a path on which a ball moves like this, and the word for it.
fn of_motion(motion: Motion) -> Option<(&'static str, &'static str)> {
    match motion {
        Motion::Sliding => Some(("#ff9f43", "slides")),
        Motion::Rolling => Some(("#7fd0ff", "rolls")),
        Motion::Airborne => Some(("#f08bfb", "flies")),
        Motion::Gliding => Some(("#d5dae2", "glides")),
        Motion::Tipping => Some(("#ff6b6b", "tips")),
        Motion::Rest | Motion::Spinning | Motion::Wedged | Motion::Pocketed | Motion::OffTable => {
            None
        }
    }
}

/// Every path in the colours of its motion, and what they mean.
pub(super) fn paths(page: &Page, trails: &[Vec<State>]) -> Group {
    let mut group = layer("paths")
        .set("fill", "none")
        .set("stroke-linejoin", "round")
        .set("stroke-width", "2.2");
    let mut used = Vec::new();
    for trail in trails {
        for stretch in trail.chunk_by(|a, b| a.motion == b.motion) {
            let Some(look) = of_motion(stretch[0].motion) else {
                continue;
            };
            let mut points: Vec<DVec2> = stretch.iter().map(|state| page.place(state)).collect();
            points.dedup();
            if points.len() < 2 {
                continue;
            }
            if !used.contains(&look) {
                used.push(look);
            }
            group = group.add(polyline(&thinned(&points), look.0));
        }
    }
    let y = Page::ABOVE - 12.0;
    let mut x = page.width() - Page::MARGIN - 110.0 * used.len() as f64;
    for (colour, word) in used {
        let line = polyline(
            &[DVec2::new(x, y - 4.0), DVec2::new(x + 22.0, y - 4.0)],
            colour,
        );
        group = group
            .add(line.set("stroke-width", "4"))
            .add(line_of_text(x + 28.0, y, 13.0, word).set("stroke", "none"));
        x += 110.0;
    }
    group
}

fn polyline(points: &[DVec2], colour: &str) -> Polyline {
    let points: Vec<String> = points
        .iter()
        .map(|point| format!("{},{}", number(point.x), number(point.y)))
        .collect();
    Polyline::new()
        .set("points", points.join(" "))
        .set("stroke", colour)
}

/// The outline of each ball that came to a hit, where it was then.
pub(super) fn ghosts(page: &Page, scene: &Scene, events: &[Event]) -> Group {
    let mut group = layer("ghosts")
        .set("fill", "none")
        .set("stroke-dasharray", "3 2.5");
    if scene.balls.len() > CROWD {
        return group;
    }
    let hits = events
        .iter()
        .filter(|event| event.kind == EventKind::BallBall);
    for part in hits.take(MOST_GHOSTS).flat_map(Event::participants) {
        let Some(ball) = scene.balls.get(part.ball) else {
            continue;
        };
        let radius = ball.ball.radius;
        if part.before.position.distance(ball.state.position) < 0.2 * radius {
            continue;
        }
        group = group.add(
            disc(page.place(&part.before), page.length(radius), "none")
                .set("stroke", colour(&ball.name, part.ball).0)
                .set("stroke-width", 1.4),
        );
    }
    group
}

/// What is said of an event; none if it is not numbered.
fn told(scene: &Scene, event: &Event) -> Option<String> {
    let name = |ball: usize| scene.balls.get(ball).map_or("?", |ball| ball.name.as_str());
    let first = name(event.first.ball);
    let what = match event.kind {
        EventKind::Strike { miscue: false } => format!("the cue strikes {first}"),
        EventKind::Strike { miscue: true } => format!("the cue slips off {first}"),
        EventKind::BallBall => {
            format!(
                "{first} meets {}",
                event.second.map_or("?", |second| name(second.ball))
            )
        }
        EventKind::Cushion { .. } => format!("{first} meets a cushion"),
        EventKind::Slate => format!("{first} lands"),
        EventKind::Pocketed { pocket } => {
            let pocket = scene.table.pockets.get(pocket);
            format!(
                "{first} falls into {}",
                pocket.map_or("a pocket", |p| p.name.as_str())
            )
        }
        EventKind::OffTable => format!("{first} leaves the table"),
        EventKind::Motion { .. } | EventKind::Rim { .. } => return None,
    };
    Some(format!("{:.3} s  {what}", event.time))
}

/// The events that get numbers, and how many others there are.
fn numbered<'e>(scene: &Scene, events: &'e [Event]) -> (Vec<(&'e Event, String)>, usize) {
    if scene.balls.len() > CROWD {
        return (Vec::new(), 0);
    }
    let mut all: Vec<(&Event, String)> = events
        .iter()
        .filter_map(|event| Some((event, told(scene, event)?)))
        .collect();
    let more = all.len().saturating_sub(MOST_NUMBERED);
    all.truncate(MOST_NUMBERED);
    (all, more)
}

/// Pixels that the list takes below the picture.
pub(super) fn room_for_list(scene: &Scene, events: &[Event]) -> f64 {
    let (all, more) = numbered(scene, events);
    let rows = (all.len() + usize::from(more > 0)).div_ceil(COLUMNS);
    if rows == 0 {
        0.0
    } else {
        ROW * rows as f64 + 16.0
    }
}

/// A number at each event, and the list.
pub(super) fn numbers(page: &Page, scene: &Scene, events: &[Event]) -> Group {
    let mut group = layer("numbers");
    let (all, more) = numbered(scene, events);
    let rows = (all.len() + usize::from(more > 0)).div_ceil(COLUMNS).max(1);
    let top = page.height() - room_for_list(scene, events);
    let width = (page.width() - 2.0 * Page::MARGIN) / COLUMNS as f64;
    let at = |i: usize| {
        let (column, row) = (i / rows, i % rows);
        DVec2::new(
            Page::MARGIN + column as f64 * width,
            top + ROW * (row + 1) as f64,
        )
    };
    let mut placed: Vec<DVec2> = Vec::new();
    for (i, (event, told)) in all.iter().enumerate() {
        let mut place = page.place(&event.first.before) + DVec2::new(9.0, -9.0);
        // Events in one place stand one above the other.
        while placed
            .iter()
            .any(|other| (*other - place).abs().cmplt(DVec2::new(14.0, 11.0)).all())
        {
            place.y -= 12.0;
        }
        placed.push(place);
        let label = (i + 1).to_string();
        let halo = Text::new(label.clone())
            .set("x", number(place.x))
            .set("y", number(place.y))
            .set("font-size", 12)
            .set("fill", "#0b2a1e")
            .set("stroke", "#0b2a1e")
            .set("stroke-width", 3)
            .set("stroke-linejoin", "round");
        let row = at(i);
        group = group
            .add(halo)
            .add(line_of_text(place.x, place.y, 12.0, &label).set("fill", "#fff6d0"))
            .add(line_of_text(
                row.x,
                row.y,
                13.0,
                &format!("{label}  {told}"),
            ));
    }
    if more > 0 {
        let row = at(all.len());
        group = group.add(line_of_text(
            row.x,
            row.y,
            13.0,
            &format!("and {more} more"),
        ));
    }
    group
}
