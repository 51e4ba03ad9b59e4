//! Two balls that meet while nothing else touches them: nearly every impact. The same numbers as the general way of
//! `impact`, without its lists.

use glam::{DVec2, DVec3};

use crate::physics::ball::Motion;
use crate::physics::exact::cells::Neighbours;
use crate::physics::exact::engine::Engine;
use crate::physics::exact::predict::Partner;
use crate::physics::exact::walls::Area;
use crate::physics::exact::{DEEP, SLOW, SolveError, Watch};
use crate::physics::laws::ball_ball::PairContact;
use crate::physics::laws::cluster::TOUCH;
use crate::physics::record::{Event, EventKind, Participant};

impl Engine {
    /// Lets two balls collide, if they touch nothing else, meet fast and part fast; otherwise nothing is done and the
    /// answer is false.
    pub(super) fn collide_alone(
        &mut self,
        ball: usize,
        other: usize,
        watch: &mut impl Watch,
    ) -> Result<bool, SolveError> {
        let (one, two) = (self.state(ball), self.state(other));
        let (body_one, body_two) = (self.bodies[ball], self.bodies[other]);
        let offset = two.position - one.position;
        let overlap = body_one.radius + body_two.radius - offset.length();
        let flat = DVec3::new(offset.x, 0.0, offset.z);
        let normal = flat / flat.length();
        let closing = (one.velocity - two.velocity).dot(normal);
        // Written so that what is not a number goes the general way.
        if !(closing >= SLOW && overlap <= DEEP)
            || one.motion == Motion::Airborne
            || two.motion == Motion::Airborne
        {
            return Ok(false);
        }
        let (mut near_one, mut near_two) = (Neighbours::none(), Neighbours::none());
        if !self.is_alone(ball, one.position, other, &mut near_one)
            || !self.is_alone(other, two.position, ball, &mut near_two)
        {
            return Ok(false);
        }
        let geometry = PairContact {
            normal,
            on_slate: true,
            restitution: None,
        };
        let laws = self.laws;
        let outcome = laws
            .ball_ball
            .collide((&body_one, &one), (&body_two, &two), &geometry);
        let first = laws.motion.classify(&body_one, outcome.first);
        let second = laws.motion.classify(&body_two, outcome.second);
        let parting = (second.velocity - first.velocity).dot(normal);
        if !(parting >= SLOW && outcome.impulse > 0.0) {
            return Ok(false);
        }
        self.set(ball, first, watch)?;
        self.set(other, second, watch)?;
        self.touched[ball].add(Partner::Ball(other as u32), self.clock);
        self.touched[other].add(Partner::Ball(ball as u32), self.clock);
        let participant = |ball, before, after| Participant {
            ball,
            before,
            after,
        };
        watch.event(&Event {
            time: self.clock,
            kind: EventKind::BallBall,
            first: participant(ball, one, first),
            second: Some(participant(other, two, second)),
            impulse: outcome.impulse,
        });
        let known = self.cells.is_some();
        self.predict_among(ball, known.then_some(&near_one))?;
        self.predict_among(other, known.then_some(&near_two))?;
        Ok(true)
    }

    /// Whether a ball touches nothing but its partner. Where balls are found by cells, the list is filled with those
    /// around.
    fn is_alone(&self, ball: usize, place: DVec3, partner: usize, list: &mut Neighbours) -> bool {
        let point = DVec2::new(place.x, place.z);
        let here = Area {
            least: point,
            most: point,
        };
        if !self.walls.is_open(&here) {
            return false;
        }
        if let Some(cells) = &self.cells {
            // More than the list holds go the general way.
            return cells.around(ball as u32, list, |_| Err(())).is_ok()
                && self.touches_none(list, ball, place, partner);
        }
        self.touches_none(&self.everyone, ball, place, partner)
    }

    fn touches_none(&self, list: &[u32], ball: usize, place: DVec3, partner: usize) -> bool {
        let radius = self.flights[ball].radius;
        let mut touches = false;
        for &other in list {
            let flight = &self.flights[other as usize];
            let reach = radius + flight.radius + TOUCH;
            let offset = flight.place(self.clock) - place;
            touches |= (offset.length_squared() <= reach * reach)
                & flight.in_play
                & (other != ball as u32)
                & (other != partner as u32);
        }
        !touches
    }
}
