//! What makes a scene playable.

use std::collections::HashSet;

use crate::physics::laws::motion::MotionLaw;
use crate::physics::scene::range::{Listed, check_parameters, in_plan, in_space, within};
use crate::physics::scene::{Scene, SceneBall, SceneError, Solver, Stepped};
use crate::physics::table::Cushion;

/// Most cells of a grid: more would cost memory and find nothing sooner.
const MOST_CELLS: f64 = 1e6;

/// Share of a plane that equal discs cover at most: π / √12.
const DENSEST: f64 = 0.906_899_682_117_089_3;

impl Scene {
    /// Finds the first thing that makes the scene unplayable.
    ///
    /// # Errors
    /// A [`SceneError`] that names the field and the value.
    pub fn check(&self) -> Result<(), SceneError> {
        if self.balls.is_empty() {
            return Err(SceneError::NoBalls);
        }
        self.check_surroundings()?;
        self.check_balls()?;
        if self.solver.is_crowd() {
            self.check_crowd()?;
        }
        self.check_shot()?;
        self.check_places()?;
        self.check_pockets()?;
        self.check_room()?;
        self.check_overlaps()?;
        if self.solver == Solver::Exact && !self.laws.motion.is_closed_form() {
            return Err(SceneError::NotExact);
        }
        Ok(())
    }

    /// Checks the numbers of everything but the balls and the shot: laws, cue, table, solver, time limit.
    ///
    /// # Errors
    /// A [`SceneError`] that names the field and the value.
    pub fn check_surroundings(&self) -> Result<(), SceneError> {
        check_parameters("laws", &self.laws)?;
        check_parameters("cue", &self.cue)?;
        within("table.length", self.table.length, 1e-3, 1e4)?;
        within("table.width", self.table.width, 1e-3, 1e4)?;
        within("table.nose_height", self.table.nose_height, 0.0, 10.0)?;
        within("time_limit", self.time_limit, 0.0, 1e6)?;
        for (i, cushion) in self.table.cushions.iter().enumerate() {
            let field = |field| Listed {
                list: "table.cushions",
                index: i,
                name: None,
                field,
            };
            match cushion {
                Cushion::Line(line) => {
                    in_plan(field("from"), line.from)?;
                    in_plan(field("to"), line.to)?;
                    within(field("length"), (line.to - line.from).length(), 1e-9, 1e5)?;
                }
                Cushion::Arc(arc) => {
                    in_plan(field("center"), arc.center)?;
                    within(field("radius"), arc.radius, 0.0, 1e4)?;
                }
            }
        }
        let mut names = HashSet::with_capacity(self.table.pockets.len());
        for (i, pocket) in self.table.pockets.iter().enumerate() {
            if !names.insert(pocket.name.as_str()) {
                return Err(SceneError::DuplicatePocket {
                    pocket: i,
                    name: pocket.name.clone(),
                });
            }
            let field = |field| Listed {
                list: "table.pockets",
                index: i,
                name: Some(pocket.name.as_str()),
                field,
            };
            in_plan(field("center"), pocket.center)?;
            within(field("radius"), pocket.radius, 1e-6, 1e4)?;
            within(field("depth"), pocket.depth, 0.0, 1e4)?;
        }
        if let Solver::Stepped(stepped) = &self.solver {
            within("solver.tick", stepped.tick, 1e-6, 0.25)?;
            if let Some((columns, rows)) = stepped.grid {
                let (columns, rows) = (f64::from(columns), f64::from(rows));
                within("solver.grid.0", columns, 1.0, MOST_CELLS)?;
                within("solver.grid.1", rows, 1.0, MOST_CELLS)?;
                within("solver.grid (cells)", columns * rows, 1.0, MOST_CELLS)?;
            }
        }
        Ok(())
    }

    /// Checks every number of the scene, but not whether the balls have room where they are, as they may not have in the
    /// middle of a shot.
    ///
    /// # Errors
    /// A [`SceneError`] that names the field and the value.
    pub fn check_numbers(&self) -> Result<(), SceneError> {
        self.check_surroundings()?;
        self.check_balls()
    }

