//! What an expectation finds in a record, and how far that is from what it wants.

use glam::DVec2;

use crate::physics::ball::State;
use crate::physics::record::Record;
use crate::physics::scene::Scene;
use crate::scenarios::expect::grade;
use crate::scenarios::expect::moment::{Came, Moment};
use crate::scenarios::expect::trace::{self, Span, place, plan};
use crate::scenarios::expect::{Expectation, Spot};

/// A miss for which the moment that an expectation speaks of never came.
const NEVER: f64 = 1.0;

/// Degrees that count as much as a metre.
const DEGREES: f64 = 30.0;

/// A speed in m/s below which a ball has no direction.
const STILL: f64 = 1e-9;

/// What was found, for words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shown {
    /// A number with its unit.
    Value(f64, &'static str),
    /// A pocket took the ball.
    Fell { pocket: usize, time: f64 },
    /// The ball left the table.
    Left { time: f64 },
    /// The ball stayed in play.
    Stayed,
    /// So many contacts of an order came.
    Steps { done: usize, of: usize },
    /// A contact happened, or did not.
    Happened(Option<f64>),
    /// The moment never came.
    NoMoment,
    /// The ball does not move then, so that it has no direction.
    NoDirection,
    /// One ball never comes within a radius of the other in plan; the least distance of their centres in m.
    Beside(f64),
}

/// What was found and how far off it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reading {
    pub(super) shown: Shown,
    pub(super) miss: f64,
}

impl Reading {
    pub(super) fn new(shown: Shown, miss: f64) -> Self {
        Self { shown, miss }
    }

    fn never(moment: &Moment, scene: &Scene, record: &Record) -> Self {
        let miss = NEVER + grade::away_from(moment, scene, record);
        Self::new(Shown::NoMoment, miss)
    }

    /// A number that has to lie between two ends; `scale` counts as 1.
    fn range(
        value: f64,
        unit: &'static str,
        (least, most): (Option<f64>, Option<f64>),
        scale: f64,
    ) -> Self {
        let below = least.map_or(0.0, |least| (least - value).max(0.0));
        let above = most.map_or(0.0, |most| (value - most).max(0.0));
        Self::new(Shown::Value(value, unit), (below + above) / scale)
    }
}

/// Gives up with a reading where a part of it is missing.
macro_rules! or_return {
    ($part:expr, $reading:expr) => {
        match $part {
            Some(part) => part,
            None => return $reading,
        }
    };
}

