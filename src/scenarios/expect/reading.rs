//! What an expectation finds in a record, and how far that is from what it wants.

use crate::physics::ball::State;
use crate::physics::record::Record;
use crate::physics::scene::Scene;
use crate::scenarios::expect::grade;
use crate::scenarios::expect::moment::{Came, Moment};
use crate::scenarios::expect::trace::Span;

/// A miss for which the moment that an expectation speaks of never came.
const NEVER: f64 = 1.0;

/// A speed in m/s below which a ball has no direction.
pub(super) const STILL: f64 = 1e-9;

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

/// The least and the greatest value that are wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ends(pub(super) Option<f64>, pub(super) Option<f64>);

/// What was found and how far off it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reading {
    pub(super) shown: Shown,
    pub(super) miss: f64,
}

impl Reading {
    /// Of what cannot be told at all.
    pub(super) const NOTHING: Self = Self {
        shown: Shown::NoMoment,
        miss: 2.0 * NEVER,
    };

    pub(super) fn new(shown: Shown, miss: f64) -> Self {
        Self { shown, miss }
    }

    /// Of a ball that should have a direction and stands.
    pub(super) fn no_direction() -> Self {
        Self::new(Shown::NoDirection, NEVER)
    }

    /// A number that has to lie between two ends; `scale` counts as 1.
    pub(super) fn within(
        value: f64,
        unit: &'static str,
        Ends(least, most): Ends,
        scale: f64,
    ) -> Self {
        let below = least.map_or(0.0, |least| (least - value).max(0.0));
        let above = most.map_or(0.0, |most| (value - most).max(0.0));
        Self::new(Shown::Value(value, unit), (below + above) / scale)
    }
}

/// A scene and what happened in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Play<'a> {
    pub(super) scene: &'a Scene,
    pub(super) record: &'a Record,
}

impl<'a> Play<'a> {
    /// None if the record is of another scene: it meets nothing.
    pub(super) fn of(scene: &'a Scene, record: &'a Record) -> Option<Self> {
        let count = scene.balls.len();
        let fits = record.paths.len() == count
            && record.end.len() == count
            && !record.paths.iter().any(Vec::is_empty);
        fits.then_some(Self { scene, record })
    }

    pub(super) fn ball(&self, name: &str) -> Option<usize> {
        self.scene.ball_named(name)
    }

    pub(super) fn came(&self, moment: &Moment) -> Option<Came<'a>> {
        moment.came(self.scene, self.record)
    }

    /// A ball at a moment, if it came.
    pub(super) fn state(&self, ball: usize, moment: &Moment) -> Option<State> {
        let came = self.came(moment)?;
        Some(came.state(self.record, ball))
    }

    /// The time between two moments; none if one of them does not come.
    pub(super) fn span(&self, from: &Moment, until: &Moment) -> Option<Span> {
        Some(Span {
            from: self.came(from)?.time,
            until: self.came(until)?.time,
        })
    }

    /// The time of the whole run.
    pub(super) fn whole(&self) -> Span {
        Span {
            from: 0.0,
            until: self.record.end_time,
        }
    }

    /// What is read where a moment never came.
    pub(super) fn never(&self, moment: &Moment) -> Reading {
        Reading::new(Shown::NoMoment, NEVER + grade::away_from(self, moment))
    }

    /// Whether a ball is out of play at the end.
    pub(super) fn is_gone(&self, name: &str) -> bool {
        let ball = self.ball(name).and_then(|ball| self.record.end.get(ball));
        ball.is_some_and(|state| !state.motion.in_play())
    }
}
