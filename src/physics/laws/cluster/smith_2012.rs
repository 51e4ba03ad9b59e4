//! Generalised reflections: simultaneous impacts that keep symmetry, momentum and energy.
//!
//! In rounds. All contacts that close at this moment are taken together and reflected: λ are the impulses that would
//! just stop them (see `complementarity`), and (1 + e) λ is what passes. Contacts that begin to close by that are the
//! next round. So two balls struck at once leave as mirror images, while a blow runs through a touching row from ball
//! to ball as in Newton's cradle. With one e ≤ 1 for all no round adds energy; contacts of different e that hold each other,
//! as of a light ball between a heavy one and a cushion, could, and then the larger ones count less. Contacts that share no
//! ball are rounds of their own law, friction and all. Where contacts share a ball, friction of each follows its law for the impulse it
//! transmits and the slip before the round, and is scaled back if together they would add energy.
//!
//! After [`ROUNDS`] rounds or more the rest of the closing speeds is taken out at once without rebound: inelastic collapse
//! within the instant.
//!
//! Source: Smith, Kaufman, Vouga, Tamstorf & Grinspun, "Reflections on simultaneous impact", ACM Trans. Graph. 31
//! (2012) 106; e < 1, friction and the limit of rounds are ours. Contact is instant: the spread of a blow over a row by
//! elastic waves is not modelled.

use glam::DVec3;

use crate::physics::ball::State;
use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::PairContact;
use crate::physics::laws::cluster::complementarity::Complementarity;
use crate::physics::laws::cluster::{Against, Blow, Member, STILL, Touching};
use crate::physics::laws::cushion::CushionContact;

/// Rounds of one impact of up to half as many balls before what is left is settled; of more balls, two a ball.
pub const ROUNDS: usize = 48;

/// A set of touching balls. Lists are kept between impacts, so that resolving one allocates nothing once warm.
#[derive(Clone, Debug, Default)]
pub struct Cluster {
    /// The balls.
    pub members: Vec<Member>,
    /// Their contacts.
    pub contacts: Vec<Touching>,
    /// The states of the members before the last [`Cluster::collide`].
    pub before: Vec<State>,
    pub(super) lasting: Vec<bool>,
    pub(super) parting: Vec<f64>,
    pub(super) firm: Vec<(usize, f64)>,
    pub(super) held: Vec<bool>,
    pub(super) jammed: bool,
    pub(super) stuck: bool,
    pub(super) borne: bool,
    pub(super) system: Complementarity,
    active: Vec<usize>,
    group: Vec<usize>,
    pub(super) component: Vec<usize>,
    pub(super) bounces: Vec<f64>,
    pub(super) changes: Vec<(DVec3, DVec3)>,
}

impl Cluster {
    /// Forgets all balls and contacts.
    pub fn clear(&mut self) {
        self.members.clear();
        self.contacts.clear();
    }

    /// Speed in m/s at which a contact closes; negative if it opens.
    #[must_use]
    pub fn closing(&self, contact: &Touching) -> f64 {
        let velocity = self.members[contact.first].state.velocity;
        let other = match contact.against {
            Against::Ball { member } => self.members[member].state.velocity,
            Against::Cushion { .. } | Against::Rim { .. } | Against::Wall { .. } => DVec3::ZERO,
        };
        (velocity - other).dot(contact.normal)
    }

    /// Velocities after the impact, written to the members; impulses are added up in the contacts. Labels of motion are
    /// left as they are.
    pub fn resolve(&mut self, laws: &Laws, blow: Blow) {
        if blow == Blow::Stroke {
            self.component.clear();
            for (index, contact) in self.contacts.iter().enumerate() {
                if let Against::Ball { .. } = contact.against {
                    self.component.push(index);
                }
            }
            self.reflect(laws, &[], true, true);
        }
        // A blow takes a round for each ball of a row that it runs through.
        for _ in 0..ROUNDS.max(2 * self.members.len()) {
            self.active.clear();
            for index in 0..self.contacts.len() {
                if self.closing(&self.contacts[index]) > STILL {
                    self.active.push(index);
                }
            }
            if self.active.is_empty() {
                return;
            }
            self.round(laws);
        }
        self.settle(laws);
    }

