//! Impacts with what touches: the same clusters as the exact solver resolves.

use glam::DVec2;

use crate::physics::laws::cluster::{
    Against, Blow, CONTACT_TIME, Cluster, How, LEAN, Member, Other, TOUCH, Touching, leans,
    leans_inside, reach_of,
};
use crate::physics::record::{Event, EventKind, Participant};
use crate::sim::playfield::Playfield;
use crate::sim::stepped::bodies::Bodies;
use crate::sim::stepped::contacts::{Contact, Kind};
use crate::sim::stepped::grid::Grid;
use crate::sim::stepped::resolve::BOUNCES;

/// What happened at one moment; its lists are kept from impact to impact.
#[derive(Debug, Default)]
pub(super) struct Impact {
    pub(super) cluster: Cluster,
    near: Vec<usize>,
    /// The events of this moment.
    pub events: Vec<Event>,
    /// The balls that are on new paths, those first that met.
    pub changed: Vec<usize>,
}

impl Impact {
    /// Forgets the last moment.
    pub fn clear(&mut self) {
        self.cluster.clear();
        self.events.clear();
        self.changed.clear();
    }

    /// A ball meets another, or a cushion, at its time of the tick.
    pub fn meet(
        &mut self,
        bodies: &mut Bodies,
        grid: &Grid,
        playfield: &Playfield,
        contact: &Contact,
    ) {
        self.join(bodies, contact.ball, contact.time);
        self.changed.push(contact.ball);
        match contact.kind {
            Kind::Ball(other, _) => {
                self.join(bodies, other, contact.time);
                self.changed.push(other);
                self.cluster.touch_ball(0, 1);
            }
            Kind::Cushion(cushion) => {
                let (laws, table) = (&playfield.laws, &playfield.table);
                self.cluster.touch_cushion(laws, table, 0, cushion);
            }
            kind => {
                if let Some(what) = kind.other() {
                    self.touch_inside(playfield, 0, what);
                }
            }
        }
        self.resolve(
            bodies,
            grid,
            playfield,
            (Blow::Impact, contact.time, contact.kind),
        );
    }

    /// A ball has been struck at the start of the tick: what is frozen to it goes along.
    pub fn push_off(
        &mut self,
        bodies: &mut Bodies,
        grid: &Grid,
        playfield: &Playfield,
        ball: usize,
    ) {
        self.join(bodies, ball, 0.0);
        self.resolve(bodies, grid, playfield, (Blow::Stroke, 0.0, Kind::Change));
    }

    pub(super) fn join(&mut self, bodies: &Bodies, ball: usize, time: f64) -> usize {
        let body = &bodies.all[ball];
        self.cluster.join(ball, body.ball, body.at(time))
    }

    fn touch_inside(&mut self, playfield: &Playfield, place: usize, what: Other) {
        let (laws, table) = (&playfield.laws, &playfield.table);
        self.cluster.touch_inside(laws, table, place, what);
    }

    fn resolve(
        &mut self,
        bodies: &mut Bodies,
        grid: &Grid,
        playfield: &Playfield,
        (blow, time, kind): (Blow, f64, Kind),
    ) {
        let (touched, now) = (&bodies.touched, bodies.start + time);
        let age = |ball: usize, other: Other| now - touched[ball].last(other);
        let how = self.cluster.how(blow, age);
        self.gather(bodies, grid, playfield, (time, kind, how));
        for contact in &mut self.cluster.contacts {
            let ball = self.cluster.members[contact.first].ball;
            let other = contact.against.member();
            let other = other.map_or(ball, |member| self.cluster.members[member].ball);
            let impacts = bodies.all[ball].impacts.max(bodies.all[other].impacts);
            contact.restitution = (impacts >= BOUNCES).then_some(0.0);
        }
        let (laws, table) = (&playfield.laws, &playfield.table);
        let (touched, now) = (&bodies.touched, bodies.start + time);
        let age = |ball: usize, other: Other| now - touched[ball].last(other);
        self.cluster.collide(laws, table, blow, age);
        for (member, before) in self.cluster.members.iter().zip(&self.cluster.before) {
            let Member { ball, state, .. } = member;
            if state != before && !self.changed.contains(ball) {
                self.changed.push(*ball);
            }
            if self.changed.contains(ball) {
                bodies.all[*ball].follow(playfield, state, time);
            }
        }
        for index in 0..self.cluster.contacts.len() {
            let contact = self.cluster.contacts[index];
            if contact.impulse > 0.0 || (index == 0 && blow == Blow::Impact) {
                self.report(bodies, &contact, now);
            }
        }
        let met = self.cluster.members[0].ball;
        let (hold, jammed) = (self.cluster.may_hold(), self.cluster.is_jammed());
        for ball in self.cluster.dislodged().collect::<Vec<_>>() {
            self.let_go(bodies, grid, playfield, (ball, time));
        }
        if hold {
            self.hold(bodies, grid, playfield, (met, time, jammed));
        }
    }

