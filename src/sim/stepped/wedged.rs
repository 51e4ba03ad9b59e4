//! Balls that come to rest off the slate, and those that are let go.

use crate::physics::ball::Motion;
use crate::physics::laws::cluster::{How, LEAN, Member};
use crate::physics::record::{Event, EventKind, Participant};
use crate::sim::playfield::Playfield;
use crate::sim::stepped::bodies::Bodies;
use crate::sim::stepped::contacts::Kind;
use crate::sim::stepped::grid::Grid;
use crate::sim::stepped::impact::Impact;

impl Impact {
    /// Brings to rest, of this ball and all that is close to it, what is held, and lets go what is not.
    pub(super) fn hold(
        &mut self,
        bodies: &mut Bodies,
        grid: &Grid,
        playfield: &Playfield,
        (ball, time, jammed): (usize, f64, bool),
    ) {
        self.cluster.clear();
        self.join(bodies, ball, time);
        self.gather(bodies, grid, playfield, (time, Kind::Change, How::Close));
        self.cluster.hold(&playfield.laws, jammed);
        for (member, before) in self.cluster.members.iter().zip(&self.cluster.before) {
            let Member { ball, state, .. } = member;
            if state == before {
                continue;
            }
            if !self.changed.contains(ball) {
                self.changed.push(*ball);
            }
            bodies.all[*ball].follow(playfield, state, time);
            self.events.push(Event {
                time: bodies.start + time,
                kind: EventKind::Motion {
                    from: before.motion,
                    to: state.motion,
                },
                first: Participant {
                    ball: bodies.all[*ball].index,
                    before: *before,
                    after: *state,
                },
                second: None,
                impulse: 0.0,
            });
        }
    }

    /// A ball that has been dislodged bears no others.
    pub(super) fn let_go(
        &mut self,
        bodies: &mut Bodies,
        grid: &Grid,
        playfield: &Playfield,
        (dislodged, time): (usize, f64),
    ) {
        let body = &bodies.all[dislodged];
        let (center, radius) = (body.piece.position(time - body.since), body.ball.radius);
        for other in 0..bodies.all.len() {
            let there = &bodies.all[other];
            let near = radius + there.ball.radius + LEAN;
            let place = there.piece.position(time - there.since);
            if is_wedged(bodies, other) && place.distance_squared(center) <= near * near {
                self.hold(bodies, grid, playfield, (other, time, false));
            }
        }
    }

    /// Lets go at the start of a tick what nothing holds of the balls that are said to be wedged.
    pub(super) fn let_loose_go(&mut self, bodies: &mut Bodies, grid: &Grid, playfield: &Playfield) {
        for ball in 0..bodies.all.len() {
            if is_wedged(bodies, ball) {
                self.hold(bodies, grid, playfield, (ball, 0.0, false));
            }
        }
    }
}

fn is_wedged(bodies: &Bodies, ball: usize) -> bool {
    bodies.all[ball].piece.start.motion == Motion::Wedged
}
