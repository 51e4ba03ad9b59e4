//! The table in motion.

use glam::DVec3;

use crate::physics::ball::{Ball, State};
use crate::physics::contact::Track;
use crate::physics::cue::{Cue, Shot};
use crate::physics::exact::cells::Cells;
use crate::physics::exact::flight::Flight;
use crate::physics::exact::predict::Partner;
use crate::physics::exact::queue::Queue;
use crate::physics::exact::walls::Walls;
use crate::physics::exact::{Contact, Limits, SolveError, Watch};
use crate::physics::laws::Laws;
use crate::physics::laws::cluster::{CONTACT_TIME, Cluster, Other, Touched};
use crate::physics::laws::motion::MotionLaw;
use crate::physics::record::{Event, EventKind, Participant, PathPiece};
use crate::physics::scene::strike_with;
use crate::physics::table::Table;

/// A table in motion: advanced by any amount of time, asked for any state, struck, saved and restored, always with the
/// same bits.
///
/// Its clock starts at 0, and again at 0 with each stroke at a table at rest, so that a shot on a live table has the bits
/// of the same shot solved from its scene.
#[derive(Clone, Debug)]
pub struct Engine {
    pub(super) table: Table,
    pub(super) laws: Laws,
    pub(super) names: Vec<String>,
    pub(super) bodies: Vec<Ball>,
    /// The present paths, of those only that are not plain.
    pub(super) paths: Vec<PathPiece>,
    pub(super) flights: Vec<Flight>,
    pub(super) touched: Vec<Touched>,
    pub(super) widest: f64,
    /// The largest difference in m² of the squares of distance and of reach at which two balls touch.
    pub(super) touch: f64,
    pub(super) walls: Walls,
    pub(super) cells: Option<Cells>,
    pub(super) queue: Queue,
    pub(super) clock: f64,
    pub(super) last: f64,
    pub(super) happened: u64,
    pub(super) limits: Limits,
    pub(super) cluster: Cluster,
    pub(super) near: Vec<usize>,
    /// All balls, where they are not found by cells.
    pub(super) everyone: Vec<u32>,
}

impl Engine {
    pub(super) fn not_finite(&self, ball: usize, state: State) -> SolveError {
        SolveError::NotFinite {
            ball: self.names[ball].clone(),
            time: self.clock,
            state,
        }
    }

    /// Number of balls.
    #[must_use]
    pub fn count(&self) -> usize {
        self.bodies.len()
    }

