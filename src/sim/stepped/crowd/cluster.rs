//! Clusters: balls that a chain of contacts ties together in one stretch of time.
//!
//! Most balls only move on. Those that meet something are caught, and those that meet each other form a cluster, mostly
//! of two to four balls, that is followed by itself in exact order of time. Every new leg of a path is held against all
//! balls near it, in other clusters too; where it meets one, the two clusters are followed again as one. At the end no
//! leg meets another but where both turn. Since contacts are resolved in order of time there is only one such
//! solution: it does not depend on the order in which clusters are worked on, and so not on stripes or threads.

use std::ops::Range;

use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::caught::{Caught, Cluster, Contact, Kind, Leg, NONE, Seed};
use crate::sim::stepped::crowd::cells::{CAUGHT, Record, roomy};
use crate::sim::stepped::crowd::search::Solver;
use crate::sim::stepped::crowd::stripe::place;

impl<B: Body> Solver<'_, B> {
    #[inline]
    pub fn caught(&self, id: u32) -> &Caught {
        &self.stripes[place::stripe(id) - self.base].caught[place::index(id)]
    }

    #[inline]
    pub fn caught_mut(&mut self, id: u32) -> &mut Caught {
        &mut self.stripes[place::stripe(id) - self.base].caught[place::index(id)]
    }

    /// A leg of a caught ball.
    #[inline]
    pub fn leg(&self, ball: u32, leg: u32) -> &Leg<B> {
        &self.stripes[place::stripe(ball) - self.base].legs[leg as usize]
    }

    /// The leg a caught ball is on.
    #[inline]
    pub fn last(&self, ball: u32) -> &Leg<B> {
        let stripe = &self.stripes[place::stripe(ball) - self.base];
        &stripe.legs[stripe.caught[place::index(ball)].last as usize]
    }

    #[inline]
    pub fn cluster(&mut self, id: u32) -> &mut Cluster {
        &mut self.stripes[place::stripe(id) - self.base].clusters[place::index(id)]
    }

    /// The cluster that a cluster is part of now.
    #[inline]
    pub fn root(&mut self, mut id: u32) -> u32 {
        loop {
            let parent = self.cluster(id).parent;
            if parent == id {
                return id;
            }
            let above = self.cluster(parent).parent;
            self.cluster(id).parent = above;
            id = above;
        }
    }

    /// Catches the ball at a place, in a cluster of its own, unless it is caught already.
    #[inline]
    pub fn catch(&mut self, at: u32) -> u32 {
        let stripe = &mut self.stripes[place::stripe(at) - self.base];
        let Record {
            free, ball: slot, ..
        } = stripe.sorted(at).records[place::index(at)];
        if slot & CAUGHT != 0 {
            return slot & !CAUGHT;
        }
        let body = self.bodies[slot as usize];
        let free = if free.is_nan() {
            // It is fast, and from now on looked after like any other.
            roomy(self.stretch.freedom(&body) + self.stretch.spare)
        } else {
            free
        };
        let id = place::of(stripe.index, stripe.caught.len());
        let cluster = place::of(stripe.index, stripe.clusters.len());
        let leg = stripe.legs.len() as u32;
        stripe.legs.push(Leg {
            body,
            from: self.stretch.start,
            before: NONE,
        });
        stripe.caught.push(Caught {
            place: at,
            slot,
            number: self.numbers[slot as usize],
            first: leg,
            last: leg,
            impacts: 0,
            free,
            turn: self.stretch.end,
            held: self.stretch.end,
            cluster,
            next: NONE,
        });
        stripe.clusters.push(Cluster {
            parent: cluster,
            balls: [id; 2],
            seeds: [NONE; 2],
            solved: false,
            count: [0; 3],
        });
        let record = &mut stripe.sorted_mut(at).records[place::index(at)];
        record.ball = CAUGHT | id;
        record.free = free;
        id
    }

    /// Makes the second cluster part of the first. Both are roots.
    pub fn unite(&mut self, one: u32, two: u32) {
        let taken = *self.cluster(two);
        self.cluster(two).parent = one;
        let tail = self.cluster(one).balls[1];
        self.caught_mut(tail).next = taken.balls[0];
        let cluster = self.cluster(one);
        cluster.balls[1] = taken.balls[1];
        let tail = cluster.seeds[1];
        if taken.seeds[0] != NONE {
            cluster.seeds[1] = taken.seeds[1];
            if tail == NONE {
                cluster.seeds[0] = taken.seeds[0];
            } else {
                self.seed(tail).next = taken.seeds[0];
            }
        }
    }

    fn seed(&mut self, id: u32) -> &mut Seed {
        &mut self.stripes[place::stripe(id) - self.base].seeds[place::index(id)]
    }

    /// Takes up a contact of paths that go on from before the stretch.
    pub fn sow(&mut self, contact: Contact) {
        let stripe = place::stripe(contact.ball);
        let seeds = &mut self.stripes[stripe - self.base].seeds;
        let id = place::of(stripe, seeds.len());
        let next = NONE;
        seeds.push(Seed { contact, next });
        let cluster = self.caught(contact.ball).cluster;
        let mut root = self.root(cluster);
        if let Kind::Ball(other) = contact.kind {
            let cluster = self.caught(other).cluster;
            let other = self.root(cluster);
            if other != root {
                self.unite(root.min(other), root.max(other));
                root = root.min(other);
            }
        }
        let solved = std::mem::replace(&mut self.cluster(root).solved, false);
        if solved || (self.is_whole() && self.all > 1) {
            self.stripes[0].wide.push(root);
        }
        let cluster = self.cluster(root);
        let tail = std::mem::replace(&mut cluster.seeds[1], id);
        if tail == NONE {
            cluster.seeds[0] = id;
        } else {
            self.seed(tail).next = id;
        }
    }

    /// Follows the clusters of a stripe in this range that are not solved.
    pub fn solve_all(&mut self, stripe: usize, range: Range<usize>) {
        let mut index = range.start;
        // Balls that are met on the way are caught in clusters of their own, but taken up at once.
        while index
            < range
                .end
                .min(self.stripes[stripe - self.base].clusters.len())
        {
            let id = place::of(stripe, index);
            let cluster = self.cluster(id);
            if cluster.parent == id && !cluster.solved && cluster.seeds[0] != NONE {
                self.solve(id);
            }
            index += 1;
        }
    }

    /// Follows every cluster that reaches beyond a stripe, or was sown from beyond it.
    pub fn solve_wide(&mut self) {
        for stripe in 0..self.stripes.len() {
            for id in std::mem::take(&mut self.stripes[stripe].wide) {
                let root = self.root(id);
                if !self.cluster(root).solved {
                    self.solve(root);
                }
            }
        }
    }

    /// Follows a cluster, and those that it meets with it.
    pub fn solve(&mut self, root: u32) {
        let mut turns = 0;
        while !(self.follow(root) && self.hold_beginnings(root)) {
            turns += 1;
            self.stripes[0].tally.repeated += 1;
            if turns == TURNS {
                if self.is_whole() {
                    self.unite_all(root);
                } else {
                    self.outside = true;
                }
            }
            if std::mem::take(&mut self.outside) {
                self.release(root);
                self.stripes[0].wide.push(root);
                return;
            }
        }
        let count = self.count;
        let cluster = self.cluster(root);
        cluster.count = count;
        cluster.solved = true;
    }

    /// Makes one cluster of all: where chains of contacts run through everything there is nothing to gain from parts.
    fn unite_all(&mut self, root: u32) {
        for stripe in 0..self.stripes.len() {
            for index in 0..self.stripes[stripe].clusters.len() {
                let id = place::of(stripe, index);
                let cluster = self.cluster(id);
                if cluster.parent == id && id != root {
                    self.unite(root, id);
                }
            }
        }
    }

    /// A ball that stays longer on the leg it began on than it did before may meet there what has been found free of it;
    /// false if it does.
    fn hold_beginnings(&mut self, root: u32) -> bool {
        let mut at = self.cluster(root).balls[0];
        while at != NONE {
            let ball = *self.caught(at);
            if ball.turn > ball.held && !self.hold_beginning(root, at, &ball) {
                return false;
            }
            self.caught_mut(at).held = ball.turn;
            at = ball.next;
        }
        true
    }

    /// Puts all balls of a cluster back to where they began.
    pub fn release(&mut self, root: u32) {
        let end = self.stretch.end;
        let cluster = self.cluster(root);
        cluster.solved = false;
        let mut at = cluster.balls[0];
        while at != NONE {
            let ball = self.caught_mut(at);
            ball.last = ball.first;
            ball.turn = end;
            ball.impacts = 0;
            at = ball.next;
        }
    }

    /// Follows a cluster to the end of the stretch; false if it has met another and both must be followed as one.
    fn follow(&mut self, root: u32) -> bool {
        self.release(root);
        self.queue.clear();
        self.count = [0; 3];
        let mut at = self.cluster(root).seeds[0];
        while at != NONE {
            let Seed { contact, next } = *self.seed(at);
            self.queue.push(contact);
            at = next;
        }
        while let Some(contact) = self.queue.pop() {
            let other = match contact.kind {
                Kind::Ball(other) => other,
                _ => NONE,
            };
            let stale = self.caught(contact.ball).last != contact.legs[0]
                || other != NONE && self.caught(other).last != contact.legs[1];
            if stale {
                continue;
            }
            self.happen(&contact);
            for (ball, partner) in [(contact.ball, other), (other, contact.ball)] {
                if ball != NONE && !self.look_ahead(root, ball, partner) {
                    return false;
                }
            }
        }
        true
    }
}

/// A cluster that had to be followed again so often is followed with all others.
const TURNS: u32 = 24;
