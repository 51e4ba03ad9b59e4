//! The test stand: balls and cloth, and the few shots that most judges are made of, all played by the laws and the
//! solver of the game.

use std::fmt::Debug;

use glam::DVec3;

use crate::physics::ball::{Ball, Motion, State};
use crate::physics::laws::Laws;
use crate::physics::laws::ball_ball::{
    BallBallLaw, Friction, Frictional, PairContact, PairOutcome,
};
use crate::physics::laws::cushion::{CushionContact, CushionLaw};
use crate::physics::laws::motion::{Cloth, MotionLaw};
use crate::physics::scene::{Scene, Solver};
use crate::physics::table::{Nose, Preset};

/// The nose of the papers.
pub(super) const EDGE: Nose = Nose::Round { radius: 0.0 };

/// Balls of one kind on a cloth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stand {
    /// The balls.
    pub ball: Ball,
    /// The cloth.
    pub cloth: Cloth,
    /// Height of the nose in m.
    pub nose_height: f64,
}

impl Stand {
    /// Pool balls on the cloth of the judges: μₛ 0.2, μᵣ 0.01, g 9.81; nose at 63.5 % of a ball.
    pub const POOL: Self = Self {
        ball: Ball::POOL,
        cloth: Cloth {
            sliding: 0.2,
            rolling: 0.01,
            spin_deceleration: 10.9,
            gravity: 9.81,
        },
        nose_height: 1.27 * Ball::POOL.radius,
    };

    /// The snooker balls, cloth and nose of Mathavan, Jackson & Parkin (2009, 2010, 2014).
    pub const SNOOKER: Self = Self {
        ball: Ball {
            mass: 0.1406,
            radius: 0.02625,
            spins: true,
        },
        cloth: Cloth {
            sliding: 0.212,
            rolling: 0.0127,
            spin_deceleration: 10.9,
            gravity: 9.81,
        },
        nose_height: 1.4 * 0.02625,
    };

    /// Carom balls on heated cloth (rolling resistance as tracked in E10), nose at 37 mm (UMB).
    pub const CAROM: Self = Self {
        ball: Ball {
            mass: 0.21,
            radius: 0.03075,
            spins: true,
        },
        cloth: Cloth {
            sliding: 0.2,
            rolling: 0.0046,
            spin_deceleration: 10.9,
            gravity: 9.81,
        },
        nose_height: 0.037,
    };

    /// The motion law of the cloth.
    pub fn motion(&self) -> MotionLaw {
        MotionLaw::Coulomb(self.cloth)
    }

    /// A ball in the middle of the table that moves and spins.
    pub fn moving(&self, velocity: DVec3, angular_velocity: DVec3) -> State {
        let state = State {
            position: DVec3::Y * self.ball.radius,
            velocity,
            angular_velocity,
            motion: Motion::Rest,
        };
        self.motion().classify(&self.ball, state)
    }

    /// A ball that slides along x without spin.
    pub fn stunned(&self, speed: f64) -> State {
        self.moving(DVec3::X * speed, DVec3::ZERO)
    }

    /// A ball that moves along x with `roll` times the spin of a rolling one: 1 rolls, below 0 draws.
    pub fn rolling(&self, speed: f64, roll: f64) -> State {
        let velocity = DVec3::X * speed;
        self.moving(velocity, roll * self.ball.rolling_spin(velocity))
    }

    /// The state in which a ball that slides begins to roll, or rests.
    pub fn settled(&self, state: &State) -> State {
        let state = self.motion().classify(&self.ball, *state);
        if state.motion == Motion::Sliding {
            self.motion().piece(&self.ball, &state).end(&self.ball)
        } else {
            state
        }
    }

    /// What becomes of a ball with this state and of one at rest that it cuts by this angle in rad to the left.
    pub fn hit(&self, law: &BallBallLaw, state: &State, cut: f64) -> PairOutcome {
        self.hit_with(law, state, cut, None)
    }

    /// The same with another restitution than the law's own.
    pub fn hit_with(
        &self,
        law: &BallBallLaw,
        state: &State,
        cut: f64,
        restitution: Option<f64>,
    ) -> PairOutcome {
        let object = State::at_rest(state.position + 2.0 * self.ball.radius * cut_line(cut));
        let contact = PairContact {
            restitution,
            ..PairContact::between(state, &object)
        };
        law.collide((&self.ball, state), (&self.ball, &object), &contact)
    }

