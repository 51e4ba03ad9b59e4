//! Contacts that last. A ball that is pressed against a cushion or another ball by the friction under it would bounce ever
//! more often. Five rules end that. A contact that closes at less than [`SLOW`] less than [`CONTACT_TIME`] after the same two
//! touched loses nothing (the TC model of Luding et al., Granular Matter 1 (1998) 113); a contact that is pressed
//! together parts fast enough not to close again within a [`CONTACT_TIME`]; a ball that is squeezed between others is settled
//! together with all that it leans on ([`Cluster::how`]); where it would close again sooner all the
//! same, without force and by next to nothing, as of a ball between two others that leave it no room, it is let wait
//! ([`put_off`]); and what nothing lets move comes to rest ([`Cluster::hold`]). So two that rest against each other touch once
//! every [`CONTACT_TIME`] at most, with gaps of some micrometres.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Motion, State};
use crate::physics::laws::Laws;
use crate::physics::laws::cluster::{Against, Blow, Cluster, How, Member, PART, STILL, Touching};
use crate::physics::table::Table;

/// Two contacts of the same two within this time in s are one lasting contact. Cushions hold a ball for about 8 ms
/// (Sudo & Shibata 2002), balls touch for about 0.3 ms.
pub const CONTACT_TIME: f64 = 1e-3;

/// Closing speed in m/s below which two contacts soon after each other are one lasting contact.
pub const SLOW: f64 = 5e-3;

/// Gap in m up to which a ball leans on what it touched less than a [`CONTACT_TIME`] ago: what it crosses at [`SLOW`] in that
/// time.
pub const LEAN: f64 = SLOW * CONTACT_TIME;

/// Two slow ones that touch again within this time in s do not press each other only: one of them is squeezed.
const SQUEEZED: f64 = CONTACT_TIME / 8.0;

/// How much deeper in m a contact may get that is let wait.
const SLIGHT: f64 = 1e-13;

/// Times at which it is looked how deep a contact gets that is let wait, each half the one before: a fast ball may be past the
/// end of the nose, or past the other ball, at the last of them.
const LOOKS: i32 = 7;

/// Most times that contacts are made to part at one instant.
const BEARINGS: usize = 64;

/// What a ball of a scene touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Other {
    /// Another ball, by its index.
    Ball(u32),
    /// A cushion, by its index.
    Cushion(u32),
    /// The edge of a pocket, by the index of the pocket.
    Rim(u32),
    /// The wall or the liner of a pocket, by the index of the pocket.
    Wall(u32),
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

/// When a contact that would close in `wait` s is to be looked at: at once, unless the same two touched less than a contact
/// time before, `age` s ago now, and would get deeper into each other by next to nothing if they were left alone for the
/// rest of it. `overlap` tells how deep in m they are after a time, and how fast in m/s that grows.
#[must_use]
pub fn put_off(wait: f64, age: f64, overlap: impl Fn(f64) -> (f64, f64)) -> f64 {
    let later = CONTACT_TIME - age;
    if later <= wait {
        return wait;
    }
    // Fast ones are deeper on the way than at the end of it.
    let deepest = (0..LOOKS)
        .map(|halved| overlap(libm::ldexp(later, -halved)).0)
        .fold(f64::NEG_INFINITY, f64::max);
    let deeper = deepest - overlap(0.0).0.max(0.0);
    if overlap(wait).1 * CONTACT_TIME <= SLIGHT && deeper <= SLIGHT {
        later
    } else {
        wait
    }
}

impl Cluster {
    /// What is to be gathered around what met: all that leans on each other, if it is squeezed.
    #[must_use]
    pub fn how(&self, blow: Blow, ages: impl Fn(usize, Other) -> f64) -> How {
        if self.is_squeezed(blow, ages) {
            How::Leaning
        } else {
            How::Touching
        }
    }

