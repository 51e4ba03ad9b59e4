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
        ui.label(desk.language.text("last-none"));
        return;
    };
    let names = names(desk);
    let name = |ball: usize| names.get(ball).map_or("?", String::as_str);
    summary(ui, desk, strike);
    let count = |kind: fn(&EventKind) -> bool| events.iter().filter(|e| kind(&e.kind)).count();
    let balls = count(|kind| matches!(kind, EventKind::BallBall));
    let cushions = count(|kind| matches!(kind, EventKind::Cushion { .. }));
    let counts = [("balls", balls.into()), ("cushions", cushions.into())];
    ui.label(desk.language.with("last-contacts", &counts));
    let potted: Vec<&str> = events
        .iter()
        .filter(|e| matches!(e.kind, EventKind::Pocketed { .. }))
        .map(|e| name(e.first.ball))
        .collect();
    if !potted.is_empty() {
        let balls = [("balls", potted.join(", ").into())];
        ui.label(desk.language.with("last-potted", &balls));
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
    let speed = [("speed", format!("{:.3}", velocity.length()).into())];
    ui.label(desk.language.with("last-speed", &speed));
    if miscue {
        ui.label(desk.language.text("status-miscue"));
    }
    if let Some(shot) = desk.practice.history.last_shot() {
        use std::f64::consts::TAU;
        let way = Shot::heading_between(DVec3::ZERO, velocity) - shot.heading;
        let squirt = (way - TAU * (way / TAU).round()).to_degrees();
        let angle = [("angle", format!("{squirt:+.3}°").into())];
        ui.label(desk.language.with("last-squirt", &angle));
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
    let other = event.second.map_or("?", |second| name(second.ball));
    let mut values = vec![("ball", who.into()), ("other", other.into())];
    let key = match event.kind {
        EventKind::Strike { .. } => "event-strike",
        EventKind::Slate => "event-slate",
        EventKind::Rim { .. } => "event-rim",
        EventKind::OffTable => "event-off-table",
        EventKind::BallBall => "event-balls",
        EventKind::Cushion { cushion } => {
            values.push(("cushion", cushion.into()));
            "event-cushion"
        }
        EventKind::Pocketed { pocket } => {
            let pockets = &desk.playfield.table.pockets;
            let into = pockets.get(pocket).map_or("?", |pocket| &pocket.name);
            let key = format!("pocket-{}", into.replace(' ', "-"));
            let into = desk.language.find(&key).unwrap_or(into);
            values.push(("pocket", into.to_owned().into()));
            "event-pocketed"
        }
        EventKind::Motion { .. } => "event-motion",
    };
    let what = desk.language.with(key, &values);
    format!("{:7.4} s  {what}  {:.3} N s", event.time, event.impulse)
}
