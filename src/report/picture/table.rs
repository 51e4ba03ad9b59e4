//! The table from above.

use glam::DVec2;
use svg::node::element::{Circle, Group, Line, Rectangle};

use crate::physics::table::{Cushion, Table};
use crate::report::picture::{Page, layer, number};

/// Distance of the diamonds from the noses, as a share of the rail's width.
const DIAMONDS_AT: f64 = 0.72;

pub(super) fn draw(page: &Page, table: &Table) -> Group {
    let half = 0.5 * DVec2::new(table.length, table.width);
    let mut group = layer("table")
        .add(
            box_around(page, half + page.rail, "#5a3a22")
                .set("rx", number(page.length(0.5 * page.rail))),
        )
        .add(box_around(page, half + 0.4 * page.rail, "#0e5238"))
        .add(box_around(page, half, "#17704c"));
    for pocket in &table.pockets {
        // The mouth: cloth from the hole to a little inside the playing surface.
        let inner = pocket.center.clamp(-half, half);
        let inwards = (inner - pocket.center).normalize_or_zero();
        let mouth = stroke(
            page.point(pocket.center),
            page.point(inner + 0.7 * pocket.radius * inwards),
            "#17704c",
            page.length(1.75 * pocket.radius),
        );
        let edge = disc(
            page.point(pocket.center),
            page.length(1.15 * pocket.radius),
            "#17704c",
        );
        group = group.add(mouth).add(edge);
    }
    for pocket in &table.pockets {
        group = group.add(disc(
            page.point(pocket.center),
            page.length(pocket.radius),
            "#0b0b0d",
        ));
    }
    for cushion in &table.cushions {
        group = match cushion {
            Cushion::Line(line) => {
                let (from, to) = (page.point(line.from), page.point(line.to));
                group.add(stroke(from, to, "#7fc6a2", 1.5))
            }
            Cushion::Arc(arc) => group.add(
                disc(
                    page.point(arc.center),
                    page.length(arc.radius).max(0.75),
                    "#0e5238",
                )
                .set("stroke", "#7fc6a2")
                .set("stroke-width", 1),
            ),
        };
    }
    markings(page, table, group)
}

/// Diamonds, head string and foot spot.
fn markings(page: &Page, table: &Table, mut group: Group) -> Group {
    let half = 0.5 * DVec2::new(table.length, table.width);
    let out = DIAMONDS_AT * page.rail;
    let has_sides = table
        .pockets
        .iter()
        .any(|p| p.center.x.abs() < 0.1 * half.x);
    let mut places = Vec::new();
    for i in 1..8 {
        if i == 4 && has_sides {
            continue;
        }
        let x = table.length * (f64::from(i) / 8.0 - 0.5);
        places.extend([DVec2::new(x, -half.y - out), DVec2::new(x, half.y + out)]);
    }
    for i in 1..4 {
        let z = table.width * (f64::from(i) / 4.0 - 0.5);
        places.extend([DVec2::new(-half.x - out, z), DVec2::new(half.x + out, z)]);
    }
    for place in places {
        group = group.add(disc(
            page.point(place),
            page.length(0.05 * page.rail),
            "#e9dfc4",
        ));
    }
    let head = table.head_spot();
    let string = stroke(
        page.point(DVec2::new(head.x, -half.y)),
        page.point(DVec2::new(head.x, half.y)),
        "#2f8a63",
        1.0,
    );
    group.add(string.set("stroke-dasharray", "6 6")).add(disc(
        page.point(table.foot_spot()),
        2.0,
        "#0e5238",
    ))
}

fn box_around(page: &Page, half: DVec2, fill: &str) -> Rectangle {
    let (least, greatest) = (page.point(-half), page.point(half));
    Rectangle::new()
        .set("x", number(least.x))
        .set("y", number(least.y))
        .set("width", number(greatest.x - least.x))
        .set("height", number(greatest.y - least.y))
        .set("fill", fill)
}

pub(super) fn disc(place: DVec2, radius: f64, fill: &str) -> Circle {
    Circle::new()
        .set("cx", number(place.x))
        .set("cy", number(place.y))
        .set("r", number(radius))
        .set("fill", fill)
}

fn stroke(from: DVec2, to: DVec2, colour: &str, width: f64) -> Line {
    Line::new()
        .set("x1", number(from.x))
        .set("y1", number(from.y))
        .set("x2", number(to.x))
        .set("y2", number(to.y))
        .set("stroke", colour)
        .set("stroke-width", number(width))
}