/// Reads one expectation off a record.
#[expect(clippy::too_many_lines, reason = "one arm for each kind")]
pub(super) fn read(expected: &Expectation, scene: &Scene, record: &Record) -> Reading {
    let nothing = Reading::new(Shown::NoMoment, 2.0 * NEVER);
    // A record of another scene meets nothing.
    let count = scene.balls.len();
    if record.paths.len() != count
        || record.end.len() != count
        || record.paths.iter().any(Vec::is_empty)
    {
        return nothing;
    }
    let index = |name: &str| scene.ball_named(name);
    match expected {
        Expectation::Potted { ball, pocket } => {
            let ball = or_return!(index(ball), nothing);
            grade::potted(scene, record, ball, pocket.as_deref())
        }
        Expectation::Stays { ball } => grade::stays(record, or_return!(index(ball), nothing)),
        Expectation::Order(contacts) => grade::order(scene, record, contacts),
        Expectation::Never(contact) => grade::never(scene, record, contact),
        Expectation::Count {
            of,
            least,
            most,
            until,
        } => {
            let until = or_return!(
                until.came(scene, record),
                Reading::never(until, scene, record)
            );
            let counted = |event: &&_| of.is(scene, event) && event.time < until.time;
            let at_end = |event: &&_| of.is(scene, event);
            let number = if matches!(
                expected,
                Expectation::Count {
                    until: Moment::End,
                    ..
                }
            ) {
                record.events.iter().filter(at_end).count()
            } else {
                record.events.iter().filter(counted).count()
            };
            let ends = (least.map(f64::from), most.map(f64::from));
            Reading::range(number as f64, "times", ends, 3.0)
        }
        Expectation::Near {
            ball,
            at,
            within,
            when,
        } => {
            let ball = or_return!(index(ball), nothing);
            let came = or_return!(
                when.came(scene, record),
                Reading::never(when, scene, record)
            );
            let mark = or_return!(at.point(scene), nothing);
            let state = came.state(record, ball);
            let distance = plan(state.position).distance(mark);
            let mut reading = Reading::range(distance, "m away", (None, Some(*within)), 1.0);
            if !state.motion.in_play() {
                reading.miss = reading.miss.max(0.5);
            }
            reading
        }
        Expectation::Inside {
            ball,
            least,
            most,
            when,
        } => {
            let ball = or_return!(index(ball), nothing);
            let came = or_return!(
                when.came(scene, record),
                Reading::never(when, scene, record)
            );
            let at = plan(came.state(record, ball).position);
            let (least, most) = (DVec2::from(*least), DVec2::from(*most));
            let outside = at.distance(at.clamp(least, most));
            Reading::range(outside, "m outside", (None, Some(0.0)), 1.0)
        }
        Expectation::Passes {
            ball,
            at,
            within,
            from,
            until,
        } => {
            let ball = or_return!(index(ball), nothing);
            let mark = or_return!(at.point(scene), nothing);
            let span = or_return!(span(from, until, scene, record), nothing);
            let away = |time: f64| plan(place(record, ball, time)).distance(mark);
            let (_, distance) = or_return!(trace::least(record, &[ball], span, away), nothing);
            Reading::range(distance, "m away", (None, Some(*within)), 1.0)
        }
        Expectation::Gap {
            ball,
            of,
            least,
            most,
            from,
            until,
        } => {
            let pair = [
                or_return!(index(ball), nothing),
                or_return!(index(of), nothing),
            ];
            let span = or_return!(span(from, until, scene, record), nothing);
            let gap = |time: f64| grade::gap(scene, record, pair, time);
            let (_, gap) = or_return!(trace::least(record, &pair, span, gap), nothing);
            Reading::range(gap, "m", (*least, *most), 1.0)
        }
        Expectation::Height {
            ball,
            least,
            most,
            from,
            until,
        } => {
            let ball = or_return!(index(ball), nothing);
            let span = or_return!(span(from, until, scene, record), nothing);
            let radius = scene.balls[ball].ball.radius;
            let below = |time: f64| radius - place(record, ball, time).y;
            let (_, below) = or_return!(trace::least(record, &[ball], span, below), nothing);
            Reading::range(-below, "m", (*least, *most), 0.1)
        }
        Expectation::Over {
            ball,
            of,
            least,
            most,
        } => {
            let pair = [
                or_return!(index(ball), nothing),
                or_return!(index(of), nothing),
            ];
            over(scene, record, pair, (*least, *most)).unwrap_or(nothing)
        }
        _ => read_motion(expected, scene, record).unwrap_or(nothing),
    }
}