    /// Ends the closing of every contact without rebound.
    pub fn settle(&mut self, laws: &Laws) {
        self.component.clear();
        self.component.extend(0..self.contacts.len());
        self.reflect(laws, &[], true, false);
    }

    /// One round over the active contacts, group by group of contacts that share balls.
    fn round(&mut self, laws: &Laws) {
        self.group.clear();
        self.group.extend(0..self.members.len());
        for &index in &self.active {
            let contact = self.contacts[index];
            if let Against::Ball { member } = contact.against {
                let (one, two) = (self.group[contact.first], self.group[member]);
                let (low, high) = (one.min(two), one.max(two));
                for group in &mut self.group {
                    if *group == high {
                        *group = low;
                    }
                }
            }
        }
        for group in 0..self.members.len() {
            self.component.clear();
            for &index in &self.active {
                if self.group[self.contacts[index].first] == group {
                    self.component.push(index);
                }
            }
            match self.component.len() {
                0 => {}
                1 => self.single(laws, self.component[0]),
                _ => self.reflect(laws, &[], false, true),
            }
        }
    }

    /// One contact on its own: its law as it stands.
    fn single(&mut self, laws: &Laws, index: usize) {
        let contact = self.contacts[index];
        let restitution = match contact.against {
            Against::Ball { .. } | Against::Cushion { .. } => contact.restitution,
            // How a slow touch of these ends their laws say themselves.
            Against::Rim { .. } | Against::Wall { .. } => None,
        };
        self.contacts[index].impulse += self.apply(laws, &contact, restitution);
    }

    /// Applies the law of a contact and returns the normal impulse.
    pub(super) fn apply(
        &mut self,
        laws: &Laws,
        contact: &Touching,
        restitution: Option<f64>,
    ) -> f64 {
        let first = self.members[contact.first];
        match contact.against {
            Against::Ball { member } => {
                let second = self.members[member];
                let geometry = PairContact {
                    normal: contact.normal,
                    on_slate: !first.state.motion.flies() && !second.state.motion.flies(),
                    restitution,
                };
                let outcome = laws.ball_ball.collide(
                    (&first.body, &first.state),
                    (&second.body, &second.state),
                    &geometry,
                );
                self.members[contact.first].state = outcome.first;
                self.members[member].state = outcome.second;
                outcome.impulse
            }
            Against::Cushion { .. } => {
                let geometry = CushionContact {
                    normal: contact.away,
                    nose_height: contact.nose_height,
                    nose: contact.nose,
                    restitution,
                };
                let rebound = laws.cushion.rebound(&first.body, &first.state, &geometry);
                self.members[contact.first].state = rebound.state;
                rebound.impulse
            }
            Against::Rim { .. } | Against::Wall { .. } => {
                let on_edge = matches!(contact.against, Against::Rim { .. });
                let (body, normal) = (&first.body, -contact.normal);
                let after = laws.rattle((body, &first.state), on_edge, normal, restitution);
                self.members[contact.first].state = after;
                body.mass * (after.velocity - first.state.velocity).dot(normal)
            }
        }
    }

    /// Restitution of a contact that closes at this speed in m/s.
    pub(super) fn restitution(contact: &Touching, laws: &Laws, closing: f64) -> f64 {
        contact
            .restitution
            .unwrap_or_else(|| match contact.against {
                Against::Ball { .. } => laws.ball_ball.restitution(closing),
                Against::Cushion { .. } => laws.cushion.restitution(closing),
                Against::Rim { .. } => laws.rattle_restitution(true),
                Against::Wall { .. } => laws.rattle_restitution(false),
            })
    }

