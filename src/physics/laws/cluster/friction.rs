//! Friction in contacts that share balls.
//!
//! Each contact rubs as its own law says for the impulse that it passes and the slip before the round. Together they could
//! turn back more slip than there was; so they are scaled down, all by one share, until no energy is won.

use crate::physics::laws::Laws;
use crate::physics::laws::cluster::smith_2012::ends;
use crate::physics::laws::cluster::{Cluster, STILL};

impl Cluster {
    /// Adds the friction of one contact to the changes: what its law does beyond the normal impulse.
    pub(super) fn rub(&mut self, laws: &Laws, place: usize) {
        let contact = self.contacts[self.component[place]];
        let closing = self.closing(&contact);
        let impulse = (1.0 + self.bounces[place]) * self.system.impulse[place];
        if closing <= STILL || impulse <= 0.0 {
            return;
        }
        let free = closing
            / ends(&contact)
                .map(|(ball, _)| 1.0 / self.members[ball].body.mass)
                .sum::<f64>();
        // The restitution with which this contact on its own would pass the impulse that it passes now.
        let mut alike = impulse / free - 1.0;
        if contact.against.member().is_none() {
            alike = alike.clamp(0.0, 1.0);
        }
        let kept: [_; 2] = std::array::from_fn(|end| {
            ends(&contact)
                .nth(end)
                .map(|(ball, _)| (ball, self.members[ball].state))
        });
        let passed = self.apply(laws, &contact, Some(alike));
        for (ball, old) in kept.into_iter().flatten() {
            let sign = if ball == contact.first { -1.0 } else { 1.0 };
            let member = &mut self.members[ball];
            let normal = sign * passed / member.body.mass * contact.normal;
            self.changes[ball].0 += member.state.velocity - old.velocity - normal;
            self.changes[ball].1 += member.state.angular_velocity - old.angular_velocity;
            member.state = old;
        }
    }

    /// Adds the changes by friction, no more of them than leaves the energy below `before`.
    pub(super) fn add_friction(&mut self, before: f64) {
        let normal = (self.energy() - before).min(0.0);
        let (mut linear, mut square) = (0.0, 0.0);
        for (member, (velocity, spin)) in self.members.iter().zip(&self.changes) {
            let (m, i) = (member.body.mass, member.body.inertia());
            linear += m * member.state.velocity.dot(*velocity)
                + i * member.state.angular_velocity.dot(*spin);
            square += 0.5 * (m * velocity.length_squared() + i * spin.length_squared());
        }
        let share = if normal + linear + square <= 0.0 {
            1.0
        } else if square > 0.0 {
            (-linear / (2.0 * square)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        for (member, (velocity, spin)) in self.members.iter_mut().zip(&self.changes) {
            member.state.velocity += share * *velocity;
            member.state.angular_velocity += share * *spin;
        }
    }
}
