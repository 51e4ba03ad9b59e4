//! A still picture of a scene: the table from above, the balls, and the paths of the shot.

use bevy_egui::egui::{self, Color32, Pos2, Rect, Shape, Stroke};

use crate::physics::exact::{Limits, solve};
use crate::physics::scene::{Scene, Solver};
use crate::report::picture::colour;

/// Points of a path.
const POINTS: u32 = 240;

/// Events after which a path is cut.
const EVENTS: u64 = 20_000;

/// Wood around the cloth, as a share of the width of the table.
const RAIL: f32 = 0.07;

const CLOTH: Color32 = Color32::from_rgb(18, 92, 78);
const WOOD: Color32 = Color32::from_rgb(74, 40, 22);

/// A disc of the picture: centre and radius in m from the corner of the cloth, colour.
type Disc = ([f32; 2], f32, Color32);

/// What a picture shows, in m.
#[derive(Debug, Default)]
pub(super) struct Still {
    size: [f32; 2],
    pockets: Vec<Disc>,
    balls: Vec<Disc>,
    paths: Vec<(Vec<[f32; 2]>, Color32)>,
}

impl Still {
    /// Plays the scene and draws what happens. Where it cannot be played exactly there are no paths.
    pub(super) fn of(scene: &Scene) -> Self {
        let (length, width) = (scene.table.length, scene.table.width);
        let place = |x: f64, z: f64| [(x + 0.5 * length) as f32, (z + 0.5 * width) as f32];
        let tint = |ball: usize| {
            let (hex, _) = colour(&scene.balls[ball].name, ball);
            Color32::from_hex(hex).unwrap_or(Color32::WHITE)
        };
        let in_play = |ball: &usize| scene.balls[*ball].state.motion.in_play();
        let pockets = scene.table.pockets.iter().map(|pocket| {
            let at = place(pocket.center.x, pocket.center.y);
            (at, pocket.radius as f32, Color32::BLACK)
        });
        let balls = (0..scene.balls.len()).filter(in_play).map(|i| {
            let ball = &scene.balls[i];
            let at = ball.state.position;
            (place(at.x, at.z), ball.ball.radius as f32, tint(i))
        });
        let mut still = Self {
            size: [length as f32, width as f32],
            pockets: pockets.collect(),
            balls: balls.collect(),
            paths: Vec::new(),
        };
        let exact = Scene {
            solver: Solver::Exact,
            ..scene.clone()
        };
        let Ok(record) = solve(&exact, Limits { events: EVENTS }) else {
            return still;
        };
        for ball in 0..scene.balls.len() {
            let mut points: Vec<[f32; 2]> = Vec::new();
            for step in 0..=POINTS {
                let time = record.end_time * f64::from(step) / f64::from(POINTS);
                let state = record.state_at(ball, time);
                if !state.motion.in_play() {
                    break;
                }
                let point = place(state.position.x, state.position.z);
                if points.last() != Some(&point) {
                    points.push(point);
                }
            }
            if points.len() > 1 {
                still.paths.push((points, tint(ball)));
            }
        }
        still
    }
}

/// Lays out a picture of this size in points, or an empty table while it is not there yet.
pub(super) fn show(ui: &mut egui::Ui, still: Option<&Still>, size: egui::Vec2) -> egui::Response {
    let (rect, response) = ui.allocate_exact_size(size, egui::Sense::click());
    if !ui.is_rect_visible(rect) {
        return response;
    }
    let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
    painter.rect_filled(rect, 3.0, WOOD);
    let rail = RAIL * rect.height();
    let cloth = rect.shrink(rail);
    let Some(still) = still else {
        painter.rect_filled(cloth, 0.0, CLOTH);
        return response;
    };
    let [length, width] = still.size;
    let scale = (cloth.width() / length).min(cloth.height() / width);
    let bed = Rect::from_center_size(cloth.center(), scale * egui::vec2(length, width));
    painter.rect_filled(bed, 0.0, CLOTH);
    let at = |[x, z]: [f32; 2]| -> Pos2 { bed.min + scale * egui::vec2(x, z) };
    for (center, radius, tint) in &still.pockets {
        painter.circle_filled(at(*center), (scale * radius).max(2.0), *tint);
    }
    for (points, tint) in &still.paths {
        let points = points.iter().map(|point| at(*point)).collect();
        painter.add(Shape::line(points, Stroke::new(1.2, *tint)));
    }
    for (center, radius, tint) in &still.balls {
        painter.circle(
            at(*center),
            (scale * radius).max(2.4),
            *tint,
            Stroke::new(0.5, Color32::BLACK),
        );
    }
    if response.hovered() {
        let light = Stroke::new(1.5, ui.visuals().strong_text_color());
        painter.rect_stroke(rect, 3.0, light, egui::StrokeKind::Inside);
    }
    response
}
