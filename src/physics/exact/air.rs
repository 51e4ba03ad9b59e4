//! Balls that are off the flat of the slate.

use crate::physics::airborne::{self, Landing};
use crate::physics::contact::{Track, flight};
use crate::physics::exact::engine::Engine;
use crate::physics::exact::predict::{Partner, Search};
use crate::physics::exact::walls::Wall;
use crate::physics::exact::{SolveError, Watch};
use crate::physics::laws::cluster::{Other, put_off};
use crate::physics::record::Event;
use crate::physics::roots::RootError;

impl Search {
    fn offer_landing(&mut self, found: Option<(f64, Landing)>) {
        let Some((wait, landing)) = found else { return };
        self.offer(Some(wait), Partner::Landing(landing));
    }
}

impl Engine {
    /// When a ball in flight comes down, and where.
    pub(super) fn search_ground(
        &self,
        ball: usize,
        track: &Track,
        search: &mut Search,
    ) -> Result<(), RootError> {
        let radius = self.flights[ball].radius;
        let found = airborne::ground(&self.table, &self.laws, radius, track, search.wait)?;
        search.offer_landing(found);
        Ok(())
    }

    /// When a ball in flight meets a cushion or a pocket.
    pub(super) fn search_wall_in_flight(
        &self,
        ball: usize,
        track: &Track,
        wall: Wall,
        search: &mut Search,
    ) -> Result<(), RootError> {
        let (table, radius) = (&self.table, self.flights[ball].radius);
        match wall {
            Wall::Cushion(index) => {
                let cushion = &table.cushions[index as usize];
                let nose = (cushion, &table.nose, table.nose_height);
                let wait = flight::nose(track, nose, radius, search.wait)?;
                let overlap = |time| flight::overlap_of_nose(track, nose, radius, time);
                let age = self.age(ball, Other::Cushion(index));
                let wait = wait.map(|wait| put_off(wait, age, overlap));
                search.offer(wait, Partner::Cushion(index));
            }
            Wall::Pocket(index) => {
                let what = (radius, self.paths[ball].piece.start.motion);
                let (laws, index) = (&self.laws, index as usize);
                let ages = |other| self.age(ball, other);
                let found = airborne::pocket(table, laws, index, what, track, search.wait, ages)?;
                search.offer_landing(found);
            }
        }
        Ok(())
    }

    /// The centre of a ball on the slate passes the edge of a pocket.
    pub(super) fn pass_edge(
        &mut self,
        ball: usize,
        pocket: usize,
        watch: &mut impl Watch,
    ) -> Result<(), SolveError> {
        let before = self.state(ball);
        let (table, laws, body) = (&self.table, &self.laws, &self.bodies[ball]);
        let (kind, after) = airborne::pass_edge(table, laws, body, &before, pocket);
        self.set(ball, after, watch)?;
        self.leave(ball);
        watch.event(&self.lone(ball, kind, before, after));
        self.predict(ball)
    }

    /// How many seconds ago a ball touched something, infinity if never.
    pub(super) fn age(&self, ball: usize, other: Other) -> f64 {
        self.clock - self.touched[ball].last(other)
    }

    /// A ball in flight comes down on something.
    pub(super) fn come_down(
        &mut self,
        ball: usize,
        landing: Landing,
        watch: &mut impl Watch,
    ) -> Result<(), SolveError> {
        let before = self.state(ball);
        let (table, laws, body) = (&self.table, &self.laws, &self.bodies[ball]);
        let (kind, after, impulse) = airborne::land(table, laws, body, &before, landing);
        if let Some(what) = landing.other() {
            // A fast touch is over before anything else can be felt; slow ones are lasting contact, and of all that touches.
            if !airborne::is_fast((table, laws, body), &before, &after, what) {
                return self.collide(ball, Partner::Landing(landing), watch);
            }
            self.touched[ball].add(what, self.clock);
        }
        self.set(ball, after, watch)?;
        self.leave(ball);
        let event = self.lone(ball, kind, before, after);
        watch.event(&Event { impulse, ..event });
        self.predict(ball)
    }

    /// Takes a ball that is out of play from the cells.
    fn leave(&mut self, ball: usize) {
        let is_gone = !self.paths[ball].piece.start.motion.in_play();
        if let Some(cells) = self.cells.as_mut().filter(|_| is_gone) {
            cells.remove(ball as u32);
        }
    }
}
