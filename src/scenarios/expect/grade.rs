//! How far a shot is from potting a ball, from an order of contacts, from a moment.

use glam::DVec2;

use crate::physics::record::{Event, EventKind};
use crate::scenarios::expect::reading::{Play, Reading, Shown};
use crate::scenarios::expect::trace::{self, Span, place, plan};
use crate::scenarios::expect::{Contact, Moment};

/// A step of a shot that did not happen counts as much as this many metres.
const STEP: f64 = 0.5;

/// What counts where nothing says how near a shot came.
const UNKNOWN: f64 = 1.0;

/// The distance in m in space between the surfaces of two balls.
pub(super) fn gap(play: &Play, [a, b]: [usize; 2], time: f64) -> f64 {
    let (scene, record) = (play.scene, play.record);
    let apart = place(record, a, time).distance(place(record, b, time));
    apart - scene.balls[a].ball.radius - scene.balls[b].ball.radius
}

/// The least gap between two balls from a time on, m.
fn least_gap(play: &Play, pair: [usize; 2], from: f64) -> f64 {
    let span = Span {
        from,
        ..play.whole()
    };
    trace::least(play.record, &pair, span, |time| gap(play, pair, time))
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
pub(super) fn potted(play: &Play, ball: usize, name: Option<&str>) -> Reading {
    let (scene, record) = (play.scene, play.record);
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
    let span = play.whole();
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
            .map(|other| least_gap(play, [ball, other], 0.0))
            .fold(4.0, f64::min);
        miss += STEP + nearest;
    }
    Reading::new(fell.unwrap_or(Shown::Stayed), miss)
}

/// A ball that should stay in play.
pub(super) fn stays(play: &Play, ball: usize) -> Reading {
    let fell = play.record.events.iter().rev().find_map(|event| {
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
pub(super) fn order(play: &Play, contacts: &[Contact]) -> Reading {
    let mut done = 0;
    let mut reached = 0.0;
    for event in &play.record.events {
        match contacts.get(done) {
            Some(next) if next.is(play.scene, event) => {
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
            STEP * left + 0.01 + away_from_contact(play, next, reached)
        }
    };
    Reading::new(Shown::Steps { done, of }, miss)
}

/// A contact that should not happen.
pub(super) fn never(play: &Play, contact: &Contact) -> Reading {
    let mut events = play.record.events.iter();
    let found = events.find(|event| contact.is(play.scene, event));
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
fn away_from_contact(play: &Play, contact: &Contact, after: f64) -> f64 {
    let (scene, record) = (play.scene, play.record);
    let index = |name: &str| scene.ball_named(name);
    match contact {
        Contact::Hit(a, b) => match (index(a), index(b)) {
            (Some(a), Some(b)) => least_gap(play, [a, b], after),
            _ => UNKNOWN,
        },
        Contact::Falls(ball) => {
            index(ball).map_or(UNKNOWN, |ball| potted(play, ball, None).miss.min(UNKNOWN))
        }
        Contact::FallsInto(ball, pocket) => index(ball).map_or(UNKNOWN, |ball| {
            potted(play, ball, Some(pocket)).miss.min(UNKNOWN)
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
pub(super) fn away_from(play: &Play, moment: &Moment) -> f64 {
    let (scene, record) = (play.scene, play.record);
    match moment {
        Moment::Hit(a, b) | Moment::After(a, b) => match (scene.ball_named(a), scene.ball_named(b))
        {
            (Some(a), Some(b)) => least_gap(play, [a, b], 0.0),
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
        Moment::Falls(ball) => scene
            .ball_named(ball)
            .map_or(UNKNOWN, |ball| potted(play, ball, None).miss.min(UNKNOWN)),
        Moment::Start
        | Moment::End
        | Moment::At(_)
        | Moment::Rolls(_)
        | Moment::Rests(_)
        | Moment::Lands(_) => UNKNOWN,
    }
}
