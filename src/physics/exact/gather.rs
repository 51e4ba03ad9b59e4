//! Who touches whom at this moment.

use glam::{DVec2, DVec3};

use crate::physics::exact::SolveError;
use crate::physics::exact::cells::Neighbours;
use crate::physics::exact::engine::Engine;
use crate::physics::exact::predict::Partner;
use crate::physics::exact::walls::{Area, Wall};
use crate::physics::laws::cluster::{
    CONTACT_TIME, DEEP, How, LEAN, Member, Other, TOUCH, leans, leans_inside, reach_of,
};
use crate::physics::laws::pocket::PocketLaw;
use crate::physics::table::Pocket;

impl Engine {
    /// Adds a ball to the cluster and returns its place.
    pub(super) fn join(&mut self, ball: usize) -> usize {
        let state = self.state(ball);
        self.cluster.join(ball, self.bodies[ball], state)
    }

    pub(super) fn touch_balls(&mut self, first: usize, second: usize) -> Result<(), SolveError> {
        let overlap = self.cluster.touch_ball(first, second);
        let (one, two) = (&self.cluster.members[first], &self.cluster.members[second]);
        if overlap > DEEP && !self.is_at_pocket(one.state.position) {
            return Err(SolveError::Overlap {
                ball: self.names[one.ball].clone(),
                other: format!("ball `{}`", self.names[two.ball]),
                time: self.clock,
                overlap,
            });
        }
        Ok(())
    }

    /// Whether a ball is where pockets give balls back: such a one is put on the slate wherever it leaves the edge, and what
    /// it then overlaps pushes it away.
    fn is_at_pocket(&self, position: DVec3) -> bool {
        let point = DVec2::new(position.x, position.z);
        let is_near = |pocket: &Pocket| point.distance(pocket.center) < 2.0 * pocket.radius;
        self.laws.pocket != PocketLaw::Capture && self.table.pockets.iter().any(is_near)
    }

    pub(super) fn touch_cushion(&mut self, first: usize, cushion: u32) -> Result<(), SolveError> {
        let overlap = self
            .cluster
            .touch_cushion(&self.laws, &self.table, first, cushion as usize);
        let member = &self.cluster.members[first];
        // In flight the ends of noses count, which balls on the slate pass by: such an overlap is pushed apart.
        if overlap > DEEP
            && !member.state.motion.flies()
            && !self.is_at_pocket(member.state.position)
        {
            return Err(SolveError::Overlap {
                ball: self.names[member.ball].clone(),
                other: format!("cushion {cushion}"),
                time: self.clock,
                overlap,
            });
        }
        Ok(())
    }

    pub(super) fn touch_inside(&mut self, first: usize, what: Other) {
        self.cluster
            .touch_inside(&self.laws, &self.table, first, what);
    }

    /// Adds everything that touches the members, and what touches that; also what they lean on, or of those that fly all that
    /// is close.
    pub(super) fn gather(&mut self, partner: Partner, how: How) -> Result<(), SolveError> {
        let mut place = 0;
        while place < self.cluster.members.len() {
            let Member { ball, body, state } = self.cluster.members[place];
            if !how.spreads_from(&state) {
                place += 1;
                continue;
            }
            let mut near = std::mem::take(&mut self.near);
            near.clear();
            {
                let mut look = |other: usize| {
                    let flight = &self.flights[other];
                    let reach = body.radius + flight.radius + how.within();
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
            self.gather_walls(place, partner, how)?;
            if how == How::Leaning {
                self.gather_leaning(place, partner)?;
            }
            place += 1;
        }
        Ok(())
    }

    /// Adds what a member touches no more, but touched lately.
    fn gather_leaning(&mut self, place: usize, partner: Partner) -> Result<(), SolveError> {
        let Member { ball, body, state } = self.cluster.members[place];
        let reach = reach_of(&self.table, &body, &state);
        let point = DVec2::new(state.position.x, state.position.z);
        let touched = self.touched[ball];
        for (what, time) in touched.list() {
            if self.clock - time >= CONTACT_TIME || (place == 0 && partner == Partner::from(what)) {
                continue;
            }
            match what {
                Other::Ball(other) => {
                    let flight = &self.flights[other as usize];
                    let distance = self.center(other as usize).distance(state.position);
                    let gap = distance - (body.radius + flight.radius);
                    if flight.in_play && gap > TOUCH && gap <= LEAN {
                        let joined = self.join(other as usize);
                        if joined > place {
                            self.touch_balls(place, joined)?;
                        }
                    }
                }
                Other::Cushion(cushion) => {
                    if leans(&self.table.cushions[cushion as usize], point, reach) {
                        self.touch_cushion(place, cushion)?;
                    }
                }
                Other::Rim(_) | Other::Wall(_) => {
                    if leans_inside(&self.laws, &self.table, (&body, &state), what) {
                        self.touch_inside(place, what);
                    }
                }
            }
        }
        Ok(())
    }

    pub(super) fn gather_walls(
        &mut self,
        place: usize,
        partner: Partner,
        how: How,
    ) -> Result<(), SolveError> {
        let member = &self.cluster.members[place];
        let reach = reach_of(&self.table, &member.body, &member.state);
        let ball = member.ball;
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
            if !area.meets(&here) {
                continue;
            }
            let met = |what| place == 0 && partner == Partner::from(what);
            match wall {
                Wall::Cushion(cushion) => {
                    let nose = &self.table.cushions[cushion as usize];
                    if how.takes(nose, point, reach) && !met(Other::Cushion(cushion)) {
                        self.touch_cushion(place, cushion)?;
                    }
                }
                Wall::Pocket(pocket) => {
                    for what in [Other::Rim(pocket), Other::Wall(pocket)] {
                        let Member { body, state, .. } = &self.cluster.members[place];
                        let (laws, table) = (&self.laws, &self.table);
                        let takes = how.takes_inside(laws, table, (body, state), what);
                        if takes && !met(what) {
                            self.touch_inside(place, what);
                        }
                    }
                }
            }
        }
        Ok(())
    }
}
