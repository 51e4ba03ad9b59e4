//! What happened in the last shot.

use bevy_egui::egui;

use super::Desk;
use crate::physics::cue::Shot;
use crate::physics::record::{Event, EventKind};
use glam::DVec3;

/// Events listed at most.
const LISTED: usize = 200;

/// Lays out the summary and the list of events.
pub(super) fn show(ui: &mut egui::Ui, desk: &Desk) {
    let events = &desk.recorder.events;
    let Some(strike) = events
        .iter()
        .find(|e| matches!(e.kind, EventKind::Strike { .. }))
    else {
        ui.label("No shot yet.");
        return;
    };
    let names = names(desk);
    let name = |ball: usize| names.get(ball).map_or("?", String::as_str);
    summary(ui, desk, strike);
    let count = |kind: fn(&EventKind) -> bool| events.iter().filter(|e| kind(&e.kind)).count();
    ui.label(format!(
        "{} ball contacts, {} cushion contacts",
        count(|kind| matches!(kind, EventKind::BallBall)),
        count(|kind| matches!(kind, EventKind::Cushion { .. })),
    ));
    let potted: Vec<&str> = events
        .iter()
        .filter(|e| matches!(e.kind, EventKind::Pocketed { .. }))
        .map(|e| name(e.first.ball))
        .collect();
    if !potted.is_empty() {
        ui.label(format!("Potted: {}", potted.join(", ")));
    }
    egui::ScrollArea::vertical()
        .max_height(160.0)
        .id_salt("events")
        .show(ui, |ui| {
            let told = events
                .iter()
                .filter(|e| !matches!(e.kind, EventKind::Motion { .. }));
            for event in told.take(LISTED) {
                ui.label(line(desk, event, &name));
            }
        });
}

fn summary(ui: &mut egui::Ui, desk: &Desk, strike: &Event) {
    let EventKind::Strike { miscue } = strike.kind else {
        return;
    };
    let velocity = strike.first.after.velocity;
    ui.label(format!(
        "Speed after the strike {:.3} m/s{}",
        velocity.length(),
        if miscue { ", miscue" } else { "" }
    ));
    if let Some(shot) = desk.practice.history.last_shot() {
        use std::f64::consts::TAU;
        let way = Shot::heading_between(DVec3::ZERO, velocity) - shot.heading;
        let squirt = (way - TAU * (way / TAU).round()).to_degrees();
        ui.label(format!("Left the line of the cue by {squirt:+.3}°"));
    }
}

fn names(desk: &Desk) -> Vec<String> {
    let mut names: Vec<(usize, String)> = desk
        .balls
        .iter()
        .map(|ball| (ball.0.0, ball.1.0.clone()))
        .collect();
    names.sort_by_key(|(index, _)| *index);
    names.into_iter().map(|(_, name)| name).collect()
}

fn line<'a>(desk: &Desk, event: &Event, name: &impl Fn(usize) -> &'a str) -> String {
    let who = name(event.first.ball);
    let what = match event.kind {
        EventKind::Strike { .. } => format!("cue strikes {who}"),
        EventKind::Slate => format!("{who} lands"),
        EventKind::Rim { .. } => format!("{who} on the rim"),
        EventKind::OffTable => format!("{who} leaves the table"),
        EventKind::BallBall => {
            let other = event.second.map_or("?", |second| name(second.ball));
            format!("{who} and {other}")
        }
        EventKind::Cushion { cushion } => format!("{who}, cushion {cushion}"),
        EventKind::Pocketed { pocket } => {
            let pockets = &desk.playfield.table.pockets;
            let into = pockets.get(pocket).map_or("?", |pocket| &pocket.name);
            format!("{who} into {into}")
        }
        EventKind::Motion { from, to } => format!("{who} {from:?} to {to:?}"),
    };
    format!("{:7.4} s  {what}  {:.3} N s", event.time, event.impulse)
}
