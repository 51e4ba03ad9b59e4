//! Balls that nothing lets move: on the edge of a pocket and between its noses or its liner, on each other. A ball there would
//! bounce between them without end, and where the normals of its contacts span all directions no speed parts it from all of
//! them. So a slow one that its weight does not move comes to rest ([`Motion::Wedged`]), until something dislodges it.

use glam::DVec3;

use crate::physics::ball::Motion;
use crate::physics::laws::Laws;
use crate::physics::laws::cluster::smith_2012::ends;
use crate::physics::laws::cluster::{Against, CONTACT_TIME, Cluster, Member, SLOW, Touching};

/// Speed in m/s, of the centre and of the surface, up to which a ball that its weight does not move comes to rest: it would
/// rise by 5 µm.
const CALM: f64 = 2.0 * SLOW;

/// Share of the speed of a free fall up to which a ball is not moved: a slope of a millionth.
const MOVED: f64 = 1e-6;

/// How many times heavier a wedged ball is to what touches it slowly.
const FIRM: f64 = 1e9;

impl Cluster {
    /// Keeps wedged balls in their places where what met is slow: it leans on them as on a wall. Whether it dislodges them by
    /// its weight is for [`Self::hold`] to say.
    pub(super) fn firm(&mut self) {
        self.firm.clear();
        let slow = self.contacts.first().is_some_and(|contact| {
            let closing = self.closing(contact);
            closing < SLOW
        });
        if !slow {
            return;
        }
        for (place, member) in self.members.iter_mut().enumerate() {
            if member.state.motion == Motion::Wedged {
                self.firm.push((place, member.body.mass));
                member.body.mass *= FIRM;
            }
        }
        let firm = &self.firm;
        let is_firm = |place: usize| firm.iter().any(|(one, _)| *one == place);
        if !firm.is_empty() {
            self.contacts.retain(|contact| {
                !is_firm(contact.first) || contact.against.member().is_some_and(|two| !is_firm(two))
            });
        }
    }

    /// Gives firm balls their mass back: they have not moved.
    pub(super) fn loosen(&mut self) {
        for (place, mass) in self.firm.drain(..) {
            let member = &mut self.members[place];
            member.body.mass = mass;
            member.state = self.before[place];
        }
    }

    /// Whether a ball of what met has lasting contact in flight, so that it may be held.
    #[must_use]
    pub fn may_hold(&self) -> bool {
        let flies = |place: usize| self.members[place].state.motion == Motion::Airborne;
        let of_contact = |index: usize| {
            let contact = &self.contacts[index];
            flies(contact.first) || contact.against.member().is_some_and(flies)
        };
        !self.stuck && self.lasting.first() == Some(&true) && of_contact(0)
    }

    /// In a pocket what has jammed, and meets again at the same moment, is stuck where it is: no speed parts it from all that it
    /// touches, and no time would pass any more. Until something meets it, whatever its weight says.
    pub(super) fn stick(&mut self) {
        let part_of_pocket = |one: &Touching| one.hollow != 0.0 || is_wall(one);
        if !self.contacts.iter().any(part_of_pocket) {
            return;
        }
        for index in 0..self.contacts.len() {
            let (contact, parting) = (self.contacts[index], self.parting[index]);
            if parting <= 0.0 || self.closing(&contact) <= -0.5 * parting {
                continue;
            }
            for (place, _) in ends(&contact) {
                let state = &mut self.members[place].state;
                if state.motion.flies() {
                    state.velocity = DVec3::ZERO;
                    state.angular_velocity = DVec3::ZERO;
                    state.motion = Motion::Wedged;
                    self.stuck = true;
                }
            }
        }
    }

    /// The balls that were wedged and are so no more.
    pub fn dislodged(&self) -> impl Iterator<Item = usize> {
        let pairs = self.members.iter().zip(&self.before);
        pairs
            .filter(|(member, before)| {
                before.motion == Motion::Wedged && member.state.motion != Motion::Wedged
            })
            .map(|(member, _)| member.ball)
    }

    /// Whether something that touched did not part, however often it tried.
    #[must_use]
    pub fn is_jammed(&self) -> bool {
        self.jammed
    }

