//! Contacts in order of time, and those that follow from them.

use crate::physics::laws::ball_ball::PairContact;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::patch::{END, FAST, Patch, Role, STATIC, Stretch};
use crate::sim::stepped::crowd::queue::{Contact, Kind};
use crate::sim::stepped::resolve::{BOUNCES, IMPACTS};

impl<B: Body> Patch<B> {
    /// Runs through the calendar.
    pub(super) fn resolve(&mut self, stretch: &Stretch) {
        loop {
            let versions = &self.versions;
            let next = self.calendar.pop(|contact| {
                versions[contact.ball as usize] == contact.versions[0]
                    && match contact.kind {
                        Kind::Ball(other) => versions[other as usize] == contact.versions[1],
                        _ => true,
                    }
            });
            let Some(contact) = next else { break };
            let (ball, time) = (contact.ball, contact.time);
            self.happen(stretch, &contact);
            let other = match contact.kind {
                Kind::Ball(other) => Some(other),
                _ => None,
            };
            for ball in [Some(ball), other].into_iter().flatten() {
                self.list(stretch, ball, time);
            }
            for ball in [Some(ball), other].into_iter().flatten() {
                if B::BENDS {
                    self.find_change(stretch, ball);
                }
                let impacts = self.impacts[ball as usize];
                if self.origins[ball as usize].role == Role::Own && impacts == BOUNCES {
                    self.tally.saturated += 1;
                }
                if impacts > IMPACTS {
                    continue;
                }
                self.scan(stretch, ball, time);
                self.find_cushions(stretch, ball, time);
            }
        }
    }

    /// Applies the law of a contact.
    fn happen(&mut self, stretch: &Stretch, contact: &Contact) {
        let (ball, laws) = (&stretch.ball, stretch.laws);
        let i = contact.ball as usize;
        let before = self.bodies[i].state(ball, contact.time - self.since[i]);
        let settled = |impacts: u32| (impacts >= BOUNCES).then_some(0.0);
        let owns = |origin: Role| u64::from(origin == Role::Own);
        let after = match contact.kind {
            Kind::Change => self.bodies[i].end(ball),
            Kind::Cushion(index) => {
                let cushion = &stretch.table.cushions[index as usize];
                let restitution = settled(self.impacts[i]);
                let met = (ball, &before);
                let rebound = laws.cushion.meet(stretch.table, cushion, met, restitution);
                self.impacts[i] += 1;
                self.tally.cushions += owns(self.origins[i].role);
                laws.motion.classify(ball, rebound.state)
            }
            Kind::Ball(other) => {
                let j = other as usize;
                let second = self.bodies[j].state(ball, contact.time - self.since[j]);
                let mut meeting = PairContact::between(&before, &second);
                meeting.restitution = settled(self.impacts[i].max(self.impacts[j]));
                let outcome = laws
                    .ball_ball
                    .collide((ball, &before), (ball, &second), &meeting);
                self.impacts[i] += 1;
                self.impacts[j] += 1;
                self.tally.met += owns(self.origins[i].role) + owns(self.origins[j].role);
                self.follow(
                    stretch,
                    j,
                    &laws.motion.classify(ball, outcome.second),
                    contact.time,
                );
                laws.motion.classify(ball, outcome.first)
            }
        };
        self.follow(stretch, i, &after, contact.time);
    }

    fn follow(
        &mut self,
        stretch: &Stretch,
        i: usize,
        state: &crate::physics::ball::State,
        time: f64,
    ) {
        self.bodies[i] = B::start(&stretch.laws.motion, &stretch.ball, state);
        self.since[i] = time;
        self.versions[i] += 1;
    }

    /// Lists a ball by the middle of its new path.
    fn list(&mut self, stretch: &Stretch, ball: u32, time: f64) {
        let i = ball as usize;
        let old = self.listed[i];
        if old == FAST {
            return;
        }
        self.x[i] = f64::INFINITY;
        let left = stretch.length - time;
        let body = &self.bodies[i];
        let middle = body.position(0.5 * left);
        self.middles[i] = middle;
        let new = if Self::extent(body, 0.0, left) > self.slack {
            FAST
        } else {
            self.cell(middle) as u32
        };
        if new == old {
            return;
        }
        if old != STATIC {
            self.strike_out(ball, old as usize);
        }
        self.listed[i] = new;
        if new == FAST {
            self.fast.push(ball);
        } else {
            self.next[i] = self.heads[new as usize];
            self.heads[new as usize] = ball;
        }
    }

    /// Takes a ball from the chain of a cell.
    fn strike_out(&mut self, ball: u32, cell: usize) {
        let next = self.next[ball as usize];
        if self.heads[cell] == ball {
            self.heads[cell] = next;
            return;
        }
        let mut at = self.heads[cell];
        while at != END {
            if self.next[at as usize] == ball {
                self.next[at as usize] = next;
                return;
            }
            at = self.next[at as usize];
        }
    }
}
