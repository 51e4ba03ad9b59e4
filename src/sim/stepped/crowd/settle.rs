//! What happens at a contact.

use glam::DVec2;

use crate::physics::ball::State;
use crate::physics::laws::ball_ball::{BallBallLaw, PairContact};
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::look::Turn;
use crate::sim::stepped::crowd::search::Solver;
use crate::sim::stepped::crowd::stripe::{Stripe, place};
use crate::sim::stepped::crowd::turned::{Contact, Kind, Leg};
use crate::sim::stepped::resolve::BOUNCES;

impl<B: Body, const WIDE: bool> Solver<'_, B, WIDE> {
    /// Applies the law of a contact.
    pub(super) fn happen(&mut self, contact: &Contact) {
        let (ball, laws, time) = (&self.stretch.ball, self.stretch.laws, contact.time);
        let one = contact.ball;
        let leg = self.leg(one);
        match contact.kind {
            Kind::Change => {
                let after = leg.body.end(ball);
                let turn = self.follow(one, &after, time, leg.impacts);
                self.look(&[turn]);
            }
            Kind::Cushion(index) => {
                let table = self.stretch.table;
                let met = (ball, &leg.body.state(ball, time));
                let cushion = &table.cushions[index as usize];
                let closing = || {
                    let (_, normal) = cushion.nearest(leg.body.position(time));
                    leg.body.velocity(time).dot(normal).abs()
                };
                let settled = self.stretch.settled(time, [&leg, &leg], closing);
                let rebound = laws.cushion.meet(table, cushion, met, settled);
                let after = laws.motion.classify(ball, rebound.state);
                let turn = self.follow(one, &after, time, leg.impacts + 1);
                self.look(&[turn]);
                self.tally().cushions += 1;
            }
            Kind::Ball(other) => self.collide(time, (one, leg), (other, self.leg(other))),
        }
    }

    fn collide(&mut self, time: f64, one: (u32, Leg<B>), other: (u32, Leg<B>)) {
        let (ball, laws) = (&self.stretch.ball, self.stretch.laws);
        let apart = self.apart(time, &one, &other);
        let impacts = u32::from(one.1.impacts.max(other.1.impacts));
        let settled = self.stretch.settled(time, [&one.1, &other.1], || {
            let normal = other.1.body.position(time) - one.1.body.position(time);
            let velocity = other.1.body.velocity(time) - one.1.body.velocity(time);
            velocity.dot(normal.normalize_or_zero()).abs()
        });
        self.tally().saturated += u64::from(impacts == BOUNCES);
        if let (BallBallLaw::Frictionless(law), None) = (&laws.ball_ball, apart)
            && let Some(bodies) = B::collide([&one.1.body, &other.1.body], time, law.restitution)
            && settled.is_none()
        {
            self.tally().met += 1;
            let turns = [
                self.turn(one.0, bodies[0], time, one.1.impacts + 1),
                self.turn(other.0, bodies[1], time, other.1.impacts + 1),
            ];
            self.look(&turns);
            return;
        }
        // The law sees them in the order of the scene, whoever found the other.
        let (first, second) = if self.number(one.0) < self.number(other.0) {
            (one, other)
        } else {
            (other, one)
        };
        let mut before = [
            first.1.body.state(ball, time),
            second.1.body.state(ball, time),
        ];
        if let Some(apart) = apart {
            let apart = if first.0 == one.0 {
                apart
            } else {
                [apart[1], apart[0]]
            };
            for (state, place) in before.iter_mut().zip(apart) {
                (state.position.x, state.position.z) = (place.x, place.y);
            }
        }
        let mut meeting = PairContact::between(&before[0], &before[1]);
        meeting.restitution = settled;
        let pair = [(ball, &before[0]), (ball, &before[1])];
        let outcome = laws.ball_ball.collide(pair[0], pair[1], &meeting);
        self.tally().met += u64::from(outcome.impulse > 0.0);
        let turns = [(first, outcome.first), (second, outcome.second)].map(|((at, leg), state)| {
            let after = laws.motion.classify(ball, state);
            self.follow(at, &after, time, leg.impacts + 1)
        });
        self.look(&turns);
    }

    /// Where the two balls of a contact that was found too late are set so that they just touch; `None` if it was not.
    fn apart(
        &mut self,
        time: f64,
        (_, one): &(u32, Leg<B>),
        (_, other): &(u32, Leg<B>),
    ) -> Option<[DVec2; 2]> {
        let places = [one.body.position(time), other.body.position(time)];
        let offset = places[1] - places[0];
        let reach = self.stretch.reach();
        let square = offset.length_squared();
        if square >= self.stretch.least_square() {
            return None;
        }
        let distance = square.sqrt();
        self.tally().late += 1;
        let normal = offset.try_normalize().unwrap_or(DVec2::X);
        let push = 0.5 * (reach - distance) * normal;
        Some([self.inside(places[0] - push), self.inside(places[1] + push)])
    }

    /// The nearest place at which a ball overlaps no cushion.
    fn inside(&self, mut place: DVec2) -> DVec2 {
        let walls = self.stretch.walls;
        if place.abs().cmplt(self.stretch.clear(0.0)).all() {
            return place;
        }
        let reach = self.stretch.table.reach(self.stretch.ball.radius);
        for listed in walls.near(place) {
            let cushion = &self.stretch.table.cushions[walls.cushion(listed) as usize];
            let (distance, normal) = cushion.nearest(place);
            if distance < reach {
                place += (reach - distance) * normal;
            }
        }
        place
    }

    /// Puts a ball on the path that begins with this state.
    fn follow(&mut self, at: u32, state: &State, time: f64, impacts: u16) -> Turn {
        let body = B::start(&self.stretch.laws.motion, &self.stretch.ball, state, time);
        self.turn(at, body, time, impacts)
    }

    /// Puts a ball on another path. Nobody sees it before it is looked for what it meets.
    #[inline]
    fn turn(&mut self, at: u32, body: B, from: f64, impacts: u16) -> Turn {
        let turn = self.stretch.turn(at, &body, from);
        let speed = body.velocity(from).length_squared();
        let (stripe, index) = (self.stripe_mut(at), place::index(at));
        let Stripe {
            moving,
            still,
            turned,
            tally,
            ..
        } = stripe;
        let sorted = if at & place::STILL == 0 {
            moving
        } else {
            still
        };
        let [x, z, ..] = sorted.records[index].numbers;
        sorted.lanes.hide(index);
        let ball = &mut sorted.balls[index];
        *ball = turned.turn(*ball, at, (body, from, impacts));
        let most = &mut tally.speed;
        *most = if speed > *most { speed } else { *most };
        self.wander.include([x, z], turn.bounds);
        turn
    }
}
