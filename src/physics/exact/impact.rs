//! Impacts: the law, and the paths that follow.

use crate::physics::ball::State;
use crate::physics::exact::engine::Engine;
use crate::physics::exact::predict::Partner;
use crate::physics::exact::{SolveError, Watch};
use crate::physics::laws::cluster::{Against, Blow, Member, Other, Touching};
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
            Partner::Landing(landing) => {
                if let Some(what) = landing.other() {
                    self.touch_inside(0, what);
                }
            }
            _ => {}
        }
        self.resolve(partner, Blow::Impact, watch)
    }

    /// A ball has just been struck by the cue: what is frozen to it goes along. [`Self::strike`] does so itself; it is for
    /// an engine that was made from balls of which one has been struck at this moment.
    ///
    /// # Errors
    /// [`SolveError`] as [`Self::advance`].
    pub fn push_off(&mut self, ball: usize, watch: &mut impl Watch) -> Result<(), SolveError> {
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
        let (touched, now) = (&self.touched, self.clock);
        let age = |ball: usize, other: Other| now - touched[ball].last(other);
        self.gather(partner, self.cluster.how(blow, age))?;
        let touched = &self.touched;
        let age = |ball: usize, other: Other| now - touched[ball].last(other);
        self.cluster.collide(&self.laws, &self.table, blow, age);
        for place in 0..self.cluster.members.len() {
            let Member { ball, state, .. } = self.cluster.members[place];
            if state != self.cluster.before[place] {
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
            if met || state != self.cluster.before[place] {
                self.predict(ball)?;
            }
        }
        let met = self.cluster.members[0].ball;
        let (hold, jammed) = (self.cluster.may_hold(), self.cluster.is_jammed());
        for ball in self.cluster.dislodged().collect::<Vec<_>>() {
            self.let_go(ball, watch)?;
        }
        if hold {
            self.hold(met, jammed, watch)?;
        }
        Ok(())
    }

    fn report(&mut self, contact: &Touching, watch: &mut impl Watch) {
        let participant = |place: usize| {
            let after: State = self.cluster.members[place].state;
            Participant {
                ball: self.cluster.members[place].ball,
                before: self.cluster.before[place],
                after,
            }
        };
        let first = participant(contact.first);
        let (kind, second) = match contact.against {
            Against::Ball { member } => (EventKind::BallBall, Some(participant(member))),
            Against::Cushion { cushion } => (EventKind::Cushion { cushion }, None),
            Against::Rim { pocket } | Against::Wall { pocket } => (EventKind::Rim { pocket }, None),
        };
        let other = self.cluster.other(contact);
        self.touched[first.ball].add(other, self.clock);
        if let Some(second) = &second {
            let first = Other::Ball(first.ball as u32);
            self.touched[second.ball].add(first, self.clock);
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