    /// Seconds since the start of the scene, or since the last stroke at a table at rest.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.clock
    }

    /// Time in s of the last event.
    #[must_use]
    pub fn last_event_time(&self) -> f64 {
        self.last
    }

    /// Number of events since the start, changes of motion among them.
    #[must_use]
    pub fn events(&self) -> u64 {
        self.happened
    }

    /// A time in s before which nothing happens; `None` if nothing ever will.
    #[must_use]
    pub fn next_time(&self) -> Option<f64> {
        let time = self.queue.first_time();
        time.is_finite().then_some(time)
    }

    /// The piece of path that a ball follows now.
    #[must_use]
    pub fn path(&self, ball: usize) -> PathPiece {
        let flight = &self.flights[ball];
        if flight.plain {
            flight.path()
        } else {
            self.paths[ball]
        }
    }

    /// The state of a ball now.
    #[must_use]
    pub fn state(&self, ball: usize) -> State {
        let flight = &self.flights[ball];
        if flight.plain {
            return flight.state(self.clock);
        }
        let path = &self.paths[ball];
        path.piece.at(self.clock - path.time)
    }

    /// Where a ball is now.
    #[inline]
    pub(super) fn center(&self, ball: usize) -> DVec3 {
        let flight = &self.flights[ball];
        if flight.level {
            return flight.place(self.clock);
        }
        let path = &self.paths[ball];
        path.piece.position(self.clock - path.time)
    }

    /// The path of a ball seen from now.
    #[inline]
    pub(super) fn seen(&self, ball: usize) -> Track {
        let flight = &self.flights[ball];
        if flight.level {
            return flight.glide(self.clock).track();
        }
        let path = &self.paths[ball];
        Track::of(&path.piece, self.clock - path.time)
    }

    /// Whether no ball moves or spins.
    #[must_use]
    pub fn is_at_rest(&self) -> bool {
        let mut balls = self.flights.iter().zip(&self.paths);
        balls.all(|(flight, path)| !flight.plain && path.piece.start.motion.is_still())
    }

    /// Whether a ball leans on something: it has touched the same thing within the last two contact times and is slow.
    #[must_use]
    pub fn contact(&self, ball: usize) -> Contact {
        let next = &self.flights[ball].next;
        let Some((what, time)) = self.touched[ball].list().next() else {
            return Contact::Free;
        };
        let soon = |later: f64| later - time <= 2.0 * CONTACT_TIME;
        if next.partner != Partner::from(what) || !soon(self.clock) || !soon(next.time) {
            return Contact::Free;
        }
        match what {
            Other::Ball(other) => Contact::Resting { on: other as usize },
            Other::Cushion(cushion) => Contact::RestingOnCushion {
                cushion: cushion as usize,
            },
            Other::Rim(pocket) | Other::Wall(pocket) => Contact::RestingInPocket {
                pocket: pocket as usize,
            },
        }
    }

    /// Advances to this time, all events until then included. A time in the past changes nothing; with an infinite time
    /// the clock stops at the last event.
    ///
    /// # Errors
    /// [`SolveError`] with names, time and numbers; the engine is then of no further use.
    pub fn advance(&mut self, until: f64, watch: &mut impl Watch) -> Result<(), SolveError> {
        while let Some(time) = self.next_time().filter(|time| *time <= until) {
            // Rounding may put an event a bit before the clock.
            self.clock = self.clock.max(time);
            self.look_ahead();
            self.step(watch)?;
        }
        if until.is_finite() {
            self.clock = self.clock.max(until);
        }
        Ok(())
    }

    /// Asks the memory for what the next event but one is likely to need, so that it is there when its turn comes. Changes
    /// nothing.
    fn look_ahead(&self) {
        let Some(cells) = &self.cells else { return };
        let Some(flight) = self.queue.runner_up().and_then(|ball| {
            cells.look(ball as u32);
            self.flights.get(ball)
        }) else {
            return;
        };
        let other = match flight.next.partner {
            Partner::Ball(other) => other as usize,
            _ => 0,
        };
        std::hint::black_box(self.flights[other].count);
    }

    /// Plays a stroke now.
    ///
    /// # Errors
    /// [`SolveError`] as [`Self::advance`], and if there is no such ball.
    pub fn strike(
        &mut self,
        ball: usize,
        cue: &Cue,
        shot: &Shot,
        watch: &mut impl Watch,
    ) -> Result<(), SolveError> {
        if ball >= self.count() {
            return Err(SolveError::NoSuchBall {
                ball,
                count: self.count(),
            });
        }
        if self.is_at_rest() {
            self.restart();
        }
        let before = self.state(ball);
        if !before.motion.in_play() {
            return Ok(());
        }
        let struck = strike_with(cue, &self.laws, &self.bodies[ball], &before, shot);
        watch.event(&Event {
            time: self.clock,
            kind: EventKind::Strike {
                miscue: struck.miscue,
            },
            first: Participant {
                ball,
                before,
                after: struck.state,
            },
            second: None,
            impulse: struck.impulse,
        });
        self.happened += 1;
        self.last = self.clock;
        self.set(ball, struck.state, watch)?;
        self.push_off(ball, watch)?;
        self.let_go(ball, watch)
    }

    /// Sets the clock of a table at rest to 0.
    fn restart(&mut self) {
        for path in &mut self.paths {
            path.time = 0.0;
        }
        for flight in &mut self.flights {
            flight.since = 0.0;
        }
        self.touched.fill(Touched::NOTHING);
        self.clock = 0.0;
        self.last = 0.0;
        self.happened = 0;
    }

    /// Puts a ball on the path that starts with this state now.
    pub(super) fn set(
        &mut self,
        ball: usize,
        state: State,
        watch: &mut impl Watch,
    ) -> Result<(), SolveError> {
        if !state.is_finite() {
            return Err(self.not_finite(ball, state));
        }
        let body = &self.bodies[ball];
        let old = &self.flights[ball];
        let gliding =
            (self.laws.motion == MotionLaw::Frictionless).then(|| old.gliding(&state, self.clock));
        if let Some(flight) = gliding.flatten() {
            self.flights[ball] = flight;
            watch.piece(ball, &flight.path());
            return Ok(());
        }
        let count = old.count.wrapping_add(1);
        let path = PathPiece {
            time: self.clock,
            piece: self.laws.piece(&self.table, body, &state),
        };
        self.paths[ball] = path;
        self.flights[ball] = Flight::new(body, &path, count);
        watch.piece(ball, &path);
        Ok(())
    }
}
