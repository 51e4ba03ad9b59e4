//! The earliest event happens.

use crate::physics::ball::State;
use crate::physics::exact::engine::Engine;
use crate::physics::exact::predict::Partner;
use crate::physics::exact::{SolveError, Watch};
use crate::physics::record::{Event, EventKind, Participant};

impl Engine {
    /// Lets the earliest event happen; the clock stands at its time.
    pub(super) fn step(&mut self, watch: &mut impl Watch) -> Result<(), SolveError> {
        let ball = self.queue.first();
        let next = self.flights[ball].next;
        match next.partner {
            Partner::Nothing => Ok(()),
            Partner::Cell(cell) => {
                if let Some(cells) = &mut self.cells {
                    cells.remove(ball as u32);
                    cells.insert(ball as u32, cell);
                }
                self.predict(ball)
            }
            // The other ball has changed its path since: look again.
            Partner::Ball(other) if self.flights[other as usize].count != next.count => {
                self.predict(ball)
            }
            Partner::Ball(_) | Partner::Cushion(_) => {
                self.count_event(ball)?;
                self.collide(ball, next.partner, watch)
            }
            Partner::Motion => {
                self.count_event(ball)?;
                let before = self.state(ball);
                let (table, body) = (&self.table, &self.bodies[ball]);
                let after = self.laws.end(table, body, &self.paths[ball].piece);
                self.set(ball, after, watch)?;
                let kind = EventKind::Motion {
                    from: before.motion,
                    to: after.motion,
                };
                watch.event(&self.lone(ball, kind, before, after));
                self.predict(ball)
            }
            Partner::Pocket(pocket) => {
                self.count_event(ball)?;
                self.pass_edge(ball, pocket as usize, watch)
            }
            Partner::Landing(landing) => {
                self.count_event(ball)?;
                self.come_down(ball, landing, watch)
            }
        }
    }

    pub(super) fn lone(&self, ball: usize, kind: EventKind, before: State, after: State) -> Event {
        Event {
            time: self.clock,
            kind,
            first: Participant {
                ball,
                before,
                after,
            },
            second: None,
            impulse: 0.0,
        }
    }

    fn count_event(&mut self, ball: usize) -> Result<(), SolveError> {
        self.happened += 1;
        self.last = self.clock;
        if self.happened > self.limits.events {
            return Err(SolveError::EventLimit {
                events: self.happened,
                time: self.clock,
                ball: self.names[ball].clone(),
            });
        }
        Ok(())
    }
}
