//! Contacts, moments and places as expectations name them.

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Motion, State};
use crate::physics::record::{Event, EventKind, Record};
use crate::physics::scene::Scene;
use crate::physics::table::Table;
use crate::scenarios::file::balls::from_diamonds;

/// One of the four sides of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Rail {
    /// The short side where the cue ball starts, x least.
    Head,
    /// The other short side, x greatest.
    Foot,
    /// The long side to the left of somebody who looks from the head to the foot, z least.
    Left,
    /// The other long side, z greatest.
    Right,
}

impl Rail {
    /// The rail that is nearest to a point.
    fn nearest(table: &Table, point: DVec2) -> Self {
        let out = point.abs() - 0.5 * DVec2::new(table.length, table.width);
        match (out.x > out.y, point.x < 0.0, point.y < 0.0) {
            (true, true, _) => Self::Head,
            (true, false, _) => Self::Foot,
            (false, _, true) => Self::Left,
            (false, _, false) => Self::Right,
        }
    }
}

/// Something that happens to balls.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Contact {
    /// Two balls meet.
    Hit(String, String),
    /// A ball meets a cushion, jaws and facings included.
    Rail(String),
    /// A ball meets a cushion of this side.
    RailAt(String, Rail),
    /// A pocket takes a ball.
    Falls(String),
    /// This pocket takes a ball.
    FallsInto(String, String),
    /// A ball comes down on the slate.
    Lands(String),
    /// A ball leaves the table.
    Leaves(String),
}

impl Contact {
    /// Whether an event is this contact.
    pub(super) fn is(&self, scene: &Scene, event: &Event) -> bool {
        let named = |ball: usize, name: &str| scene.balls.get(ball).is_some_and(|b| b.name == name);
        let first = |name: &str| named(event.first.ball, name);
        match (self, event.kind) {
            (Self::Hit(a, b), EventKind::BallBall) => {
                let second = |name: &str| event.second.is_some_and(|s| named(s.ball, name));
                (first(a) && second(b)) || (first(b) && second(a))
            }
            (Self::Rail(ball), EventKind::Cushion { .. })
            | (Self::Falls(ball), EventKind::Pocketed { .. })
            | (Self::Lands(ball), EventKind::Slate)
            | (Self::Leaves(ball), EventKind::OffTable) => first(ball),
            (Self::RailAt(ball, rail), EventKind::Cushion { .. }) => {
                let at = event.first.before.position;
                first(ball) && Rail::nearest(&scene.table, DVec2::new(at.x, at.z)) == *rail
            }
            (Self::FallsInto(ball, into), EventKind::Pocketed { pocket }) => {
                let pocket = scene.table.pockets.get(pocket);
                first(ball) && pocket.is_some_and(|pocket| pocket.name == *into)
            }
            _ => false,
        }
    }
}

/// A moment of a shot.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Moment {
    /// Just after the stroke.
    #[default]
    Start,
    /// When the run ends.
    End,
    /// This many seconds after the start.
    At(f64),
    /// Just before two balls meet for the first time.
    Hit(String, String),
    /// Just after two balls met for the first time.
    After(String, String),
    /// Just before a ball meets its first, second, ... cushion.
    Rail(String, u32),
    /// Just after a ball met its first, second, ... cushion.
    AfterRail(String, u32),
    /// When a ball begins to roll for the first time.
    Rolls(String),
    /// When a ball comes to rest and does not move again.
    Rests(String),
    /// When a pocket takes a ball.
    Falls(String),
    /// When a ball comes down on the slate for the first time.
    Lands(String),
}

/// A moment that came.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Came<'r> {
    /// When, s.
    pub(super) time: f64,
    /// The event, and whether the side after it is meant.
    event: Option<(&'r Event, bool)>,
}

impl Came<'_> {
    /// A ball at this moment.
    pub(super) fn state(&self, record: &Record, ball: usize) -> State {
        let part = self.event.and_then(|(event, after)| {
            let mut parts = event.participants();
            let part = parts.find(|part| part.ball == ball)?;
            Some(if after { part.after } else { part.before })
        });
        part.unwrap_or_else(|| record.state_at(ball, self.time))
    }
}

