//! How much a stroke may vary, in the studio: the numbers of `masse sensitivity`, and its map over two of them. Worked out
//! beside the game.

use bevy::prelude::*;
use bevy::tasks::futures_lite::future;
use bevy::tasks::{AsyncComputeTaskPool, Task, block_on};
use bevy_egui::egui::{self, Align2, Color32, Rect, pos2, vec2};

use crate::report::heat_map;
use crate::scenarios::dial::Dial;
use crate::scenarios::file::Scenario;
use crate::scenarios::sensitivity::{self, Edge, Map, Room, SensitivityError, in_four_digits};
use crate::window::language::Language;

/// Values each way of the map.
const CELLS: usize = 41;

/// Side of the map in points.
const SIDE: f32 = 220.0;

/// Points to the left of the map and below it, for its ends.
const MARGIN: (f32, f32) = (56.0, 18.0);

/// What was worked out.
#[derive(Debug)]
struct Found {
    rooms: Vec<Room>,
    map: Map,
}

/// Of which shot, and what came of it.
#[derive(Debug)]
struct Outcome {
    of: Scenario,
    found: Result<Found, SensitivityError>,
}

/// Which two numbers are varied, and what came of it.
#[derive(Resource, Debug)]
pub struct Heat {
    over: (Dial, Dial),
    work: Option<Task<Outcome>>,
    done: Option<Outcome>,
}

impl Default for Heat {
    fn default() -> Self {
        Self {
            over: (Dial::Heading, Dial::Speed),
            work: None,
            done: None,
        }
    }
}

impl Heat {
    /// Begins to work out the sensitivity of a shot.
    fn begin(&mut self, scenario: Scenario) {
        let over = self.over;
        let work = async move { work(scenario, over) };
        self.work = Some(AsyncComputeTaskPool::get().spawn(work));
    }

    /// Takes what has been worked out.
    fn take(&mut self) {
        let Some(work) = &mut self.work else { return };
        if let Some(done) = block_on(future::poll_once(work)) {
            self.work = None;
            self.done = Some(done);
        }
    }

    /// Whether something is still worked out.
    #[must_use]
    pub fn is_working(&self) -> bool {
        self.work.is_some()
    }

    /// The share of the map on which the shot does what is expected, once it is there.
    #[must_use]
    pub fn met(&self) -> Option<f64> {
        let found = self.done.as_ref()?.found.as_ref().ok()?;
        Some(found.map.met())
    }
}

/// Works on all processors but one, which goes on with the game.
fn work(scenario: Scenario, over: (Dial, Dial)) -> Outcome {
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = rayon::ThreadPoolBuilder::new().num_threads((processors - 1).max(1));
    let find = || {
        let rooms = sensitivity::sensitivity(&scenario)?;
        let map = sensitivity::map_around(&scenario, &rooms, over, CELLS)?;
        Ok(Found { rooms, map })
    };
    let found = match threads.build() {
        Ok(pool) => pool.install(find),
        // Without threads of its own it takes those that are there.
        Err(_) => find(),
    };
    Outcome {
        of: scenario,
        found,
    }
}

/// Lays out the choice of two numbers, the map and the table; `scenario` is what lies on the table.
pub(super) fn show(
    ui: &mut egui::Ui,
    language: &Language,
    heat: &mut Heat,
    scenario: impl Fn() -> Scenario,
) {
    heat.take();
    ui.horizontal_wrapped(|ui| {
        let (across, along) = heat.over;
        let (mut a, mut b) = heat.over;
        choose(ui, language, "heat-across", &mut a);
        choose(ui, language, "heat-along", &mut b);
        // The same number twice is no map: the other one gives way.
        heat.over = match (a == b, a == across) {
            (false, _) => (a, b),
            (true, true) => (along, b),
            (true, false) => (a, across),
        };
        let button = egui::Button::new(language.text("heat-work"));
        if ui.add_enabled(heat.work.is_none(), button).clicked() {
            heat.begin(scenario());
        }
        if heat.work.is_some() {
            ui.spinner();
            ui.ctx().request_repaint();
        }
    });
    match &heat.done {
        None => {
            ui.add(egui::Label::new(language.text("heat-about")).wrap());
        }
        Some(Outcome {
            of,
            found: Ok(found),
        }) => {
            if of.scene.shot != scenario().scene.shot {
                ui.weak(language.text("heat-old"));
            }
            picture(ui, language, found);
            table(ui, language, of, found);
        }
        Some(Outcome {
            of,
            found: Err(error),
        }) => {
            let why = why(language, of, error);
            ui.add(egui::Label::new(why).wrap());
        }
    }
}

/// The key of the name of a number.
fn name(dial: Dial) -> &'static str {
    match dial {
        Dial::Heading => "number-heading",
        Dial::Speed => "number-power",
        Dial::Side => "number-side",
        Dial::Height => "number-height",
        Dial::Elevation => "number-elevation",
    }
}

fn unit(dial: Dial) -> &'static str {
    match dial {
        Dial::Heading | Dial::Elevation => "°",
        Dial::Speed => " m/s",
        Dial::Side | Dial::Height => " R",
    }
}

fn choose(ui: &mut egui::Ui, language: &Language, id: &str, dial: &mut Dial) {
    ui.label(language.text(id));
    egui::ComboBox::from_id_salt(id)
        .width(76.0)
        .selected_text(language.text(name(*dial)))
        .show_ui(ui, |ui| {
            for one in Dial::ALL {
                ui.selectable_value(dial, one, language.text(name(one)));
            }
        });
}

