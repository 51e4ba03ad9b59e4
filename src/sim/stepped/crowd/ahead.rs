//! What new legs of paths lead to.

use glam::DVec2;

use crate::sim::stepped::crowd::body::Body;
use crate::sim::stepped::crowd::caught::{Caught, Contact, Kind, Leg, NONE};
use crate::sim::stepped::crowd::cells::{END, Link, roomy};
use crate::sim::stepped::crowd::search::Solver;
use crate::sim::stepped::crowd::stripe::place;
use crate::sim::stepped::resolve::{BOUNCES, IMPACTS};

impl<B: Body> Solver<'_, B> {
    /// Finds what the new leg of a ball leads to; false if it meets another cluster, which has been taken up, or leaves
    /// these stripes. It comes from a contact with its partner, if with a ball.
    pub fn look_ahead(&mut self, root: u32, ball: u32, partner: u32) -> bool {
        let leg = *self.last(ball);
        let me = *self.caught(ball);
        if me.impacts == BOUNCES {
            self.count[2] += 1;
        }
        let end = self.stretch.end;
        let middle = leg.body.position(0.5 * (leg.from + end));
        if B::BENDS && leg.body.change() <= end || !self.stretch.walls.is_clear(middle) {
            let mut queue = std::mem::take(&mut self.queue);
            let legs = [me.last; 2];
            self.alone(&leg, me.number, |contact| {
                if me.impacts <= IMPACTS || contact.kind == Kind::Change {
                    queue.push(Contact {
                        ball,
                        legs,
                        ..contact
                    });
                }
            });
            self.queue = queue;
        }
        me.impacts > IMPACTS || self.look_around(root, (ball, &leg, &me), middle, partner)
    }

    /// Finds the balls that a new leg meets.
    fn look_around(
        &mut self,
        root: u32,
        (ball, leg, me): (u32, &Leg<B>, &Caught),
        middle: DVec2,
        partner: u32,
    ) -> bool {
        let extent = self.stretch.extent(&leg.body, leg.from);
        if (self.begun < self.stretch.cells.rows || !self.is_whole()) && self.is_at_edge(me.place) {
            self.outside = true;
            return false;
        }
        let stripe = &mut self.stripes[place::stripe(me.place) - self.base];
        let index = place::index(me.place);
        let record = &mut stripe.sorted_mut(me.place).records[index];
        let wander = record.wander(middle, extent);
        if wander > me.free {
            record.free = record.free.max(wander);
            self.wander = self.wander.max(f64::from(wander));
            return self.look_far(root, (ball, leg, me), middle, extent, partner);
        }
        let (x, z) = (middle.x as f32, middle.y as f32);
        let near = roomy(self.stretch.reach() + extent) + 2.0 * f32::EPSILON * (x.abs() + z.abs());
        let mut link = stripe.sorted(me.place).head(index);
        while link != END {
            let Link { place: at, next } =
                self.stripes[place::stripe(me.place) - self.base].links[link as usize];
            let stripe = &self.stripes[place::stripe(at) - self.base];
            let record = &stripe.sorted(at).records[place::index(at)];
            let (dx, dz) = (record.x - x, record.z - z);
            let most = near + record.free;
            let is_far = dx * dx + dz * dz >= most * most;
            if !is_far && !self.hold_against(root, (ball, leg, me), at, partner) {
                return false;
            }
            link = next;
        }
        true
    }

    /// Whether a ball may be linked to one of another stripe, or to one of a row that is not looked at yet.
    fn is_at_edge(&self, at: u32) -> bool {
        let stripe = &self.stripes[place::stripe(at) - self.base];
        let record = stripe.sorted(at).records[place::index(at)];
        let cells = &self.stretch.cells;
        let far = self.stretch.reach() + 2.0 * f64::from(record.free.max(self.fastest as f32));
        let place = DVec2::new(f64::from(record.x), f64::from(record.z));
        let [low, high] = cells.window(place, far * (1.0 + 1e-5)).rows;
        let rows = &stripe.rows;
        (low < rows.start && !self.is_whole())
            || high
                >= self.begun.min(if self.is_whole() {
                    usize::MAX
                } else {
                    rows.end
                })
            || stripe.wide_fast.contains(&at)
    }

    /// Finds the balls that a new leg meets far from where its ball was to be, and links them.
    fn look_far(
        &mut self,
        root: u32,
        (ball, leg, me): (u32, &Leg<B>, &Caught),
        middle: DVec2,
        extent: f64,
        partner: u32,
    ) -> bool {
        let near = self.stretch.reach() + extent;
        let mut list = std::mem::take(&mut self.near);
        list.clear();
        let inside = self.list_near(middle, near, &mut list);
        for &at in &list {
            if at != me.place {
                self.link(&[[me.place, at]]);
            }
        }
        let mut whole = inside;
        for &at in &list {
            whole = whole && self.hold_against(root, (ball, leg, me), at, partner);
        }
        self.near = list;
        self.outside |= !inside;
        whole
    }

    /// Finds whether a new leg meets the ball at a place; false if it meets another cluster.
    #[inline]
    fn hold_against(
        &mut self,
        root: u32,
        (ball, leg, me): (u32, &Leg<B>, &Caught),
        at: u32,
        partner: u32,
    ) -> bool {
        let end = self.stretch.end;
        let (other, is_caught) = self.held(at);
        if !is_caught {
            let slot = other as usize;
            if !self.may_meet(leg, &self.bodies[slot], leg.from, end) {
                return true;
            }
            let other = Leg {
                body: self.bodies[slot],
                from: self.stretch.start,
                before: NONE,
            };
            let met = self.meet(
                (leg, me.number),
                (&other, self.numbers[slot]),
                end,
                me.impacts,
            );
            if let Some(time) = met {
                let other = self.catch(at);
                let it = *self.caught(other);
                self.unite(root, it.cluster);
                self.plan(time, (ball, me), (other, &it));
            }
            return true;
        }
        // Two balls on straight lines have nothing more to do with each other.
        if other == ball || (other == partner && !B::BENDS) {
            return true;
        }
        let it = self.caught(other);
        let may_meet = self.may_meet(leg, &self.last(other).body, leg.from, end);
        if it.last == it.first && !may_meet {
            return true;
        }
        let it = *it;
        let impacts = me.impacts.max(it.impacts);
        if it.cluster == root || self.root(it.cluster) == root {
            let theirs = *self.last(other);
            if may_meet
                && let Some(time) = self.meet((leg, me.number), (&theirs, it.number), end, impacts)
            {
                self.plan(time, (ball, me), (other, &it));
            }
            return true;
        }
        !self.meets_other(root, (leg, me.number), &it, [leg.from, end], impacts, other)
    }

    fn plan(&mut self, time: f64, (ball, me): (u32, &Caught), (other, it): (u32, &Caught)) {
        let (m, n) = (me.number, it.number);
        self.queue.push(Contact {
            time,
            order: Contact::order(2, m.max(n), m.min(n)),
            ball,
            kind: Kind::Ball(other),
            legs: [me.last, it.last],
        });
    }

    /// Whether a leg meets, in a span of time, a ball of another cluster, as far as its legs are known. If so, the other
    /// cluster is taken up.
    fn meets_other(
        &mut self,
        root: u32,
        (leg, number): (&Leg<B>, u32),
        it: &Caught,
        [begin, end]: [f64; 2],
        impacts: u32,
        other: u32,
    ) -> bool {
        let (mut at, mut until) = (it.last, end);
        while at != NONE && until >= begin {
            let theirs = *self.leg(other, at);
            let from = begin.max(theirs.from);
            if from <= until
                && self.may_meet(leg, &theirs.body, from, until)
                && self
                    .meet((leg, number), (&theirs, it.number), until, impacts)
                    .is_some()
            {
                let two = self.root(it.cluster);
                self.unite(root, two);
                return true;
            }
            (at, until) = (theirs.before, until.min(theirs.from));
        }
        false
    }

    /// Holds the leg a ball began on against other clusters, from where it has been held to where it ends; false if it
    /// meets one.
    pub fn hold_beginning(&mut self, root: u32, ball: u32, me: &Caught) -> bool {
        let leg = *self.leg(ball, me.first);
        let stripe = &self.stripes[place::stripe(me.place) - self.base];
        let mut link = stripe.sorted(me.place).head(place::index(me.place));
        while link != END {
            let stripe = &self.stripes[place::stripe(me.place) - self.base];
            let Link { place, next } = stripe.links[link as usize];
            if let (other, true) = self.held(place) {
                let it = *self.caught(other);
                let span = [me.held, me.turn];
                if self.root(it.cluster) != root
                    && self.meets_other(root, (&leg, me.number), &it, span, 0, other)
                {
                    return false;
                }
            }
            link = next;
        }
        true
    }
}
