//! Balls that come to rest off the slate, and those that are let go.

use crate::physics::ball::Motion;
use crate::physics::exact::engine::Engine;
use crate::physics::exact::predict::Partner;
use crate::physics::exact::{SolveError, Watch};
use crate::physics::laws::cluster::{How, LEAN, Member};
use crate::physics::record::EventKind;

impl Engine {
    /// Brings to rest, of this ball and all that is close to it, what is held, and lets go what is not.
    pub(super) fn hold(
        &mut self,
        ball: usize,
        jammed: bool,
        watch: &mut impl Watch,
    ) -> Result<(), SolveError> {
        self.cluster.clear();
        self.join(ball);
        self.gather(Partner::Nothing, How::Close)?;
        self.cluster.hold(&self.laws, jammed);
        for place in 0..self.cluster.members.len() {
            let Member { ball, state, .. } = self.cluster.members[place];
            let before = self.cluster.before[place];
            if state != before {
                self.set(ball, state, watch)?;
                let kind = EventKind::Motion {
                    from: before.motion,
                    to: state.motion,
                };
                watch.event(&self.lone(ball, kind, before, state));
            }
        }
        for place in 0..self.cluster.members.len() {
            let Member { ball, state, .. } = self.cluster.members[place];
            if state != self.cluster.before[place] {
                self.predict(ball)?;
            }
        }
        Ok(())
    }

    /// A ball that has been dislodged bears no others.
    pub(super) fn let_go(
        &mut self,
        dislodged: usize,
        watch: &mut impl Watch,
    ) -> Result<(), SolveError> {
        let (center, radius) = (self.center(dislodged), self.flights[dislodged].radius);
        for other in 0..self.count() {
            let near = radius + self.flights[other].radius + LEAN;
            if self.is_wedged(other) && self.center(other).distance_squared(center) <= near * near {
                self.hold(other, false, watch)?;
            }
        }
        Ok(())
    }

    /// Lets go what nothing holds of the balls that are said to be wedged.
    pub(super) fn wake_loose(&mut self, watch: &mut impl Watch) -> Result<(), SolveError> {
        (0..self.count()).try_for_each(|ball| {
            if self.is_wedged(ball) {
                self.hold(ball, false, watch)?;
            }
            Ok(())
        })
    }

    fn is_wedged(&self, ball: usize) -> bool {
        let flight = &self.flights[ball];
        !flight.plain && self.paths[ball].piece.start.motion == Motion::Wedged
    }
}