fn why(language: &Language, of: &Scenario, error: &SensitivityError) -> String {
    let key = match error {
        SensitivityError::NoShot => "heat-no-shot",
        SensitivityError::NothingExpected => "heat-nothing-expected",
        SensitivityError::NotExact => "heat-not-exact",
        SensitivityError::Misses { expectation } => {
            let missed = of.expect.get(*expectation);
            let missed = missed.map(|one| language.phrase(&one.wanted()));
            let values = [("missed", missed.unwrap_or_default().into())];
            return language.with("heat-misses", &values);
        }
    };
    language.text(key).to_owned()
}

/// The map, with its ends, and a cross where the shot is.
fn picture(ui: &mut egui::Ui, language: &Language, found: &Found) {
    let map = &found.map;
    let size = vec2(MARGIN.0 + SIDE, SIDE + MARGIN.1);
    let (whole, response) = ui.allocate_exact_size(size, egui::Sense::hover());
    if !ui.is_rect_visible(whole) {
        return;
    }
    let painter = ui.painter();
    let field = Rect::from_min_size(whole.min + vec2(MARGIN.0, 0.0), vec2(SIDE, SIDE));
    let (columns, rows) = (map.columns.len().max(1), map.rows.len().max(1));
    let step = vec2(SIDE / columns as f32, SIDE / rows as f32);
    for (i, miss) in map.misses.iter().enumerate() {
        let (column, row) = ((i % columns) as f32, (i / columns) as f32);
        let corner = pos2(
            field.left() + column * step.x,
            field.bottom() - (row + 1.0) * step.y,
        );
        let tint = Color32::from_hex(heat_map::colour(*miss)).unwrap_or(Color32::GRAY);
        // A little more than the cell, so that no line shows between two.
        painter.rect_filled(
            Rect::from_min_size(corner, step + vec2(0.5, 0.5)),
            0.0,
            tint,
        );
    }
    let share = |values: &[f64], value: f64| {
        let (first, last) = (values.first().copied()?, values.last().copied()?);
        let half = 0.5 / values.len() as f64;
        Some((half + (value - first) / (last - first) * (1.0 - 2.0 * half)) as f32)
    };
    let value = |dial: Dial| found.rooms.iter().find(|room| room.dial == dial);
    if let (Some(x), Some(y)) = (
        value(map.across).and_then(|room| share(&map.columns, room.value)),
        value(map.along).and_then(|room| share(&map.rows, room.value)),
    ) {
        let at = pos2(field.left() + x * SIDE, field.bottom() - y * SIDE);
        let line = egui::Stroke::new(1.5, Color32::WHITE);
        painter.hline(at.x - 6.0..=at.x + 6.0, at.y, line);
        painter.vline(at.x, at.y - 6.0..=at.y + 6.0, line);
    }
    let font = egui::FontId::proportional(11.0);
    let ink = ui.visuals().text_color();
    let write = |at, anchor: Align2, value: Option<&f64>, dial: Dial| {
        let value = value.map_or_else(String::new, |value| in_four_digits(*value) + unit(dial));
        painter.text(at, anchor, value, font.clone(), ink);
    };
    let below = field.bottom() + 3.0;
    write(
        pos2(field.left(), below),
        Align2::LEFT_TOP,
        map.columns.first(),
        map.across,
    );
    write(
        pos2(field.right(), below),
        Align2::RIGHT_TOP,
        map.columns.last(),
        map.across,
    );
    let beside = field.left() - 4.0;
    write(
        pos2(beside, field.bottom()),
        Align2::RIGHT_BOTTOM,
        map.rows.first(),
        map.along,
    );
    write(
        pos2(beside, field.top()),
        Align2::RIGHT_TOP,
        map.rows.last(),
        map.along,
    );
    let percent = format!("{:.1}", 100.0 * map.met());
    response.on_hover_text(language.with("heat-share", &[("percent", percent.into())]));
}

/// How far each number may be turned alone.
fn table(ui: &mut egui::Ui, language: &Language, of: &Scenario, found: &Found) {
    egui::Grid::new("heat")
        .num_columns(4)
        .striped(true)
        .show(ui, |ui| {
            for room in &found.rooms {
                let unit = unit(room.dial);
                ui.label(language.text(name(room.dial)));
                ui.label(in_four_digits(room.value) + unit);
                edge(
                    ui,
                    language,
                    of,
                    &room.below,
                    &format!("−{}", in_four_digits(room.below.by)),
                );
                edge(
                    ui,
                    language,
                    of,
                    &room.above,
                    &format!("+{}", in_four_digits(room.above.by)),
                );
                ui.end_row();
            }
        });
    ui.weak(language.text("heat-hint"));
}

fn edge(ui: &mut egui::Ui, language: &Language, of: &Scenario, edge: &Edge, text: &str) {
    let fails = edge.fails.and_then(|fails| of.expect.get(fails));
    let why = match fails {
        Some(one) => {
            let wanted = language.phrase(&one.wanted());
            language.with("heat-then-not", &[("wanted", wanted.into())])
        }
        None => language.text("heat-stop").to_owned(),
    };
    ui.label(text).on_hover_text(why);
}
