//! Impacts: the law, and the paths that follow.

use glam::DVec3;

use crate::physics::ball::{Motion, State};
use crate::physics::exact::engine::Engine;
use crate::physics::exact::predict::Partner;
use crate::physics::exact::{CONTACT_TIME, SLOW, SolveError, Watch};
use crate::physics::laws::cluster::{Against, Blow, Member, PART, STILL, Touching};
use crate::physics::laws::motion::MotionLaw;
use crate::physics::record::{Event, EventKind, Participant};

impl Engine {
    /// A ball meets its partner now.
    pub(super) fn collide(
        &mut self,
        ball: usize,
        partner: Partner,
        watch: &mut impl Watch,
    ) -> Result<(), SolveError> {
        if let Partner::Ball(other) = partner
            && (self.collide_gliding(ball, other as usize, watch)
                || self.collide_alone(ball, other as usize, watch)?)
        {
            return Ok(());
        }
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
                member.state = self.laws.settled(&self.table, &member.body, &member.state);
                stop(&self.laws.motion, member);
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
                let press_of = |member: &Member| {
                    self.laws
                        .piece(&self.table, &member.body, &member.state)
                        .acceleration
                };
                let mut press = press_of(first);
                let mut moves = first.state.motion.translates();
                if let Against::Ball { member } = contact.against {
                    let second = &self.cluster.members[member];
                    press -= press_of(second);
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

/// Brings a ball on cloth to rest that a blow has left with less speed than settles a contact. It would go no further
/// than 1e-20 m, but touch what it leans on again at each change of motion.
fn stop(motion: &MotionLaw, member: &mut Member) {
    let state = &mut member.state;
    let spin = state.angular_velocity;
    if matches!(state.motion, Motion::Sliding | Motion::Rolling)
        && state.velocity.length() <= STILL
        && member.body.radius * spin.length() <= STILL + member.body.radius * spin.y.abs()
    {
        state.velocity = DVec3::ZERO;
        state.angular_velocity = DVec3::Y * spin.y;
        *state = motion.classify(&member.body, *state);
    }
}