    /// Reflects the contacts of the component together.
    pub(super) fn reflect(
        &mut self,
        laws: &Laws,
        parting: &[f64],
        inelastic: bool,
        friction: bool,
    ) {
        self.assemble(parting);
        self.system.solve();
        self.agree(laws, inelastic);
        let before: f64 = self.energy();
        self.changes.clear();
        self.changes
            .resize(self.members.len(), (DVec3::ZERO, DVec3::ZERO));
        if friction {
            for place in 0..self.component.len() {
                self.rub(laws, place);
            }
        }
        for place in 0..self.component.len() {
            let index = self.component[place];
            let contact = self.contacts[index];
            let impulse = (1.0 + self.bounces[place]) * self.system.impulse[place];
            self.contacts[index].impulse += impulse;
            self.push(&contact, impulse);
        }
        if friction {
            self.add_friction(before);
        }
    }

    /// The restitutions of the component. The energy that a reflection adds is ½ (εᵀAε − λᵀAλ), ε = e λ by contact, where
    /// all e are alike at most 0; where they are not they are drawn to the least of them until it is.
    fn agree(&mut self, laws: &Laws, inelastic: bool) {
        self.bounces.clear();
        for (place, &index) in self.component.iter().enumerate() {
            let closing = self.system.closing[place];
            self.bounces.push(if inelastic {
                0.0
            } else {
                Self::restitution(&self.contacts[index], laws, closing)
            });
        }
        let least = self.bounces.iter().copied().fold(f64::INFINITY, f64::min);
        if self.bounces.iter().all(|&bounce| bounce == least) {
            return;
        }
        let n = self.bounces.len();
        let (matrix, impulse) = (&self.system.matrix, &self.system.impulse);
        let product = |one: &dyn Fn(usize) -> f64, two: &dyn Fn(usize) -> f64| -> f64 {
            let row = |i: usize| (0..n).map(|j| matrix[i * n + j] * two(j)).sum::<f64>();
            (0..n).map(|i| one(i) * row(i)).sum()
        };
        let base = |i: usize| least * impulse[i];
        let more = |i: usize| (self.bounces[i] - least) * impulse[i];
        // c + 2 b s + a s² ≤ 0 for the share s of what is above the least.
        let a = product(&more, &more);
        let b = product(&base, &more);
        let c = product(&base, &base) - product(&|i| impulse[i], &|i| impulse[i]);
        if c + 2.0 * b + a <= 0.0 {
            return;
        }
        let root = (b * b - a * c).max(0.0).sqrt();
        let share = if a > 0.0 { (root - b) / a } else { 0.0 };
        let share = share.clamp(0.0, 1.0);
        for bounce in &mut self.bounces {
            *bounce = least + share * (*bounce - least);
        }
    }

    /// Matrix and closing speeds of the component.
    fn assemble(&mut self, parting: &[f64]) {
        let n = self.component.len();
        self.system.clear(n);
        for i in 0..n {
            let a = self.contacts[self.component[i]];
            let parting = parting.get(self.component[i]).copied().unwrap_or(0.0);
            self.system.closing[i] = self.closing(&a) + parting;
            for j in 0..n {
                let b = self.contacts[self.component[j]];
                let mut entry = 0.0;
                for (ball_a, sign_a) in ends(&a) {
                    for (ball_b, sign_b) in ends(&b) {
                        if ball_a == ball_b {
                            let along = self
                                .push_of(&a, ball_a, sign_a)
                                .dot(self.push_of(&b, ball_b, sign_b));
                            entry += along / self.members[ball_a].body.mass;
                        }
                    }
                }
                self.system.matrix[i * n + j] = entry;
            }
        }
    }

    fn push(&mut self, contact: &Touching, impulse: f64) {
        for (ball, sign) in ends(contact) {
            let way = self.push_of(contact, ball, sign);
            let member = &mut self.members[ball];
            member.state.velocity += impulse / member.body.mass * way;
        }
    }
}

/// The balls of a contact with the sign of a unit impulse on them along the normal.
pub(super) fn ends(contact: &Touching) -> impl Iterator<Item = (usize, f64)> {
    let second = contact.against.member().map(|member| (member, 1.0));
    std::iter::once((contact.first, -1.0)).chain(second)
}
