//! What a ball is, and how it moves at one instant.

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// The constants of one ball: a homogeneous sphere.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ball {
    /// Mass in kg.
    pub mass: f64,
    /// Radius in m.
    pub radius: f64,
    /// Whether spin is modelled. A ball without spin feels no friction from other balls, cushions or cue
    /// offset, and on cloth it is taken to roll.
    pub spins: bool,
}

impl Ball {
    /// A regulation pool ball: 2.25 in, 6 oz (Alciatore, physical properties page).
    pub const POOL: Self = Self {
        mass: 0.170_097,
        radius: 0.028_575,
        spins: true,
    };

    /// Moment of inertia of a homogeneous sphere, (2/5) m R², in kg m².
    #[must_use]
    pub fn inertia(&self) -> f64 {
        0.4 * self.mass * self.radius * self.radius
    }

    /// Velocity in m/s of the point of the ball that touches the slate: u = v − R ω × ŷ.
    #[must_use]
    pub fn slip(&self, velocity: DVec3, angular_velocity: DVec3) -> DVec3 {
        velocity - self.radius * angular_velocity.cross(DVec3::Y)
    }

    /// Angular velocity in rad/s of a ball that rolls with this velocity: ω = ŷ × v / R.
    #[must_use]
    pub fn rolling_spin(&self, velocity: DVec3) -> DVec3 {
        DVec3::Y.cross(velocity) / self.radius
    }

    /// Kinetic energy in J of translation and rotation.
    #[must_use]
    pub fn kinetic_energy(&self, state: &State) -> f64 {
        0.5 * self.mass * state.velocity.length_squared()
            + 0.5 * self.inertia() * state.angular_velocity.length_squared()
    }
}

/// How a ball moves. The label decides which closed form its path follows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Motion {
    /// Nothing moves.
    #[default]
    Rest,
    /// The centre rests, the ball turns about the vertical.
    Spinning,
    /// The lowest point does not slip on the cloth.
    Rolling,
    /// The lowest point slips on the cloth.
    Sliding,
    /// Moves on a table without cloth: nothing slows it.
    Gliding,
    /// Off the slate, in free flight.
    Airborne,
    /// Rolls over the rounded edge of a pocket.
    Tipping,
    /// At rest off the slate: the edge of a pocket, its liner, noses or other such balls bear it. It may turn in place if nothing
    /// rubs on it.
    Wedged,
    /// In a pocket: out of play.
    Pocketed,
    /// Has left the table: out of play.
    OffTable,
}

impl Motion {
    /// Whether the centre of the ball moves.
    #[must_use]
    pub fn translates(self) -> bool {
        matches!(
            self,
            Self::Rolling | Self::Sliding | Self::Gliding | Self::Airborne | Self::Tipping
        )
    }

    /// Whether the ball is still on the table, moving or not.
    #[must_use]
    pub fn in_play(self) -> bool {
        !matches!(self, Self::Pocketed | Self::OffTable)
    }

    /// Whether the ball is off the flat of the slate: it meets things in space and not in plan, and falls unless it is wedged.
    #[must_use]
    pub fn flies(self) -> bool {
        matches!(self, Self::Airborne | Self::Tipping | Self::Wedged)
    }

    /// Whether nothing of the ball moves, in play or not.
    #[must_use]
    pub fn is_still(self) -> bool {
        matches!(
            self,
            Self::Rest | Self::Wedged | Self::Pocketed | Self::OffTable
        )
    }
}

/// Where a ball is and how it moves at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Position of the centre in m.
    pub position: DVec3,
    /// Velocity of the centre in m/s.
    pub velocity: DVec3,
    /// Angular velocity in rad/s, right-handed.
    pub angular_velocity: DVec3,
    /// The kind of motion.
    pub motion: Motion,
}

impl State {
    /// A ball at rest with its centre at this position.
    #[must_use]
    pub fn at_rest(position: DVec3) -> Self {
        Self {
            position,
            ..Self::default()
        }
    }

    /// Whether every number is finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.position.is_finite() && self.velocity.is_finite() && self.angular_velocity.is_finite()
    }
}
