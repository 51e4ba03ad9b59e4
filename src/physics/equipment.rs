//! What is played with: table, laws, balls and cue, without anything on the table yet.

use glam::DVec3;

use crate::physics::ball::{Ball, Motion};
use crate::physics::cue::Cue;
use crate::physics::laws::{Check, Laws, Parameter};
use crate::physics::scene::{Scene, SceneError, Solver, check_parameter};
use crate::physics::table::{Preset, Table};

/// Everything that is given before balls are placed.
#[derive(Clone, Debug, PartialEq)]
pub struct Equipment {
    /// The table.
    pub table: Table,
    /// Which laws hold.
    pub laws: Laws,
    /// The cue.
    pub cue: Cue,
    /// The balls of the set.
    pub balls: BallSet,
}

/// The kinds of balls of a set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallSet {
    /// Every ball but the cue ball.
    pub object: Ball,
    /// The cue ball.
    pub cue: Ball,
}

impl Default for BallSet {
    fn default() -> Self {
        Self::of(Ball::POOL)
    }
}

impl BallSet {
    /// The name of the ball that counts as cue ball.
    pub const CUE: &'static str = "cue";

    /// A set of equal balls.
    #[must_use]
    pub fn of(ball: Ball) -> Self {
        Self {
            object: ball,
            cue: ball,
        }
    }

    /// The kind of the ball with this name.
    #[must_use]
    pub fn named(&self, name: &str) -> Ball {
        if name == Self::CUE {
            self.cue
        } else {
            self.object
        }
    }

    /// The set that a scene is played with: its cue ball and its first other ball.
    #[must_use]
    pub fn in_scene(scene: &Scene) -> Option<Self> {
        let cue = scene.balls.iter().find(|ball| ball.name == Self::CUE);
        let object = scene.balls.iter().find(|ball| ball.name != Self::CUE);
        let any = cue.or(object)?.ball;
        Some(Self {
            object: object.map_or(any, |ball| ball.ball),
            cue: cue.map_or(any, |ball| ball.ball),
        })
    }

    /// Exchanges the balls of a scene for those of this set. They stay where they are and come to rest on the slate.
    pub fn exchange(&self, scene: &mut Scene) {
        for placed in &mut scene.balls {
            let kind = self.named(&placed.name);
            if placed.ball == kind {
                continue;
            }
            placed.ball = kind;
            if placed.state.motion.in_play() {
                placed.state.position.y = kind.radius;
                placed.state.velocity = DVec3::ZERO;
                placed.state.angular_velocity = DVec3::ZERO;
                placed.state.motion = Motion::Rest;
            }
        }
    }
}

impl Check for BallSet {
    fn parameters(&self) -> Vec<Parameter> {
        [("ball", self.object), ("cue_ball", self.cue)]
            .into_iter()
            .flat_map(|(name, ball)| ball.parameters().into_iter().map(move |p| p.within(name)))
            .collect()
    }
}

impl Check for Ball {
    fn parameters(&self) -> Vec<Parameter> {
        vec![
            Parameter::new("mass", self.mass, 1e-9, 1e9).basis(
                "kg; pool 0.156 to 0.170, WPA, snooker about 0.14, carom 0.205 to 0.220, UMB",
            ),
            Parameter::new("radius", self.radius, 1e-6, 1e3)
                .basis("m; pool 0.0286, WPA, snooker 0.0262, WPBSA, carom 0.0305 to 0.0308, UMB"),
        ]
    }
}

impl Default for Equipment {
    /// A nine-foot pool table, pool balls and a playing cue.
    fn default() -> Self {
        Self {
            table: Preset::NineFoot.table(),
            laws: Laws::default(),
            cue: Cue::default(),
            balls: BallSet::default(),
        }
    }
}

impl Equipment {
    /// An empty scene with this equipment.
    #[must_use]
    pub fn scene(&self) -> Scene {
        Scene {
            cue: self.cue,
            ..Scene::new(self.table.clone(), self.laws)
        }
    }

    /// Checks every number.
    ///
    /// # Errors
    /// A [`SceneError`] that names the field, the value, its range and where the range comes from.
    pub fn check(&self) -> Result<(), SceneError> {
        self.scene().check_surroundings()?;
        for parameter in self.balls.parameters() {
            check_parameter(&parameter)?;
        }
        Ok(())
    }

    /// Plays a scene on with this equipment. True if its balls could stay where they are; false if they have no room
    /// there, and the scene then has the new table and laws but no balls.
    pub fn take_over(&self, scene: &mut Scene) -> bool {
        let mut next = Scene {
            balls: std::mem::take(&mut scene.balls),
            time_limit: scene.time_limit,
            ..self.scene()
        };
        if scene.solver != Solver::Exact || self.laws.motion.is_closed_form() {
            next.solver = scene.solver;
        }
        self.balls.exchange(&mut next);
        let room = next.check().is_ok();
        if !room {
            next.balls.clear();
        }
        *scene = next;
        room
    }
}
