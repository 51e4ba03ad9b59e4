//! The contacts of a cluster as the balls lie.

use glam::{DVec2, DVec3};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::PairContact;
use crate::physics::laws::cluster::{Against, Cluster, LEAN, Member, Other, TOUCH, Touching};
use crate::physics::laws::pocket::{PocketLaw, Rim};
use crate::physics::table::{Cushion, Nose, Table};

/// What belongs to a cluster.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum How {
    /// What touches.
    Touching,
    /// And what touched less than a contact time ago and is still within [`LEAN`].
    Leaning,
    /// All within [`LEAN`] of what is off the slate, whether it has touched or not.
    Close,
}

impl How {
    /// Gap in m up to which a ball next to another belongs to it.
    #[must_use]
    pub fn within(self) -> f64 {
        match self {
            Self::Touching | Self::Leaning => TOUCH,
            Self::Close => LEAN,
        }
    }

    /// Whether what is around a ball with this state belongs to it.
    #[must_use]
    pub fn spreads_from(self, state: &State) -> bool {
        self != Self::Close || state.motion.flies()
    }

    /// Whether a cushion belongs to a ball here in plan that reaches so far.
    #[must_use]
    pub fn takes(self, cushion: &Cushion, point: DVec2, reach: f64) -> bool {
        touches(cushion, point, reach) || (self == Self::Close && leans(cushion, point, reach))
    }

    /// Whether the edge or the wall of a pocket belongs to a ball.
    #[must_use]
    pub fn takes_inside(
        self,
        laws: &Laws,
        table: &Table,
        ball: (&Ball, &State),
        what: Other,
    ) -> bool {
        touches_inside(laws, table, ball, what)
            || (self == Self::Close && leans_inside(laws, table, ball, what))
    }
}

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
            hollow: 0.0,
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
            hollow: 0.0,
            nose_height: laws
                .cushion
                .nose_height(table.nose_height, &member.body, nose),
            nose: table.nose,
            restitution: None,
            impulse: 0.0,
        });
        overlap
    }

    /// Adds the contact of a member in flight and what it touches of a pocket, if there is anything of it where it is.
    pub fn touch_inside(&mut self, laws: &Laws, table: &Table, first: usize, what: Other) {
        let Member { body, state, .. } = &self.members[first];
        let against = match what {
            Other::Rim(pocket) => Against::Rim {
                pocket: pocket as usize,
            },
            Other::Wall(pocket) => Against::Wall {
                pocket: pocket as usize,
            },
            Other::Ball(_) | Other::Cushion(_) => return,
        };
        let Some(met) = inside(laws, table, (body, state), what) else {
            return;
        };
        self.contacts.push(Touching {
            first,
            against,
            normal: -met.normal,
            away: met.away,
            hollow: met.hollow,
            nose_height: 0.0,
            nose: Nose::Wall,
            restitution: None,
            impulse: 0.0,
        });
    }
}

/// What a ball in flight meets of a pocket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inside {
    /// How far it is away in m.
    pub gap: f64,
    /// Unit vector from there to the ball.
    pub normal: DVec3,
    /// Horizontal unit vector to the middle of the pocket.
    pub away: DVec3,
    /// See [`Touching::hollow`].
    pub hollow: f64,
}

/// How a ball in flight is to the edge or the wall of a pocket; nothing if it cannot touch it where it is.
#[must_use]
pub fn inside(
    laws: &Laws,
    table: &Table,
    (body, state): (&Ball, &State),
    what: Other,
) -> Option<Inside> {
    let PocketLaw::Rim(Rim { edge, .. }) = laws.pocket else {
        return None;
    };
    let (Other::Rim(pocket) | Other::Wall(pocket)) = what else {
        return None;
    };
    let (radius, position) = (body.radius, state.position);
    let pocket = &table.pockets[pocket as usize];
    let at = pocket.at_edge(edge, position);
    let away = at.away();
    let on_edge = matches!(what, Other::Rim(_));
    // Below the edge there is the wall.
    let is_there = if on_edge {
        position.y >= -edge
    } else {
        table.has_wall(pocket, edge, radius, position)
    };
    let (gap, normal, hollow) = if on_edge {
        (at.length - radius - edge, at.normal(), at.hollow())
    } else {
        let gap = pocket.room(edge, radius) - at.from_axis;
        (gap, away, 1.0 / at.from_axis.max(1e-12))
    };
    (is_there && state.motion.flies()).then_some(Inside {
        gap,
        normal,
        away,
        hollow,
    })
}

/// Whether a ball in flight touches the edge or the wall of a pocket, however deep: one that tips is in its edge by up to 0.05
/// mm between two pieces of its path, and one that comes down behind the hole is in the liner.
fn touches_inside(laws: &Laws, table: &Table, ball: (&Ball, &State), what: Other) -> bool {
    inside(laws, table, ball, what).is_some_and(|met| met.gap <= TOUCH)
}

/// Whether a ball in flight does not touch the edge or the wall of a pocket, but leans on it if it did touch it lately.
#[must_use]
pub fn leans_inside(laws: &Laws, table: &Table, ball: (&Ball, &State), what: Other) -> bool {
    inside(laws, table, ball, what).is_some_and(|met| met.gap > TOUCH && met.gap <= LEAN)
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
fn touches(cushion: &Cushion, point: DVec2, reach: f64) -> bool {
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
