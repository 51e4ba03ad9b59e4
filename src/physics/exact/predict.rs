//! The next event of one ball.

use crate::physics::airborne::Landing;
use crate::physics::contact::{self, Track};
use crate::physics::exact::SolveError;
use crate::physics::exact::cells::Neighbours;
use crate::physics::exact::engine::Engine;
use crate::physics::exact::flight::Glide;
use crate::physics::exact::walls::{Area, Wall};
use crate::physics::laws::cluster::{Other, put_off};
use crate::physics::roots::{RootError, quadratic};
use crate::physics::table::Cushion;

/// With whom or what.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub(super) enum Partner {
    Nothing,
    /// A change of motion.
    Motion,
    Ball(u32),
    Cushion(u32),
    Pocket(u32),
    /// What a ball in flight comes down on.
    Landing(Landing),
    /// The ball enters this cell.
    Cell(u32),
}

impl From<Other> for Partner {
    fn from(other: Other) -> Self {
        match other {
            Other::Ball(ball) => Self::Ball(ball),
            Other::Cushion(cushion) => Self::Cushion(cushion),
            Other::Rim(pocket) => Self::Landing(Landing::Rim(pocket as usize)),
            Other::Wall(pocket) => Self::Landing(Landing::Wall(pocket as usize)),
        }
    }
}

/// An event to come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Next {
    pub(super) time: f64,
    pub(super) partner: Partner,
    /// Path count of the other ball when this was found.
    pub(super) count: u32,
}

impl Next {
    pub(super) const NEVER: Self = Self {
        time: f64::INFINITY,
        partner: Partner::Nothing,
        count: 0,
    };
}

/// The best event so far of a search, `wait` seconds from now.
pub(super) struct Search {
    pub(super) wait: f64,
    pub(super) partner: Partner,
    /// A ball that may touch.
    but: u32,
    /// Whether any other may touch; told for straight level paths only, of others the answer is true.
    touches: bool,
}

impl Search {
    pub(super) fn offer(&mut self, wait: Option<f64>, partner: Partner) {
        let Some(wait) = wait else { return };
        let first_named = match (partner, self.partner) {
            (Partner::Ball(new), Partner::Ball(old)) => new < old,
            _ => false,
        };
        if wait < self.wait || (wait == self.wait && first_named) {
            self.wait = wait;
            self.partner = partner;
        }
    }
}

impl Engine {
    /// Finds the next event of a ball whose path, neighbourhood or partner has changed.
    pub(super) fn predict(&mut self, ball: usize) -> Result<(), SolveError> {
        self.predict_among(ball, None)
    }

    /// The same where the balls that can be met are known.
    pub(super) fn predict_among(
        &mut self,
        ball: usize,
        among: Option<&Neighbours>,
    ) -> Result<(), SolveError> {
        let next = self
            .search(ball, among)
            .map_err(|source| SolveError::Root {
                ball: self.names[ball].clone(),
                time: self.clock,
                source,
            })?;
        self.flights[ball].next = next;
        self.queue.set(ball, next.time);
        Ok(())
    }

    fn search(&self, ball: usize, among: Option<&Neighbours>) -> Result<Next, RootError> {
        Ok(self.search_but(ball, among, u32::MAX)?.0)
    }

    /// The next event of a ball, and whether it may touch any but this one now.
    pub(super) fn search_but(
        &self,
        ball: usize,
        among: Option<&Neighbours>,
        but: u32,
    ) -> Result<(Next, bool), RootError> {
        let now = self.clock;
        let flight = &self.flights[ball];
        if !flight.in_play {
            return Ok((Next::NEVER, true));
        }
        let mut search = Search {
            wait: flight.until - now,
            partner: Partner::Motion,
            but,
            touches: false,
        };
        let glide = flight.level.then(|| flight.glide(now));
        let track = self.seen(ball);
        if flight.flies {
            self.search_ground(ball, &track, &mut search)?;
        }
        if flight.moves {
            if let Some(cells) = &self.cells {
                let left = match &glide {
                    Some(glide) => cells.leaves_straight(ball as u32, glide),
                    None => cells.leaves(ball as u32, &track, search.wait)?,
                };
                if let Some((wait, cell)) = left {
                    search.offer(Some(wait), Partner::Cell(cell));
                }
            }
            self.search_walls(ball, &track, &mut search)?;
        }
        let mut pairs =
            |list: &[u32]| self.search_pairs(ball, &track, glide.as_ref(), list, &mut search);
        match (among, &self.cells) {
            (Some(list), _) => pairs(list)?,
            (None, Some(cells)) => {
                let mut list = Neighbours::none();
                cells.around(ball as u32, &mut list, |list| pairs(list))?;
                pairs(&list)?;
            }
            (None, None) => pairs(&self.everyone)?,
        }
        if search.wait == f64::INFINITY {
            return Ok((Next::NEVER, search.touches));
        }
        // A change of motion comes exactly when its piece ends.
        let time = match search.partner {
            Partner::Motion => flight.until,
            _ => now + search.wait,
        };
        let count = match search.partner {
            Partner::Ball(other) => self.flights[other as usize].count,
            _ => 0,
        };
        let next = Next {
            time,
            partner: search.partner,
            count,
        };
        Ok((next, search.touches))
    }