impl Moment {
    pub(super) fn end() -> Self {
        Self::End
    }

    pub(super) fn is_end(&self) -> bool {
        *self == Self::End
    }

    pub(super) fn is_start(&self) -> bool {
        *self == Self::Start
    }

    /// When this came, if it did.
    pub(super) fn came<'r>(&self, scene: &Scene, record: &'r Record) -> Option<Came<'r>> {
        let plain = |time: f64| Some(Came { time, event: None });
        let nth = |number: u32, after: bool, is: &dyn Fn(&Event) -> bool| {
            let mut events = record.events.iter().filter(|event| is(event));
            let event = events.nth((number as usize).saturating_sub(1))?;
            Some(Came {
                time: event.time,
                event: Some((event, after)),
            })
        };
        let met = |a: &str, b: &str, after: bool| nth(1, after, &|event| hit(scene, event, a, b));
        let ball_is = |event: &Event, name: &str| {
            scene
                .balls
                .get(event.first.ball)
                .is_some_and(|b| b.name == name)
        };
        match self {
            Self::Start => plain(0.0),
            Self::End => plain(record.end_time),
            Self::At(time) => (*time <= record.end_time).then_some(*time).and_then(plain),
            Self::Hit(a, b) => met(a, b, false),
            Self::After(a, b) => met(a, b, true),
            Self::Rail(ball, number) => nth(*number, false, &|event| {
                matches!(event.kind, EventKind::Cushion { .. }) && ball_is(event, ball)
            }),
            Self::AfterRail(ball, number) => nth(*number, true, &|event| {
                matches!(event.kind, EventKind::Cushion { .. }) && ball_is(event, ball)
            }),
            Self::Rolls(ball) => {
                let path = record.paths.get(scene.ball_named(ball)?)?;
                let mut rolls = path
                    .iter()
                    .filter(|p| p.piece.start.motion == Motion::Rolling);
                rolls.next().and_then(|piece| plain(piece.time))
            }
            Self::Rests(ball) => {
                let path = record.paths.get(scene.ball_named(ball)?)?;
                let last = path.last()?;
                let still = matches!(last.piece.start.motion, Motion::Rest | Motion::Spinning);
                if still { plain(last.time) } else { None }
            }
            Self::Falls(ball) => nth(1, false, &|event| {
                matches!(event.kind, EventKind::Pocketed { .. }) && ball_is(event, ball)
            }),
            Self::Lands(ball) => nth(1, false, &|event| {
                matches!(event.kind, EventKind::Slate) && ball_is(event, ball)
            }),
        }
    }
}

/// Whether an event is the meeting of these two.
fn hit(scene: &Scene, event: &Event, a: &str, b: &str) -> bool {
    let Some(second) = event.second else {
        return false;
    };
    let name = |ball: usize| scene.balls.get(ball).map_or("", |ball| ball.name.as_str());
    let pair = (name(event.first.ball), name(second.ball));
    event.kind == EventKind::BallBall && (pair == (a, b) || pair == (b, a))
}

/// A place on the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Spot {
    /// x and z, m.
    Position(f64, f64),
    /// Across from 0 to 4, along from 0 at the foot rail to 8 at the head rail, as for a ball.
    Diamonds(f64, f64),
    /// Where a ball begins.
    Start(String),
}

impl Spot {
    /// The point in plan, m; none if there is no such ball.
    #[must_use]
    pub fn point(&self, scene: &Scene) -> Option<DVec2> {
        match self {
            Self::Position(x, z) => Some(DVec2::new(*x, *z)),
            Self::Diamonds(across, along) => {
                Some(from_diamonds(&scene.table, DVec2::new(*across, *along)))
            }
            Self::Start(ball) => {
                let at = scene.balls[scene.ball_named(ball)?].state.position;
                Some(DVec2::new(at.x, at.z))
            }
        }
    }

    /// Whether the place is on the playing surface.
    pub(super) fn on_table(&self, scene: &Scene) -> bool {
        self.point(scene).is_some_and(|point| {
            let half = 0.5 * DVec2::new(scene.table.length, scene.table.width);
            point.abs().cmple(half).all()
        })
    }
}
