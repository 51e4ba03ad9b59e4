//! The laws of the house, one file a published law.
//!
//! [`Laws`] names one choice per class. Both solvers, the aim preview, the computer players and the tests call the
//! same functions. A new law is one file, one enum variant and one entry in the `all()` of its class.

pub mod ball_ball;
pub mod cluster;
pub mod coursework;
pub mod cue_ball;
pub mod cushion;
pub mod motion;
pub mod pocket;
pub mod restitution;
mod rub;
pub mod slate;
pub mod source;

use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::table::{Ground, Pocket, Table};

use ball_ball::BallBallLaw;
use cluster::TOUCH;
use cushion::CushionLaw;
use motion::{Cloth, MotionLaw, Piece};
use pocket::{PocketLaw, Rim};
use slate::SlateLaw;

/// One choice of law per class. What is absent is not modelled and costs nothing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Laws {
    /// Free motion.
    pub motion: MotionLaw,
    /// Impact of two balls.
    pub ball_ball: BallBallLaw,
    /// Impact of a ball and a cushion.
    pub cushion: CushionLaw,
    /// Impact of a ball and the slate.
    pub slate: SlateLaw,
    /// Capture by a pocket.
    pub pocket: PocketLaw,
}

impl Default for Laws {
    /// Pool as it is played: Coulomb cloth, Marlow's throw, Han's cushion, a slate that bounces, pockets with an edge.
    fn default() -> Self {
        Self {
            motion: MotionLaw::Coulomb(Cloth::default()),
            ball_ball: BallBallLaw::Frictional(ball_ball::Frictional::default()),
            cushion: CushionLaw::Han2005(cushion::Han2005::default()),
            slate: SlateLaw::Bouncing(slate::Bouncing::default()),
            pocket: PocketLaw::Rim(pocket::Rim::default()),
        }
    }
}

impl Laws {
    /// The closed-form piece of path that starts with this state on this table.
    #[must_use]
    pub fn piece(&self, table: &Table, ball: &Ball, state: &State) -> Piece {
        match self.tipping(table, state) {
            Some((rim, gravity, pocket)) => rim.piece(gravity, pocket, ball, state),
            None => self.motion.piece(ball, state),
        }
    }

    /// The state at the end of a piece, with the next kind of motion.
    #[must_use]
    pub fn end(&self, table: &Table, ball: &Ball, piece: &Piece) -> State {
        match self.tipping(table, &piece.start) {
            Some((rim, gravity, pocket)) => rim.tipped(gravity, pocket, ball, piece),
            None => piece.end(ball),
        }
    }

