//! How far a shot is from potting a ball, from an order of contacts, from a moment.

use glam::DVec2;

use crate::physics::record::{Event, EventKind, Record};
use crate::physics::scene::Scene;
use crate::scenarios::expect::measure::{Reading, Shown};
use crate::scenarios::expect::trace::{self, Span, place, plan};
use crate::scenarios::expect::{Contact, Moment};

/// A step of a shot that did not happen counts as much as this many metres.
const STEP: f64 = 0.5;

/// What counts where nothing says how near a shot came.
const UNKNOWN: f64 = 1.0;

fn whole(record: &Record) -> Span {
    Span {
        from: 0.0,
        until: record.end_time,
    }
}

/// The distance in m in space between the surfaces of two balls.
pub(super) fn gap(scene: &Scene, record: &Record, [a, b]: [usize; 2], time: f64) -> f64 {
    let apart = place(record, a, time).distance(place(record, b, time));
    apart - scene.balls[a].ball.radius - scene.balls[b].ball.radius
}

/// The least gap between two balls from a time on, m.
fn least_gap(scene: &Scene, record: &Record, pair: [usize; 2], from: f64) -> f64 {
    let span = Span {
        from,
        until: record.end_time,
    };
    trace::least(record, &pair, span, |time| gap(scene, record, pair, time))
        .map_or(UNKNOWN, |(_, gap)| gap.max(0.0))
}

/// How an event takes a ball out of play, if it does.
fn fall(event: &Event, ball: usize) -> Option<Shown> {
    let time = event.time;
    match event.kind {
        _ if event.first.ball != ball => None,
        EventKind::Pocketed { pocket } => Some(Shown::Fell { pocket, time }),
        EventKind::OffTable => Some(Shown::Left { time }),
        _ => None,
    }
}

/// A ball that a pocket should take.
pub(super) fn potted(scene: &Scene, record: &Record, ball: usize, name: Option<&str>) -> Reading {
    let fell = record
        .events
        .iter()
        .rev()
        .find_map(|event| fall(event, ball));
    let right = |pocket: usize| name.is_none_or(|name| scene.table.pockets[pocket].name == name);
    match fell {
        Some(Shown::Fell { pocket, .. }) if right(pocket) => {
            return Reading::new(fell.unwrap_or(Shown::Stayed), 0.0);
        }
        _ => {}
    }
    let wanted = |pocket: &&_| -> bool {
        let pocket: &crate::physics::table::Pocket = pocket;
        name.is_none_or(|name| pocket.name == name)
    };
    let span = whole(record);
    let away = |center: DVec2, radius: f64| {
        let away = |time: f64| plan(place(record, ball, time)).distance(center) - radius;
        trace::least(record, &[ball], span, away).map_or(UNKNOWN, |(_, away)| away.max(0.0))
    };
    let pockets = scene.table.pockets.iter().filter(wanted);
    let mut miss = pockets
        .map(|pocket| away(pocket.center, pocket.radius))
        .fold(f64::INFINITY, f64::min)
        .clamp(1e-3, 4.0);
    if fell.is_some() {
        miss += STEP;
    }
    if !trace::moved(record, ball) {
        let nearest = (0..scene.balls.len())
            .filter(|other| *other != ball && trace::moved(record, *other))
            .map(|other| least_gap(scene, record, [ball, other], 0.0))
            .fold(4.0, f64::min);
        miss += STEP + nearest;
    }
    Reading::new(fell.unwrap_or(Shown::Stayed), miss)
}

/// A ball that should stay in play.
pub(super) fn stays(record: &Record, ball: usize) -> Reading {
    let fell = record.events.iter().rev().find_map(|event| {
        let speed = event.first.before.velocity.length();
        fall(event, ball).map(|shown| (shown, speed))
    });
    // The faster it falls, the farther the shot is from one in which it stays.
    match fell {
        Some((shown, speed)) => Reading::new(shown, 0.2 + 0.1 * speed),
        None => Reading::new(Shown::Stayed, 0.0),
    }
}

