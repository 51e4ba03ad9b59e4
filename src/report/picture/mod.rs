//! A picture of a run in SVG: the table from above, where the balls began, how they went, where they ended.
//!
//! The head of the table is on the left, z runs down the page. The same run gives the same text, byte for byte.

mod balls;
mod paths;
mod set_up;
mod style;
mod table;
mod trails;

pub use balls::colour;
pub use style::Style;

use glam::DVec2;
use svg::Document;
use svg::node::element::{Group, Rectangle, Text};

use crate::physics::ball::{Motion, State};
use crate::physics::record::Record;
use crate::physics::scene::Scene;

/// Pixels of the longer side of the table.
const SIZE: f64 = 1200.0;

/// The picture of a run as the text of an SVG file. Balls without a path are drawn where they lie.
#[must_use]
pub fn draw(title: &str, scene: &Scene, record: &Record) -> String {
    draw_as(title, scene, record, Style::default())
}

/// The picture of a scene before its shot, as the text of an SVG file.
#[must_use]
pub fn draw_set_up(title: &str, scene: &Scene) -> String {
    let page = Page::around(scene);
    let states: Vec<State> = scene.balls.iter().map(|ball| ball.state).collect();
    let mut layers = vec![table::draw(&page, &scene.table)];
    if let Some(planned) = &scene.shot {
        layers.push(set_up::stroke(&page, scene, planned));
    }
    layers.push(balls::ends(&page, scene, &states));
    document(&page, title, layers, &set_up::caption(scene))
}

/// As [`draw`], in a style.
#[must_use]
pub fn draw_as(title: &str, scene: &Scene, record: &Record, style: Style) -> String {
    let mut page = Page::around(scene);
    if style.numbers {
        page.list = style::room_for_list(scene, &record.events);
    }
    let end: Vec<State> = if record.end.len() == scene.balls.len() {
        record.end.clone()
    } else {
        scene.balls.iter().map(|ball| ball.state).collect()
    };
    let potted: Vec<usize> = (0..end.len())
        .filter(|&i| end[i].motion == Motion::Pocketed)
        .collect();
    let trails = trails::of(record);
    let mut layers = vec![
        table::draw(&page, &scene.table),
        if style.by_motion {
            style::paths(&page, &trails)
        } else {
            paths::draw(&page, scene, &trails)
        },
        balls::starts(&page, scene),
        paths::marks(&page, scene, &record.events),
        balls::ends(&page, scene, &end),
    ];
    if !potted.is_empty() {
        layers.push(balls::tray(&page, scene, &potted));
    }
    if style.ghosts {
        layers.insert(3, style::ghosts(&page, scene, &record.events));
    }
    if style.numbers {
        layers.push(style::numbers(&page, scene, &record.events));
    }
    let caption = format!("{} events in {:.3} s", record.events.len(), record.end_time);
    document(&page, title, layers, &caption)
}

/// A page with these layers.
fn document(page: &Page, title: &str, layers: Vec<Group>, caption: &str) -> String {
    let mut document = Document::new()
        .set(
            "viewBox",
            format!("0 0 {} {}", number(page.width()), number(page.height())),
        )
        .set("width", number(page.width()))
        .set("height", number(page.height()))
        .set("font-family", "Helvetica, Arial, sans-serif")
        .add(
            Rectangle::new()
                .set("width", "100%")
                .set("height", "100%")
                .set("fill", "#20242a"),
        )
        .add(line_of_text(Page::MARGIN, 30.0, 20.0, title));
    for layer in layers {
        document = document.add(layer);
    }
    document = document.add(line_of_text(
        Page::MARGIN,
        page.height() - page.list - 16.0,
        14.0,
        caption,
    ));
    let mut text = document.to_string();
    text.push('\n');
    text
}

/// How metres become pixels.
struct Page {
    /// Least corner of what is drawn, m.
    least: DVec2,
    /// Greatest corner, m.
    greatest: DVec2,
    /// Width of the rails, m.
    rail: f64,
    /// Pixels in a metre.
    scale: f64,
    /// Pixels at the bottom for the list of events.
    list: f64,
}

impl Page {
    /// Pixels around the table.
    const MARGIN: f64 = 24.0;
    /// Pixels above the table, for the title.
    const ABOVE: f64 = 48.0;
    /// Pixels below the table, for the tray and the caption.
    const BELOW: f64 = 84.0;

    fn around(scene: &Scene) -> Self {
        let table = &scene.table;
        let half = 0.5 * DVec2::new(table.length, table.width);
        let rail = 0.1024 * table.length.min(table.width);
        let (mut least, mut greatest) = (-half - rail, half + rail);
        for cushion in &table.cushions {
            let (low, high) = cushion.bounds();
            least = least.min(low);
            greatest = greatest.max(high);
        }
        let size = greatest - least;
        Self {
            least,
            greatest,
            rail,
            scale: SIZE / size.max_element(),
            list: 0.0,
        }
    }

    fn width(&self) -> f64 {
        self.length(self.greatest.x - self.least.x) + 2.0 * Self::MARGIN
    }

    fn height(&self) -> f64 {
        self.length(self.greatest.y - self.least.y) + Self::ABOVE + Self::BELOW + self.list
    }

    /// Pixels of a length in m.
    fn length(&self, length: f64) -> f64 {
        length * self.scale
    }

    /// Pixels of a point in plan in m.
    fn point(&self, point: DVec2) -> DVec2 {
        (point - self.least) * self.scale + DVec2::new(Self::MARGIN, Self::ABOVE)
    }

    /// Pixels of the place of a ball.
    fn place(&self, state: &State) -> DVec2 {
        self.point(DVec2::new(state.position.x, state.position.z))
    }
}

/// A number with two decimals: a hundredth of a pixel is finer than any eye.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

fn line_of_text(x: f64, y: f64, size: f64, text: &str) -> Text {
    Text::new(text)
        .set("x", number(x))
        .set("y", number(y))
        .set("font-size", number(size))
        .set("fill", "#e8e6df")
}

fn layer(name: &str) -> Group {
    Group::new().set("id", name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::ball::Ball;
    use crate::physics::laws::Laws;
    use crate::physics::scene::Rack;
    use crate::physics::table::Preset;

    fn rack() -> Scene {
        let mut scene = Scene::new(Preset::NineFoot.table(), Laws::default());
        Rack::EightBall.place(&mut scene, Ball::POOL, 0.0, 1);
        scene
    }

    #[test]
    fn the_same_run_gives_the_same_text() {
        let scene = rack();
        let mut record = Record {
            end: scene.balls.iter().map(|ball| ball.state).collect(),
            ..Record::default()
        };
        record.end[3].motion = Motion::Pocketed;
        let first = draw("a < b & c", &scene, &record);
        assert_eq!(first, draw("a < b & c", &scene, &record));
        assert!(first.contains("a &lt; b &amp; c"), "{}", &first[..600]);
        assert!(first.contains("id=\"potted\""));
    }

    #[test]
    fn x_runs_to_the_right_and_z_down() {
        let page = Page::around(&rack());
        let head_left = page.point(DVec2::new(-1.27, -0.635));
        let foot_right = page.point(DVec2::new(1.27, 0.635));
        assert!(foot_right.x > head_left.x && foot_right.y > head_left.y);
        assert!(foot_right.x < page.width() && foot_right.y < page.height());
    }
}
