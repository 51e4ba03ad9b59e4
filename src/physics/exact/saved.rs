//! Saving a table in motion, and restoring it bit for bit.

use serde::{Deserialize, Serialize};

use crate::physics::airborne::Landing;
use crate::physics::ball::State;
use crate::physics::exact::flight::Flight;
use crate::physics::exact::predict::{Next, Partner};
use crate::physics::exact::{Engine, Limits, SolveError};
use crate::physics::laws::cluster::{Other, Touched};
use crate::physics::record::PathPiece;
use crate::physics::scene::Scene;

/// A table in motion, to be written to a file. It belongs to the scene from which the engine was made: table, laws, masses
/// and radii are not in it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Saved {
    time: f64,
    last: f64,
    happened: u64,
    balls: Vec<SavedBall>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedBall {
    /// When its piece of path began.
    since: f64,
    /// The state with which it began.
    start: State,
    /// The next event found for it; what is infinite in the engine is absent here.
    next: Option<(f64, Partner, u32)>,
    count: u32,
    cell: Option<u32>,
    touched: Vec<(Other, f64)>,
}

impl Engine {
    /// Everything that the scene does not hold.
    #[must_use]
    pub fn save(&self) -> Saved {
        let balls = (0..self.count())
            .map(|ball| {
                let next = self.flights[ball].next;
                let path = self.path(ball);
                SavedBall {
                    since: path.time,
                    start: path.piece.start,
                    next: next
                        .time
                        .is_finite()
                        .then_some((next.time, next.partner, next.count)),
                    count: self.flights[ball].count,
                    cell: self.cells.as_ref().map(|cells| cells.cell_of[ball]),
                    touched: self.touched[ball].list().collect(),
                }
            })
            .collect();
        Saved {
            time: self.clock,
            last: self.last,
            happened: self.happened,
            balls,
        }
    }

    /// Nothing in a saved ball points to what is not there.
    fn check_saved(&self, index: usize, ball: &SavedBall) -> Result<(), SolveError> {
        let refuse = |what: String| {
            Err(SolveError::Saved {
                ball: self.names[index].clone(),
                what,
            })
        };
        let (balls, table) = (self.count(), &self.table);
        let is_there = |partner: Partner| match partner {
            Partner::Ball(other) => (other as usize) < balls && other as usize != index,
            Partner::Cushion(cushion) => (cushion as usize) < table.cushions.len(),
            Partner::Pocket(pocket) => (pocket as usize) < table.pockets.len(),
            Partner::Landing(
                Landing::Rim(pocket) | Landing::Wall(pocket) | Landing::Bottom(pocket),
            ) => pocket < table.pockets.len(),
            Partner::Cell(cell) => self.cells.as_ref().is_some_and(|cells| cells.has(cell)),
            Partner::Landing(Landing::Slate | Landing::Off)
            | Partner::Motion
            | Partner::Nothing => true,
        };
        let mut known = ball.touched.iter();
        if let Some((what, time)) = known.find(|(what, _)| !is_there(Partner::from(*what))) {
            return refuse(format!("touched {what:?} at {time} s"));
        }
        let next = ball
            .next
            .filter(|(time, partner, _)| !time.is_finite() || !is_there(*partner));
        if let Some((time, partner, _)) = next {
            return refuse(format!("next event at {time} s, {partner:?}"));
        }
        if !ball.since.is_finite() {
            return refuse(format!("path since {} s", ball.since));
        }
        let cell = ball.cell.filter(|cell| *cell != u32::MAX);
        let lost = match (&self.cells, cell) {
            (Some(cells), Some(cell)) => !cells.has(cell),
            (Some(_), None) => ball.start.motion.in_play(),
            (None, _) => false,
        };
        if lost {
            return refuse(format!("cell {cell:?}"));
        }
        Ok(())
    }

    /// The engine that was saved, from the scene from which it was made.
    ///
    /// # Errors
    /// [`SolveError`] as [`Engine::new`], and if the numbers of balls differ.
    pub fn restore(scene: &Scene, saved: &Saved, limits: Limits) -> Result<Self, SolveError> {
        let mut engine = Self::unpredicted(scene, limits)?;
        if saved.balls.len() != engine.count() {
            return Err(SolveError::NoSuchBall {
                ball: saved.balls.len(),
                count: engine.count(),
            });
        }
        for (index, ball) in saved.balls.iter().enumerate() {
            engine.check_saved(index, ball)?;
        }
        if !(saved.time.is_finite() && saved.last.is_finite()) {
            return Err(SolveError::Saved {
                ball: String::new(),
                what: format!("times {} and {}", saved.time, saved.last),
            });
        }
        engine.clock = saved.time;
        engine.last = saved.last;
        engine.happened = saved.happened;
        for (index, ball) in saved.balls.iter().enumerate() {
            if !ball.start.is_finite() {
                return Err(engine.not_finite(index, ball.start));
            }
            let path = PathPiece {
                time: ball.since,
                piece: engine
                    .laws
                    .piece(&engine.table, &engine.bodies[index], &ball.start),
            };
            engine.paths[index] = path;
            engine.flights[index] = Flight::new(&engine.bodies[index], &path, ball.count);
            if let Some((time, partner, count)) = ball.next {
                engine.flights[index].next = Next {
                    time,
                    partner,
                    count,
                };
                engine.queue.set(index, time);
            }
            engine.touched[index] = Touched::from_list(&ball.touched);
            if let Some(cells) = &mut engine.cells {
                cells.remove(index as u32);
                if let Some(cell) = ball.cell.filter(|cell| *cell != u32::MAX) {
                    cells.insert(index as u32, cell);
                }
            }
        }
        Ok(engine)
    }
}
