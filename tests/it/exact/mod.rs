//! The exact solver, judged by whole simulations.

mod clusters;
mod flight;
mod free_paths;
mod impacts;
mod live;
mod pockets;
mod random_shots;
mod wedged;

use glam::DVec3;

use masse::physics::ball::{Ball, State};
use masse::physics::exact::{Limits, solve};
use masse::physics::laws::Laws;
use masse::physics::laws::ball_ball::{BallBallLaw, Frictionless};
use masse::physics::laws::cushion::{CushionLaw, Mirror};
use masse::physics::laws::motion::MotionLaw;
use masse::physics::record::{EventKind, Record};
use masse::physics::scene::{Scene, Solver};
use masse::physics::table::Preset;

/// A large box with these laws, to be solved exactly.
pub fn scene(laws: Laws) -> Scene {
    let table = Preset::Box {
        length: 100.0,
        width: 50.0,
    };
    let mut scene = Scene::new(table.table(), laws);
    scene.solver = Solver::Exact;
    scene
}

/// No cloth, no friction, this restitution of balls and of cushions.
pub fn smooth(balls: f64, cushions: f64) -> Laws {
    Laws {
        motion: MotionLaw::Frictionless,
        ball_ball: BallBallLaw::Frictionless(Frictionless { restitution: balls }),
        cushion: CushionLaw::Mirror(Mirror {
            restitution: cushions.into(),
        }),
        ..Laws::ideal()
    }
}

/// Adds a pool ball that moves and spins.
pub fn put(scene: &mut Scene, name: &str, x: f64, z: f64, velocity: DVec3, spin: DVec3) -> usize {
    let index = scene.place(name, Ball::POOL, x, z);
    scene.balls[index].state.velocity = velocity;
    scene.balls[index].state.angular_velocity = spin;
    index
}

/// Solves with the default limits.
#[track_caller]
pub fn play(scene: &Scene) -> Record {
    solve(scene, Limits::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// The first event of two balls: states after of both, the one with the smaller index first.
#[track_caller]
pub fn first_hit(record: &Record) -> (State, State) {
    let hit = record
        .events
        .iter()
        .find(|event| event.kind == EventKind::BallBall)
        .expect("two balls met");
    let second = hit.second.expect("a collision has two balls");
    if hit.first.ball < second.ball {
        (hit.first.after, second.after)
    } else {
        (second.after, hit.first.after)
    }
}

/// Kinetic and potential energy of all balls at one time.
pub fn energy(scene: &Scene, record: &Record, time: f64) -> f64 {
    (0..scene.balls.len())
        .map(|ball| {
            let (body, state) = (scene.balls[ball].ball, record.state_at(ball, time));
            body.kinetic_energy(&state) + body.mass * 9.81 * (state.position.y - body.radius)
        })
        .sum()
}
