//! The drop: a rounded edge, a hole, a liner.
//!
//! The flat of the slate ends at the radius of the pocket. There begins an edge rounded with radius ρ, and below it the
//! wall of the hole. A ball whose centre has not passed the end of the flat hangs, however near; one that has passed it
//! tips. A fast one, v² ≥ g (R + ρ), leaves the edge at once and falls freely. A slow one rolls over the edge,
//!
//! ω² = ω₀² + (k g/ℓ) (cos φ₀ − cos φ), ℓ = R + ρ, k = 10/7 rolling, 2 slipping,
//!
//! until the edge no longer presses, cos φ = ω² ℓ/g. Falling, it meets the edge as it would bounce from a
//! slate so turned, and the soft wall of the hole, away from the table up to the top of the cushions, which gives back a
//! share of its motion in plan and lets it turn freely. It is gone when its centre reaches the bottom.
//!
//! The energy of the roll over the edge and where it ends are exact; the way between them is given in pieces of constant
//! acceleration of at most 0.12 rad each, which leave the arc by less than 0.05 mm. What a ball runs along the edge it keeps
//! as the edge turns, at the same speed: that the run itself drives it outwards is left out, so one that runs more than half
//! as fast as it tips bounces along the edge instead. A ball that is hit while it tips falls from there. Radius of the edge
//! and restitution of the liner are our choice: no published measurement is known to us.

use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::laws::motion::Piece;
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};
use crate::physics::table::Pocket;

/// Where the law comes from.
pub(super) const SOURCE: Source = Source {
    paper: "energy of a sphere that rolls over an edge; no measurement is known",
    formula: "ω² = ω₀² + (k g/ℓ)(cos φ₀ − cos φ), then a free fall between edge, wall and liner",
    leaves_out: "what the run along the edge adds to the fall",
};

/// Largest turn about the edge in one piece, rad.
const TURN: f64 = 0.12;

/// Fastest run along the edge of a ball that tips, as a share of its speed into the hole.
const MOST_RUN: f64 = 0.5;

/// A pocket with an edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Rim {
    /// Radius of the rounded edge of the slate, m.
    pub edge: f64,
    /// Restitution of the liner, 0 to 1.
    pub liner_restitution: f64,
}

impl Default for Rim {
    fn default() -> Self {
        Self {
            edge: 0.003,
            liner_restitution: 0.3,
        }
    }
}

/// A ball on the edge: the plane in which it tips, and how far it has.
struct Pivot {
    /// Horizontal unit vector into the hole.
    inward: DVec3,
    length: f64,
    /// Angle from the vertical, rad.
    angle: f64,
    /// Rate of that angle, rad/s.
    rate: f64,
    /// k g/ℓ, rad²/s².
    pull: f64,
    rolls: bool,
}

impl Pivot {
    fn new(law: &Rim, gravity: f64, pocket: &Pocket, ball: &Ball, state: &State) -> Self {
        let inward = inward(pocket, state);
        let length = ball.radius + law.edge;
        let cos = ((state.position.y + law.edge) / length).clamp(-1.0, 1.0);
        let angle = libm::acos(cos);
        let normal = cos * DVec3::Y + libm::sin(angle) * inward;
        let along = cos * inward - libm::sin(angle) * DVec3::Y;
        let slip = state.velocity - ball.radius * state.angular_velocity.cross(normal);
        let rolls = ball.spins && slip.length() <= 1e-6 * state.velocity.length();
        let k = if rolls { 10.0 / 7.0 } else { 2.0 };
        Self {
            inward,
            length,
            angle,
            rate: state.velocity.dot(along).max(0.0) / length,
            pull: k * gravity / length,
            rolls,
        }
    }

    /// Speed along the edge.
    fn run(&self, state: &State) -> f64 {
        state.velocity.dot(self.inward.cross(DVec3::Y))
    }

    /// Way of the centre to another angle, while it runs along the edge: it ends over the edge as that is bent.
    fn way(&self, pocket: &Pocket, state: &State, angle: f64, time: f64) -> DVec3 {
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let in_by = self.length * (sin - libm::sin(self.angle));
        let run = time * self.run(state) * self.inward.cross(DVec3::Y);
        let middle = DVec3::new(pocket.center.x, state.position.y, pocket.center.y);
        let offset = state.position - middle;
        let (distance, turned) = (offset.length(), offset + run);
        let end = (distance - in_by) * turned.normalize_or_zero();
        end - offset + self.length * (cos - libm::cos(self.angle)) * DVec3::Y
    }

    /// Velocities at another angle, where the position is that there: the edge has turned by what the ball ran along it.
    fn turn(&self, pocket: &Pocket, ball: &Ball, (start, end): (&State, &mut State), angle: f64) {
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let inward = inward(pocket, end);
        let normal = cos * DVec3::Y + sin * inward;
        let along = cos * inward - sin * DVec3::Y;
        end.velocity =
            self.rate_at(angle) * self.length * along + self.run(start) * inward.cross(DVec3::Y);
        if self.rolls {
            let before = libm::cos(self.angle) * DVec3::Y + libm::sin(self.angle) * self.inward;
            let twist = start.angular_velocity.dot(before);
            end.angular_velocity = normal.cross(end.velocity) / ball.radius + twist * normal;
        }
    }