    /// Angle in rad by which the object ball leaves the line of centres, along the motion of the cue ball's surface.
    pub fn throw(&self, law: &BallBallLaw, state: &State, cut: f64) -> f64 {
        -turn(cut_line(cut), self.hit(law, state, cut).second.velocity)
    }

    /// The state just after a ball that moves along x meets a cushion whose normal is turned by this angle in rad: 0 is
    /// square into it.
    pub fn rebound(&self, law: &CushionLaw, state: &State, incidence: f64) -> State {
        self.rebound_at(law, state, incidence, self.nose_height)
    }

    /// The same for another height of the nose in m.
    pub fn rebound_at(
        &self,
        law: &CushionLaw,
        state: &State,
        incidence: f64,
        nose_height: f64,
    ) -> State {
        let contact = CushionContact {
            normal: -cut_line(incidence),
            nose_height,
            nose: EDGE,
            restitution: None,
        };
        law.rebound(&self.ball, state, &contact).state
    }

    /// An empty room of 200 m by 100 m for the exact solver, with the cloth of the stand.
    pub fn room(&self, ball_ball: BallBallLaw) -> Scene {
        let laws = Laws {
            motion: self.motion(),
            ball_ball,
            ..Laws::default()
        };
        room(laws)
    }
}

/// An empty room of 200 m by 100 m for the exact solver.
pub(super) fn room(laws: Laws) -> Scene {
    let table = Preset::Box {
        length: 200.0,
        width: 100.0,
    };
    let mut scene = Scene::new(table.table(), laws);
    scene.solver = Solver::Exact;
    scene.time_limit = 300.0;
    scene
}

/// Line of centres of a cut by this angle in rad by a ball that comes along x: turned to the left.
pub(super) fn cut_line(cut: f64) -> DVec3 {
    DVec3::new(libm::cos(cut), 0.0, -libm::sin(cut))
}

/// Angle in rad from the first vector to the second, counter-clockwise seen from above.
pub(super) fn turn(from: DVec3, to: DVec3) -> f64 {
    libm::atan2(from.cross(to).y, from.dot(to))
}

/// The name of a law as a scene file has it, such as `Han2005`.
pub(in crate::report) fn name_of(law: &impl Debug) -> String {
    let text = format!("{law:?}");
    let end = text
        .find(|letter: char| !letter.is_alphanumeric())
        .unwrap_or(text.len());
    text[..end].to_owned()
}

/// Smooth balls.
pub(super) fn smooth(restitution: f64) -> BallBallLaw {
    BallBallLaw::Frictionless(crate::physics::laws::ball_ball::Frictionless { restitution })
}

/// Rough balls.
pub(super) fn rough(restitution: f64, friction: Friction) -> BallBallLaw {
    BallBallLaw::Frictional(Frictional {
        restitution,
        friction,
    })
}

/// Every registered ball-ball law by name, and the frictional one once more with the constant friction in the middle of
/// Alciatore's range.
pub(super) fn ball_ball_laws() -> Vec<(String, BallBallLaw)> {
    let mut laws = Vec::new();
    for law in BallBallLaw::all() {
        if let BallBallLaw::Frictional(frictional) = law {
            laws.push(("Frictional, Marlow".to_owned(), law));
            let constant = rough(frictional.restitution, Friction::Constant(0.06));
            laws.push(("Frictional, μ 0.06".to_owned(), constant));
        } else {
            laws.push((name_of(&law), law));
        }
    }
    laws
}

/// Every registered cushion law by name.
pub(super) fn cushion_laws() -> Vec<(String, CushionLaw)> {
    CushionLaw::all()
        .into_iter()
        .map(|law| (name_of(&law), law))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn laws_are_named_as_in_scene_files() {
        let names: Vec<String> = cushion_laws().into_iter().map(|(name, _)| name).collect();
        assert!(names.contains(&"Han2005".to_owned()), "{names:?}");
        assert_eq!(name_of(&MotionLaw::Frictionless), "Frictionless");
    }
}
