//! What happens at a contact.

use glam::DVec2;

use crate::physics::ball::State;
use crate::physics::laws::ball_ball::{BallBallLaw, PairContact};
use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::look::Turn;
use crate::sim::stepped::crowd::search::Solver;
use crate::sim::stepped::crowd::stripe::{Stripe, place};
use crate::sim::stepped::crowd::turned::{Contact, Kind};
use crate::sim::stepped::resolve::BOUNCES;

impl<B: Body, const WIDE: bool> Solver<'_, B, WIDE> {
    /// Applies the law of a contact.
    pub(super) fn happen(&mut self, contact: &Contact) {
        let (ball, laws, time) = (&self.stretch.ball, self.stretch.laws, contact.time);
        let one = contact.ball;
        match contact.kind {
            Kind::Change => {
                let seen = self.seen(one);
                let (after, impacts) = (seen.body.end(ball), seen.impacts);
                let turn = self.follow(one, &after, time, impacts);
                self.look(&[turn]);
            }
            Kind::Cushion(index) => {
                let (table, seen) = (self.stretch.table, self.seen(one));
                let met = (ball, &seen.body.state(ball, time));
                let cushion = &table.cushions[index as usize];
                let closing = || {
                    let (_, normal) = cushion.nearest(seen.body.position(time));
                    seen.body.velocity(time).dot(normal).abs()
                };
                let settled = self.stretch.settled(time, [&seen, &seen], closing);
                let rebound = laws.cushion.meet(table, cushion, met, settled);
                let after = laws.motion.classify(ball, rebound.state);
                let impacts = seen.impacts + 1;
                let turn = self.follow(one, &after, time, impacts);
                self.look(&[turn]);
                self.tally().cushions += 1;
            }
            Kind::Ball(other) => self.collide(time, one, other),
        }
    }

    fn collide(&mut self, time: f64, one: u32, other: u32) {
        let (ball, laws) = (&self.stretch.ball, self.stretch.laws);
        let (a, b) = (self.seen(one), self.seen(other));
        let apart = self.apart([a.body.position(time), b.body.position(time)]);
        let impacts = [a.impacts, b.impacts];
        let settled = self.stretch.settled(time, [&a, &b], || {
            let normal = b.body.position(time) - a.body.position(time);
            let velocity = b.body.velocity(time) - a.body.velocity(time);
            velocity.dot(normal.normalize_or_zero()).abs()
        });
        let saturated = u32::from(impacts[0].max(impacts[1])) == BOUNCES;
        if let (BallBallLaw::Frictionless(law), None) = (&laws.ball_ball, apart)
            && settled.is_none()
            && let Some([first, second]) = B::collide([a.body, b.body], time, law.restitution)
        {
            let tally = self.tally();
            tally.met += 1;
            tally.saturated += u64::from(saturated);
            let turns = [
                self.turn(one, first, time, impacts[0] + 1),
                self.turn(other, second, time, impacts[1] + 1),
            ];
            self.look(&turns);
            return;
        }
        let mut before = [a.body.state(ball, time), b.body.state(ball, time)];
        for (state, place) in before.iter_mut().zip(apart.into_iter().flatten()) {
            (state.position.x, state.position.z) = (place.x, place.y);
        }
        // The law sees them in the order of the scene, whoever found the other.
        let swapped = self.number(one) > self.number(other);
        if swapped {
            before.swap(0, 1);
        }
        let mut meeting = PairContact::between(&before[0], &before[1]);
        meeting.restitution = settled;
        let pair = [(ball, &before[0]), (ball, &before[1])];
        let outcome = laws.ball_ball.collide(pair[0], pair[1], &meeting);
        let mut after = [outcome.first, outcome.second];
        if swapped {
            after.swap(0, 1);
        }
        let tally = self.tally();
        tally.met += u64::from(outcome.impulse > 0.0);
        tally.saturated += u64::from(saturated);
        tally.late += u64::from(apart.is_some());
        let [first, second] = after.map(|state| laws.motion.classify(ball, state));
        let turns = [
            self.follow(one, &first, time, impacts[0] + 1),
            self.follow(other, &second, time, impacts[1] + 1),
        ];
        self.look(&turns);
    }

    /// Where the two balls of a contact that was found too late are set so that they just touch; `None` if it was not.
    fn apart(&self, places: [DVec2; 2]) -> Option<[DVec2; 2]> {
        let offset = places[1] - places[0];
        let reach = self.stretch.reach();
        let square = offset.length_squared();
        if square >= self.stretch.least_square() {
            return None;
        }
        let distance = square.sqrt();
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