    /// Brings to rest what the contacts hold, and lets go what was wedged and is not held: all that flies, all within
    /// [`LEAN`](super::LEAN) of each other, is among the members. States before are in [`Cluster::before`].
    ///
    /// Slow balls are held that a contact time of their weight alone does not move: the velocities that follow from it are
    /// unique (see `complementarity`). What moves bears nothing, so it is asked again without it. Along the wall of a pocket
    /// that it is pressed to none moves: each touch takes a share of that motion, so lasting contact takes all of it. A ball that
    /// spins is not held while what it touches rubs on it, except in a jam, which takes the spin too: there is no limit to what
    /// presses there.
    pub fn hold(&mut self, laws: &Laws, jammed: bool) {
        self.before.clear();
        self.before
            .extend(self.members.iter().map(|member| member.state));
        let Some(gravity) = laws.motion.gravity() else {
            return;
        };
        let fall = CONTACT_TIME * gravity;
        self.held.clear();
        for place in 0..self.members.len() {
            let state = self.members[place].state;
            let calm = state.motion.flies() && state.velocity.length() <= CALM;
            let held = calm && (jammed || !self.is_driven(laws, place, fall));
            self.held.push(held);
        }
        self.cling();
        loop {
            let held = &self.held;
            self.contacts.retain(|contact| {
                let second = match contact.against {
                    Against::Ball { member } => held[member],
                    Against::Cushion { .. } | Against::Rim { .. } | Against::Wall { .. } => true,
                };
                held[contact.first] && second
            });
            for (member, held) in self.members.iter_mut().zip(&self.held) {
                if *held {
                    member.state.velocity = -fall * DVec3::Y;
                }
            }
            for contact in &mut self.contacts {
                contact.impulse = 0.0;
            }
            self.settle(laws);
            let mut again = self.slip();
            for (member, held) in self.members.iter().zip(&mut self.held) {
                if *held && member.state.velocity.length() > MOVED * fall {
                    *held = false;
                    again = true;
                }
            }
            if !again {
                break;
            }
        }
        self.contacts.clear();
        for place in 0..self.members.len() {
            let Member { body, state, .. } = &mut self.members[place];
            *state = self.before[place];
            if self.held[place] {
                let spin = body.radius * state.angular_velocity.length();
                if jammed || spin <= CALM {
                    state.angular_velocity = DVec3::ZERO;
                }
                state.velocity = DVec3::ZERO;
                state.motion = Motion::Wedged;
            } else if state.motion == Motion::Wedged {
                state.motion = Motion::Airborne;
            }
        }
    }

    /// Whether what a member touches rubs on its spin when it is pressed to it at this speed in m/s: that drives it on. It may
    /// turn for ever where nothing rubs, or about a contact.
    fn is_driven(&mut self, laws: &Laws, place: usize, pressed: f64) -> bool {
        let Member { body, state, .. } = self.members[place];
        let spin = state.angular_velocity;
        if body.radius * spin.length() <= CALM {
            return false;
        }
        let contacts = self.contacts.iter();
        let own = contacts.filter(|contact| ends(contact).any(|(ball, _)| ball == place));
        let slipping: Vec<Touching> = own
            .filter(|contact| body.radius * spin.cross(contact.normal).length() > CALM)
            .copied()
            .collect();
        slipping.iter().any(|contact| {
            let kept = self.members.clone();
            for (ball, sign) in ends(contact) {
                self.members[ball].state.velocity = -0.5 * sign * pressed * contact.normal;
            }
            self.apply(laws, contact, Some(0.0));
            let after = self.members[place].state.angular_velocity;
            self.members = kept;
            after != spin
        })
    }

    /// Lets no member move along a wall that it touches, one way or the other.
    fn cling(&mut self) {
        for index in 0..self.contacts.len() {
            let contact = self.contacts[index];
            if is_wall(&contact) {
                let along = DVec3::Y.cross(contact.away);
                for normal in [along, -along] {
                    self.contacts.push(Touching { normal, ..contact });
                }
            }
        }
    }

    /// Lets go of the walls to which nothing presses the members, and tells whether there are any.
    fn slip(&mut self) -> bool {
        let presses = |contact: &Touching| !clings(contact) && contact.impulse > 0.0;
        let pressed: Vec<(usize, Against)> = self
            .contacts
            .iter()
            .filter(|contact| is_wall(contact) && presses(contact))
            .map(|contact| (contact.first, contact.against))
            .collect();
        let count = self.contacts.len();
        self.contacts.retain(|contact| {
            !clings(contact) || pressed.contains(&(contact.first, contact.against))
        });
        self.contacts.len() < count
    }
}

fn is_wall(contact: &Touching) -> bool {
    matches!(contact.against, Against::Wall { .. })
}

/// Whether this is one that [`Cluster::cling`] has added: it is across what it belongs to.
fn clings(contact: &Touching) -> bool {
    is_wall(contact) && contact.normal.dot(contact.away).abs() < 0.5
}
