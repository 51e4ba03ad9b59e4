//! Two balls that meet while nothing else touches them: nearly every impact. The same numbers as the general way of
//! `impact`, without its lists.

use glam::{DVec2, DVec3};

use crate::physics::ball::State;
use crate::physics::exact::cells::Neighbours;
use crate::physics::exact::engine::Engine;
use crate::physics::exact::walls::Area;
use crate::physics::exact::{SolveError, Watch};
use crate::physics::laws::ball_ball::PairContact;
use crate::physics::laws::cluster::{DEEP, Other, SLOW, TOUCH};
use crate::physics::record::{Event, EventKind, Participant};

impl Engine {
    /// Lets two balls that glide without spin collide, as [`Self::collide_alone`] does. What each of them meets next is
    /// found first; whether they touch anything else comes out on the way. Such an impact is not remembered: they part fast,
    /// and if others send them back slowly within a contact time it counts as a first touch.
    pub(super) fn collide_gliding(
        &mut self,
        ball: usize,
        other: usize,
        watch: &mut impl Watch,
    ) -> bool {
        let old = [self.flights[ball], self.flights[other]];
        if !(old[0].plain && old[1].plain) {
            return false;
        }
        let now = self.clock;
        let before = old.map(|flight| flight.state(now));
        let Some((after, impulse)) = self.rebound(ball, other, &before) else {
            return false;
        };
        let gliding = |place: usize| old[place].gliding(&after[place], now);
        let (Some(one), Some(two)) = (gliding(0), gliding(1)) else {
            return false;
        };
        let is_open = |state: &State| {
            let point = DVec2::new(state.position.x, state.position.z);
            self.walls.is_open(&Area {
                least: point,
                most: point,
            })
        };
        if !(before.iter().all(is_open) && after.iter().all(State::is_finite)) {
            return false;
        }
        self.flights[ball] = one;
        self.flights[other] = two;
        let first = self.search_but(ball, None, other as u32);
        let second = self.search_but(other, None, ball as u32);
        let (Ok((first, false)), Ok((second, false))) = (first, second) else {
            self.flights[ball] = old[0];
            self.flights[other] = old[1];
            return false;
        };
        self.flights[ball].next = first;
        self.flights[other].next = second;
        self.queue.set(ball, first.time);
        self.queue.set(other, second.time);
        watch.piece(ball, &one.path());
        watch.piece(other, &two.path());
        report([ball, other], before, after, impulse, now, watch);
        true
    }

    /// Lets two balls collide, if they touch nothing else, meet fast and part fast; otherwise nothing is done and the
    /// answer is false.
    pub(super) fn collide_alone(
        &mut self,
        ball: usize,
        other: usize,
        watch: &mut impl Watch,
    ) -> Result<bool, SolveError> {
        let before = [self.state(ball), self.state(other)];
        let Some((after, impulse)) = self.rebound(ball, other, &before) else {
            return Ok(false);
        };
        let (mut near_one, mut near_two) = (Neighbours::none(), Neighbours::none());
        if !self.is_alone(ball, before[0].position, other, &mut near_one)
            || !self.is_alone(other, before[1].position, ball, &mut near_two)
        {
            return Ok(false);
        }
        self.set(ball, after[0], watch)?;
        self.set(other, after[1], watch)?;
        self.touched[ball].add(Other::Ball(other as u32), self.clock);
        self.touched[other].add(Other::Ball(ball as u32), self.clock);
        report([ball, other], before, after, impulse, self.clock, watch);
        let known = self.cells.is_some();
        self.predict_among(ball, known.then_some(&near_one))?;
        self.predict_among(other, known.then_some(&near_two))?;
        Ok(true)
    }

    /// The states of two balls after an impact that is no lasting contact, and its impulse.
    fn rebound(&self, ball: usize, other: usize, before: &[State; 2]) -> Option<([State; 2], f64)> {
        let [one, two] = before;
        let (body_one, body_two) = (&self.flights[ball].body, &self.flights[other].body);
        let offset = two.position - one.position;
        let overlap = body_one.radius + body_two.radius - offset.length();
        let flat = DVec3::new(offset.x, 0.0, offset.z);
        let normal = flat / flat.length();
        let closing = (one.velocity - two.velocity).dot(normal);
        // Written so that what is not a number goes the general way.
        if !(closing >= SLOW && overlap <= DEEP) || one.motion.flies() || two.motion.flies() {
            return None;
        }
        let geometry = PairContact {
            normal,
            on_slate: true,
            restitution: None,
        };
        let outcome = self
            .laws
            .ball_ball
            .collide((body_one, one), (body_two, two), &geometry);
        let first = self.laws.motion.classify(body_one, outcome.first);
        let second = self.laws.motion.classify(body_two, outcome.second);
        let parting = (second.velocity - first.velocity).dot(normal);
        (parting >= SLOW && outcome.impulse > 0.0).then_some(([first, second], outcome.impulse))
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

    #[expect(
        clippy::needless_bitwise_bool,
        reason = "no branch can be guessed here"
    )]
    fn touches_none(&self, list: &[u32], ball: usize, place: DVec3, partner: usize) -> bool {
        let radius = self.flights[ball].radius;
        let mut touches = false;
        for &other in list {
            let flight = &self.flights[other as usize];
            let reach = radius + flight.radius + TOUCH;
            let offset = self.center(other as usize) - place;
            touches |= (offset.length_squared() <= reach * reach)
                & flight.in_play
                & (other != ball as u32)
                & (other != partner as u32);
        }
        !touches
    }
}

fn report(
    balls: [usize; 2],
    before: [State; 2],
    after: [State; 2],
    impulse: f64,
    time: f64,
    watch: &mut impl Watch,
) {
    let participant = |place: usize| Participant {
        ball: balls[place],
        before: before[place],
        after: after[place],
    };
    watch.event(&Event {
        time,
        kind: EventKind::BallBall,
        first: participant(0),
        second: Some(participant(1)),
        impulse,
    });
}
