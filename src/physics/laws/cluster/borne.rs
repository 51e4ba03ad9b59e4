//! What lies on the slate is borne by it. Of a blow the slate takes up its part afterwards, as its law says; of what lasts, or
//! is to end without a rebound, at the same moment. Else a heavy ball on a light one would press it down, be stopped by a
//! little, and press it down again.

use glam::{DVec2, DVec3};

use crate::physics::laws::Laws;
use crate::physics::laws::cluster::{Cluster, TOUCH, Touching};
use crate::physics::table::{Ground, Table};

impl Cluster {
    /// Whether whoever gathered the contacts wants any to end without a rebound.
    pub(super) fn ends_without_rebound(&self) -> bool {
        let mut contacts = self.contacts.iter();
        contacts.any(|contact| contact.restitution == Some(0.0))
    }

    /// Stops members at the slate that are driven into it.
    pub(super) fn ground(&mut self, table: &Table) {
        for member in &mut self.members {
            let (position, radius) = (member.state.position, member.body.radius);
            let point = DVec2::new(position.x, position.z);
            if member.state.velocity.y < 0.0
                && (position.y - radius).abs() <= TOUCH
                && table.ground(point) == Ground::Slate
            {
                member.state.velocity.y = 0.0;
            }
        }
    }

    /// Ends the closing of every contact without rebound, where the slate bears at once what is pressed down on it, and contact
    /// i parts with at least `parting[i]` m/s; an empty list is zeros.
    pub(super) fn bear(&mut self, laws: &Laws, parting: &[f64]) {
        self.component.clear();
        self.component.extend(0..self.contacts.len());
        self.borne = true;
        self.reflect(laws, parting, true, false);
        self.borne = false;
    }

    /// Where a unit impulse of a contact moves one of its balls of mass 1.
    pub(super) fn push_of(&self, contact: &Touching, ball: usize, sign: f64) -> DVec3 {
        let way = sign * contact.normal;
        let Self { members, borne, .. } = self;
        let on_slate = || {
            let member = &members[ball];
            let height = member.state.position.y - member.body.radius;
            let rises = member.state.velocity.y > 0.0;
            !rises && (!member.state.motion.flies() || height.abs() <= TOUCH)
        };
        if *borne && way.y < 0.0 && on_slate() {
            DVec3::new(way.x, 0.0, way.z)
        } else {
            way
        }
    }
}
