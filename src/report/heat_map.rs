//! A map over two numbers as an SVG picture: where a shot succeeds, and how badly it fails elsewhere.

use svg::Document;
use svg::node::element::{Group, Line, Rectangle, Text};

/// What a map shows.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatMap<'a> {
    /// One line above it.
    pub title: &'a str,
    /// Name and unit of the number that changes across.
    pub across: (&'a str, &'a str),
    /// Name and unit of the number that changes upwards.
    pub along: (&'a str, &'a str),
    /// Values of the first, ascending.
    pub columns: &'a [f64],
    /// Values of the second, ascending.
    pub rows: &'a [f64],
    /// Row by row, not negative; 0 is a success.
    pub misses: &'a [f64],
    /// The values of the shot itself.
    pub shot: (f64, f64),
}

/// Pixels of the square of the map.
const SIDE: f64 = 560.0;

/// Pixels around it.
const LEFT: f64 = 110.0;
const TOP: f64 = 64.0;
const RIGHT: f64 = 130.0;
const BELOW: f64 = 70.0;

/// A success.
const MET: &str = "#3fae5a";

/// Failures, from a narrow to a wide miss, with the miss up to which each goes.
const MISSED: [(f64, &str, &str); 5] = [
    (0.01, "#f5d77c", "below 0.01"),
    (0.05, "#eda24a", "to 0.05"),
    (0.2, "#cf5f38", "to 0.2"),
    (1.0, "#8d2f3c", "to 1"),
    (f64::INFINITY, "#3d1f3a", "more"),
];

/// The colour of a cell with this miss, as `#rrggbb`.
#[must_use]
pub fn colour(miss: f64) -> &'static str {
    if miss == 0.0 {
        return MET;
    }
    let found = MISSED.iter().find(|(most, ..)| miss <= *most);
    found.map_or(MISSED[4].1, |(_, colour, _)| colour)
}

/// The picture as the text of an SVG file.
#[must_use]
pub fn draw(map: &HeatMap) -> String {
    let (width, height) = (LEFT + SIDE + RIGHT, TOP + SIDE + BELOW);
    let mut document = Document::new()
        .set("viewBox", format!("0 0 {width} {height}"))
        .set("width", width)
        .set("height", height)
        .set("font-family", "Helvetica, Arial, sans-serif")
        .add(
            Rectangle::new()
                .set("width", "100%")
                .set("height", "100%")
                .set("fill", "#20242a"),
        )
        .add(words(LEFT, 30.0, 18.0, "start", map.title))
        .add(words(
            LEFT,
            50.0,
            12.0,
            "start",
            "green: every expectation is met",
        ))
        .add(cells(map))
        .add(axes(map))
        .add(legend());
    if let Some(cross) = cross(map) {
        document = document.add(cross);
    }
    let mut text = document.to_string();
    text.push('\n');
    text
}

/// The cells, those of one colour in a row as one.
fn cells(map: &HeatMap) -> Group {
    let (columns, rows) = (map.columns.len(), map.rows.len());
    let (wide, high) = (SIDE / columns.max(1) as f64, SIDE / rows.max(1) as f64);
    let mut group = Group::new()
        .set("id", "cells")
        .set("shape-rendering", "crispEdges");
    for (row, misses) in map.misses.chunks(columns.max(1)).enumerate() {
        let y = TOP + SIDE - (row + 1) as f64 * high;
        let mut from = 0;
        for column in 1..=misses.len() {
            let same = misses
                .get(column)
                .is_some_and(|miss| colour(*miss) == colour(misses[from]));
            if same {
                continue;
            }
            group = group.add(
                Rectangle::new()
                    .set("x", short(LEFT + from as f64 * wide))
                    .set("y", short(y))
                    .set("width", short((column - from) as f64 * wide))
                    .set("height", short(high))
                    .set("fill", colour(misses[from])),
            );
            from = column;
        }
    }
    group
}

