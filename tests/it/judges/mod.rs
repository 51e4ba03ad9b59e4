//! Judges: cases whose answer is known in closed form, or printed by others. The numbers J1 to J12 are ours; sources are
//! Alciatore's technical proofs (TP) and the derivations named beside each.

mod collision;
mod cue_ball;
mod cushion;
mod free_motion;
mod mathavan;
mod symmetry;
mod thirty_degrees;
mod throw;

use glam::DVec3;

use masse::physics::ball::{Ball, Motion, State};
use masse::physics::laws::ball_ball::{
    BallBallLaw, Friction, Frictional, Frictionless, PairContact, PairOutcome,
};
use masse::physics::laws::motion::{Cloth, MotionLaw};

/// Speeds at which the laws are judged, m/s.
const SPEEDS: [f64; 3] = [0.447, 1.341, 3.129];

/// The cloth of the judges: μₛ 0.2, μᵣ 0.01, g 9.81.
fn cloth() -> MotionLaw {
    MotionLaw::Coulomb(Cloth {
        sliding: 0.2,
        rolling: 0.01,
        spin_deceleration: 10.9,
        gravity: 9.81,
    })
}

fn smooth(restitution: f64) -> BallBallLaw {
    BallBallLaw::Frictionless(Frictionless { restitution })
}

fn rough(restitution: f64, friction: Friction) -> BallBallLaw {
    BallBallLaw::Frictional(Frictional {
        restitution,
        friction,
    })
}

/// A pool ball in the middle of the table.
fn moving(velocity: DVec3, angular_velocity: DVec3) -> State {
    let state = State {
        position: DVec3::Y * Ball::POOL.radius,
        velocity,
        angular_velocity,
        motion: Motion::Rest,
    };
    cloth().classify(&Ball::POOL, state)
}

/// A pool ball that rolls along x.
fn rolling(speed: f64) -> State {
    moving(DVec3::X * speed, Ball::POOL.rolling_spin(DVec3::X * speed))
}

/// Line of centres for a cut by this angle in rad of a ball that comes along x: turned to the left.
fn cut_line(cut: f64) -> DVec3 {
    DVec3::new(libm::cos(cut), 0.0, -libm::sin(cut))
}

/// The outcome of a pool ball with this state hitting a pool ball at rest along `normal`.
fn hit(law: &BallBallLaw, state: &State, normal: DVec3) -> PairOutcome {
    let ball = Ball::POOL;
    let object = State::at_rest(state.position + 2.0 * ball.radius * normal);
    let contact = PairContact {
        normal,
        on_slate: true,
        restitution: None,
    };
    law.collide((&ball, state), (&ball, &object), &contact)
}

/// The state in which a ball begins to roll, or rests.
fn settled(state: &State) -> State {
    let state = cloth().classify(&Ball::POOL, *state);
    if state.motion != Motion::Sliding {
        return state;
    }
    cloth().piece(&Ball::POOL, &state).end(&Ball::POOL)
}

/// Angle in rad from the first vector to the second, counter-clockwise seen from above.
fn turn(from: DVec3, to: DVec3) -> f64 {
    libm::atan2(from.cross(to).y, from.dot(to))
}
