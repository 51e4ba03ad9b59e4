//! The energy of a cluster, and what parting may win of it.

use glam::DVec3;

use crate::physics::laws::cluster::lasting::turned;
use crate::physics::laws::cluster::{Cluster, Member, SLOW};

impl Cluster {
    /// Kinetic energy in J of all members.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.members
            .iter()
            .map(|member| member.body.kinetic_energy(&member.state))
            .sum()
    }

    /// Where a pocket turns a fast ball, what leans on that ball is in the way, and to part from both can take far more speed
    /// than either; so it does between walls that nearly face each other. All are slowed then, by one share, until no energy is
    /// won but what lasting contacts may win; to the common speed, where nothing but balls has touched. Tells whether they are.
    pub(super) fn hold_energy(&mut self, before: f64) -> bool {
        let most = |member: &Member| 0.5 * member.body.mass * SLOW * SLOW;
        let allowed = before + self.members.iter().map(most).sum::<f64>();
        let excess = self.energy() - allowed;
        if excess <= 0.0 {
            return false;
        }
        let mut contacts = self.contacts.iter();
        let walled = contacts.any(|one| one.impulse > 0.0 && one.against.member().is_none());
        let mass: f64 = self.members.iter().map(|member| member.body.mass).sum();
        let momentum = |member: &Member| member.body.mass * member.state.velocity;
        let common = if walled {
            DVec3::ZERO
        } else {
            self.members.iter().map(momentum).sum::<DVec3>() / mass
        };
        let way = |one: &Member| one.body.mass * (one.state.velocity - common).length_squared();
        let moving = 0.5 * self.members.iter().map(way).sum::<f64>();
        let kept = (1.0 - excess / moving).max(0.0).sqrt();
        if moving > 0.0 {
            for member in &mut self.members {
                member.state.velocity = common + kept * (member.state.velocity - common);
            }
        }
        moving > 0.0
    }

    /// What a hollow contact gives a ball that runs along it on the way out it takes from the run: it is turned, not driven.
    pub(super) fn turn_hollow(&mut self, parting: &[f64]) {
        for (contact, parting) in self.contacts.iter().zip(parting) {
            let state = &mut self.members[contact.first].state;
            let (turned, along) = turned(contact, state);
            if turned > 0.0 && *parting >= turned {
                let run = state.velocity.dot(along);
                let kept = (1.0 - (turned / run) * (turned / run)).max(0.0).sqrt();
                state.velocity -= (1.0 - kept) * run * along;
            }
        }
    }
}