    /// Adds everything that touches the members, and what touches that; also what they lean on, or of those off the slate all
    /// that is close.
    pub(super) fn gather(
        &mut self,
        bodies: &Bodies,
        grid: &Grid,
        playfield: &Playfield,
        (time, kind, how): (f64, Kind, How),
    ) {
        let (laws, table) = (&playfield.laws, &playfield.table);
        let mut place = 0;
        while place < self.cluster.members.len() {
            let Member { ball, body, state } = self.cluster.members[place];
            if !how.spreads_from(&state) {
                place += 1;
                continue;
            }
            self.near.clear();
            grid.neighbours(bodies, ball, |other| {
                let there = &bodies.all[other];
                let reach = body.radius + there.ball.radius + how.within();
                let offset = there.piece.position(time - there.since) - state.position;
                if there.is_in_play() && offset.length_squared() <= reach * reach {
                    self.near.push(other);
                }
            });
            // Cells list their balls in any order.
            self.near.sort_unstable();
            for index in 0..self.near.len() {
                let joined = self.join(bodies, self.near[index], time);
                let known = place == 0 && joined == 1 && matches!(kind, Kind::Ball(..));
                if joined > place && !known {
                    self.cluster.touch_ball(place, joined);
                }
            }
            self.near.clear();
            let point = DVec2::new(state.position.x, state.position.z);
            let reach = reach_of(table, &body, &state);
            grid.cushions(table, &bodies.all[ball].cells, |cushion| {
                let met = place == 0 && kind == Kind::Cushion(cushion);
                if !met && how.takes(&table.cushions[cushion], point, reach) {
                    self.near.push(cushion);
                }
            });
            self.near.sort_unstable();
            self.near.dedup();
            for index in 0..self.near.len() {
                let cushion = self.near[index];
                self.cluster.touch_cushion(laws, table, place, cushion);
            }
            self.gather_inside(bodies, grid, playfield, (place, kind, how));
            if how == How::Leaning {
                self.gather_leaning(bodies, playfield, place, (time, kind));
            }
            place += 1;
        }
    }

    /// Adds what a member touches of pockets.
    fn gather_inside(
        &mut self,
        bodies: &Bodies,
        grid: &Grid,
        playfield: &Playfield,
        (place, kind, how): (usize, Kind, How),
    ) {
        let (laws, table) = (&playfield.laws, &playfield.table);
        let Member { ball, body, state } = self.cluster.members[place];
        if !state.motion.flies() {
            return;
        }
        self.near.clear();
        grid.pockets(table, &bodies.all[ball].cells, |pocket| {
            self.near.push(pocket);
        });
        self.near.sort_unstable();
        self.near.dedup();
        for index in 0..self.near.len() {
            let pocket = self.near[index];
            for what in [Other::Rim(pocket as u32), Other::Wall(pocket as u32)] {
                let met = place == 0 && kind.other() == Some(what);
                if !met && how.takes_inside(laws, table, (&body, &state), what) {
                    self.touch_inside(playfield, place, what);
                }
            }
        }
    }

    /// Adds what a member touches no more, but touched lately.
    fn gather_leaning(
        &mut self,
        bodies: &Bodies,
        playfield: &Playfield,
        place: usize,
        (time, kind): (f64, Kind),
    ) {
        let (laws, table) = (&playfield.laws, &playfield.table);
        let Member { ball, body, state } = self.cluster.members[place];
        let reach = reach_of(table, &body, &state);
        let point = DVec2::new(state.position.x, state.position.z);
        for (what, touched) in bodies.touched[ball].list() {
            if bodies.start + time - touched >= CONTACT_TIME {
                continue;
            }
            match what {
                Other::Ball(other) => {
                    let other = other as usize;
                    let met = place == 0 && matches!(kind, Kind::Ball(ball, _) if ball == other);
                    let there = &bodies.all[other];
                    let center = there.piece.position(time - there.since);
                    let gap = center.distance(state.position) - (body.radius + there.ball.radius);
                    if !met && there.is_in_play() && gap > TOUCH && gap <= LEAN {
                        let joined = self.join(bodies, other, time);
                        if joined > place {
                            self.cluster.touch_ball(place, joined);
                        }
                    }
                }
                Other::Cushion(cushion) => {
                    let cushion = cushion as usize;
                    let met = place == 0 && kind == Kind::Cushion(cushion);
                    if !met && leans(&table.cushions[cushion], point, reach) {
                        self.cluster.touch_cushion(laws, table, place, cushion);
                    }
                }
                Other::Rim(_) | Other::Wall(_) => {
                    let met = place == 0 && kind.other() == Some(what);
                    if !met && leans_inside(laws, table, (&body, &state), what) {
                        self.touch_inside(playfield, place, what);
                    }
                }
            }
        }
    }

    fn report(&mut self, bodies: &mut Bodies, contact: &Touching, time: f64) {
        let participant = |place: usize| Participant {
            ball: bodies.all[self.cluster.members[place].ball].index,
            before: self.cluster.before[place],
            after: self.cluster.members[place].state,
        };
        let first = participant(contact.first);
        let (kind, second) = match contact.against {
            Against::Ball { member } => (EventKind::BallBall, Some(participant(member))),
            Against::Cushion { cushion } => (EventKind::Cushion { cushion }, None),
            Against::Rim { pocket } | Against::Wall { pocket } => (EventKind::Rim { pocket }, None),
        };
        let other = self.cluster.other(contact);
        let ball = self.cluster.members[contact.first].ball;
        bodies.touched[ball].add(other, time);
        bodies.all[ball].impacts += 1;
        if let Other::Ball(other) = other {
            bodies.touched[other as usize].add(Other::Ball(ball as u32), time);
            bodies.all[other as usize].impacts += 1;
        }
        self.events.push(Event {
            time,
            kind,
            first,
            second,
            impulse: contact.impulse,
        });
    }
}
