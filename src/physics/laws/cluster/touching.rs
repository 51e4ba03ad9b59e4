//! The contacts of a cluster as the balls lie.

use glam::{DVec2, DVec3};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::PairContact;
use crate::physics::laws::cluster::{Against, Cluster, LEAN, Member, TOUCH, Touching};
use crate::physics::table::{Cushion, Nose, Table};

/// Overlap in m at an impact that is beyond rounding.
pub const DEEP: f64 = 1e-6;

impl Cluster {
    /// Adds a ball unless it is there, and returns its place.
    pub fn join(&mut self, ball: usize, body: Ball, state: State) -> usize {
        let known = self.members.iter().position(|member| member.ball == ball);
        known.unwrap_or_else(|| {
            self.members.push(Member { ball, body, state });
            self.members.len() - 1
        })
    }

    /// Adds the contact of two members and returns how deep they overlap in m.
    pub fn touch_ball(&mut self, first: usize, second: usize) -> f64 {
        let (one, two) = (&self.members[first], &self.members[second]);
        let offset = two.state.position - one.state.position;
        let overlap = one.body.radius + two.body.radius - offset.length();
        let PairContact { normal, .. } = PairContact::between(&one.state, &two.state);
        self.contacts.push(Touching {
            first,
            against: Against::Ball { member: second },
            normal,
            away: DVec3::ZERO,
            nose_height: 0.0,
            nose: Nose::Wall,
            restitution: None,
            impulse: 0.0,
        });
        overlap
    }

    /// Adds the contact of a member and a cushion and returns how deep they overlap in m.
    pub fn touch_cushion(
        &mut self,
        laws: &Laws,
        table: &Table,
        first: usize,
        cushion: usize,
    ) -> f64 {
        let member = &self.members[first];
        let position = member.state.position;
        let nose = &table.cushions[cushion];
        let (distance, direction) = nose.nearest(DVec2::new(position.x, position.z));
        let overlap = reach_of(table, &member.body, &member.state) - distance;
        let away = DVec3::new(direction.x, 0.0, direction.y);
        let normal = if member.state.motion.flies() {
            let (profile, height) = (&table.nose, table.nose_height);
            -profile.normal(away, height, distance, position.y)
        } else {
            -away
        };
        self.contacts.push(Touching {
            first,
            against: Against::Cushion { cushion },
            normal,
            away,
            nose_height: laws
                .cushion
                .nose_height(table.nose_height, &member.body, nose),
            nose: table.nose,
            restitution: None,
            impulse: 0.0,
        });
        overlap
    }
}

/// Distance in plan from a nose line at which a ball touches it, at the height at which it is; -1 for one that passes over
/// it.
#[must_use]
pub fn reach_of(table: &Table, body: &Ball, state: &State) -> f64 {
    if !state.motion.flies() {
        return table.reach(body.radius);
    }
    let (nose, height) = (&table.nose, table.nose_height);
    nose.reach_at(height, body.radius, state.position.y)
        .unwrap_or(-1.0)
}

/// Whether a ball whose centre is here in plan and reaches so far touches a cushion; a line has no end caps.
#[must_use]
pub fn touches(cushion: &Cushion, point: DVec2, reach: f64) -> bool {
    let (distance, _) = cushion.nearest(point);
    is_beside(cushion, point) && distance <= reach + TOUCH && distance > reach - DEEP
}

/// Whether such a ball does not touch a cushion, but leans on it if it did touch it lately.
#[must_use]
pub fn leans(cushion: &Cushion, point: DVec2, reach: f64) -> bool {
    let (distance, _) = cushion.nearest(point);
    is_beside(cushion, point) && distance > reach + TOUCH && distance <= reach + LEAN
}

fn is_beside(cushion: &Cushion, point: DVec2) -> bool {
    match cushion {
        Cushion::Line(line) => {
            let along = line.to - line.from;
            (0.0..=along.length_squared()).contains(&(point - line.from).dot(along))
        }
        Cushion::Arc(_) => true,
    }
}
