//! What makes a scene playable.

use thiserror::Error;

use crate::physics::ball::Motion;
use crate::physics::laws::Check;
use crate::physics::scene::{Scene, Solver};

/// Overlap in m that still counts as touching: rounding of positions written in a file.
pub const OVERLAP_TOLERANCE: f64 = 1e-9;

/// Why a scene cannot be played. Every variant names the field and the value.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SceneError {
    /// No balls.
    #[error("balls: there are 0 balls, at least 1 is needed")]
    NoBalls,
    /// Two balls share a name.
    #[error("balls[{ball}].name: `{name}` is used twice")]
    DuplicateName {
        /// Index of the second ball.
        ball: usize,
        /// The name.
        name: String,
    },
    /// A number is not finite or out of its range.
    #[error("{field}: {value} is not allowed, it must be between {least} and {most}")]
    OutOfRange {
        /// Path of the field.
        field: String,
        /// The value.
        value: f64,
        /// Smallest allowed value.
        least: f64,
        /// Largest allowed value.
        most: f64,
    },
    /// A number is NaN or infinite.
    #[error("{field}: {value} is not a finite number")]
    NotFinite {
        /// Path of the field.
        field: String,
        /// The value.
        value: f64,
    },
    /// Two balls overlap.
    #[error("balls: `{first}` and `{second}` overlap by {overlap} m")]
    Overlap {
        /// One ball.
        first: String,
        /// The other.
        second: String,
        /// Depth in m.
        overlap: f64,
    },
    /// A ball is inside a cushion.
    #[error("balls: `{ball}` is inside cushion {cushion} by {overlap} m")]
    InsideCushion {
        /// The ball.
        ball: String,
        /// Index of the cushion.
        cushion: usize,
        /// Depth in m.
        overlap: f64,
    },
    /// A ball lies outside the table.
    #[error("balls: `{ball}` at x = {x} m, z = {z} m is not on the table")]
    OffTable {
        /// The ball.
        ball: String,
        /// Position, m.
        x: f64,
        /// Position, m.
        z: f64,
    },
    /// A ball is not on the slate.
    #[error(
        "balls: `{ball}`: position.y is {height} m, a ball on the slate has y = radius = {radius} m"
    )]
    OffSlate {
        /// The ball.
        ball: String,
        /// Height of the centre, m.
        height: f64,
        /// Radius, m.
        radius: f64,
    },
    /// The table is too small for a ball.
    #[error("table: {length} m x {width} m is smaller than ball `{ball}` of radius {radius} m")]
    TableTooSmall {
        /// Length, m.
        length: f64,
        /// Width, m.
        width: f64,
        /// The ball.
        ball: String,
        /// Radius, m.
        radius: f64,
    },
    /// The shot names a ball that is not there.
    #[error("shot.ball: there is no ball number {ball}, the scene has {count}")]
    NoSuchBall {
        /// Index asked for.
        ball: usize,
        /// Number of balls.
        count: usize,
    },
    /// The exact solver needs closed forms.
    #[error(
        "solver: `Exact` cannot play motion law `Coursework`, which has no closed form; use `Stepped`"
    )]
    NotExact,
}

impl Scene {
    /// Finds the first thing that makes the scene unplayable.
    ///
    /// # Errors
    /// A [`SceneError`] that names the field and the value.
    pub fn check(&self) -> Result<(), SceneError> {
        if self.balls.is_empty() {
            return Err(SceneError::NoBalls);
        }
        self.check_numbers()?;
        self.check_balls()?;
        self.check_places()?;
        if self.solver == Solver::Exact && !self.laws.motion.is_closed_form() {
            return Err(SceneError::NotExact);
        }
        Ok(())
    }