    /// Whether what met is squeezed: a light ball between a heavy one that presses and a cushion would rattle in a gap of
    /// some nanometres. All that leans on each other settles then without a rebound.
    fn is_squeezed(&self, blow: Blow, ages: impl Fn(usize, Other) -> f64) -> bool {
        self.contacts.first().is_some_and(|contact| {
            let age = ages(self.members[contact.first].ball, self.other(contact));
            blow == Blow::Impact && age < SQUEEZED && self.closing(contact) < SLOW
        })
    }

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
        self.firm.clear();
        (self.jammed, self.stuck) = (false, false);
        if blow == Blow::Impact {
            self.firm();
        }
        let no_rebound = self.ends_without_rebound();
        let first = self.contacts.first();
        let known =
            first.is_some_and(|one| ages(self.members[one.first].ball, self.other(one)) <= 0.0);
        let rebound = if self.is_squeezed(blow, &ages) {
            0.0
        } else {
            1.0
        };
        for index in 0..self.contacts.len() {
            let contact = self.contacts[index];
            let closing = self.closing(&contact);
            let age = ages(self.members[contact.first].ball, self.other(&contact));
            let again = closing < SLOW && age < CONTACT_TIME;
            if again && closing > 0.0 {
                // Unless the caller has had enough of its bounces.
                self.contacts[index].restitution.get_or_insert(rebound);
            }
            // What meets without closing is pressed together.
            let pressed = index == 0 && closing <= STILL;
            self.lasting
                .push((again || pressed) && blow == Blow::Impact);
        }
        self.resolve(laws, blow);
        if no_rebound {
            self.ground(table);
            self.bear(laws, &[]);
        }
        self.classify(laws, table);
        if self.must_part(laws, table, blow) {
            let parting = std::mem::take(&mut self.parting);
            let before = self.energy();
            self.turn_hollow(&parting);
            // The slate takes up what drives a ball into it: one that bears another on top gives way again and again.
            for _ in 0..BEARINGS {
                self.bear(laws, &parting);
                self.classify(laws, table);
                if self.have_parted(&parting) {
                    break;
                }
            }
            let mut pairs = self.contacts.iter().zip(&parting);
            self.jammed = pairs
                .any(|(contact, parting)| *parting > 0.0 && self.closing(contact) > -0.5 * parting);
            self.parting = parting;
            if self.hold_energy(before) {
                self.classify(laws, table);
            }
            if self.jammed && known {
                self.stick();
            }
        }
        self.loosen();
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
            Against::Rim { pocket } => Other::Rim(pocket as u32),
            Against::Wall { pocket } => Other::Wall(pocket as u32),
        }
    }

    fn classify(&mut self, laws: &Laws, table: &Table) {
        for (member, before) in self.members.iter_mut().zip(&self.before) {
            if member.state != *before {
                member.state = laws.settled(table, &member.body, &member.state);
                stop(laws, table, member);
            }
        }
        self.leave_alone(laws);
    }

    /// Takes from balls that move on what little drives them into others that have come to rest by [`stop`].
    fn leave_alone(&mut self, laws: &Laws) {
        for index in 0..self.contacts.len() {
            let contact = self.contacts[index];
            let Against::Ball { member } = contact.against else {
                continue;
            };
            let closing = self.closing(&contact);
            let flies = |place: usize| self.members[place].state.motion.flies();
            if !(0.0 < closing && closing <= STILL) || flies(contact.first) || flies(member) {
                continue;
            }
            for (moves, rests, sign) in
                [(contact.first, member, -1.0), (member, contact.first, 1.0)]
            {
                if self.members[rests].state.velocity == DVec3::ZERO {
                    let Member { body, state, .. } = &mut self.members[moves];
                    state.velocity += sign * closing * contact.normal;
                    *state = laws.motion.classify(body, *state);
                }
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
                let second = contact.against.member();
                let second = second.map(|member| &self.members[member]);
                let moves = |member: &Member| member.state.motion.translates();
                if moves(first) || second.is_some_and(moves) {
                    // A first touch parts as its law says; if it is pressed back at once it is lasting then.
                    let spring = if self.lasting[index] {
                        spring(laws, table, contact, (first, second))
                    } else {
                        0.0
                    };
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

/// The speed in m/s that a ball which runs along something hollow must get away from it so as not to meet it again within a
/// contact time, and the direction in which it runs. One that is faster than that is turned by at most 30°.
pub(super) fn turned(contact: &Touching, state: &State) -> (f64, DVec3) {
    let along = DVec3::Y.cross(contact.away);
    let run = state.velocity.dot(along);
    let turned = 0.5 * CONTACT_TIME * contact.hollow * run * run;
    (turned.min(0.5 * run.abs()), along)
}

/// The speed in m/s at which a contact must part so that what drives the two together does not close it again within a
/// contact time. A slide that begins with a blow may end within a microsecond, and takes back two sevenths of what the blow
/// gave: two that roll into each other would touch ever more often if only its acceleration counted.
fn spring(
    laws: &Laws,
    table: &Table,
    contact: &Touching,
    (first, second): (&Member, Option<&Member>),
) -> f64 {
    let members = || std::iter::once((first, 1.0)).chain(second.map(|member| (member, -1.0)));
    let piece_of = |member: &Member| laws.piece(table, &member.body, &member.state);
    let press: DVec3 = members()
        .map(|(member, sign)| sign * piece_of(member).acceleration)
        .sum();
    let now = 0.5 * CONTACT_TIME * press.dot(contact.normal) + turned(contact, &first.state).0;
    let until = |member: &Member| match member.state.motion {
        Motion::Sliding | Motion::Rolling => piece_of(member).duration,
        _ => f64::INFINITY,
    };
    let ends = || members().map(|(member, _)| until(member));
    let within = |time: &f64| (f64::MIN_POSITIVE..CONTACT_TIME).contains(time);
    if !ends().any(|time| within(&time)) {
        return now;
    }
    // How far a ball gets from the straight line on which it is.
    let bent = |member: &Member, time: f64| {
        let here = State {
            position: DVec3::ZERO,
            ..member.state
        };
        laws.motion.advance(&member.body, &here, time).position - time * here.velocity
    };
    let later = |time: f64| {
        let bent: DVec3 = members()
            .map(|(member, sign)| sign * bent(member, time))
            .sum();
        bent.dot(contact.normal) / time
    };
    ends()
        .filter(within)
        .map(later)
        .fold(now.max(later(CONTACT_TIME)), f64::max)
}

/// Brings a ball on cloth to rest that a blow has left with less speed than settles a contact. It would go no further
/// than 1e-20 m, but touch what it leans on again at each change of motion; and where the cloth does not rub, a ball that
/// spins would run to and fro for ever in a gap of one bit.
fn stop(laws: &Laws, table: &Table, member: &mut Member) {
    let Member { body, state, .. } = member;
    let on_cloth = matches!(state.motion, Motion::Sliding | Motion::Rolling);
    if !on_cloth || state.velocity.length() > STILL {
        return;
    }
    let spin = state.angular_velocity;
    if body.radius * spin.length() <= STILL + body.radius * spin.y.abs() {
        state.angular_velocity = DVec3::Y * spin.y;
    } else if laws.piece(table, body, state).acceleration != DVec3::ZERO {
        return;
    }
    state.velocity = DVec3::ZERO;
    *state = laws.motion.classify(body, *state);
}
