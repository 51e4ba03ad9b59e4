//! The ways to advance a scene that are compared.

use std::fmt;

use crate::physics::laws::Laws;
use crate::physics::laws::motion::MotionLaw;
use crate::physics::scene::{Scene, Solver, Stepped};

/// One way to advance a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Every event at its own time.
    Exact,
    /// A fixed tick, this many a second, each contact located inside its tick.
    Located(u32),
    /// The same for balls packed as a crowd.
    Crowd(u32),
    /// The same with places and velocities kept in f32. Only where nothing spins and nothing rubs.
    Single(u32),
    /// A fixed tick, balls met where the tick leaves them.
    Plain(u32),
    /// The model of the coursework report, with its own friction and its own way to meet.
    Coursework(u32),
}

impl Method {
    /// Ticks a second; `None` for the exact solver, which has none.
    #[must_use]
    pub fn rate(self) -> Option<u32> {
        match self {
            Self::Exact => None,
            Self::Located(rate)
            | Self::Crowd(rate)
            | Self::Single(rate)
            | Self::Plain(rate)
            | Self::Coursework(rate) => Some(rate),
        }
    }

    /// What all ticks of one method are called together.
    #[must_use]
    pub fn family(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Located(_) => "stepped",
            Self::Crowd(_) => "stepped, as a crowd",
            Self::Single(_) => "stepped, as a crowd in f32",
            Self::Plain(_) => "stepped, contacts not located",
            Self::Coursework(_) => "coursework model",
        }
    }

    /// The scene as this method plays it. The laws stay, but for the coursework model; where a table has no cloth, its
    /// model has none either.
    #[must_use]
    pub fn prepare(self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        let Some(rate) = self.rate() else {
            scene.solver = Solver::Exact;
            return scene;
        };
        if let Self::Coursework(_) = self {
            scene.laws = if scene.laws.motion == MotionLaw::Frictionless {
                Laws::ideal()
            } else {
                Laws::coursework()
            };
        }
        scene.solver = Solver::Stepped(Stepped {
            tick: 1.0 / f64::from(rate),
            grid: match self {
                Self::Crowd(_) | Self::Single(_) => None,
                _ if scene.balls.len() > 1000 => Some((80, 80)),
                _ => Stepped::default().grid,
            },
            locate: matches!(self, Self::Located(_) | Self::Crowd(_) | Self::Single(_)),
            crowd: matches!(self, Self::Crowd(_) | Self::Single(_)),
            single: matches!(self, Self::Single(_)),
        });
        scene
    }
}

impl fmt::Display for Method {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        match self.rate() {
            None => out.write_str(self.family()),
            Some(rate) => write!(out, "{}, 1/{rate} s", self.family()),
        }
    }
}
