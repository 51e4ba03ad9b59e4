//! The stroke: what the cue gives the ball.
//!
//! An instant hit at one point. With Q the contact seen from the centre, q the direction of the impulse, M the cue:
//! J = (1 + e) V₀ (q·c) / (1/M + 1/m + |Q × q|²/I), v = J q / m, ω = J Q × q / I, where c is the direction of the cue.
//! While the tip grips, q = c. Source: Alciatore, TP A.30, with a tip restitution e below 1.
//!
//! Then squirt turns the velocity away from the english by α, tan α = 2.5 b √(1 − b²) / (1 + m/mₑ + 2.5 (1 − b²)), b the
//! sideways offset in R, mₑ the end mass of the cue (TP A.31); it does not depend on speed.
//!
//! Beyond the miscue offset b₀ the tip slips: a miscue. The impulse then lies on the edge of the friction cone around the
//! contact normal, so the ball leaves in a direction turned away from the cue. And while the tip slips the ball has to take
//! up only the normal part of the cue's approach, V₀ √(1 − b²), so J is less by √((1 − b²) / (1 − b₀²)): nothing at b₀, all
//! of it at the rim, where the cue passes the ball by. (Our own continuation; no measured miscues were found.)

use glam::DVec3;

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::cue::{Cue, Shot};
use crate::physics::laws::slate::SlateLaw;
use crate::physics::laws::source::Source;

/// Where the law comes from.
pub const SOURCE: Source = Source {
    paper: "Alciatore, TP A.30, with a tip restitution below 1; squirt TP A.31",
    formula: "J = (1 + e) V₀ (q·c) / (1/M + 1/m + |Q × q|²/I); tan α = 2.5 b √(1 − b²) / (1 + m/mₑ + 2.5 (1 − b²))",
    leaves_out: "a second touch; the miscue is our own continuation",
};

/// What a stroke does to a ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Struck {
    /// The ball after the hit, with its position and motion label as they were.
    pub state: State,
    /// Impulse in N s.
    pub impulse: f64,
    /// Whether the tip slipped off.
    pub miscue: bool,
    /// Angle in rad by which squirt turned the ball to the left of the cue.
    pub squirt: f64,
}

/// Velocity and spin of a ball at rest after this stroke. `slate` takes up the downward part of an elevated hit.
#[must_use]
pub fn strike(cue: &Cue, slate: &SlateLaw, ball: &Ball, state: &State, shot: &Shot) -> Struck {
    let along = shot.along();
    let contact = shot.contact();
    let offset = shot.offset();
    let miscue = offset > cue.miscue_offset;
    let (direction, share) = if miscue {
        (
            cone_edge(contact, along, cue.miscue_offset),
            slipping_share(offset, cue.miscue_offset),
        )
    } else {
        (along, 1.0)
    };

    let lever = if ball.spins {
        ball.radius * contact.cross(direction)
    } else {
        DVec3::ZERO
    };
    let impulse = share * (1.0 + cue.tip_restitution) * shot.speed * direction.dot(along)
        / (1.0 / cue.mass + 1.0 / ball.mass + lever.length_squared() / ball.inertia());
    let squirt = squirt_angle(cue, ball, shot.side);
    let velocity = turned_left(impulse / ball.mass * direction, squirt);
    let angular_velocity = impulse / ball.inertia() * lever;

    let struck = State {
        velocity: state.velocity + velocity,
        angular_velocity: state.angular_velocity + angular_velocity,
        ..*state
    };
    let state = if state.motion.flies() {
        // No slate is under it.
        State {
            motion: Motion::Airborne,
            ..struck
        }
    } else {
        slate.land(ball, &struck)
    };
    Struck {
        state,
        impulse,
        miscue,
        squirt,
    }
}

/// The angle in rad by which a contact this far to the right, in R, turns the ball to the left.
#[must_use]
pub fn squirt_angle(cue: &Cue, ball: &Ball, side: f64) -> f64 {
    if cue.end_mass == 0.0 || !ball.spins {
        return 0.0;
    }
    let square = 1.0 - side * side;
    libm::atan2(
        2.5 * side * square.sqrt(),
        1.0 + ball.mass / cue.end_mass + 2.5 * square,
    )
}

/// The edge of the friction cone around the contact normal that lies nearest to the cue's direction.
fn cone_edge(contact: DVec3, along: DVec3, miscue_offset: f64) -> DVec3 {
    let normal = -contact;
    let tangent = (along - along.dot(normal) * normal).normalize_or_zero();
    let grip = (1.0 - miscue_offset * miscue_offset).sqrt();
    grip * normal + miscue_offset * tangent
}

/// What is left of the impulse when the tip slips, 1 at the miscue offset, 0 at the rim.
fn slipping_share(offset: f64, miscue_offset: f64) -> f64 {
    ((1.0 - offset * offset).max(0.0) / (1.0 - miscue_offset * miscue_offset)).sqrt()
}

/// The vector turned about the vertical by this angle in rad, counter-clockwise seen from above.
fn turned_left(vector: DVec3, angle: f64) -> DVec3 {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    DVec3::new(
        cos * vector.x + sin * vector.z,
        vector.y,
        cos * vector.z - sin * vector.x,
    )
}