    fn check_numbers(&self) -> Result<(), SceneError> {
        check_parameters("laws", &self.laws)?;
        check_parameters("cue", &self.cue)?;
        within("table.length", self.table.length, 1e-3, 1e4)?;
        within("table.width", self.table.width, 1e-3, 1e4)?;
        within("table.nose_height", self.table.nose_height, 0.0, 10.0)?;
        within("time_limit", self.time_limit, 0.0, 1e6)?;
        for (i, cushion) in self.table.cushions.iter().enumerate() {
            let (least, greatest) = cushion.bounds();
            for (axis, value) in [
                ("x", least.x),
                ("z", least.y),
                ("x", greatest.x),
                ("z", greatest.y),
            ] {
                finite(&format!("table.cushions[{i}].{axis}"), value)?;
            }
            match cushion {
                crate::physics::table::Cushion::Line(line) => {
                    let length = (line.to - line.from).length();
                    within(&format!("table.cushions[{i}].length"), length, 1e-9, 1e4)?;
                }
                crate::physics::table::Cushion::Arc(arc) => {
                    within(&format!("table.cushions[{i}].radius"), arc.radius, 0.0, 1e4)?;
                }
            }
        }
        for (i, pocket) in self.table.pockets.iter().enumerate() {
            finite(&format!("table.pockets[{i}].center.x"), pocket.center.x)?;
            finite(&format!("table.pockets[{i}].center.z"), pocket.center.y)?;
            within(
                &format!("table.pockets[{i}].radius"),
                pocket.radius,
                1e-6,
                1e4,
            )?;
            within(&format!("table.pockets[{i}].depth"), pocket.depth, 0.0, 1e4)?;
        }
        if let Solver::Stepped(stepped) = &self.solver {
            within("solver.tick", stepped.tick, 1e-6, 0.25)?;
            if let Some((columns, rows)) = stepped.grid {
                within("solver.grid.0", f64::from(columns), 1.0, 10_000.0)?;
                within("solver.grid.1", f64::from(rows), 1.0, 10_000.0)?;
            }
        }
        if let Some(planned) = &self.shot {
            if planned.ball >= self.balls.len() {
                return Err(SceneError::NoSuchBall {
                    ball: planned.ball,
                    count: self.balls.len(),
                });
            }
            check_parameters("shot", &planned.shot)?;
        }
        Ok(())
    }

    fn check_balls(&self) -> Result<(), SceneError> {
        for (i, ball) in self.balls.iter().enumerate() {
            if self.balls[..i].iter().any(|other| other.name == ball.name) {
                return Err(SceneError::DuplicateName {
                    ball: i,
                    name: ball.name.clone(),
                });
            }
            let field = |name: &str| format!("balls[{i}] (`{}`).{name}", ball.name);
            within(&field("mass"), ball.ball.mass, 1e-9, 1e9)?;
            within(&field("radius"), ball.ball.radius, 1e-6, 1e3)?;
            let vectors = [
                ("position", ball.state.position, 1e4),
                ("velocity", ball.state.velocity, 1e3),
                ("spin", ball.state.angular_velocity, 1e5),
            ];
            for (name, vector, most) in vectors {
                for (axis, value) in ["x", "y", "z"].into_iter().zip(vector.to_array()) {
                    within(&field(&format!("{name}.{axis}")), value, -most, most)?;
                }
            }
        }
        Ok(())
    }

    fn check_places(&self) -> Result<(), SceneError> {
        for (i, first) in self.balls.iter().enumerate() {
            let (radius, position) = (first.ball.radius, first.state.position);
            let name = || first.name.clone();
            if 2.0 * radius > self.table.length.min(self.table.width) {
                return Err(SceneError::TableTooSmall {
                    length: self.table.length,
                    width: self.table.width,
                    ball: name(),
                    radius,
                });
            }
            if first.state.motion == Motion::Pocketed {
                continue;
            }
            if (position.y - radius).abs() > OVERLAP_TOLERANCE {
                return Err(SceneError::OffSlate {
                    ball: name(),
                    height: position.y,
                    radius,
                });
            }
            let plan = glam::DVec2::new(position.x, position.z);
            for (cushion, nose) in self.table.cushions.iter().enumerate() {
                let overlap = radius - nose.nearest(plan).0;
                if overlap > OVERLAP_TOLERANCE {
                    return Err(SceneError::InsideCushion {
                        ball: name(),
                        cushion,
                        overlap,
                    });
                }
            }
            if plan.x.abs() > 0.5 * self.table.length || plan.y.abs() > 0.5 * self.table.width {
                return Err(SceneError::OffTable {
                    ball: name(),
                    x: plan.x,
                    z: plan.y,
                });
            }
            for second in &self.balls[..i] {
                if second.state.motion == Motion::Pocketed {
                    continue;
                }
                let distance = (position - second.state.position).length();
                let overlap = radius + second.ball.radius - distance;
                if overlap > OVERLAP_TOLERANCE {
                    return Err(SceneError::Overlap {
                        first: second.name.clone(),
                        second: name(),
                        overlap,
                    });
                }
            }
        }
        Ok(())
    }
}

fn check_parameters(parent: &str, checked: &impl Check) -> Result<(), SceneError> {
    for parameter in checked.parameters() {
        let parameter = parameter.within(parent);
        within(
            &parameter.field,
            parameter.value,
            parameter.least,
            parameter.most,
        )?;
    }
    Ok(())
}

fn within(field: &str, value: f64, least: f64, most: f64) -> Result<(), SceneError> {
    finite(field, value)?;
    if value < least || value > most {
        return Err(SceneError::OutOfRange {
            field: field.to_owned(),
            value,
            least,
            most,
        });
    }
    Ok(())
}

fn finite(field: &str, value: f64) -> Result<(), SceneError> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(SceneError::NotFinite {
            field: field.to_owned(),
            value,
        })
    }
}
