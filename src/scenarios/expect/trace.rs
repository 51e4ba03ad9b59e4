//! What can be read off the paths of a record: nearest places, heights, lengths.

use glam::{DVec2, DVec3};

use crate::physics::ball::Motion;
use crate::physics::record::Record;

/// Parts into which every stretch of path is divided where a least value is looked for.
const PARTS: u32 = 6;

/// Steps of the golden section that follows: the place is then known to a millionth of a part.
const GOLDEN: u32 = 30;

/// The smaller part of a stretch divided by the golden section.
const SECTION: f64 = 0.381_966_011_250_105_1;

/// A stretch of time, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    pub(super) from: f64,
    pub(super) until: f64,
}

/// Where a ball is, in space.
pub(super) fn place(record: &Record, ball: usize, time: f64) -> DVec3 {
    let pieces = &record.paths[ball];
    let next = pieces.partition_point(|piece| piece.time <= time);
    let current = &pieces[next.saturating_sub(1)];
    current.piece.position((time - current.time).max(0.0))
}

pub(super) fn plan(point: DVec3) -> DVec2 {
    DVec2::new(point.x, point.z)
}

/// Whether a ball is in play at this time.
fn plays(record: &Record, ball: usize, time: f64) -> bool {
    let pieces = &record.paths[ball];
    let next = pieces.partition_point(|piece| piece.time <= time);
    pieces[next.saturating_sub(1)].piece.start.motion.in_play()
}

/// The time and the value at which a function of the places of these balls is least while all of them are in play. Between
/// two pieces of path it is smooth; there it is divided into [`PARTS`] and the best of them into ever smaller ones.
pub(super) fn least(
    record: &Record,
    balls: &[usize],
    span: Span,
    value: impl Fn(f64) -> f64,
) -> Option<(f64, f64)> {
    let mut best: Option<(f64, f64, f64)> = None; // time, value, width of a part
    let mut from = span.from;
    loop {
        let ahead = |ball: &usize| {
            let pieces = &record.paths[*ball];
            let next = pieces.partition_point(|piece| piece.time <= from);
            pieces.get(next).map_or(f64::INFINITY, |piece| piece.time)
        };
        let until = balls.iter().map(ahead).fold(span.until, f64::min);
        if balls.iter().all(|ball| plays(record, *ball, from)) {
            let part = (until - from) / f64::from(PARTS);
            for i in 0..=PARTS {
                // The end of a stretch is the end of its pieces, not the begin of the next.
                let time = (from + f64::from(i) * part).min(until);
                let found = value(time);
                if best.is_none_or(|best| found < best.1) {
                    best = Some((time, found, part));
                }
            }
        }
        if until >= span.until {
            break;
        }
        from = until;
    }
    let (time, found, part) = best?;
    let (low, high) = ((time - part).max(span.from), (time + part).min(span.until));
    let refined = golden(low, high, &value);
    Some(if refined.1 < found {
        refined
    } else {
        (time, found)
    })
}

/// The least value between two times, after Kiefer (1953).
fn golden(mut low: f64, mut high: f64, value: &impl Fn(f64) -> f64) -> (f64, f64) {
    let mut left = low + SECTION * (high - low);
    let mut right = high - SECTION * (high - low);
    let (mut at_left, mut at_right) = (value(left), value(right));
    for _ in 0..GOLDEN {
        if at_left < at_right {
            (high, right, at_right) = (right, left, at_left);
            left = low + SECTION * (high - low);
            at_left = value(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = high - SECTION * (high - low);
            at_right = value(right);
        }
    }
    if at_left < at_right {
        (left, at_left)
    } else {
        (right, at_right)
    }
}

/// Length of the way of a ball in play, m: Simpson's rule over the speed of every piece.
pub(super) fn length(record: &Record, ball: usize, span: Span) -> f64 {
    const PANELS: u32 = 16;
    let pieces = &record.paths[ball];
    let mut sum = 0.0;
    for (i, turn) in pieces.iter().enumerate() {
        let next = pieces.get(i + 1).map_or(record.end_time, |next| next.time);
        let (from, until) = (turn.time.max(span.from), next.min(span.until));
        let motion = turn.piece.start.motion;
        if until <= from || !motion.translates() {
            continue;
        }
        let width = (until - from) / f64::from(PANELS);
        let speed = |time: f64| turn.piece.velocity(time - turn.time).length();
        let total: f64 = (0..PANELS)
            .map(|panel| {
                let at = from + f64::from(panel) * width;
                speed(at) + 4.0 * speed(at + 0.5 * width) + speed(at + width)
            })
            .sum();
        sum += total * width / 6.0;
    }
    sum
}

/// Whether a ball ever moves.
pub(super) fn moved(record: &Record, ball: usize) -> bool {
    let moves = |motion: Motion| motion.translates();
    record.paths[ball]
        .iter()
        .any(|piece| moves(piece.piece.start.motion))
}
