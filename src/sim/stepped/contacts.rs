//! The contacts found for this tick, earliest first.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use bevy::prelude::*;

use crate::physics::airborne::{self, Landing};
use crate::physics::contact::{self, flight};
use crate::physics::laws::cluster::Other;
use crate::physics::roots::RootError;
use crate::physics::table::{Cushion, Table};
use crate::sim::playfield::Playfield;
use crate::sim::stepped::bodies::{Bodies, Body};
use crate::sim::stepped::collide_cushions::beyond;

/// What will happen to a ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    /// Its kind of motion changes.
    Change,
    /// Its centre passes the edge of a pocket.
    Pocket(usize),
    /// In flight it comes down on something.
    Landing(Landing),
    /// It meets a cushion.
    Cushion(usize),
    /// It meets another ball, at the version of its path given.
    Ball(usize, u32),
}

impl Kind {
    /// What it is that touches, if it is something.
    pub(super) fn other(self) -> Option<Other> {
        match self {
            Self::Ball(ball, _) => Some(Other::Ball(ball as u32)),
            Self::Cushion(cushion) => Some(Other::Cushion(cushion as u32)),
            Self::Landing(landing) => landing.other(),
            Self::Change | Self::Pocket(_) => None,
        }
    }
}

/// One thing that will happen if no path changes before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Contact {
    /// Time of the tick, s.
    pub time: f64,
    pub kind: Kind,
    pub ball: usize,
    /// The version of the ball's path.
    pub version: u32,
}

impl Eq for Contact {}

impl Ord for Contact {
    /// The earliest is the greatest, as the heap wants it. Ties are broken by kind and ball, never by the order in which
    /// contacts were found: that depends on the grid.
    fn cmp(&self, other: &Self) -> Ordering {
        other
            .time
            .total_cmp(&self.time)
            .then_with(|| other.kind.cmp(&self.kind))
            .then_with(|| other.ball.cmp(&self.ball))
            .then_with(|| other.version.cmp(&self.version))
    }
}

impl PartialOrd for Contact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The queue of the tick.
#[derive(Resource, Debug, Default)]
pub struct Contacts {
    queue: BinaryHeap<Contact>,
    /// The first thing that could not be computed, with the balls it happened to.
    pub(super) failure: Option<(usize, RootError)>,
}

impl Contacts {
    /// The earliest contact whose balls are still on the paths it was found for.
    pub(super) fn next(&mut self, bodies: &Bodies) -> Option<Contact> {
        while let Some(contact) = self.queue.pop() {
            let fresh = bodies.all[contact.ball].version == contact.version
                && match contact.kind {
                    Kind::Ball(other, version) => bodies.all[other].version == version,
                    _ => true,
                };
            if fresh {
                return Some(contact);
            }
        }
        None
    }

    fn push(&mut self, body: &Body, ball: usize, kind: Kind, time: f64) {
        self.queue.push(Contact {
            time,
            kind,
            ball,
            version: body.version,
        });
    }

    fn found(&mut self, ball: usize, result: Result<Option<f64>, RootError>) -> Option<f64> {
        result.unwrap_or_else(|error| {
            self.failure.get_or_insert((ball, error));
            None
        })
    }

    /// Finds when two balls meet.
    pub(super) fn find_pair(&mut self, bodies: &Bodies, first: usize, second: usize, time: f64) {
        let (first, second) = (first.min(second), first.max(second));
        let (a, b) = (&bodies.all[first], &bodies.all[second]);
        if !(a.translates() || b.translates()) || !(a.is_in_play() && b.is_in_play()) {
            return;
        }
        let left = bodies.horizon(time).min(a.change()).min(b.change()) - time;
        let met = contact::pair(
            &a.track(time),
            &b.track(time),
            a.ball.radius + b.ball.radius,
            left.max(0.0),
        );
        let Some(met) = self.found(first, met) else {
            return;
        };
        let met = bodies.put_off(first, Other::Ball(second as u32), (met, time), |later| {
            let reach = a.ball.radius + b.ball.radius;
            a.track(time).overlap(&b.track(time), reach, later)
        });
        if met <= left.max(0.0) {
            self.push(a, first, Kind::Ball(second, b.version), time + met);
        }
    }