/// Contacts that should come in this order.
pub(super) fn order(scene: &Scene, record: &Record, contacts: &[Contact]) -> Reading {
    let mut done = 0;
    let mut reached = 0.0;
    for event in &record.events {
        match contacts.get(done) {
            Some(next) if next.is(scene, event) => {
                done += 1;
                reached = event.time;
            }
            _ => {}
        }
    }
    let of = contacts.len();
    let miss = match contacts.get(done) {
        None => 0.0,
        Some(next) => {
            let left = (of - done - 1) as f64;
            STEP * left + 0.01 + away_from_contact(next, scene, record, reached)
        }
    };
    Reading::new(Shown::Steps { done, of }, miss)
}

/// A contact that should not happen.
pub(super) fn never(scene: &Scene, record: &Record, contact: &Contact) -> Reading {
    let found = record.events.iter().find(|event| contact.is(scene, event));
    let miss = found.map_or(0.0, |event| {
        // A hit that only just grazes is nearer to none than a full one.
        let pushed = event.second.map_or(1.0, |second| {
            let gained = (second.after.velocity - second.before.velocity).length();
            gained / (gained + 0.5)
        });
        0.05 + 0.3 * pushed
    });
    Reading::new(Shown::Happened(found.map(|event| event.time)), miss)
}

/// How far a shot is from a contact that did not happen after a time.
fn away_from_contact(contact: &Contact, scene: &Scene, record: &Record, after: f64) -> f64 {
    let index = |name: &str| scene.ball_named(name);
    match contact {
        Contact::Hit(a, b) => match (index(a), index(b)) {
            (Some(a), Some(b)) => least_gap(scene, record, [a, b], after),
            _ => UNKNOWN,
        },
        Contact::Falls(ball) => index(ball).map_or(UNKNOWN, |ball| {
            potted(scene, record, ball, None).miss.min(UNKNOWN)
        }),
        Contact::FallsInto(ball, pocket) => index(ball).map_or(UNKNOWN, |ball| {
            potted(scene, record, ball, Some(pocket)).miss.min(UNKNOWN)
        }),
        Contact::Rail(ball) | Contact::RailAt(ball, _) => index(ball).map_or(UNKNOWN, |ball| {
            let at = plan(record.state_at(ball, record.end_time).position);
            let half = 0.5 * DVec2::new(scene.table.length, scene.table.width);
            0.1 + (half - at.abs()).min_element().clamp(0.0, UNKNOWN)
        }),
        Contact::Lands(_) | Contact::Leaves(_) => UNKNOWN,
    }
}

/// How far a shot is from a moment that did not come.
pub(super) fn away_from(moment: &Moment, scene: &Scene, record: &Record) -> f64 {
    match moment {
        Moment::Hit(a, b) | Moment::After(a, b) => match (scene.ball_named(a), scene.ball_named(b))
        {
            (Some(a), Some(b)) => least_gap(scene, record, [a, b], 0.0),
            _ => UNKNOWN,
        },
        Moment::Rail(ball, number) | Moment::AfterRail(ball, number) => {
            let is = |event: &&Event| {
                let rail = matches!(event.kind, EventKind::Cushion { .. });
                rail && scene
                    .balls
                    .get(event.first.ball)
                    .is_some_and(|b| b.name == *ball)
            };
            let found = record.events.iter().filter(is).count() as f64;
            STEP * (f64::from(*number) - found).max(0.0)
        }
        Moment::Falls(ball) => scene.ball_named(ball).map_or(UNKNOWN, |ball| {
            potted(scene, record, ball, None).miss.min(UNKNOWN)
        }),
        Moment::Start
        | Moment::End
        | Moment::At(_)
        | Moment::Rolls(_)
        | Moment::Rests(_)
        | Moment::Lands(_) => UNKNOWN,
    }
}
