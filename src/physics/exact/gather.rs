//! Who touches whom at this moment.

use glam::{DVec2, DVec3};

use crate::physics::ball::{Ball, State};
use crate::physics::exact::cells::Neighbours;
use crate::physics::exact::engine::Engine;
use crate::physics::exact::predict::Partner;
use crate::physics::exact::walls::{Area, Wall, Walls};
use crate::physics::exact::{DEEP, SolveError};
use crate::physics::laws::cluster::{Against, Member, TOUCH, Touching};
use crate::physics::laws::pocket::PocketLaw;
use crate::physics::table::{Cushion, Nose, Pocket};

impl Engine {
    /// Adds a ball to the cluster and returns its place.
    pub(super) fn join(&mut self, ball: usize) -> usize {
        if let Some(place) = self
            .cluster
            .members
            .iter()
            .position(|member| member.ball == ball)
        {
            return place;
        }
        self.cluster.members.push(Member {
            ball,
            body: self.bodies[ball],
            state: self.state(ball),
        });
        self.cluster.members.len() - 1
    }

    pub(super) fn touch_balls(&mut self, first: usize, second: usize) -> Result<(), SolveError> {
        let (one, two) = (&self.cluster.members[first], &self.cluster.members[second]);
        let offset = two.state.position - one.state.position;
        let overlap = one.body.radius + two.body.radius - offset.length();
        if overlap > DEEP && !self.is_at_pocket(one.state.position) {
            return Err(SolveError::Overlap {
                ball: self.names[one.ball].clone(),
                other: format!("ball `{}`", self.names[two.ball]),
                time: self.clock,
                overlap,
            });
        }
        // Divided, not multiplied by the reciprocal: a row along an axis has exactly that axis for its normals.
        let flies = one.state.motion.flies() || two.state.motion.flies();
        let flat = if flies {
            offset
        } else {
            DVec3::new(offset.x, 0.0, offset.z)
        };
        let normal = flat / flat.length();
        self.cluster.contacts.push(Touching {
            first,
            against: Against::Ball { member: second },
            normal,
            nose_height: 0.0,
            nose: Nose::Wall,
            restitution: None,
            impulse: 0.0,
        });
        Ok(())
    }

    /// Whether a ball is where pockets give balls back: such a one is put on the slate wherever it leaves the edge, and what
    /// it then overlaps pushes it away.
    fn is_at_pocket(&self, position: DVec3) -> bool {
        let point = DVec2::new(position.x, position.z);
        let is_near = |pocket: &Pocket| point.distance(pocket.center) < 2.0 * pocket.radius;
        self.laws.pocket != PocketLaw::Capture && self.table.pockets.iter().any(is_near)
    }

    /// Distance in plan from a nose line at which a ball touches it, at the height at which it is; -1 for one that
    /// passes over it.
    fn reach_of(&self, body: &Ball, state: &State) -> f64 {
        let table = &self.table;
        if !state.motion.flies() {
            return table.reach(body.radius);
        }
        let (nose, height) = (&table.nose, table.nose_height);
        nose.reach_at(height, body.radius, state.position.y)
            .unwrap_or(-1.0)
    }

    pub(super) fn touch_cushion(&mut self, first: usize, cushion: u32) -> Result<(), SolveError> {
        let member = &self.cluster.members[first];
        let position = member.state.position;
        let (distance, direction) =
            Walls::gap(&self.table, cushion, DVec2::new(position.x, position.z));
        let overlap = self.reach_of(&member.body, &member.state) - distance;
        // In flight the ends of noses count, which balls on the slate pass by: such an overlap is pushed apart.
        if overlap > DEEP && !member.state.motion.flies() && !self.is_at_pocket(position) {
            return Err(SolveError::Overlap {
                ball: self.names[member.ball].clone(),
                other: format!("cushion {cushion}"),
                time: self.clock,
                overlap,
            });
        }
        let index = cushion as usize;
        let mut normal = -DVec3::new(direction.x, 0.0, direction.y);
        if member.state.motion.flies() {
            let (nose, height) = (&self.table.nose, self.table.nose_height);
            normal = -nose.normal(-normal, height, distance, position.y);
        }
        self.cluster.contacts.push(Touching {
            first,
            against: Against::Cushion { cushion: index },
            normal,
            nose_height: self.laws.cushion.nose_height(
                self.table.nose_height,
                &member.body,
                &self.table.cushions[index],
            ),
            nose: self.table.nose,
            restitution: None,
            impulse: 0.0,
        });
        Ok(())
    }

    /// Adds everything that touches the members, and what touches that.
    pub(super) fn gather(&mut self, partner: Partner) -> Result<(), SolveError> {
        let mut place = 0;
        while place < self.cluster.members.len() {
            let Member { ball, body, state } = self.cluster.members[place];
            let mut near = std::mem::take(&mut self.near);
            near.clear();
            {
                let mut look = |other: usize| {
                    let flight = &self.flights[other];
                    let reach = body.radius + flight.radius + TOUCH;
                    let offset = self.center(other) - state.position;
                    if offset.length_squared() <= reach * reach && flight.in_play && other != ball {
                        near.push(other);
                    }
                    Ok::<(), SolveError>(())
                };
                match &self.cells {
                    None => (0..self.flights.len()).try_for_each(look)?,
                    Some(cells) => {
                        let mut list = Neighbours::none();
                        cells.around(ball as u32, &mut list, |list| {
                            list.iter().try_for_each(|&other| look(other as usize))
                        })?;
                        list.iter().try_for_each(|&other| look(other as usize))?;
                    }
                }
            }
            // Cells list their balls in any order.
            near.sort_unstable();
            for &other in &near {
                let joined = self.join(other);
                let known = place == 0 && joined == 1 && matches!(partner, Partner::Ball(_));
                if joined > place && !known {
                    self.touch_balls(place, joined)?;
                }
            }
            self.near = near;
            self.gather_cushions(place, partner)?;
            place += 1;
        }
        Ok(())
    }

    pub(super) fn gather_cushions(
        &mut self,
        place: usize,
        partner: Partner,
    ) -> Result<(), SolveError> {
        let member = &self.cluster.members[place];
        let (ball, reach) = (member.ball, self.reach_of(&member.body, &member.state));
        let point = DVec2::new(member.state.position.x, member.state.position.z);
        let here = Area {
            least: point,
            most: point,
        };
        if self.walls.is_open(&here) {
            return Ok(());
        }
        let count = match &self.cells {
            Some(cells) => cells.walls(ball as u32).len(),
            None => self.walls.list.len(),
        };
        for index in 0..count {
            let index = match &self.cells {
                Some(cells) => cells.walls(ball as u32)[index] as usize,
                None => index,
            };
            let (wall, area) = self.walls.list[index];
            let Wall::Cushion(cushion) = wall else {
                continue;
            };
            if !area.meets(&here) || (place == 0 && partner == Partner::Cushion(cushion)) {
                continue;
            }
            if self.touches(cushion, point, reach) {
                self.touch_cushion(place, cushion)?;
            }
        }
        Ok(())
    }

    /// Whether a ball touches a cushion; a line has no end caps.
    pub(super) fn touches(&self, cushion: u32, point: DVec2, reach: f64) -> bool {
        let (distance, _) = Walls::gap(&self.table, cushion, point);
        let beside = match &self.table.cushions[cushion as usize] {
            Cushion::Line(line) => {
                let along = line.to - line.from;
                (0.0..=along.length_squared()).contains(&(point - line.from).dot(along))
            }
            Cushion::Arc(_) => true,
        };
        beside && distance <= reach + TOUCH && distance > reach - DEEP
    }
}