    fn check_shot(&self) -> Result<(), SceneError> {
        let Some(planned) = &self.shot else {
            return Ok(());
        };
        let Some(ball) = self.balls.get(planned.ball) else {
            return Err(SceneError::NoSuchBall {
                ball: planned.ball,
                count: self.balls.len(),
            });
        };
        if !in_play(ball) {
            return Err(SceneError::StrikesPocketed {
                ball: ball.name.clone(),
            });
        }
        check_parameters("shot", &planned.shot)
    }

    fn check_balls(&self) -> Result<(), SceneError> {
        let mut names = HashSet::with_capacity(self.balls.len());
        for (i, ball) in self.balls.iter().enumerate() {
            if !names.insert(ball.name.as_str()) {
                return Err(SceneError::DuplicateName {
                    ball: i,
                    name: ball.name.clone(),
                });
            }
            let field = |field| Listed {
                list: "balls",
                index: i,
                name: Some(ball.name.as_str()),
                field,
            };
            within(field("mass"), ball.ball.mass, 1e-9, 1e9)?;
            within(field("radius"), ball.ball.radius, 1e-6, 1e3)?;
            let vectors = [
                ("position", ball.state.position, 1e4),
                ("velocity", ball.state.velocity, 1e3),
                ("spin", ball.state.angular_velocity, 1e5),
            ];
            for (name, vector, most) in vectors {
                in_space(field(name), vector, most)?;
            }
        }
        Ok(())
    }

    /// The balls in play can fit on the table at all. Balls of different sizes pack denser, but never cover it.
    fn check_room(&self) -> Result<(), SceneError> {
        let Some(first) = self.balls.first() else {
            return Ok(());
        };
        let playing = || self.balls.iter().filter(|ball| in_play(ball));
        let covered: f64 = playing()
            .map(|ball| std::f64::consts::PI * ball.ball.radius * ball.ball.radius)
            .sum();
        let alike = playing().all(|ball| ball.ball.radius == first.ball.radius);
        // Half a ball can lie over the edge, in the mouth of a pocket.
        let edge = if self.table.pockets.is_empty() {
            0.0
        } else {
            2.0 * first.ball.radius
        };
        let room = (self.table.length + edge) * (self.table.width + edge);
        let most = if alike { DENSEST } else { 1.0 };
        if covered > most * room {
            return Err(SceneError::TooDense {
                count: playing().count(),
                percent: 100.0 * covered / room,
                most: 100.0 * most,
            });
        }
        Ok(())
    }

    /// A crowd is equal balls on the slate of a table without pockets, with contacts located.
    fn check_crowd(&self) -> Result<(), SceneError> {
        let refuse = |field: &str, value: String, allowed: &'static str| {
            Err(SceneError::NotACrowd {
                field: field.to_owned(),
                value,
                allowed,
            })
        };
        if let Solver::Stepped(stepped) = &self.solver
            && !stepped.locate
        {
            return refuse("solver.locate", "false".to_owned(), "true");
        }
        if let Solver::Stepped(Stepped { single: true, .. }) = &self.solver {
            let spins = self.balls.iter().any(|ball| ball.ball.spins);
            if spins || self.laws.motion != MotionLaw::Frictionless {
                let allowed =
                    "false, but for balls that do not spin on a level table without cloth";
                return refuse("solver.single", "true".to_owned(), allowed);
            }
        }
        if !self.table.pockets.is_empty() {
            let count = self.table.pockets.len();
            return refuse("table.pockets", format!("{count} pockets"), "none");
        }
        for (i, ball) in self.balls.iter().enumerate() {
            let field = format!("balls[{i}] (`{}`)", ball.name);
            let (this, first) = (&ball.ball, &self.balls[0].ball);
            if this != first {
                return refuse(&field, format!("{this:?}"), "the same ball as balls[0]");
            }
            if ball.state.motion.flies() {
                return refuse(&field, "airborne".to_owned(), "on the slate");
            }
        }
        Ok(())
    }
}

pub(super) fn in_play(ball: &SceneBall) -> bool {
    ball.state.motion.in_play()
}