    fn tipping<'t>(&self, table: &'t Table, state: &State) -> Option<(Rim, f64, &'t Pocket)> {
        if state.motion != Motion::Tipping {
            return None;
        }
        let PocketLaw::Rim(rim) = self.pocket else {
            return None;
        };
        let point = DVec2::new(state.position.x, state.position.z);
        let from =
            |pocket: &Pocket| pocket.center.distance_squared(point) - pocket.radius * pocket.radius;
        let nearest = |a: &&Pocket, b: &&Pocket| from(a).total_cmp(&from(b));
        let pocket = table.pockets.iter().min_by(nearest)?;
        Some((rim, self.motion.gravity()?, pocket))
    }

    /// The state of a ball on the slate whose centre passes the edge of a pocket: captured, tipping or falling.
    #[must_use]
    pub fn drop(&self, pocket: &Pocket, ball: &Ball, state: &State) -> State {
        let (PocketLaw::Rim(rim), Some(gravity)) = (self.pocket, self.motion.gravity()) else {
            return self.pocket.captured(pocket);
        };
        let mut state = *state;
        state.motion = if rim.holds(gravity, pocket, ball, &state) {
            Motion::Tipping
        } else {
            Motion::Airborne
        };
        state
    }

    /// A falling ball after it met the edge of a pocket, or else its wall or liner, away from which the unit vector `normal`
    /// points; `restitution` is in place of the law's own.
    #[must_use]
    pub fn rattle(
        &self,
        (ball, state): (&Ball, &State),
        on_edge: bool,
        normal: DVec3,
        restitution: Option<f64>,
    ) -> State {
        let mut after = match self.pocket {
            PocketLaw::Rim(_) if on_edge => self.slate.bounce(ball, state, normal, restitution),
            PocketLaw::Rim(rim) => rim.off_wall(state, normal, restitution),
            PocketLaw::Capture => *state,
        };
        after.motion = Motion::Airborne;
        after
    }

    /// Restitution of the edge of a pocket, or else of its wall.
    #[must_use]
    pub fn rattle_restitution(&self, on_edge: bool) -> f64 {
        match self.pocket {
            PocketLaw::Rim(rim) if !on_edge => rim.liner_restitution,
            PocketLaw::Rim(_) | PocketLaw::Capture => self.slate.restitution(),
        }
    }

    /// A ball after a blow, with the slate's answer and the label of motion that it deserves.
    #[must_use]
    pub fn settled(&self, table: &Table, ball: &Ball, state: &State) -> State {
        let mut state = *state;
        if state.motion == Motion::Tipping {
            // A ball that is hit while it tips falls from there.
            state.motion = Motion::Airborne;
        }
        let state = self.touch_down(table, ball, &state);
        self.motion.classify(ball, state)
    }

    /// A ball after a blow: if it is pressed into the slate, or leaves it too slowly to fly, the slate answers.
    fn touch_down(&self, table: &Table, ball: &Ball, state: &State) -> State {
        let point = DVec2::new(state.position.x, state.position.z);
        if state.velocity.y != 0.0
            && (state.position.y - ball.radius).abs() <= TOUCH
            && state.motion != Motion::Tipping
            && table.ground(point) == Ground::Slate
        {
            let mut landed = self.slate.land(ball, state);
            landed.position.y = ball.radius;
            landed
        } else {
            *state
        }
    }

    /// No cloth, no friction, nothing lost: the ideal gas of billiard theory.
    #[must_use]
    pub fn ideal() -> Self {
        Self {
            motion: MotionLaw::Frictionless,
            ball_ball: BallBallLaw::Frictionless(ball_ball::Frictionless { restitution: 1.0 }),
            cushion: CushionLaw::Mirror(cushion::Mirror {
                restitution: 1.0.into(),
            }),
            slate: SlateLaw::default(),
            pocket: PocketLaw::default(),
        }
    }

    /// The complete model of the coursework report.
    #[must_use]
    pub fn coursework() -> Self {
        Self {
            motion: MotionLaw::Coursework(coursework::Coursework::default()),
            ..Self::ideal()
        }
    }
}

impl Check for Laws {
    fn parameters(&self) -> Vec<Parameter> {
        let classes: [(&str, Vec<Parameter>); 5] = [
            ("motion", self.motion.parameters()),
            ("ball_ball", self.ball_ball.parameters()),
            ("cushion", self.cushion.parameters()),
            ("slate", self.slate.parameters()),
            ("pocket", self.pocket.parameters()),
        ];
        classes
            .into_iter()
            .flat_map(|(class, parameters)| parameters.into_iter().map(move |p| p.within(class)))
            .collect()
    }
}

/// A number that a user may set, with the range in which its law is meant.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Path of the field, such as `cushion.restitution`.
    pub field: String,
    /// The value given.
    pub value: f64,
    /// Smallest allowed value.
    pub least: f64,
    /// Largest allowed value.
    pub most: f64,
    /// Where the range comes from, and what has been measured; empty if the range is only a matter of arithmetic.
    pub basis: &'static str,
}

impl Parameter {
    /// A parameter with its allowed range, ends included.
    #[must_use]
    pub fn new(field: &str, value: f64, least: f64, most: f64) -> Self {
        Self {
            field: field.to_owned(),
            value,
            least,
            most,
            basis: "",
        }
    }

    /// The same parameter with the source of its range, and what has been measured: part of the message that refuses a
    /// value.
    #[must_use]
    pub fn basis(mut self, basis: &'static str) -> Self {
        self.basis = basis;
        self
    }

    /// The same parameter with its field path prefixed.
    #[must_use]
    pub fn within(mut self, parent: &str) -> Self {
        self.field = format!("{parent}.{}", self.field);
        self
    }

    /// Whether the value lies in its range; false for NaN.
    #[must_use]
    pub fn is_allowed(&self) -> bool {
        self.value >= self.least && self.value <= self.most
    }
}

/// Something with parameters that can be out of range.
pub trait Check {
    /// Every parameter with its allowed range.
    fn parameters(&self) -> Vec<Parameter>;
}
