//! The order in which contacts are resolved.
//!
//! A block of rows is followed in order of time. A ball at its edge, whose other contacts are not known yet, holds up what
//! it takes part in, and so does every ball that it holds up; all that waits for the next block, and at last for all
//! stripes together. So contacts are resolved in order of time wherever one can lead to another, but for one case: a ball
//! that waited turns and meets, within the same tick, one of another block that has been followed further already. That
//! cannot be undone; the two overlap at the moment from which both paths are known. They are set apart there, so that they
//! just touch, and meet if they approach. The census counts these.

use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::search::Solver;
use crate::sim::stepped::crowd::stripe::place;
use crate::sim::stepped::crowd::turned::{Contact, Kind, NONE};

impl<B: Body, const WIDE: bool> Solver<'_, B, WIDE> {
    /// Resolves the contacts that wait in order of time; of one stripe only those of balls in a range of places.
    pub fn resolve(&mut self, ready: Option<[u32; 2]>) {
        let mut held = std::mem::take(&mut self.held);
        let mut waiting = std::mem::take(&mut self.stripes[0].waiting);
        for contact in waiting.drain(..) {
            self.queue.push(contact);
        }
        self.stripes[0].waiting = waiting;
        let is_ready = |at: u32| {
            ready.is_none_or(|[from, to]| {
                at & place::STILL != 0 || {
                    let index = place::index(at) as u32;
                    from <= index && index < to
                }
            })
        };
        while let Some(contact) = self.queue.pop() {
            let (ball, other) = (contact.ball, contact.other());
            if self.turns(ball) != contact.turns[0] {
                continue;
            }
            let mut holds = self.is_held(ball) || !is_ready(ball);
            if other != NONE {
                if self.turns(other) != contact.turns[1] {
                    continue;
                }
                holds |= self.is_held(other) || !is_ready(other);
            }
            if holds {
                self.hold(ball, true);
                if other != NONE {
                    self.hold(other, true);
                }
                held.push(contact);
                continue;
            }
            self.happen(&contact);
        }
        for contact in &held {
            self.hold(contact.ball, false);
            if let Kind::Ball(other) = contact.kind {
                self.hold(other, false);
            }
        }
        self.stripes[0].waiting.append(&mut held);
        self.held = held;
    }

    #[inline]
    fn is_held(&self, at: u32) -> bool {
        self.stripe(at).sorted(at).held[place::index(at)]
    }

    #[inline]
    fn hold(&mut self, at: u32, held: bool) {
        self.stripe_mut(at).sorted_mut(at).held[place::index(at)] = held;
    }

    /// Gathers what waits in all stripes.
    pub fn gather(&mut self) {
        for stripe in 1..self.stripes.len() {
            let mut waiting = std::mem::take(&mut self.stripes[stripe].waiting);
            self.stripes[0].waiting.append(&mut waiting);
            self.stripes[stripe].waiting = waiting;
        }
    }

    /// Looks beyond the stripes for contacts of balls that may have some there.
    pub fn look_beyond(&mut self) {
        for stripe in 0..self.stripes.len() {
            for at in std::mem::take(&mut self.stripes[stripe].wide) {
                self.look(&[self.turn_of(at)]);
            }
        }
    }

    /// Has a contact wait for its turn.
    #[inline]
    pub fn wait(&mut self, time: f64, ball: u32, kind: Kind, turns: [u16; 2]) {
        self.queue.push(Contact {
            time,
            ball,
            kind,
            turns,
        });
    }
}
