//! What happens at a contact.

use crate::physics::ball::State;
use crate::physics::laws::ball_ball::PairContact;
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::caught::{Contact, Kind, Leg};
use crate::sim::stepped::crowd::search::Solver;
use crate::sim::stepped::crowd::stripe::place;
use crate::sim::stepped::resolve::BOUNCES;

impl<B: Body> Solver<'_, B> {
    /// Applies the law of a contact.
    pub(super) fn happen(&mut self, contact: &Contact) {
        let (ball, laws, time) = (&self.stretch.ball, self.stretch.laws, contact.time);
        let settled = |impacts: u32| (impacts >= BOUNCES).then_some(0.0);
        let one = contact.ball;
        let impacts = self.caught(one).impacts;
        let body = self.last(one).body;
        match contact.kind {
            Kind::Change => {
                let after = body.end(ball);
                self.turn(one, &after, time, 0);
            }
            Kind::Cushion(index) => {
                let table = self.stretch.table;
                let met = (ball, &body.state(ball, time));
                let cushion = &table.cushions[index as usize];
                let rebound = laws.cushion.meet(table, cushion, met, settled(impacts));
                self.count[1] += 1;
                let after = laws.motion.classify(ball, rebound.state);
                self.turn(one, &after, time, 1);
            }
            Kind::Ball(other) => {
                let it = self.caught(other);
                let (first, second) = if self.caught(one).number < it.number {
                    (one, other)
                } else {
                    (other, one)
                };
                let impacts = impacts.max(it.impacts);
                let before = [
                    self.last(first).body.state(ball, time),
                    self.last(second).body.state(ball, time),
                ];
                let mut meeting = PairContact::between(&before[0], &before[1]);
                meeting.restitution = settled(impacts);
                let pair = [(ball, &before[0]), (ball, &before[1])];
                let outcome = laws.ball_ball.collide(pair[0], pair[1], &meeting);
                self.count[0] += 1;
                let after = laws.motion.classify(ball, outcome.first);
                self.turn(first, &after, time, 1);
                let after = laws.motion.classify(ball, outcome.second);
                self.turn(second, &after, time, 1);
            }
        }
    }

    /// Puts a caught ball on the leg that begins with this state.
    fn turn(&mut self, id: u32, state: &State, time: f64, impacts: u32) {
        let body = B::start(&self.stretch.laws.motion, &self.stretch.ball, state, time);
        let stripe = &mut self.stripes[place::stripe(id) - self.base];
        let caught = &mut stripe.caught[place::index(id)];
        let leg = Leg {
            body,
            from: time,
            before: caught.last,
        };
        if caught.last == caught.first {
            caught.turn = time;
        }
        caught.last = stripe.legs.len() as u32;
        caught.impacts += impacts;
        stripe.legs.push(leg);
        let speed = body.velocity(time).length_squared();
        stripe.tally.speed = stripe.tally.speed.max(speed);
    }
}