    /// Looks for contacts with these balls, the ball itself perhaps among them.
    #[expect(
        clippy::needless_bitwise_bool,
        reason = "no branch can be guessed here"
    )]
    fn search_pairs(
        &self,
        ball: usize,
        track: &Track,
        glide: Option<&Glide>,
        list: &[u32],
        search: &mut Search,
    ) -> Result<(), RootError> {
        let now = self.clock;
        let Some(glide) = glide else {
            return list
                .iter()
                .try_for_each(|&other| self.search_pair(ball, track, other as usize, search));
        };
        for list in list.chunks(u32::BITS as usize) {
            // Which of them are not ruled out by a few products: one or two of ten, so no branch tells.
            let mut left = 0_u32;
            let mut touches = false;
            for (place, &other) in list.iter().enumerate() {
                let flight = &self.flights[other as usize];
                let (passes, near) = glide.passes(&flight.glide(now), search.wait, self.touch);
                left |= u32::from(!(passes & flight.level)) << place;
                touches |= (near | !flight.level) & (other != search.but) & (other != ball as u32);
            }
            search.touches |= touches;
            while left != 0 {
                let other = list[left.trailing_zeros() as usize];
                left &= left - 1;
                let flight = &self.flights[other as usize];
                if !flight.level {
                    self.search_pair(ball, track, other as usize, search)?;
                    continue;
                }
                let there = flight.glide(now);
                if !glide.passes(&there, search.wait, self.touch).0 {
                    let horizon = search.wait.min(flight.until - now);
                    let wait = quadratic::first_closing(glide.gap(&there), 0.0, horizon)?;
                    let wait = self.put_off_pair(ball, track, other as usize, (wait, horizon));
                    search.offer(wait, Partner::Ball(other));
                }
            }
        }
        Ok(())
    }

    #[inline]
    fn search_pair(
        &self,
        ball: usize,
        track: &Track,
        other: usize,
        search: &mut Search,
    ) -> Result<(), RootError> {
        let (one, two) = (&self.flights[ball], &self.flights[other]);
        if !two.in_play || !(one.moves || two.moves) || other == ball {
            return Ok(());
        }
        let now = self.clock;
        let horizon = search.wait.min(two.until - now);
        let wait = contact::pair(track, &self.seen(other), one.radius + two.radius, horizon)?;
        let wait = self.put_off_pair(ball, track, other, (wait, horizon));
        search.offer(wait, Partner::Ball(other as u32));
        Ok(())
    }

    /// The contact of a pair that was found until the horizon, unless it can wait for longer; see [`put_off`].
    #[inline]
    fn put_off_pair(
        &self,
        ball: usize,
        track: &Track,
        other: usize,
        (wait, horizon): (Option<f64>, f64),
    ) -> Option<f64> {
        let age = self.age(ball, Other::Ball(other as u32));
        let wait = put_off(wait?, age, |time| {
            let reach = self.flights[ball].radius + self.flights[other].radius;
            track.overlap(&self.seen(other), reach, time)
        });
        (wait <= horizon).then_some(wait)
    }

    fn search_walls(
        &self,
        ball: usize,
        track: &Track,
        search: &mut Search,
    ) -> Result<(), RootError> {
        if let Some(cells) = &self.cells {
            for &place in cells.walls(ball as u32) {
                self.search_wall(ball, track, self.walls.list[place as usize].0, search)?;
            }
            return Ok(());
        }
        let mut wait = search.wait;
        let mut path = (wait < f64::INFINITY).then(|| Area::of_path(track, wait));
        if path.is_some_and(|path| self.walls.is_open(&path)) {
            return Ok(());
        }
        for (wall, area) in &self.walls.list {
            if path.is_some_and(|path| !path.meets(area)) {
                continue;
            }
            self.search_wall(ball, track, *wall, search)?;
            if search.wait < wait {
                wait = search.wait;
                path = Some(Area::of_path(track, wait));
            }
        }
        Ok(())
    }

    fn search_wall(
        &self,
        ball: usize,
        track: &Track,
        wall: Wall,
        search: &mut Search,
    ) -> Result<(), RootError> {
        let flight = &self.flights[ball];
        if flight.flies {
            return self.search_wall_in_flight(ball, track, wall, search);
        }
        let reach = self.table.reach(flight.radius);
        let wait = match wall {
            Wall::Cushion(index) => {
                let cushion = &self.table.cushions[index as usize];
                let wait = match cushion {
                    Cushion::Line(line) => contact::line(track, line, reach, search.wait)?,
                    Cushion::Arc(arc) => contact::arc(track, arc, reach, search.wait)?,
                };
                let age = self.age(ball, Other::Cushion(index));
                let overlap = |time| track.overlap_of(cushion, reach, time);
                wait.map(|wait| put_off(wait, age, overlap))
            }
            Wall::Pocket(index) => {
                contact::pocket(track, &self.table.pockets[index as usize], search.wait)?
            }
        };
        let partner = match wall {
            Wall::Cushion(index) => Partner::Cushion(index),
            Wall::Pocket(index) => Partner::Pocket(index),
        };
        search.offer(wait, partner);
        Ok(())
    }
}