    /// Rate at another angle, by the energy.
    fn rate_at(&self, angle: f64) -> f64 {
        let square = self.rate * self.rate + self.pull * (libm::cos(self.angle) - libm::cos(angle));
        square.max(0.0).sqrt()
    }

    /// Seconds from this angle to another a little larger: exact for a pull that grows like the angle, and for the
    /// rates at both ends.
    fn time_to(&self, angle: f64) -> f64 {
        let (from, to) = (self.rate, self.rate_at(angle));
        let growth = (to * to - from * from) / (angle * angle - self.angle * self.angle);
        let top = from * from - growth * self.angle * self.angle;
        if growth > 0.0 && top > 0.0 {
            let (rate, start) = (growth.sqrt(), top.sqrt());
            (libm::asinh(rate * angle / start) - libm::asinh(rate * self.angle / start)) / rate
        } else {
            2.0 * (angle - self.angle) / (from + to).max(1e-9)
        }
    }
}

impl Rim {
    /// A falling ball after it met the wall below the edge, or the liner above it, away from which this unit vector points: a
    /// share of its motion in plan comes back, and always some of it away, or it would run round the wall and touch it without
    /// end. With a restitution in place of the law's own that share of what closed comes back, but of what runs along the wall
    /// the law's.
    #[must_use]
    pub(in crate::physics::laws) fn off_wall(
        &self,
        state: &State,
        normal: DVec3,
        restitution: Option<f64>,
    ) -> State {
        let level = DVec3::new(state.velocity.x, 0.0, state.velocity.z);
        let radial = level.dot(normal);
        let along = level - radial * normal;
        let share = self.liner_restitution;
        let back = match restitution {
            Some(restitution) => restitution * -radial,
            None => share * radial.abs().max(0.5 * along.length()),
        };
        let mut after = *state;
        after.velocity = share * along + back * normal + state.velocity.y * DVec3::Y;
        after
    }

    /// Whether a ball that passes the end of the flat with this velocity stays on the edge for a while.
    #[must_use]
    pub fn holds(&self, gravity: f64, pocket: &Pocket, ball: &Ball, state: &State) -> bool {
        let pivot = Pivot::new(self, gravity, pocket, ball, state);
        // One that runs along the edge is soon over the slate again.
        let inward = pivot.rate * pivot.length;
        inward * pivot.rate < gravity * libm::cos(pivot.angle)
            && pivot.run(state).abs() <= MOST_RUN * inward
    }

    /// The piece of the roll over the edge that begins with this state. Its end is [`Self::tipped`].
    #[must_use]
    pub fn piece(&self, gravity: f64, pocket: &Pocket, ball: &Ball, state: &State) -> Piece {
        let pivot = Pivot::new(self, gravity, pocket, ball, state);
        let (angle, leaves) = next(&pivot, gravity);
        let time = pivot.time_to(angle);
        let mut piece = Piece::uniform(*state);
        piece.next = if leaves {
            Motion::Airborne
        } else {
            Motion::Tipping
        };
        piece.duration = time;
        if time > 0.0 {
            let way = pivot.way(pocket, state, angle, time);
            piece.acceleration = 2.0 * (way - time * state.velocity) / (time * time);
            let mut end = *state;
            end.position += way;
            pivot.turn(pocket, ball, (state, &mut end), angle);
            let (from, to) = (state.angular_velocity, end.angular_velocity);
            piece.angular_acceleration = DVec3::new(to.x - from.x, 0.0, to.z - from.z) / time;
            piece.spin_deceleration = (from.y - to.y) * from.y.signum() / time;
        }
        piece
    }

    /// The state at the end of that piece.
    #[must_use]
    pub fn tipped(&self, gravity: f64, pocket: &Pocket, ball: &Ball, piece: &Piece) -> State {
        let start = &piece.start;
        let pivot = Pivot::new(self, gravity, pocket, ball, start);
        let (angle, _) = next(&pivot, gravity);
        let mut state = piece.at(piece.duration);
        state.motion = piece.next;
        pivot.turn(pocket, ball, (start, &mut state), angle);
        state
    }
}

/// The angle at the end of the next piece, and whether the ball leaves the edge there.
fn next(pivot: &Pivot, gravity: f64) -> (f64, bool) {
    // The edge presses until ω² ℓ = g cos φ.
    let k = pivot.pull * pivot.length / gravity;
    let free = pivot.rate * pivot.rate * pivot.length / gravity;
    let cos = ((free + k * libm::cos(pivot.angle)) / (1.0 + k)).clamp(0.0, 1.0);
    let leave = libm::acos(cos).max(pivot.angle);
    if leave - pivot.angle <= TURN {
        (leave, true)
    } else {
        (pivot.angle + TURN, false)
    }
}

/// Horizontal unit vector from a ball to the middle of the pocket.
fn inward(pocket: &Pocket, state: &State) -> DVec3 {
    let way = pocket.center - DVec2::new(state.position.x, state.position.z);
    let way = way.normalize_or_zero();
    DVec3::new(way.x, 0.0, way.y)
}

impl Check for Rim {
    fn parameters(&self) -> Vec<Parameter> {
        vec![
            Parameter::new("edge", self.edge, 0.0, 0.05)
                .basis("a rounding much larger than a ball would be no edge"),
            Parameter::new("liner_restitution", self.liner_restitution, 0.0, 0.8)
                .basis("leather and rubber swallow most of a blow; our range"),
        ]
    }
}