/// Names, units and five values on each side.
fn axes(map: &HeatMap) -> Group {
    let mut group = Group::new().set("id", "axes");
    let value = |values: &[f64], share: f64| {
        let (first, last) = (values.first().copied(), values.last().copied());
        let (first, last) = (first.unwrap_or(0.0), last.unwrap_or(0.0));
        (first + share * (last - first), last - first)
    };
    for i in 0..=4 {
        let share = f64::from(i) / 4.0;
        let (x, y) = (LEFT + share * SIDE, TOP + (1.0 - share) * SIDE);
        let (across, range) = value(map.columns, share);
        group = group.add(words(
            x,
            TOP + SIDE + 20.0,
            12.0,
            "middle",
            &tick(across, range),
        ));
        let (along, range) = value(map.rows, share);
        group = group.add(words(LEFT - 8.0, y + 4.0, 12.0, "end", &tick(along, range)));
    }
    let across = format!("{}, {}", map.across.0, map.across.1);
    let along = format!("{}, {}", map.along.0, map.along.1);
    let (x, y) = (28.0, TOP + 0.5 * SIDE);
    group
        .add(words(
            LEFT + 0.5 * SIDE,
            TOP + SIDE + 48.0,
            14.0,
            "middle",
            &across,
        ))
        .add(words(x, y, 14.0, "middle", &along).set("transform", format!("rotate(-90 {x} {y})")))
}

/// A number with the digits that its range needs.
fn tick(value: f64, range: f64) -> String {
    let decimals = if range > 0.0 {
        (2.0 - libm::floor(libm::log10(range))).clamp(0.0, 9.0) as usize
    } else {
        4
    };
    format!("{value:.decimals$}")
}

/// A cross at the shot.
fn cross(map: &HeatMap) -> Option<Group> {
    let share = |values: &[f64], value: f64| {
        let (first, last) = (*values.first()?, *values.last()?);
        // Cells are drawn around their values.
        let half = 0.5 / values.len() as f64;
        let share = (value - first) / (last - first);
        (0.0..=1.0)
            .contains(&share)
            .then_some(half + share * (1.0 - 2.0 * half))
    };
    let x = LEFT + share(map.columns, map.shot.0)? * SIDE;
    let y = TOP + (1.0 - share(map.rows, map.shot.1)?) * SIDE;
    let line = |dx: f64, dy: f64| {
        Line::new()
            .set("x1", short(x - dx))
            .set("x2", short(x + dx))
            .set("y1", short(y - dy))
            .set("y2", short(y + dy))
            .set("stroke", "#ffffff")
            .set("stroke-width", 1.5)
    };
    Some(
        Group::new()
            .set("id", "shot")
            .add(line(9.0, 0.0))
            .add(line(0.0, 9.0)),
    )
}

fn legend() -> Group {
    let mut group = Group::new().set("id", "legend");
    let x = LEFT + SIDE + 14.0;
    let rows = std::iter::once((MET, "met")).chain(MISSED.iter().map(|row| (row.1, row.2)));
    group = group.add(words(x, TOP + 12.0, 12.0, "start", "miss"));
    for (i, (colour, text)) in rows.enumerate() {
        let y = TOP + 24.0 + 22.0 * i as f64;
        let square = Rectangle::new()
            .set("x", x)
            .set("y", y)
            .set("width", 14)
            .set("height", 14)
            .set("fill", colour);
        group = group
            .add(square)
            .add(words(x + 22.0, y + 11.0, 12.0, "start", text));
    }
    group
}

fn words(x: f64, y: f64, size: f64, anchor: &str, text: &str) -> Text {
    Text::new(text)
        .set("x", short(x))
        .set("y", short(y))
        .set("font-size", size)
        .set("text-anchor", anchor)
        .set("fill", "#e8e6df")
}

fn short(value: f64) -> String {
    format!("{value:.2}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cell_has_the_colour_of_its_miss_and_neighbours_are_joined() {
        let map = HeatMap {
            title: "a < b",
            across: ("heading", "degrees"),
            along: ("speed", "m/s"),
            columns: &[0.0, 1.0, 2.0],
            rows: &[5.0, 6.0],
            misses: &[0.0, 0.0, 0.03, 9.0, 0.0, 0.004],
            shot: (1.0, 5.5),
        };
        let text = draw(&map);
        assert_eq!(text, draw(&map));
        assert!(text.contains("a &lt; b") && text.contains("heading, degrees"));
        let cells = text.split("id=\"axes\"").next().unwrap_or_default();
        // The three joined greens are two rectangles: two cells of the lower row, one of the upper.
        assert_eq!(cells.matches(MET).count(), 2, "{cells}");
        for miss in [0.03, 9.0, 0.004] {
            assert_eq!(cells.matches(colour(miss)).count(), 1, "{miss}");
        }
        assert!(text.contains("id=\"shot\""));
    }
}
