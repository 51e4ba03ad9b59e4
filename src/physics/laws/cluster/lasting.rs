//! Contacts that last. A ball that is pressed against a cushion or another ball by the friction under it would bounce ever
//! more often. Two rules end that. A contact that closes at less than [`SLOW`] less than [`CONTACT_TIME`] after the same two
//! touched loses nothing (the TC model of Luding et al., Granular Matter 1 (1998) 113), and a contact that is pressed
//! together by a parts with at least a [`CONTACT_TIME`] / 2. So two that rest against each other touch once every
//! [`CONTACT_TIME`] at most, with gaps of some micrometres.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::Motion;
use crate::physics::laws::Laws;
use crate::physics::laws::cluster::{Against, Blow, Cluster, Member, PART, STILL, Touching};
use crate::physics::laws::motion::MotionLaw;
use crate::physics::table::Table;

/// Two contacts of the same two within this time in s are one lasting contact. Cushions hold a ball for about 8 ms
/// (Sudo & Shibata 2002), balls touch for about 0.3 ms.
pub const CONTACT_TIME: f64 = 1e-3;

/// Closing speed in m/s below which two contacts soon after each other are one lasting contact.
pub const SLOW: f64 = 5e-3;

/// Most times that contacts are made to part at one instant.
const BEARINGS: usize = 64;

/// What a ball of a scene touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Other {
    /// Another ball, by its index.
    Ball(u32),
    /// A cushion, by its index.
    Cushion(u32),
}

/// The last things that a ball touched, newest first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touched {
    what: [Option<Other>; 4],
    time: [f64; 4],
}

impl Touched {
    /// Nothing so far.
    pub const NOTHING: Self = Self {
        what: [None; 4],
        time: [f64::NEG_INFINITY; 4],
    };

    /// It touches this now.
    pub fn add(&mut self, what: Other, time: f64) {
        let same = |old: &Option<Other>| *old == Some(what);
        let place = self.what.iter().position(same).unwrap_or(3);
        self.what[..=place].rotate_right(1);
        self.time[..=place].rotate_right(1);
        self.what[0] = Some(what);
        self.time[0] = time;
    }

    /// When it last touched this, s; minus infinity if that is long ago.
    #[must_use]
    pub fn last(&self, what: Other) -> f64 {
        let place = self.what.iter().position(|old| *old == Some(what));
        place.map_or(f64::NEG_INFINITY, |place| self.time[place])
    }

    /// All it remembers, newest first.
    pub fn list(&self) -> impl Iterator<Item = (Other, f64)> {
        let known = self.what.into_iter().zip(self.time);
        known.filter_map(|(what, time)| Some((what?, time)))
    }

    /// The same from its list.
    #[must_use]
    pub fn from_list(list: &[(Other, f64)]) -> Self {
        let mut touched = Self::NOTHING;
        for (place, (what, time)) in list.iter().take(4).enumerate() {
            touched.what[place] = Some(*what);
            touched.time[place] = *time;
        }
        touched
    }
}

impl Cluster {
    /// Velocities and labels of motion after everything that touches has met; the states before are kept in
    /// [`Cluster::before`]. `ages` tells of each contact how many seconds ago the same two touched last, infinity if never.
    /// The first contact is what met, if anything did: a stroke pushes what is frozen to the ball.
    pub fn collide(
        &mut self,
        laws: &Laws,
        table: &Table,
        blow: Blow,
        ages: impl Fn(usize, Other) -> f64,
    ) {
        self.before.clear();
        self.before
            .extend(self.members.iter().map(|member| member.state));
        self.lasting.clear();
        for index in 0..self.contacts.len() {
            let contact = self.contacts[index];
            let closing = self.closing(&contact);
            let age = ages(self.members[contact.first].ball, self.other(&contact));
            let again = closing < SLOW && age < CONTACT_TIME;
            if again && closing > 0.0 {
                // Unless the caller has had enough of its bounces.
                self.contacts[index].restitution.get_or_insert(1.0);
            }
            // What meets without closing is pressed together.
            let pressed = index == 0 && closing <= STILL;
            self.lasting
                .push((again || pressed) && blow == Blow::Impact);
        }
        self.resolve(laws, blow);
        self.classify(laws, table);
        if self.must_part(laws, table, blow) {
            let parting = std::mem::take(&mut self.parting);
            // The slate takes up what drives a ball into it: one that bears another on top gives way again and again.
            for _ in 0..BEARINGS {
                self.settle(laws, &parting);
                self.classify(laws, table);
                if self.have_parted(&parting) {
                    break;
                }
            }
            self.parting = parting;
        }
    }

    /// Whether every contact parts with at least half the speed that it must.
    fn have_parted(&self, parting: &[f64]) -> bool {
        let mut pairs = self.contacts.iter().zip(parting);
        pairs.all(|(contact, parting)| *parting <= PART || self.closing(contact) <= -0.5 * parting)
    }

    /// What the ball of a contact touches.
    #[must_use]
    pub fn other(&self, contact: &Touching) -> Other {
        match contact.against {
            Against::Ball { member } => Other::Ball(self.members[member].ball as u32),
            Against::Cushion { cushion } => Other::Cushion(cushion as u32),
        }
    }

    fn classify(&mut self, laws: &Laws, table: &Table) {
        for (member, before) in self.members.iter_mut().zip(&self.before) {
            if member.state != *before {
                member.state = laws.settled(table, &member.body, &member.state);
                stop(&laws.motion, member);
            }
        }
    }

    /// Whether a contact would close again at once, and how fast each has to part so that none does.
    fn must_part(&mut self, laws: &Laws, table: &Table, blow: Blow) -> bool {
        self.parting.clear();
        let mut must = false;
        for (index, contact) in self.contacts.iter().enumerate() {
            let closing = self.closing(contact);
            let mut parting = 0.0;
            if closing > -SLOW {
                let first = &self.members[contact.first];
                let press_of =
                    |member: &Member| laws.piece(table, &member.body, &member.state).acceleration;
                let mut press = press_of(first);
                let mut moves = first.state.motion.translates();
                if let Against::Ball { member } = contact.against {
                    let second = &self.members[member];
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
                    let met = index == 0 && blow == Blow::Impact;
                    let floor = if met { PART } else { 0.0 };
                    must |= closing > -spring.max(floor) && (closing > 0.0 || met || spring > 0.0);
                }
            }
            self.parting.push(parting);
        }
        must
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
