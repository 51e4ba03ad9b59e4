//! Balls and racks as a file names them.

use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::equipment::BallSet;
use crate::physics::laws::Laws;
use crate::physics::scene::{Rack, Scene, SceneBall, within};
use crate::physics::table::Table;
use crate::scenarios::file::error::{FieldError, LayoutError};

/// Constants of a ball; what is absent is left to the default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(in crate::scenarios) struct BallConstants {
    #[serde(skip_serializing_if = "Option::is_none")]
    mass: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    radius: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    spins: Option<bool>,
}

impl BallConstants {
    pub(in crate::scenarios) fn or(self, default: Ball) -> Ball {
        Ball {
            mass: self.mass.unwrap_or(default.mass),
            radius: self.radius.unwrap_or(default.radius),
            spins: self.spins.unwrap_or(default.spins),
        }
    }
}

/// One ball.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Ball")]
pub(super) struct BallEntry {
    name: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    mass: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    radius: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    spins: Option<bool>,
    /// x and z, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    position: Option<DVec2>,
    /// Place in diamonds, see [`from_diamonds`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    diamonds: Option<DVec2>,
    /// y of the centre, m; absent is on the slate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    height: Option<f64>,
    /// m/s.
    #[serde(default)]
    velocity: DVec3,
    /// rad/s.
    #[serde(default)]
    spin: DVec3,
    /// The kind of motion; absent is what velocity and spin say.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    motion: Option<Motion>,
}

impl BallEntry {
    pub(super) fn of(laws: &Laws, placed: &SceneBall) -> Self {
        let (ball, state) = (&placed.ball, &placed.state);
        let on_slate = state.position.y.to_bits() == ball.radius.to_bits();
        let plain = motion_of(laws, ball, *state) == state.motion;
        Self {
            name: placed.name.clone(),
            mass: Some(ball.mass),
            radius: Some(ball.radius),
            spins: Some(ball.spins),
            position: Some(DVec2::new(state.position.x, state.position.z)),
            diamonds: None,
            height: (!on_slate).then_some(state.position.y),
            velocity: state.velocity,
            spin: state.angular_velocity,
            motion: (!plain).then_some(state.motion),
        }
    }

    /// The ball for a scene with this table and these laws; `i` is its place in the file.
    pub(super) fn ball(
        self,
        i: usize,
        scene: &Scene,
        balls: &BallSet,
    ) -> Result<SceneBall, LayoutError> {
        let given = BallConstants {
            mass: self.mass,
            radius: self.radius,
            spins: self.spins,
        };
        let ball = given.or(balls.named(&self.name));
        let plan = match (self.position, self.diamonds) {
            (Some(position), None) => position,
            (None, Some(diamonds)) => from_diamonds(&scene.table, diamonds),
            (position, _) => {
                return Err(FieldError::OneOf {
                    parent: format!("balls[{i}] (`{}`)", self.name),
                    choices: "`position`, `diamonds`",
                    count: if position.is_some() { 2 } else { 0 },
                }
                .into());
            }
        };
        let mut state = State {
            position: DVec3::new(plan.x, self.height.unwrap_or(ball.radius), plan.y),
            velocity: self.velocity,
            angular_velocity: self.spin,
            motion: Motion::Rest,
        };
        state.motion = self
            .motion
            .unwrap_or_else(|| motion_of(&scene.laws, &ball, state));
        Ok(SceneBall {
            name: self.name,
            ball,
            state,
        })
    }
}

/// The label that velocity and spin deserve.
fn motion_of(laws: &Laws, ball: &Ball, mut state: State) -> Motion {
    state.motion = Motion::Rest;
    laws.motion.classify(ball, state).motion
}

/// The point at these diamonds.
pub(in crate::scenarios) fn from_diamonds(table: &Table, diamonds: DVec2) -> DVec2 {
    table.at_diamonds(diamonds)
}

/// A rack.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Rack")]
pub(super) enum RackEntry {
    EightBall(Racked),
    NineBall(Racked),
    NineOnSpot(Racked),
    TenBall(Racked),
    Straight(Racked),
    Snooker(Racked),
    ThreeCushion(Racked),
}

/// How a rack is set up.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct Racked {
    /// Distance between neighbours, m.
    gap: f64,
    /// Which of the possible orders.
    seed: u64,
}

impl Default for Racked {
    fn default() -> Self {
        Self { gap: 0.0, seed: 1 }
    }
}

impl RackEntry {
    pub(super) fn place(self, scene: &mut Scene, balls: &BallSet) -> Result<(), LayoutError> {
        let (rack, Racked { gap, seed }) = match self {
            Self::EightBall(racked) => (Rack::EightBall, racked),
            Self::NineBall(racked) => (Rack::NineBall, racked),
            Self::NineOnSpot(racked) => (Rack::NineOnSpot, racked),
            Self::TenBall(racked) => (Rack::TenBall, racked),
            Self::Straight(racked) => (Rack::Straight, racked),
            Self::Snooker(racked) => (Rack::Snooker, racked),
            Self::ThreeCushion(racked) => (Rack::ThreeCushion, racked),
        };
        within("rack.gap", gap, 0.0, 1.0)?;
        rack.place(scene, balls.object, gap, seed);
        balls.exchange(scene);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::table::Preset;

    #[test]
    fn diamonds_name_the_spots() {
        let table = Preset::NineFoot.table();
        assert_eq!(
            from_diamonds(&table, DVec2::new(2.0, 2.0)),
            table.foot_spot()
        );
        assert_eq!(
            from_diamonds(&table, DVec2::new(2.0, 6.0)),
            table.head_spot()
        );
        assert_eq!(
            from_diamonds(&table, DVec2::new(0.0, 0.0)),
            DVec2::new(1.27, 0.635)
        );
        assert_eq!(
            from_diamonds(&table, DVec2::new(4.0, 8.0)),
            DVec2::new(-1.27, -0.635)
        );
    }
}
