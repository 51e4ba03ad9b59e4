//! When two balls meet.
#![expect(
    clippy::inline_always,
    reason = "the innermost loops of a tick: a call would cost as much as the work"
)]

use glam::DVec2;

use crate::physics::contact;
use crate::sim::stepped::crowd::body::{Body, track};
use crate::sim::stepped::crowd::search::Solver;
use crate::sim::stepped::crowd::turned::Seen;
use crate::sim::stepped::resolve::IMPACTS;

/// What is added to distances before they are compared, for rounding; a share.
const MARGIN: f64 = 1e-9;

impl<B: Body, const WIDE: bool> Solver<'_, B, WIDE> {
    /// When two legs meet before the end. Where one of them began later than it should have, for a contact that was not
    /// known, they may overlap then already: they meet at once.
    #[inline(always)]
    pub fn meet(&self, place: u32, a: &Seen<B>, b: &Seen<B>) -> Option<f64> {
        let from = a.from.max(b.from);
        let end = self.stretch.end;
        let left = end - from;
        let offset = b.body.position(from) - a.body.position(from);
        let velocity = b.body.velocity(from) - a.body.velocity(from);
        let square = offset.length_squared();
        if from == self.stretch.start {
            self.nearest.set(self.nearest.get().min(square));
        }
        let reach = self.stretch.reach();
        let slope = offset.dot(velocity);
        let met = if square < self.stretch.least_square() {
            0.0
        } else if B::BENDS {
            if !self.may_meet(offset, velocity, left) {
                return None;
            }
            self.meet_bent(place, (a, b), from)?
        } else {
            straight(square - reach * reach, slope, velocity.length_squared())?
        };
        if met > left {
            return None;
        }
        let impacts = u32::from(a.impacts.max(b.impacts));
        let time = from + met.max(self.stretch.pause(impacts));
        Some(time).filter(|time| *time <= end && impacts <= IMPACTS)
    }

    fn meet_bent(&self, place: u32, (a, b): (&Seen<B>, &Seen<B>), from: f64) -> Option<f64> {
        if !(a.body.translates() || b.body.translates()) {
            return None;
        }
        let change = a.body.change().min(b.body.change());
        let left = (self.stretch.end.min(change) - from).max(0.0);
        if let Some(met) = self.meet_soon((a.body, b.body), from) {
            return Some(met).filter(|met| *met <= left);
        }
        let paths = [track(a.body, from), track(b.body, from)];
        let met = contact::pair(&paths[0], &paths[1], self.stretch.reach(), left);
        self.found(place, met)
    }

    /// When two balls on bent paths meet, seen from now, if that is plain.
    #[inline]
    fn meet_soon(&self, (a, b): (&B, &B), from: f64) -> Option<f64> {
        bent(
            b.position(from) - a.position(from),
            b.velocity(from) - a.velocity(from),
            b.acceleration() - a.acceleration(),
            self.stretch.reach(),
        )
    }

    /// Whether two balls that bend may meet in this time: most pass each other, which is told without a division and
    /// without a root.
    #[inline]
    fn may_meet(&self, offset: DVec2, velocity: DVec2, left: f64) -> bool {
        // Both may bend, each by half of the acceleration times the square of the time.
        let turn = 2.0 * self.stretch.bend * left;
        let wide = (self.stretch.reach() + 0.5 * turn * left) * (1.0 + MARGIN);
        let gap = offset.length_squared() - wide * wide;
        let slope = offset.dot(velocity);
        let square = velocity.length_squared();
        let last = gap + left * (2.0 * slope + square * left);
        let passes = gap * square > slope * slope || -slope >= square * left;
        let opens = slope > 0.0 && slope * slope > turn * turn * offset.length_squared();
        !opens && (gap <= 0.0 || slope < 0.0 && (last <= 0.0 || !passes))
    }
}

/// When two balls on straight lines meet, seen from now: the falling root of gap + 2 slope t + square t², as
/// [`contact::pair`] finds it; a test holds that they agree. Two that touch or overlap and approach meet now.
#[inline]
pub(super) fn straight(gap: f64, slope: f64, square: f64) -> Option<f64> {
    let discriminant = slope * slope - gap * square;
    if slope < 0.0 && discriminant >= 0.0 {
        Some((gap / (discriminant.sqrt() - slope)).max(0.0))
    } else {
        None
    }
}

/// Steps of Newton's method from the straight line. Each doubles the number of right digits, and the first of them are
/// right where paths bend little between now and then.
const STEPS: usize = 4;
/// The distance must fall at least at this share of its first rate until the balls meet, or the contact is not plain.
const PLAIN: f64 = 0.05;

/// When two balls meet, seen from now, whose offset, velocity and acceleration differ by these and which are apart still,
/// as [`contact::pair`] finds it; a test holds that they agree. `None` where it is not plain from the bounds of the rate at
/// which the distance falls that it is the first time: grazing contacts, and those long away.
#[inline]
pub(super) fn bent(offset: DVec2, velocity: DVec2, acceleration: DVec2, reach: f64) -> Option<f64> {
    let (gap, slope) = (
        offset.length_squared() - reach * reach,
        offset.dot(velocity),
    );
    let mut time = straight(gap, slope, velocity.length_squared()).filter(|_| gap > 0.0)?;
    let square = velocity.length_squared() + offset.dot(acceleration);
    let (turn, bend) = (velocity.dot(acceleration), acceleration.length_squared());
    // Half the derivative of the square of the distance, and the square of the distance less that at contact.
    let rate = |t: f64| slope + t * (square + t * (1.5 * turn + t * (0.5 * bend)));
    let apart = |t: f64| gap + t * (2.0 * slope + t * (square + t * (turn + t * (0.25 * bend))));
    let mut step = 0.0;
    for _ in 0..STEPS {
        step = 0.5 * apart(time) / rate(time);
        time -= step;
    }
    // Between its ends the rate is off its chord by an eighth of the square of the time, times its curvature, at most.
    let curve = 0.125 * time * time * (3.0 * turn.abs() + 3.0 * time * bend);
    let falls = rate(time).max(slope) + curve < PLAIN * slope;
    (falls && time > 0.0 && step.abs() <= 1e-9 * time).then_some(time)
}
