//! Impacts: who touches whom at this moment, the law, and the paths that follow.

use glam::{DVec2, DVec3};

use crate::physics::ball::State;
use crate::physics::exact::engine::Engine;
use crate::physics::exact::predict::Partner;
use crate::physics::exact::walls::{Area, Wall, Walls};
use crate::physics::exact::{CONTACT_TIME, DEEP, SLOW, SolveError, Watch};
use crate::physics::laws::cluster::{Against, Blow, Member, PART, STILL, TOUCH, Touching};
use crate::physics::record::{Event, EventKind, Participant};
use crate::physics::table::Cushion;

impl Engine {
    /// A ball meets its partner now.
    pub(super) fn collide(
        &mut self,
        ball: usize,
        partner: Partner,
        watch: &mut impl Watch,
    ) -> Result<(), SolveError> {
        self.cluster.clear();
        self.join(ball);
        match partner {
            Partner::Ball(other) => {
                self.join(other as usize);
                self.touch_balls(0, 1)?;
            }
            Partner::Cushion(cushion) => self.touch_cushion(0, cushion)?,
            _ => {}
        }
        self.resolve(partner, Blow::Impact, watch)
    }

    /// A ball has just been struck by the cue: what is frozen to it goes along.
    pub(super) fn push_off(
        &mut self,
        ball: usize,
        watch: &mut impl Watch,
    ) -> Result<(), SolveError> {
        self.cluster.clear();
        self.join(ball);
        self.resolve(Partner::Nothing, Blow::Stroke, watch)?;
        self.predict(ball)
    }

    /// Adds a ball to the cluster and returns its place.
    fn join(&mut self, ball: usize) -> usize {
        if let Some(place) = self
            .cluster
            .members
            .iter()
            .position(|member| member.ball == ball)
        {
            return place;
        }
        self.cluster.members.push(Member {
            ball,
            body: self.bodies[ball],
            state: self.state(ball),
        });
        self.cluster.members.len() - 1
    }

    fn touch_balls(&mut self, first: usize, second: usize) -> Result<(), SolveError> {
        let (one, two) = (&self.cluster.members[first], &self.cluster.members[second]);
        let offset = two.state.position - one.state.position;
        let overlap = one.body.radius + two.body.radius - offset.length();
        if overlap > DEEP {
            return Err(SolveError::Overlap {
                ball: self.names[one.ball].clone(),
                other: format!("ball `{}`", self.names[two.ball]),
                time: self.clock,
                overlap,
            });
        }
        // Divided, not multiplied by the reciprocal: a row along an axis has exactly that axis for its normals.
        let flat = DVec3::new(offset.x, 0.0, offset.z);
        let normal = flat / flat.length();
        self.cluster.contacts.push(Touching {
            first,
            against: Against::Ball { member: second },
            normal,
            nose_height: 0.0,
            restitution: None,
            impulse: 0.0,
        });
        Ok(())
    }

    fn touch_cushion(&mut self, first: usize, cushion: u32) -> Result<(), SolveError> {
        let member = &self.cluster.members[first];
        let position = member.state.position;
        let (distance, direction) =
            Walls::gap(&self.table, cushion, DVec2::new(position.x, position.z));
        let overlap = member.body.radius - distance;
        if overlap > DEEP {
            return Err(SolveError::Overlap {
                ball: self.names[member.ball].clone(),
                other: format!("cushion {cushion}"),
                time: self.clock,
                overlap,
            });
        }
        let index = cushion as usize;
        self.cluster.contacts.push(Touching {
            first,
            against: Against::Cushion { cushion: index },
            normal: -DVec3::new(direction.x, 0.0, direction.y),
            nose_height: self.laws.cushion.nose_height(
                self.table.nose_height,
                &member.body,
                &self.table.cushions[index],
            ),
            restitution: None,
            impulse: 0.0,
        });
        Ok(())
    }

    /// Adds everything that touches the members, and what touches that.
    fn gather(&mut self, partner: Partner) -> Result<(), SolveError> {
        let mut place = 0;
        while place < self.cluster.members.len() {
            let Member { ball, body, state } = self.cluster.members[place];
            let mut near = std::mem::take(&mut self.near);
            near.clear();
            {
                let mut look = |other: usize| {
                    let flight = &self.flights[other];
                    let reach = body.radius + flight.radius + TOUCH;
                    let offset = flight.place(self.clock) - state.position;
                    if offset.length_squared() <= reach * reach && flight.in_play && other != ball {
                        near.push(other);
                    }
                    Ok::<(), SolveError>(())
                };
                match &self.cells {
                    None => (0..self.flights.len()).try_for_each(look)?,
                    Some(cells) => cells.around(ball as u32, &mut look)?,
                }
            }
            // Cells list their balls in any order.
            near.sort_unstable();
            for &other in &near {
                let joined = self.join(other);
                let known = place == 0 && joined == 1 && matches!(partner, Partner::Ball(_));
                if joined > place && !known {
                    self.touch_balls(place, joined)?;
                }
            }
            self.near = near;
            self.gather_cushions(place, partner)?;
            place += 1;
        }
        Ok(())
    }

    fn gather_cushions(&mut self, place: usize, partner: Partner) -> Result<(), SolveError> {
        let member = &self.cluster.members[place];
        let (ball, radius) = (member.ball, member.body.radius);
        let point = DVec2::new(member.state.position.x, member.state.position.z);
        let here = Area {
            least: point,
            most: point,
        };
        if self.walls.is_open(&here) {
            return Ok(());
        }
        let count = match &self.cells {
            Some(cells) => cells.walls(ball as u32).len(),
            None => self.walls.list.len(),
        };
        for index in 0..count {
            let index = match &self.cells {
                Some(cells) => cells.walls(ball as u32)[index] as usize,
                None => index,
            };
            let (wall, area) = self.walls.list[index];
            let Wall::Cushion(cushion) = wall else {
                continue;
            };
            if !area.meets(&here) || (place == 0 && partner == Partner::Cushion(cushion)) {
                continue;
            }
            if self.touches(cushion, point, radius) {
                self.touch_cushion(place, cushion)?;
            }
        }
        Ok(())
    }