/// Reads those that speak of speeds, directions, ways and times; none if a ball is missing.
#[expect(clippy::too_many_lines, reason = "one arm for each kind")]
fn read_motion(expected: &Expectation, scene: &Scene, record: &Record) -> Option<Reading> {
    let never = |moment: &Moment| Some(Reading::never(moment, scene, record));
    let states = |ball: &str, moment: &Moment| -> Option<(usize, Option<(State, Came)>)> {
        let ball = scene.ball_named(ball)?;
        let came = moment.came(scene, record);
        Some((ball, came.map(|came| (came.state(record, ball), came))))
    };
    match expected {
        Expectation::Speed {
            ball,
            least,
            most,
            when,
        } => {
            let (_, Some((state, _))) = states(ball, when)? else {
                return never(when);
            };
            let speed = state.velocity.length();
            Some(Reading::range(speed, "m/s", (*least, *most), 1.0))
        }
        Expectation::Heading {
            ball,
            deg,
            within_deg,
            when,
        } => {
            let (_, Some((state, _))) = states(ball, when)? else {
                return never(when);
            };
            let Some(found) = heading(&state) else {
                return Some(Reading::new(Shown::NoDirection, NEVER));
            };
            let off = turn(*deg, found).abs();
            let ends = (None, Some(*within_deg));
            let miss = Reading::range(off, "", ends, DEGREES).miss;
            Some(Reading::new(Shown::Value(found, "degrees"), miss))
        }
        Expectation::Turns {
            ball,
            least,
            most,
            from,
            to,
        } => {
            let (_, Some((before, _))) = states(ball, from)? else {
                return never(from);
            };
            let (_, Some((after, _))) = states(ball, to)? else {
                return never(to);
            };
            let (Some(before), Some(after)) = (heading(&before), heading(&after)) else {
                return Some(Reading::new(Shown::NoDirection, NEVER));
            };
            let turned = turn(before, after);
            Some(Reading::range(turned, "degrees", (*least, *most), DEGREES))
        }
        Expectation::Travels {
            ball,
            least,
            most,
            from,
            to,
        } => {
            let (ball, Some((_, begin))) = states(ball, from)? else {
                return never(from);
            };
            let Some(end) = to.came(scene, record) else {
                return never(to);
            };
            let span = Span {
                from: begin.time,
                until: end.time,
            };
            let length = trace::length(record, ball, span);
            Some(Reading::range(length, "m", (*least, *most), 1.0))
        }
        Expectation::Advances {
            ball,
            least,
            most,
            from,
            to,
        } => {
            let (_, Some((begin, _))) = states(ball, from)? else {
                return never(from);
            };
            let (_, Some((end, _))) = states(ball, to)? else {
                return never(to);
            };
            let way = plan(begin.velocity);
            if way.length() < STILL {
                return Some(Reading::new(Shown::NoDirection, NEVER));
            }
            let gone = plan(end.position - begin.position).dot(way.normalize());
            Some(Reading::range(gone, "m", (*least, *most), 1.0))
        }
        Expectation::Time { of, least, most } => {
            let Some(came) = of.came(scene, record) else {
                return never(of);
            };
            Some(Reading::range(came.time, "s", (*least, *most), 1.0))
        }
        _ => None,
    }
}

/// The height of one ball over another where they are nearest in plan.
fn over(
    scene: &Scene,
    record: &Record,
    pair: [usize; 2],
    ends: (Option<f64>, Option<f64>),
) -> Option<Reading> {
    let [ball, of] = pair;
    let span = Span {
        from: 0.0,
        until: record.end_time,
    };
    let places = |time: f64| (place(record, ball, time), place(record, of, time));
    let apart = |time: f64| {
        let (above, below) = places(time);
        plan(above).distance(plan(below))
    };
    let (time, distance) = trace::least(record, &pair, span, apart)?;
    let radius = scene.balls[ball].ball.radius;
    let aside = (distance - radius).max(0.0);
    let (above, below) = places(time);
    let height = (above.y - radius) - (below.y + scene.balls[of].ball.radius);
    if aside > 0.0 {
        let miss = aside + Reading::range(height, "m", ends, 0.1).miss;
        return Some(Reading::new(Shown::Beside(distance), miss));
    }
    Some(Reading::range(height, "m", ends, 0.1))
}

/// The time between two moments; none if one of them does not come.
fn span(from: &Moment, until: &Moment, scene: &Scene, record: &Record) -> Option<Span> {
    Some(Span {
        from: from.came(scene, record)?.time,
        until: until.came(scene, record)?.time,
    })
}

/// The direction in which a ball moves, degrees.
fn heading(state: &State) -> Option<f64> {
    let way = plan(state.velocity);
    (way.length() >= STILL).then(|| libm::atan2(-way.y, way.x).to_degrees())
}

/// The turn in degrees from one direction to another, -180 to 180.
fn turn(from: f64, to: f64) -> f64 {
    let turn = (to - from).rem_euclid(360.0);
    if turn > 180.0 { turn - 360.0 } else { turn }
}

impl Spot {
    /// Whether the place is on the playing surface.
    pub(super) fn on_table(&self, scene: &Scene) -> bool {
        self.point(scene).is_some_and(|point| {
            let half = 0.5 * DVec2::new(scene.table.length, scene.table.width);
            point.abs().cmple(half).all()
        })
    }
}