    /// Finds when a ball meets a cushion.
    pub(super) fn find_cushion(
        &mut self,
        bodies: &Bodies,
        table: &Table,
        ball: usize,
        cushion: usize,
        time: f64,
    ) {
        let body = &bodies.all[ball];
        let (track, reach) = (body.track(time), table.reach(body.ball.radius));
        let left = (bodies.horizon(time).min(body.change()) - time).max(0.0);
        let what = &table.cushions[cushion];
        let met = match what {
            _ if body.flies() => {
                let nose = (what, &table.nose, table.nose_height);
                flight::nose(&track, nose, body.ball.radius, left)
            }
            Cushion::Line(line) if !bodies.locate => Ok(beyond(table, line, &track, reach)),
            Cushion::Line(line) => contact::line(&track, line, reach, left),
            Cushion::Arc(arc) => contact::arc(&track, arc, reach, left),
        };
        let Some(mut met) = self.found(ball, met) else {
            return;
        };
        let other = Other::Cushion(cushion as u32);
        met = bodies.put_off(ball, other, (met, time), |later| {
            if body.flies() {
                let nose = (what, &table.nose, table.nose_height);
                return flight::overlap_of_nose(&track, nose, body.ball.radius, later);
            }
            track.overlap_of(what, reach, later)
        });
        if met <= left {
            self.push(body, ball, Kind::Cushion(cushion), time + met);
        }
    }

    /// Finds when a pocket takes a ball.
    pub(super) fn find_pocket(
        &mut self,
        bodies: &Bodies,
        playfield: &Playfield,
        ball: usize,
        pocket: usize,
        time: f64,
    ) {
        let (table, laws) = (&playfield.table, &playfield.laws);
        let body = &bodies.all[ball];
        let left = (bodies.horizon(time).min(body.change()) - time).max(0.0);
        if body.flies() {
            let what = (body.ball.radius, body.piece.start.motion);
            let ages = |other| bodies.age(ball, other, time);
            let met = airborne::pocket(table, laws, pocket, what, &body.track(time), left, ages);
            self.land(bodies, ball, met, time);
            return;
        }
        let met = contact::pocket(&body.track(time), &table.pockets[pocket], left);
        if let Some(met) = self.found(ball, met) {
            self.push(body, ball, Kind::Pocket(pocket), time + met);
        }
    }

    /// Finds when a ball in flight comes down on slate, rail or floor.
    pub(super) fn find_ground(
        &mut self,
        bodies: &Bodies,
        playfield: &Playfield,
        ball: usize,
        time: f64,
    ) {
        let (table, laws) = (&playfield.table, &playfield.laws);
        let body = &bodies.all[ball];
        let left = (bodies.horizon(time).min(body.change()) - time).max(0.0);
        let met = airborne::ground(table, laws, body.ball.radius, &body.track(time), left);
        self.land(bodies, ball, met, time);
    }

    fn land(
        &mut self,
        bodies: &Bodies,
        ball: usize,
        met: Result<Option<(f64, Landing)>, RootError>,
        time: f64,
    ) {
        match met {
            Ok(None) => {}
            Ok(Some((met, landing))) => {
                self.push(&bodies.all[ball], ball, Kind::Landing(landing), time + met);
            }
            Err(error) => {
                self.failure.get_or_insert((ball, error));
            }
        }
    }

    /// Notes when the kind of motion of a ball changes, if it does in this tick.
    pub(super) fn find_change(&mut self, bodies: &Bodies, ball: usize) {
        let body = &bodies.all[ball];
        if body.change() <= bodies.tick {
            self.push(body, ball, Kind::Change, body.change());
        }
    }
}