    /// Whether a ball touches a cushion; a line has no end caps.
    fn touches(&self, cushion: u32, point: DVec2, radius: f64) -> bool {
        let (distance, _) = Walls::gap(&self.table, cushion, point);
        let beside = match &self.table.cushions[cushion as usize] {
            Cushion::Line(line) => {
                let along = line.to - line.from;
                (0.0..=along.length_squared()).contains(&(point - line.from).dot(along))
            }
            Cushion::Arc(_) => true,
        };
        beside && distance <= radius + TOUCH && distance > radius - DEEP
    }

    /// Resolves the cluster around the first members and sets the new paths.
    fn resolve(
        &mut self,
        partner: Partner,
        blow: Blow,
        watch: &mut impl Watch,
    ) -> Result<(), SolveError> {
        self.gather(partner)?;
        self.before.clear();
        self.before
            .extend(self.cluster.members.iter().map(|member| member.state));
        self.lasting.clear();
        for index in 0..self.cluster.contacts.len() {
            let contact = self.cluster.contacts[index];
            let closing = self.cluster.closing(&contact);
            let again = closing < SLOW && self.clock - self.last_touch(&contact) < CONTACT_TIME;
            if again && closing > 0.0 {
                self.cluster.contacts[index].restitution = Some(1.0);
            }
            // What meets without closing is pressed together.
            let pressed = index == 0 && closing <= STILL;
            self.lasting
                .push((again || pressed) && blow == Blow::Impact);
        }
        let laws = self.laws;
        self.cluster.resolve(&laws, blow);
        self.classify();
        if self.must_part(partner) {
            self.cluster.settle(&laws, &self.parting);
            self.classify();
        }
        for place in 0..self.cluster.members.len() {
            let Member { ball, state, .. } = self.cluster.members[place];
            if state != self.before[place] {
                self.set(ball, state, watch)?;
            }
        }
        for index in 0..self.cluster.contacts.len() {
            let contact = self.cluster.contacts[index];
            if contact.impulse > 0.0 {
                self.report(&contact, watch);
            }
        }
        for place in 0..self.cluster.members.len() {
            let Member { ball, state, .. } = self.cluster.members[place];
            let met = place == 0 || (place == 1 && matches!(partner, Partner::Ball(_)));
            if met || state != self.before[place] {
                self.predict(ball)?;
            }
        }
        Ok(())
    }

    fn classify(&mut self) {
        for (member, before) in self.cluster.members.iter_mut().zip(&self.before) {
            if member.state != *before {
                member.state = self.laws.motion.classify(&member.body, member.state);
            }
        }
    }

    /// Whether a contact of the cluster would close again at once, and how fast each has to part so that none does.
    fn must_part(&mut self, partner: Partner) -> bool {
        self.parting.clear();
        let mut must = false;
        for (index, contact) in self.cluster.contacts.iter().enumerate() {
            let closing = self.cluster.closing(contact);
            let mut parting = 0.0;
            if closing > -SLOW {
                let first = &self.cluster.members[contact.first];
                let mut press = self
                    .laws
                    .motion
                    .piece(&first.body, &first.state)
                    .acceleration;
                let mut moves = first.state.motion.translates();
                if let Against::Ball { member } = contact.against {
                    let second = &self.cluster.members[member];
                    press -= self
                        .laws
                        .motion
                        .piece(&second.body, &second.state)
                        .acceleration;
                    moves |= second.state.motion.translates();
                }
                if moves {
                    // A first touch parts as its law says; if it is pressed back at once it is lasting then.
                    let time = if self.lasting[index] {
                        CONTACT_TIME
                    } else {
                        0.0
                    };
                    let spring = 0.5 * time * press.dot(contact.normal);
                    parting = spring.max(PART);
                    // Two that only slide past each other are left alone, unless they are what met.
                    let met = index == 0 && partner != Partner::Nothing;
                    let floor = if met { PART } else { 0.0 };
                    must |= closing > -spring.max(floor) && (closing > 0.0 || met || spring > 0.0);
                }
            }
            self.parting.push(parting);
        }
        must
    }

    fn last_touch(&self, contact: &Touching) -> f64 {
        self.touched[self.cluster.members[contact.first].ball].last(self.other(contact))
    }

    fn other(&self, contact: &Touching) -> Partner {
        match contact.against {
            Against::Ball { member } => Partner::Ball(self.cluster.members[member].ball as u32),
            Against::Cushion { cushion } => Partner::Cushion(cushion as u32),
        }
    }

    fn report(&mut self, contact: &Touching, watch: &mut impl Watch) {
        let participant = |place: usize| {
            let after: State = self.cluster.members[place].state;
            Participant {
                ball: self.cluster.members[place].ball,
                before: self.before[place],
                after,
            }
        };
        let first = participant(contact.first);
        let (kind, second) = match contact.against {
            Against::Ball { member } => (EventKind::BallBall, Some(participant(member))),
            Against::Cushion { cushion } => (EventKind::Cushion { cushion }, None),
        };
        let other = self.other(contact);
        self.touched[first.ball].add(other, self.clock);
        if let Some(second) = &second {
            self.touched[second.ball].add(Partner::Ball(first.ball as u32), self.clock);
        }
        watch.event(&Event {
            time: self.clock,
            kind,
            first,
            second,
            impulse: contact.impulse,
        });
    }
}
