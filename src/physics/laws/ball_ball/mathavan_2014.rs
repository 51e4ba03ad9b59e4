//! Impact of two balls that press each other into the cloth.
//!
//! As [`Frictional`], and the vertical part of the friction between the balls is followed: it lifts one ball and presses
//! the other down, where the cloth rubs with `sliding` times that force while the impact lasts. Both balls are held on
//! the slate. The normal impulse is followed from contact to parting; restitution is energetic, e² of the work of
//! compression is given back.
//!
//! Source: Mathavan, Jackson & Parkin, "Numerical simulations of the frictional collisions of solid balls on a rough
//! surface", Sports Eng. 17 (2014) 227. Followed to 1e-6 of the closing speed (see `rub`). Momentum goes into the
//! table, so it is not kept; the speeds differ from [`Frictional`] by less than 0.004 m/s and the angles by less than 0.4°
//! for rolling shots. Balls in flight have no cloth: there it is [`Frictional`].
//!
//! Where the friction between the balls times that of the cloth reaches 1, far beyond any real ball, the blow presses a ball
//! to the cloth faster than it drives it off: it jams, and Coulomb's law has no solution (Painlevé 1895). The cloth then
//! rubs with no more than leaves one.

use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

use crate::physics::ball::{Ball, State};
use crate::physics::laws::ball_ball::{Friction, Frictional, Impact, PairContact, PairOutcome};
use crate::physics::laws::rub::{Accuracy, Limit, Rub};
use crate::physics::laws::source::Source;
use crate::physics::laws::{Check, Parameter};

/// Largest product of the frictions of balls and cloth that is followed; at 1 the impact jams.
const FREE: f64 = 0.9;

/// Rough balls on a rough cloth.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Mathavan2014 {
    /// Energetic coefficient of restitution, 0 to 1.
    pub restitution: f64,
    /// Friction between the balls, at the slip with which they meet.
    pub friction: Friction,
    /// Coefficient of friction between ball and cloth during the impact.
    pub sliding: f64,
}

impl Default for Mathavan2014 {
    /// As the paper: snooker balls.
    fn default() -> Self {
        Self {
            restitution: 0.89,
            friction: Friction::Constant(0.05),
            sliding: 0.21,
        }
    }
}

impl Mathavan2014 {
    /// The law of balls that touch no cloth.
    fn flying(&self) -> Frictional {
        Frictional {
            restitution: self.restitution,
            friction: self.friction,
        }
    }
}

impl Impact for Mathavan2014 {
    const SOURCE: Source = Source {
        paper: "Mathavan, Jackson & Parkin, Sports Eng. 17 (2014) 227",
        formula: "as Frictional along the impulse P, the cloth rubs with μₛ times the vertical friction; e² of the work comes back",
        leaves_out: "nothing known on the slate; in flight it is Frictional",
    };

    fn collide(
        &self,
        (ball_1, state_1): (&Ball, &State),
        (ball_2, state_2): (&Ball, &State),
        contact: &PairContact,
    ) -> PairOutcome {
        // Up is across the line of centres: balls of different size, whose line rises, are not what this law is about.
        let normal = contact.normal;
        let rough = ball_1.spins && ball_2.spins;
        let closing = (state_1.velocity - state_2.velocity).dot(normal);
        if !contact.on_slate || !rough || closing <= 0.0 || normal.y.abs() > 1e-9 {
            return self
                .flying()
                .collide((ball_1, state_1), (ball_2, state_2), contact);
        }
        let x = normal.cross(DVec3::Y);
        let relative = state_1.velocity - state_2.velocity;
        let surface =
            ball_1.radius * state_1.angular_velocity + ball_2.radius * state_2.angular_velocity;
        let slip = relative - closing * normal + surface.cross(normal);
        let at_cloth = |ball: &Ball, state: &State| {
            let slip = ball.slip(state.velocity, state.angular_velocity);
            DVec2::new(slip.dot(x), slip.dot(normal))
        };
        let slips = [
            DVec2::new(slip.dot(x), slip.y),
            at_cloth(ball_1, state_1),
            at_cloth(ball_2, state_2),
        ];
        let size = slips.iter().map(|slip| slip.length()).sum::<f64>()
            + state_1.velocity.length()
            + state_2.velocity.length();
        let total = ball_1.mass + ball_2.mass;
        let reduced = ball_1.mass * (ball_2.mass / total);
        // Inverse masses in units of the reduced mass.
        let (a, b) = (ball_2.mass / total, ball_1.mass / total);
        let between = self.friction.coefficient(slip.length());
        let sliding = self.sliding.min(FREE / between);
        let cloth = |beta| Limit {
            friction: sliding,
            alpha: 0.0,
            beta,
        };
        let rub = Rub {
            mobility_x: [[3.5, a, -b], [a, 3.5 * a, 0.0], [-b, 0.0, 3.5 * b]],
            mobility_y: [
                [2.5, 2.5 * a, 2.5 * b],
                [2.5 * a, 3.5 * a, 0.0],
                [2.5 * b, 0.0, 3.5 * b],
            ],
            drive: [0.0, -a, b],
            normal: 1.0,
            limits: [
                Limit {
                    friction: between,
                    alpha: 1.0,
                    beta: 0.0,
                },
                cloth(1.0),
                cloth(-1.0),
            ],
            slip: slips.map(|slip| slip / closing),
            noise: 1e-15 * size / closing,
            restitution: contact.restitution.unwrap_or(self.restitution),
        };
        let impulses = rub.follow(&Accuracy::GAME);
        let p = closing * impulses.normal;
        let [between, under_1, under_2] = impulses.friction.map(|impulse| closing * impulse);
        let mut outcome = PairOutcome {
            first: *state_1,
            second: *state_2,
            impulse: reduced * p,
        };
        let sides = [
            (&mut outcome.first, ball_1, a, 1.0, under_1),
            (&mut outcome.second, ball_2, b, -1.0, under_2),
        ];
        for (state, ball, share, sign, under) in sides {
            let (along, across) = (sign * p + under.y, sign * between.x + under.x);
            state.velocity -= share * (along * normal + across * x);
            let spin = (between.y + under.y) * x - under.x * normal - between.x * DVec3::Y;
            state.angular_velocity -= 2.5 * share / ball.radius * spin;
        }
        outcome
    }

    fn restitution(&self, _closing: f64) -> f64 {
        self.restitution
    }
}

impl Check for Mathavan2014 {
    fn parameters(&self) -> Vec<Parameter> {
        let mut parameters = self.flying().parameters();
        parameters.push(
            Parameter::new("sliding", self.sliding, 0.0, 2.0).basis(
                "dry friction; 0.21 measured, Mathavan 2009, balls on cloth 0.15 to 0.4, Alciatore, physical properties",
            ),
        );
        parameters
    }
}
